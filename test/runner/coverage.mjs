/** Which lines of a script run, as V8 counts them. */
import { readFileSync } from "node:fs";
import { Session } from "node:inspector";
import path from "node:path";
import { pathToFileURL } from "node:url";

/** What divides a function into blocks. */
const BRANCH = /\b(?:if|for|while|do|switch|try)\b|\?|&&|\|\||=>/;

/**
 * Begins to count what the scripts of this process run.
 *
 * @param {boolean} detailed whether blocks and conditions count too, or functions alone
 * @returns {() => object[]} lists the scripts with what their functions have run since it was called last, as V8 tells it
 */
export function beginCoverage(detailed) {
	const session = new Session();
	const ask = (method, parameters) => {
		let answer;
		session.post(method, parameters, (error, result) => {
			if (error) throw error;
			answer = result;
		});
		return answer;
	};
	session.connect();
	ask("Profiler.enable");
	ask("Profiler.startPreciseCoverage", { callCount: true, detailed });
	return () => ask("Profiler.takePreciseCoverage").result;
}

/**
 * Begins to count the runs of a script's functions, blocks and conditions.
 *
 * @param {string} file the script
 * @returns {() => number[][]} lists the lines that have run, or may have, at least in part since it was called last: the first and the
 *     last of each row of lines, from 0 on
 */
export function countLines(file) {
	const text = readFileSync(file, "utf8");
	const url = pathToFileURL(path.resolve(file)).href;
	const take = beginCoverage(true);
	const hasRun = new Uint8Array(text.length);
	const starts = [...text.matchAll(/^(?:const \w+ = .*)?class \w+/gm), { index: text.length }].map(({ index }) => index);
	let straight = null;
	return () => {
		const functions = take().find((each) => each.url === url)?.functions ?? [];
		hasRun.fill(0);
		// what is inside of another comes after it
		for (const { startOffset, endOffset, count } of functions.flatMap(({ ranges }) => ranges)) hasRun.fill(Number(count > 0), startOffset, endOffset);
		// In optimised code V8 counts blocks, but not runs of functions. So a function without a branch counts as run if anything of its
		// class has run. The first time the script itself has run, and so all of its classes.
		for (let i = 0, next = 0; straight !== null && i + 1 < starts.length; i++) {
			const isUsed = hasRun.subarray(starts[i], starts[i + 1]).includes(1);
			while (next < straight.length && straight[next][0] < starts[i]) next++;
			for (; next < straight.length && straight[next][0] < starts[i + 1]; next++) if (isUsed) hasRun.fill(1, ...straight[next]);
		}
		straight ??= functions.map(({ ranges: [{ startOffset, endOffset }] }) => [startOffset, endOffset])
			.filter(([start, end]) => !BRANCH.test(text.slice(start, end)));
		return linesOf(text, hasRun);
	};
}

function linesOf(text, hasRun) {
	const lines = [];
	let line = 0;
	for (let start = 0, end; start < text.length; start = end + 1, line++) {
		end = text.indexOf("\n", start);
		if (end < 0) end = text.length;
		let at = start;
		while (at < end && (hasRun[at] === 0 || text[at] === "\t")) at++;
		if (at === end) continue;
		if (lines.at(-1)?.[1] === line - 1) lines.at(-1)[1] = line;
		else lines.push([line, line]);
	}
	return lines;
}
