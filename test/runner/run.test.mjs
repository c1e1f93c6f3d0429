/** What test/runner/run.mjs reports of tests, wherever the file of the tests was made. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, test } from "node:test";
import { fileURLToPath } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
const folder = mkdtempSync(path.join(tmpdir(), "run-"));
after(() => rmSync(folder, { recursive: true }));

const TESTS = `import * as flexunit from "./flexunit.mjs";
class LaterTest {
	waits() {
		const target = new EventTarget();
		setTimeout(() => target.dispatchEvent(new Event("done")));
		flexunit.Async.handleEvent(this, target, "done", () => flexunit.fail("it came"));
	}
	isSkipped() {
		throw new flexunit.AssumptionViolatedException("nothing to test");
	}
	passes() {
		console.log("it passes");
	}
	throwsLater() {
		setTimeout(() => { throw new Error("too late"); });
	}
	hasNoEnd() {
		for (;;);
	}
}
class SoakTest {
	whatAGameSeesIsTheSameEverywhere() {
		flexunit.assertEquals("a hash", "1", "2");
	}
}
const test = (name) => ({ kind: "Test", name, args: {} });
export const CLASSES = [{ name: "soak.SoakTest", type: SoakTest, metadata: [test("whatAGameSeesIsTheSameEverywhere")] }, { name: "LaterTest", type: LaterTest, metadata: [test("waits"), test("isSkipped"), test("passes"), test("throwsLater"), test("hasNoEnd")] }];
export const Effort = {};
export const Fixtures = { load: (files, done) => done() };
export const setFetch = () => {};
export { flexunit };
`;

/** Runs some tests, as a file tells the runner. */
function run(choice, options = [], env = {}) {
	writeFileSync(path.join(folder, "choice.json"), JSON.stringify(choice));
	return spawnSync(process.execPath, [path.join(here, "run.mjs"), path.join(folder, "tests.mjs"), `--choice=${path.join(folder, "choice.json")}`, ...options],
		{ encoding: "utf8", env: { ...process.env, NODE_TEST_CONTEXT: undefined, ...env } });
}

test("tests that were made in another folder are waited for, and skipped if they say so", () => {
	cpSync(path.join(here, "flexunit.mjs"), path.join(folder, "flexunit.mjs"));
	writeFileSync(path.join(folder, "tests.mjs"), TESTS);
	const { stdout, stderr, status } = run({ order: ["LaterTest.waits", "LaterTest.isSkipped", "LaterTest.passes"] });
	assert.match(stdout, /FAILED LaterTest.waits: Error: it came/, stderr);
	assert.match(stdout, /: 1 passed, 1 failed, 1 skipped,/);
	assert.equal(status, 1);
	const skipped = run({ order: ["LaterTest.isSkipped"] });
	assert.match(skipped.stdout, /: 0 passed, 0 failed, 1 skipped,/);
	assert.equal(skipped.status, 0);
});

test("an error outside of any test counts, even after the last one", () => {
	const { stdout, status } = run({ order: ["LaterTest.throwsLater"] });
	assert.match(stdout, /FAILED, outside of any test: Error: too late[^]*: 1 passed, 1 failed,/);
	assert.equal(status, 1);
});

test("a test that does not end is named, and the counts of those before it are kept", () => {
	const summary = path.join(folder, "reports/summary.txt");
	const { stdout, signal } = run({ order: ["LaterTest.passes", "LaterTest.isSkipped", "LaterTest.hasNoEnd"] }, [`--summary=${summary}`], { NO_END_S: "1" });
	assert.match(stdout, /^it passes\nFAILED LaterTest.hasNoEnd: it has not ended in 1 s of a processor\n$/);
	assert.equal(signal, "SIGKILL");
	assert.equal(readFileSync(summary, "utf8"), "1 passed, 1 failed, 1 skipped\n");
});

test("a hash that differs says nothing more, so the tests after it run until one fails that does", () => {
	const hash = "SoakTest.whatAGameSeesIsTheSameEverywhere";
	const alone = run({ order: [hash], farther: ["LaterTest.passes"] });
	assert.match(alone.stdout, /^FAILED SoakTest[^]*of the tests that use the source, the nearest first, 1 ran\nof the tests that ran, only a hash says[^]*: 1 passed, 1 failed,/);
	assert.equal(alone.status, 1);
	const { stdout } = run({ order: ["LaterTest.isSkipped"], farther: [hash, "LaterTest.waits", "LaterTest.passes"] });
	assert.match(stdout, /^FAILED SoakTest[^]*\nFAILED LaterTest.waits[^]*of the tests that use the source, the nearest first, 2 ran, 1 not begun: LaterTest\.waits failed before\n.*: 0 passed, 2 failed, 1 skipped,/);
});

test("a failure names the sources that it is a test of, and files beside the classes run on the same module", () => {
	const file = path.join(folder, "beside.test.mjs");
	writeFileSync(file, "import assert from 'node:assert/strict';\nimport test from 'node:test';\ntest('engine', () => assert.equal(process.env.ENGINE, 'none'));\n");
	assert.match(run({ order: ["LaterTest.waits"], of: ["a.Low"] }).stdout, /FAILED LaterTest.waits \(a test of a.Low\): Error: it came/);
	const { stdout, status } = run({ order: ["LaterTest.passes"], farther: [file, "LaterTest.isSkipped"], of: ["a.Low"] });
	assert.match(stdout, /FAILED \S*beside.test.mjs \(a test of a.Low\):[^]*tests.mjs[^]*, 1 ran, 1 not begun: \S*beside.test.mjs failed before\n.*: 1 passed, 1 failed,/);
	assert.equal(status, 1);
});
