/** Where programs of the npm package find the page's models. */
import { MODELS } from "./names.js";

/** Those that the engine makes itself. */
export const BUILT_IN = ["sphere", "cube", "cylinder"];
/** Those that only the playground has. */
export const MADE = ["turtle", "wall"];
const COLLADA = ["dragon", "seagull", "fireman", "person"];

/** A model's file in the project's folder assets; null if it has none there. */
export const fileOf = (name) => (MODELS.includes(name) && !BUILT_IN.includes(name) ? `${name}.${COLLADA.includes(name) ? "dae" : "obj"}` : null);
