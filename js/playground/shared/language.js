/** The words of the page in the language that it speaks. The page's first script fills them in before a view is loaded. */
export const texts = {};

/** Takes the words of a language: what a file of languages/ exports. */
export function speak(words) {
	Object.assign(texts, words);
}

/** A number with so many decimals, written as the language writes it. */
export const fixed = (value, digits) => value.toFixed(digits).replace(".", texts.numbers.decimal);

/** A number without tails, written as the language writes it. */
export const plain = (value, digits = 2) => String(Number(value.toFixed(digits))).replace(".", texts.numbers.decimal);
