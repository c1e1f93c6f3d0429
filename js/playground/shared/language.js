/** The page's words in its language. The page's first script fills them in before a view is loaded. */
export const texts = {};

/** Adds the words of a file of languages/. */
export function addWords(words) {
	for (const [key, value] of Object.entries(words)) {
		if (typeof texts[key] === "object") Object.assign(texts[key], value);
		else texts[key] = value;
	}
}

/**
 * What loads the words that only some views need: "class" for the teacher's pages and handing in, "game" for
 * blocks, lessons and games, "lab" for the others. The first script fills it in.
 */
export const furtherWords = {};

/** Loads these words, if they are not there yet. */
export async function loadWords(name) {
	const { load } = furtherWords[name];
	furtherWords[name].loaded ??= load().then((words) => addWords(words.texts));
	await furtherWords[name].loaded;
}

/** A file could not be loaded. Its message is in the page's language. */
export class LoadError extends Error {
	/** @param {string} file the file's name, with the server's answer if there was one */
	constructor(file) {
		super(texts.failed(file));
	}
}

/** What the page says if something could not be loaded. The browser's own messages are in another language, so they go to the console. */
export function failure(error) {
	if (error instanceof LoadError) return error.message;
	console.error(error);
	return texts.failed();
}

/** A number with this many decimals, with the language's decimal sign. */
export const fixed = (value, digits) => value.toFixed(digits).replace(".", texts.numbers.decimal);

/** A number with at most this many decimals, with the language's decimal sign. */
export const plain = (value, digits = 2) => String(Number(value.toFixed(digits))).replace(".", texts.numbers.decimal);
