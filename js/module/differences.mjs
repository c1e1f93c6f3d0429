/** Where the module's classes differ from those in ActionScript. */

/** Methods that return a Uint8Array in place of a ByteArray, because the platform's functions can copy and send it. */
export const RETURNS_UINT8ARRAY = new Set(["starlogo.GreatLand.cook", "starlogo.collision.Collision.snapshot"]);

/** Members of a class by its qualified name: their code, and their declaration in index.d.ts unless they are for the adapters alone. */
export const ONLY_IN_JAVASCRIPT = {
	// every class that tools show has it: shown.mjs
	"starlogo.agents.Agent": {
		text: "",
		declaration: `\t/** The id and the traits as a plain object, as JSON.stringify and tools see them, with those of a game's own class that are no objects. */
	toJSON(key?: string): Record<string, unknown>;`,
	},
	// for the adapters: to three.js, which fills the data of a model as a reader of files does; its warnings are not in the minified module
	"starlogo.models.Model": {
		text: `static get $internals() {
return { ModelData, ModelBuilder, vectorOf: $vector, checkedOptions: $options, textOf: $textOf, warnings: $warningsForAdapters() };
}`,
		declaration: null,
	},
	"starlogo.models.ModelLoader": {
		text: `loadAsync(name, url, options = {}) {
  return $loadAsync(this, name, url, options);
}`,
		declaration: `\t/**
	 * Loads a model from a file as load() does, and promises it: \`const bear = await loader.loadAsync("bear", url, { signal })\`. What goes wrong
	 * rejects the promise; listeners for "error" hear it too.
	 *
	 * @param name what agents call the shape
	 * @param url where the file is: OBJ, glTF, STL, COLLADA or cooked
	 * @param options upAxis and scaling as in load(); signal: an AbortSignal that cancels this load alone
	 * @returns the model, which the receiver has by then
	 * @throws ModelError, in the promise, if it can't be loaded; the signal's reason if that is aborted; an AbortError if cancel() is called
	 */
	loadAsync(name: string, url: string, options?: {
		upAxis?: UpAxis | undefined; scaling?: Scaling | undefined; signal?: ListenerOptions["signal"];
	}): Promise<Model>;`,
	},
};
