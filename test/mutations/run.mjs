#!/usr/bin/env node
/**
 * Changes the engine in one place at random, many times, and runs the tests until one fails: what survives is tested by nothing, or changes no
 * answer. It is the translation that is changed, a line of which is a line of the source.
 *
 *   node test/mutations/run.mjs TESTS [COUNT [SEED [all [PACKAGES]]]]
 *
 * TESTS is what the build made of the engine and the tests together. PACKAGES are those to change, with commas: search,solid. First the test
 * classes run that name the changed class. Then the hash of all that the soak's game sees is compared. With "all" every other test class runs after
 * that; no *.test.mjs does. With "chosen" those run that ./antw test -Dtest=SOURCE runs in Node, and those that it leaves to the player; PACKAGES are all then.
 *
 * What survives with "all" has mostly been a change of no answer: of equal numbers the one or the other is taken, 0 or -0; children of nodes
 * are visited in another order; boxes are wider, or what would spare work does not; there is room for more than comes; a limit that nothing is
 * below is another such limit; a method that every subclass has fails in another way. The smallest sphere whose vertices are not all looked at
 * again is larger by less than a step of the hull's grid.
 */
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { choose, fartherTests, readTests } from "../chosen.mjs";
import { randomNumbers } from "../module/random.mjs";

const PACKAGES = "collision,handlers,search,ground,terrain,hierarchy,solid,intersection,queries";

/** Seconds of a processor that tests may take, so that a busy machine ends none of them; all of them take about 100. And milliseconds for those that wait. */
const PATIENCE_S = 250;
const PATIENCE_MS = 3600000;

/** Measures time: a busy machine fails it, whatever was changed. */
const TIMED = "MeasurementTest";

/** The hash of all that the soak's game sees. */
const SOAK = "SoakTest.whatAGameSeesIsTheSameEverywhere";

/** What is written in place of what: the first that a place has. */
const CHANGES = [
	[/ <= /g, " < "], [/ >= /g, " > "], [/ < /g, " <= "], [/ > /g, " >= "], [/ \+ /g, " - "], [/ - /g, " + "], [/ \* /g, " / "],
	[/ \+= /g, " -= "], [/ -= /g, " += "], [/ && /g, " || "], [/ \|\| /g, " && "], [/ === /g, " !== "], [/ !== /g, " === "], [/ == /g, " != "], [/ != /g, " == "],
	[/\bif \((?=.*\)\s*\{?$)/g, "if (!1 && "], [/\bif \((?=.*\)\s*\{?$)/g, "if (!0 || "], [/\btrue\b/g, "false"], [/\bfalse\b/g, "true"],
	[/\bMath\.max\b/g, "Math.min"], [/\bMath\.min\b/g, "Math.max"], [/(?<=[-+*(=,[] ?)\b0\b(?![.x])/g, "1"], [/(?<=[-+*(=,[] ?)\b1\b(?![.x]| \/ 0 \/\*)/g, "2"], [/\+\+(?=;)/g, "--"],
	[/^\s+(this\.)?[#\w.]+(\([^()]*\)| = [^;{]*);$/g, ";"],
	[/ [-+*] [\w.#$]+(?=[;,) ])/g, ""], [/ (&&|\|\|) !?[\w.#$]+(\([^()]*\))?( [<>=!]+ [\w.#$]+)?(?=[;,) ])/g, ""],
];

/** A field gets its first value: mostly another is written before it is read. */
const FIRST_VALUE = /^\s+this\.[#$\w]+ = (-?[\d.]+|null|false|true|""|\(0 \/ 0.*|-?Infinity);$/;

const root = fileURLToPath(new URL("../..", import.meta.url));
const [tests, count = "100", seed = "1", all = "", packages = ""] = process.argv.slice(2);

const filesBelow = (folder) => readdirSync(folder, { withFileTypes: true, recursive: true })
	.filter((entry) => entry.name.endsWith(".as")).map((entry) => path.join(entry.parentPath ?? entry.path, entry.name));
const classOf = (file) => path.basename(file, ".as");

const lines = readFileSync(tests, "utf8").split("\n");

/** Every place in a class, and what may be written there. */
function placesOf(name) {
	const first = lines.findIndex((line) => new RegExp(`^(const ${name} = .*)?(class|function) ${name}\\b`).test(line));
	const places = [];
	let isConstructor = false;
	for (let i = first + 1; first >= 0 && !/^\}/.test(lines[i]); i++) {
		const line = lines[i];
		isConstructor = /^\tconstructor\(/.test(line) || (isConstructor && !/^\t\}/.test(line));
		if (isConstructor && FIRST_VALUE.test(line)) continue;
		if (/^\s*(\/\/|\*|\/\*)|throw new|static #?\w+ =|requireType|\$check/.test(line)) continue;
		for (const [from, to] of CHANGES) for (const { index, 0: text } of line.matchAll(from)) places.push({ name, line: i, changed: line.slice(0, index) + to + line.slice(index + text.length) });
	}
	return places;
}

const everyPackage = () => readdirSync(path.join(root, "src/starlogo"), { withFileTypes: true }).filter((each) => each.isDirectory() && each.name !== "away3d").map((each) => each.name).join();
const places = (packages || (all === "chosen" ? everyPackage() : PACKAGES)).split(",").flatMap((each) => filesBelow(path.join(root, "src/starlogo", each)).map(classOf)).flatMap(placesOf);
const random = randomNumbers(Number(seed));
for (let i = 0; i < 8; i++) random();

const known = readTests();

/** What the runner is told to run for a change of a class. */
function testsOf(name) {
	const choice = choose(`${name}.as`, known.classes, known.sources);
	const simpleName = (each) => each.split(".").pop();
	const near = [...choice.tests.keys()].filter((each) => !choice.farther.has(each)).map(simpleName);
	const farther = fartherTests(choice, known.classes, known.sources).map(([each, test]) => `${simpleName(each)}.${test}`);
	if (all === "chosen") return [`--order=${near}`, `--then=${farther}`];
	if (!all) return [`--order=${[...near, SOAK]}`];
	const others = [...known.classes.keys()].map(simpleName).filter((each) => !near.includes(each) && !farther.some((test) => test.startsWith(`${each}.`)));
	return [`--order=${[...near, ...farther, ...others].filter((each) => each.split(".")[0] !== TIMED)}`];
}

/** The first test that fails; null if none does. */
function killerOf(file, name) {
	const run = spawnSync("sh", ["-c", `ulimit -t ${PATIENCE_S}; exec "$@"`, "sh", process.execPath, path.join(root, "test/module/run.mjs"), file, "--first", ...testsOf(name),
		"--mount=/assets=assets", "--mount=/fixtures=test/fixtures", "--mount=/models=bin/test-models", "--mount=/assimp=/usr/share/assimp/models"],
	{ cwd: root, encoding: "utf8", timeout: PATIENCE_MS, maxBuffer: 1 << 26 });
	return run.error || run.signal ? "no end" : run.status === 0 ? null : /FAILED,? ([\w.]+)/.exec(run.stdout)?.[1] ?? "no start";
}

const file = path.join(path.dirname(path.resolve(tests)), `mutated-${process.pid}.mjs`);
const survivors = [];
console.log(`${count} of ${places.length} changes, from seed ${seed} on`);
for (let i = 1; i <= Number(count); i++) {
	const { name, line, changed } = places[Math.floor(random() * places.length)];
	writeFileSync(file, lines.map((each, at) => (at === line ? changed : each)).join("\n"));
	const killer = killerOf(file, name);
	const change = `\n\t${lines[line].trim()}\n\t${changed.trim()}`;
	console.log(`${i}. ${name}: ${killer ?? "SURVIVED"}${killer === null || killer === "no end" ? change : ""}`);
	if (killer === null) survivors.push(name);
}
rmSync(file);
console.log(`${survivors.length} of ${count} survived: ${survivors.join(", ")}`);
