/** Reads model files. The engine that it imports is the build's second one, of which only this is bundled: what goes out of here are numbers. */
import { ErrorEvent, ModelEvent, ModelLoader } from "starlogo-collision";

/**
 * The vertices and triangles in a file.
 *
 * @param {string} name what errors call the model
 * @param {Uint8Array} bytes the file's content
 */
export function surfaceIn(name, bytes) {
	return new Promise((resolve, reject) => {
		const loader = new ModelLoader({ expect() {}, expectNoMore() {}, receive: () => null });
		loader.addEventListener(ModelEvent.LOADED, ({ model }) => resolve(model));
		loader.addEventListener(ErrorEvent.ERROR, ({ text }) => reject(new Error(text)));
		loader.loadBytes(name, bytes);
	});
}
