/** What test/module/run.mjs reports of tests, wherever the file of the tests was made. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
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
	passes() {}
}
const test = (name) => ({ kind: "Test", name, args: {} });
export const CLASSES = [{ name: "LaterTest", type: LaterTest, metadata: [test("waits"), test("isSkipped"), test("passes")] }];
export const Effort = {};
export const Fixtures = { load: (files, done) => done() };
export const setFetch = () => {};
export { flexunit };
`;

test("tests that were made in another folder are waited for, and skipped if they say so", () => {
	cpSync(path.join(here, "flexunit.mjs"), path.join(folder, "flexunit.mjs"));
	writeFileSync(path.join(folder, "tests.mjs"), TESTS);
	const { stdout, stderr, status } = spawnSync(process.execPath, [path.join(here, "run.mjs"), path.join(folder, "tests.mjs"), "--order=LaterTest"], { encoding: "utf8" });
	assert.match(stdout, /FAILED LaterTest.waits: Error: it came/, stderr);
	assert.match(stdout, /: 1 passed, 1 failed, 1 skipped,/);
	assert.equal(status, 1);
	const skipped = spawnSync(process.execPath, [path.join(here, "run.mjs"), path.join(folder, "tests.mjs"), "--order=LaterTest.isSkipped"], { encoding: "utf8" });
	assert.match(skipped.stdout, /: 0 passed, 0 failed, 1 skipped,/);
	assert.equal(skipped.status, 0);
});
