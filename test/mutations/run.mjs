#!/usr/bin/env node
/**
 * Changes the engine in one place at random, many times, and runs the tests until one fails: what survives is tested by nothing, or changes no
 * answer. It is the translation that is changed, a line of which is a line of the source.
 *
 *   node test/mutations/run.mjs TESTS [COUNT [SEED [all [PACKAGES]]]]
 *
 * TESTS is what the build made of the engine and the tests together. PACKAGES are those to change, with commas: search,solid. If none are named, all are
 * changed. The tests that the quick command takes for the changed source run, and then the hash of all that the soak's game sees is compared. With "all"
 * every test runs that runs the changed line. The first time, all tests run once for that, and TESTS.coverage keeps which lines each of them runs. With
 * "chosen" those run that ./antw test -Dtest=SOURCE runs in Node, and those that it leaves to the player. Of *.test.mjs those run that check the source.
 *
 * What survives with "all" has mostly been a change of no answer: of equal numbers the one or the other is taken, 0 or -0; children of nodes are
 * visited in another order; boxes are wider, or what would spare work does not; the slower of two sorts runs; there is room for more than comes; a
 * limit that nothing is below is another such limit; a method that every subclass has fails in another way. The smallest sphere whose vertices are
 * not all looked at again is larger by less than a step of the hull's grid. Corners of triangles are kept as moved although they are at their
 * vertices' places. A level's triangles are prepared when it is added, or when it is asked first. Where two bodies part is halved from 0 on, which
 * takes longer. Of two places that both lead into a platform the one or the other is taken (PlatformCarry.carry).
 * Of more steps than any case needs, one is left out (TouchFinder). What has not changed is read again (AgentTable.currentBodyOf).
 *
 * What is there for rounding alone, or for a counter that only long games fill, hardly any test of every day runs: DisplacedPair.findGrazing and its
 * second push against the motion, the shorter depth in DirectionSearch.correctDepth, the end of a triangle in the ray that ShearedRay makes longer by its
 * slack, a sheet under the ground in ShrunkSweep, RowFilter.forget.
 */
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { choose } from "../runner/chosen.mjs";
import { fartherTests, nameInNode } from "../runner/farther.mjs";
import { readTests } from "../runner/test-classes.mjs";
import { randomNumbers } from "../module/random.mjs";
import { placesIn } from "./places.mjs";

/** Seconds of a processor that tests may take, so that a busy machine ends none of them; all of them take about 200, with their lines counted. And milliseconds for those that wait. */
const PATIENCE_S = 600;
const PATIENCE_MS = 3600000;

/** Measures time: a busy machine fails it, whatever was changed. */
const TIMED = "MeasurementTest";

/** The hash of all that the soak's game sees. */
const SOAK = "SoakTest.whatAGameSeesIsTheSameEverywhere";

/** Tests that take no longer run in the order of their classes. */
const QUICK_MS = 60;

const root = fileURLToPath(new URL("../..", import.meta.url));
const [tests, count = "100", seed = "1", all = "", packages = ""] = process.argv.slice(2);

const filesBelow = (folder) => readdirSync(folder, { withFileTypes: true, recursive: true })
	.filter((entry) => entry.name.endsWith(".as")).map((entry) => path.join(entry.parentPath ?? entry.path, entry.name));
const classOf = (file) => path.basename(file, ".as");

const lines = readFileSync(tests, "utf8").split("\n");

const everyPackage = () => readdirSync(path.join(root, "src/starlogo"), { withFileTypes: true }).filter((each) => each.isDirectory() && each.name !== "away3d").map((each) => each.name).join();
const places = (packages || everyPackage()).split(",").flatMap((each) => filesBelow(path.join(root, "src/starlogo", each)).map(classOf)).flatMap((name) => placesIn(lines, name));
const random = randomNumbers(Number(seed));
for (let i = 0; i < 8; i++) random();

const known = readTests();

const simpleName = (name) => name.split(".").pop();

/** What the runner is told to run for a change of a line of a class, as list-tests.mjs writes it; null if no test runs it. */
function testsOf(name, line) {
	if (all === "all") {
		const reaching = coverage.filter(({ lines }) => lines.some(([first, last]) => first <= line && line <= last));
		// a line that runs when the tests are loaded may change any of them
		const some = reaching.some(({ test }) => test === "") ? coverage : reaching;
		return some.length > 0 ? { order: some.map(({ test }) => test).filter((test) => test !== "") } : null;
	}
	const choice = choose(`${name}.as`, known.classes, known.sources);
	const near = [...choice.tests.keys()].filter((each) => !choice.farther.has(each)).map(simpleName);
	if (all !== "chosen") return { order: [...near, SOAK] };
	return { order: near, farther: fartherTests(choice, known.classes, known.sources).map(nameInNode) };
}

function runTests(file, options) {
	return spawnSync("sh", ["-c", `ulimit -t ${PATIENCE_S}; exec "$@"`, "sh", process.execPath, path.join(root, "test/runner/run.mjs"), file, ...options,
		"--mount=/assets=assets", "--mount=/fixtures=test/fixtures", "--mount=/models=bin/test-models", "--mount=/assimp=/usr/share/assimp/models"],
	{ cwd: root, encoding: "utf8", timeout: PATIENCE_MS, maxBuffer: 1 << 26 });
}

/** Which lines each test runs, and how long it takes: the quick ones first, and of these the tests of a class together. */
function readCoverage() {
	const kept = `${path.resolve(tests)}.coverage`;
	const isKept = statSync(kept, { throwIfNoEntry: false })?.mtimeMs > statSync(tests).mtimeMs;
	if (!isKept) {
		console.log("all tests run once");
		runTests(tests, [`--coverage=${kept}`]);
	}
	const rows = readFileSync(kept, "utf8").trim().split("\n").map((row) => JSON.parse(row)).filter(({ test }) => !test.startsWith(TIMED));
	const slowness = ({ ms }) => (ms > QUICK_MS ? ms : 0);
	return rows.sort((a, b) => slowness(a) - slowness(b));
}

const coverage = all === "all" ? readCoverage() : [];

/** The first of some tests that fails; null if none does. */
function firstFailure(file, chosen) {
	const told = `${file}.json`;
	writeFileSync(told, JSON.stringify(chosen));
	const run = runTests(file, ["--first", `--choice=${told}`]);
	rmSync(told);
	return run.error || run.signal ? "no end" : run.status === 0 ? null : /FAILED,? ([\w./-]+)/.exec(run.stdout)?.[1] ?? "no start";
}

/** The tests that pass if nothing is changed. */
const sound = new Set();

/** Ends the program if a test, or a file of tests, fails without a change too, because then it says nothing of one. */
function requireSound(test) {
	if (sound.has(test) || !test.includes(".")) return;
	if (firstFailure(tests, { order: [test] }) !== null) {
		rmSync(file, { force: true });
		console.error(`${test} fails without a change too: mend it first`);
		process.exit(1);
	}
	sound.add(test);
}

/** The first test that fails because of a change; null if none does. */
function killerOf(file, name, line) {
	const chosen = testsOf(name, line);
	const killer = chosen === null ? null : firstFailure(file, chosen);
	if (killer !== null) requireSound(killer);
	return killer;
}

const file = path.join(path.dirname(path.resolve(tests)), `mutated-${process.pid}.mjs`);
const survivors = [];
console.log(`${count} of ${places.length} changes, from seed ${seed} on`);
for (let i = 1; i <= Number(count); i++) {
	const { name, line, changed } = places[Math.floor(random() * places.length)];
	writeFileSync(file, lines.map((each, at) => (at === line ? changed : each)).join("\n"));
	const killer = killerOf(file, name, line);
	const change = `\n\t${lines[line].trim()}\n\t${changed.trim()}`;
	console.log(`${i}. ${name}: ${killer ?? (testsOf(name, line) === null ? "SURVIVED, no test runs it" : "SURVIVED")}${killer === null || killer === "no end" ? change : ""}`);
	if (killer === null) survivors.push(name);
}
rmSync(file, { force: true });
console.log(`${survivors.length} of ${count} survived: ${survivors.join(", ")}`);
