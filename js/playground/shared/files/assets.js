/** The places of the page's models, for programs of the npm package. */
import { MODELS } from "../names.js";

/** Models that the engine makes itself. */
export const BUILT_IN = ["sphere", "cube", "cylinder"];
/** Models that only the playground has. */
export const MADE = ["turtle", "wall", "platform", "coin", "key", "rock", "house", "car"];
const COLLADA = ["dragon", "seagull", "fireman", "person"];

/** A model's file in the project's folder assets; null if it has no file there. */
export const fileOf = (name) => (MODELS.includes(name) && !BUILT_IN.includes(name) ? `${name}.${COLLADA.includes(name) ? "dae" : "obj"}` : null);
