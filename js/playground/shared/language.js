/** The page's words in its language. The page's first script fills them in before a view is loaded. */
export const texts = {};

/** Sets the words of a language: the export of a file of languages/. */
export function speak(words) {
	Object.assign(texts, words);
}

/** Loads the words of the teacher's pages and of handing in. The page's first script sets it. */
export const further = { load: null };

/** Waits until these words are there. */
export async function learnClass() {
	if (!texts.handing) speak((await further.load()).texts);
}

/** A number with this many decimals, with the language's decimal sign. */
export const fixed = (value, digits) => value.toFixed(digits).replace(".", texts.numbers.decimal);

/** A number with at most this many decimals, with the language's decimal sign. */
export const plain = (value, digits = 2) => String(Number(value.toFixed(digits))).replace(".", texts.numbers.decimal);
