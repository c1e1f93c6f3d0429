/** The names of the models. */
export const MODELS = ["sphere", "cube", "cylinder", "bear", "dragon", "seagull", "tree", "kelp", "fortress", "spaceship", "fireman", "person"];

/** The models, and the playground's own. */
export const SHAPES = [...MODELS, "turtle", "wall"];
