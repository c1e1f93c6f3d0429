/** The names of the models. */
export const MODELS = ["sphere", "cube", "cylinder", "bear", "dragon", "seagull", "tree", "kelp", "fortress", "spaceship", "fireman", "person"];

/** The models, and the playground's own. */
export const SHAPES = [...MODELS, "turtle", "wall", "platform", "coin", "key", "rock", "house", "car"];

/** How to install the package, which is in the release and in the project, in a line of a program. */
export const INSTALL = "// Install first: npm install $(npm pack PROJECT/module) - PROJECT is the folder of the unpacked release starlogo-collision-*.zip.";
