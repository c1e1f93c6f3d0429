/**
 * What the engine answers, walks and builds for blocks: null until lateengine.js is loaded. The world is drawn without it. It is loaded with the
 * blocks, before a game runs. A game that needs it already at its beginning is drawn then.
 */
export let lateEngine = null;

/** Called by lateengine.js. */
export function provideLateEngine(classes) {
	lateEngine = classes;
}
