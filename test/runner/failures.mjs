/** Of what node --test prints as TAP, the tests that failed and what they say; all of it if no test says that it failed. */
export function saidOf(output) {
	return output.match(/^( *)not ok (?!.* # (?:SKIP|TODO)\b).*\n\1  ---\n[^]*?\n\1  \.\.\.$/gm)?.join('\n') ?? output;
}

/**
 * The start of what a failed test says, in the lines of TAP after its name, and the first value that is too much, where two were
 * compared. A file says only that one of its tests failed.
 */
const ERROR = /^(?: *---\n)?(?: +(?!error:)\w+:.*\n)* +error: (?:\|-\n( +)(.+)(?:(?:\n(?:\1.*)?)*?\n\1(?:\+ +(?! |actual - expected\n|[[{]\n)|(?=.+ !== ))(.+))?|(['"`])(?!(?:test failed|\d+ subtests? failed)')(.+)\4)/;

/**
 * The names of the tests that failed, in what node --test prints: "not ok 3 - name" or, in other versions of Node, "✖ name (12 ms)".
 * Files stand before their tests. Behind a name is the first line of what the test says, if the output is TAP. If it says only
 * that two values differ, the first value that is too much follows.
 */
export function failuresIn(output) {
	const lines = [...output.matchAll(/^\s*(?:not ok \d+ - |✖ )(.+?)(?: \([\d.]+ ?ms\))?$/gm)];
	const failures = lines.filter(([, name]) => !/ # (SKIP|TODO)\b|^failing tests:$/.test(name));
	return [...new Set(failures.map(({ 0: line, 1: name, index }) => {
		const [, , ofLines, tooMuch, , ofLine] = ERROR.exec(output.slice(index + line.length + 1)) ?? [];
		const value = ofLines?.startsWith('Expected values') ? tooMuch : undefined;
		return [name, ofLines?.replace(/:$/, '') ?? ofLine, value].filter((each) => each !== undefined).join(': ');
	}))];
}
