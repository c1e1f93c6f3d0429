/** Reads model files. It is the only user of the build's second copy of the engine, so it returns only numbers. */
import { ErrorEvent, ModelEvent, ModelLoader } from "starlogo-collision";

/**
 * The vertices and triangles in a file.
 *
 * @param {string} name the model's name in errors
 * @param {Uint8Array} bytes the file's content
 */
export function surfaceIn(name, bytes) {
	return new Promise((resolve, reject) => {
		const loader = new ModelLoader({ expect() {}, expectNoMore() {}, receive: () => null });
		loader.addEventListener(ModelEvent.LOADED, ({ model }) => resolve(model));
		loader.addEventListener(ErrorEvent.ERROR, ({ text }) => reject(new Error(problemIn(text, name))));
		loader.loadBytes(name, bytes);
	});
}

/** What the engine says of a model without its name, because the page names the file: “Line 2: expected …”. */
function problemIn(text, name) {
	const problem = text.replace(`model "${name}"`, "").replace(/^[,:] /, "");
	return problem.charAt(0).toUpperCase() + problem.slice(1);
}
