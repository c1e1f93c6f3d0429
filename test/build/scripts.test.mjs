/** Scripts of the build refuse wrong arguments. No script of the build, of the package or of the page uses a name that it neither declares nor imports: most of them run only in some builds. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdirSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const ts = createRequire(path.join(root, "js/module/package.json"))("typescript");
const FOLDERS = ["build", "js/adapters", "js/module", "js/picture", "js/playground", "test/runner"];

/** TypeScript's errors "Cannot find name" and "has no exported member". */
const LOST = new Set([2304, 2305, 2552, 2724]);

const scripts = FOLDERS.flatMap((folder) => readdirSync(path.join(root, folder), { recursive: true }).map((file) => path.join(root, folder, file)))
	.filter((file) => /\.m?js$/.test(file) && !file.includes("node_modules"));

test("every name that a script uses is declared or imported", () => {
	assert.ok(scripts.length > 120, `${scripts.length} scripts`);
	const { ModuleKind, ModuleResolutionKind, ScriptTarget } = ts;
	const options = { allowJs: true, checkJs: true, noEmit: true, noResolve: true, types: [], target: ScriptTarget.ES2022, module: ModuleKind.ESNext, moduleResolution: ModuleResolutionKind.Bundler, lib: ["lib.esnext.d.ts", "lib.dom.d.ts", "lib.dom.iterable.d.ts"] };
	const program = ts.createProgram(scripts, options);
	const lost = scripts.flatMap((file) => program.getSemanticDiagnostics(program.getSourceFile(file))).filter(({ code }) => LOST.has(code))
		.map(({ file, start, messageText }) => `${path.relative(root, file.fileName)}:${file.getLineAndCharacterOfPosition(start).line + 1}: ${ts.flattenDiagnosticMessageText(messageText, " ")}`);
	assert.deepEqual(lost, []);
});

test("a wrong argument of a script is refused in one line", () => {
	const refused = {
		"build/headless/show.mjs": /^show: exactly one SWF must be given\n$/,
		"build/headless/show.mjs --parm a=b": /^show: there is no option --parm; there is --param\n$/,
		"build/headless/show.mjs no.swf": /^show: there is no SWF at no\.swf\n$/,
		"build/examples/serve.mjs abc": /^PORT must be a whole number up to 65535, not abc\n$/,
		"build/examples/index.mjs nam": /^there is no example nam\n$/,
		"build/examples/index.mjs --card": /^there is no example --card; there is --cards\n$/,
		"build/npm-ci.mjs": /^npm-ci: FOLDER and WHAT must be given\n$/,
		"test/runner/client-tests.mjs": /^OUT and FOLDER must be given\n$/,
	};
	for (const [call, said] of Object.entries(refused)) {
		const { status, stderr } = spawnSync(process.execPath, call.split(" "), { cwd: root, encoding: "utf8" });
		assert.equal(status, 64, call);
		assert.match(stderr, said);
	}
});
