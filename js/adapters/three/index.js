/** The collision engine for three.js: makes models of its objects, binds agents to objects, and draws wireframes of colliding shapes. */
export { toEngine, toScene } from "./axes.js";
export { faceOf, levelFromObject, modelFromObject } from "./model.js";
export { ThreeAgentBinding, bindInstance } from "./binding.js";
export { ThreeWireframe } from "./wireframe.js";
export { TerrainGeometry, terrainFromMesh } from "./terrain.js";
