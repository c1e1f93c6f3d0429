/** The collision engine for three.js: models of what it draws, agents in the place of its objects, wireframes of what collides. */
export { modelFromObject } from "./model.js";
export { ThreeAgentBinding, bindInstance } from "./binding.js";
export { ThreeWireframe } from "./wireframe.js";
