/** The texts that console.warn gets while a function runs. The function gets the list of them. */
export function warningsIn(run) {
	const { warn } = console;
	const texts = [];
	console.warn = (text) => texts.push(text);
	try {
		run(texts);
	} finally {
		console.warn = warn;
	}
	return texts;
}
