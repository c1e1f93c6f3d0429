/** The names of the models. */
export const MODELS = ["sphere", "cube", "cylinder", "bear", "dragon", "seagull", "tree", "kelp", "fortress", "spaceship", "fireman", "person"];

/** The models, and the playground's own. */
export const SHAPES = [...MODELS, "turtle", "wall", "platform", "coin", "key", "rock", "house", "car"];

/** Models that the engine makes itself. */
export const BUILT_IN = ["sphere", "cube", "cylinder"];
const COLLADA = ["dragon", "seagull", "fireman", "person"];

/** A model's file in the project's folder assets; null if it has no file there. */
export const fileOf = (name) => (MODELS.includes(name) && !BUILT_IN.includes(name) ? `${name}.${COLLADA.includes(name) ? "dae" : "obj"}` : null);

/** The beginning of an address's argument for a program that a pupil has handed in. */
export const HANDED = "handed-";
export const isHanded = (address) => address.startsWith(HANDED);

/** What npm installs as the package. PROJECT is the folder of the unpacked release. */
export const PACKAGE = "$(npm pack PROJECT/module)";

/** How to install the package, in a line of a program. */
export const INSTALL = `// Install first: npm install ${PACKAGE} - PROJECT is the folder of the unpacked release starlogo-collision-*.zip.`;
