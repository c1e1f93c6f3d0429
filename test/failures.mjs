/** Of what node --test prints as TAP, the tests that failed and what they say; all of it if no test says that it failed. */
export function saidOf(output) {
	return output.match(/^( *)not ok (?!.* # (?:SKIP|TODO)\b).*\n\1  ---\n[^]*?\n\1  \.\.\.$/gm)?.join('\n') ?? output;
}

/** The names of the tests that failed, in what node --test prints: "not ok 3 - name" or, in other versions of Node, "✖ name (12 ms)". Files stand before their tests. */
export function failuresIn(output) {
	const names = [...output.matchAll(/^\s*(?:not ok \d+ - |✖ )(.+?)(?: \([\d.]+ ?ms\))?$/gm)].map(([, name]) => name);
	return [...new Set(names)].filter((name) => !/ # (SKIP|TODO)\b|^failing tests:$/.test(name));
}
