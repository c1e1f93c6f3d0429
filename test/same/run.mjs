#!/usr/bin/env node
/**
 * Plays the soak in every machine that is here, and compares the hashes of all that its game has seen.
 *
 *   node test/same/run.mjs TESTS FRAMES [SWF [AVM_SWF]]
 *
 * TESTS is what the build made of the engine and the tests together; SWF is the soak's for Ruffle, AVM_SWF the same for Adobe's VM. Machines that
 * are not installed are named. Exit status: 1 if a hash differs or a machine fails.
 */
import { execFile, execFileSync, spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

const PATIENCE_MS = 1800000;
const LOOKS_MS = 200;

const root = fileURLToPath(new URL("../..", import.meta.url));
const tools = createRequire(path.join(root, "module/package.json"));
const [tests, frames = "2000", swf, avmSwf] = process.argv.slice(2);
const run = promisify(execFile);

/** The engine, the tests and what plays the soak, as one script. */
async function bundle() {
	const out = path.join(root, "bin/same/machine.js");
	mkdirSync(path.dirname(out), { recursive: true });
	await tools("esbuild").build({
		entryPoints: [path.join(root, "test/same/machine.mjs")],
		bundle: true,
		format: "iife",
		outfile: out,
		logLevel: "error",
		nodePaths: [path.join(root, "module/node_modules")],
		plugins: [{
			name: "same",
			setup(build) {
				build.onResolve({ filter: /^tests$/ }, () => ({ path: path.resolve(tests) }));
				build.onResolve({ filter: /^file:/ }, ({ path: url }) => ({ path: fileURLToPath(url) }));
				build.onResolve({ filter: /^node:zlib$/ }, () => ({ path: path.join(root, "test/same/zlib.mjs") }));
			},
		}],
	});
	return out;
}

const hashIn = (text) => {
	const found = /hash of all that the game has seen: (\w+)/.exec(text)?.[1] ?? /^hash (\w+)$/m.exec(text)?.[1];
	// a short game need not have seen all that a soak wants to see
	const problem = /^.*FAILED(?!.* never happened).*$/m.exec(text)?.[0];
	if (!found || problem) throw new Error(problem ?? "no hash");
	return found;
};

const here = (...names) => names.find((name) => name && existsSync(name));
const version = (command) => execFileSync(command, ["--version"], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }).trim();

/** What a program prints, whatever it ends with. */
const said = (...command) => run(...command).catch((error) => error);

async function inPlayer(file, player, single = false) {
	const { stdout } = await said("node", ["test/headless/run.mjs", file, "--stall", "600", "--player", player, "--param", `frames=${frames}`, "--param", `single=${single}`], { cwd: root, timeout: PATIENCE_MS });
	return hashIn(stdout);
}

async function inNode() {
	const { stdout } = await said("node", ["--expose-gc", "test/soak/run.mjs", tests, frames], { cwd: root, timeout: PATIENCE_MS });
	return hashIn(stdout);
}

async function inShell(shell, script) {
	const start = path.join(path.dirname(script), "start.js");
	writeFileSync(start, `globalThis.sameFrames = ${frames};\nglobalThis.saySame = print;\nload(${JSON.stringify(script)});\n`);
	const { stdout } = await run(shell, [start], { timeout: PATIENCE_MS });
	return hashIn(stdout);
}

/** A browser opens a page that plays the soak and hands over what it says. */
async function inBrowser(command, script) {
	const profile = mkdtempSync(path.join(tmpdir(), "same-"));
	let say;
	const said = new Promise((resolve, reject) => {
		say = resolve;
		setTimeout(() => reject(new Error("it has said nothing")), PATIENCE_MS).unref();
	});
	const page = `<!doctype html><meta charset="utf-8"><script>
globalThis.sameFrames = ${frames};
globalThis.saySame = (text) => fetch("/said", { method: "POST", body: text });
addEventListener("error", (event) => saySame("FAILED " + event.message));
</script><script src="/machine.js"></script>`;
	const server = http.createServer((request, response) => {
		if (request.method === "POST") {
			let text = "";
			request.on("data", (piece) => { text += piece; });
			request.on("end", () => {
				response.end();
				say(text);
			});
		} else if (request.url === "/machine.js") {
			response.setHeader("Content-Type", "text/javascript; charset=utf-8");
			response.end(readFileSync(script));
		} else {
			response.setHeader("Content-Type", "text/html; charset=utf-8");
			response.end(request.url === "/" ? page : "");
		}
	});
	await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
	const browser = spawn(command, ["--headless", "--no-remote", "--profile", profile, `http://127.0.0.1:${server.address().port}/`], {
		stdio: "ignore",
		env: { ...process.env, HOME: profile },
	});
	const left = new Promise((resolve, reject) => {
		browser.on("error", reject);
		browser.on("exit", (status) => reject(new Error(`it ended with ${status}`)));
	});
	left.catch(() => {});
	try {
		return hashIn(await Promise.race([said, left]));
	} finally {
		browser.kill();
		server.close();
		server.closeAllConnections();
		await new Promise((resolve) => setTimeout(resolve, LOOKS_MS));
		rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
	}
}

const firefox = here(process.env.FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox");
const jsc = here(process.env.JSC, "/usr/bin/jsc");
const shell = process.env.AVMSHELL;
const script = await bundle();
const machines = [
	["V8 (Node)", () => process.versions.v8, inNode],
	["Ruffle", () => "in Chromium", swf && (() => inPlayer(swf, "ruffle"))],
	["Adobe's VM", () => "avmshell", shell && avmSwf && (() => inPlayer(avmSwf, "avmshell")), "AVMSHELL names no folder"],
	["  single matrices", () => "avmshell", shell && avmSwf && (() => inPlayer(avmSwf, "avmshell", true)), "AVMSHELL names no folder"],
	["SpiderMonkey", () => version(firefox), firefox && (() => inBrowser(firefox, script)), "Debian's firefox-esr is not installed"],
	["JavaScriptCore", () => "jsc of Debian's WebKitGTK", jsc && (() => inShell(jsc, script)), "Debian's libjavascriptcoregtk-4.0-bin is not installed"],
];

const hashes = new Set();
console.log(`what ${frames} frames of the soak's game look like:`);
for (const [name, describe, play, why = "not built"] of machines) {
	let text = `not here: ${why}`;
	if (play) {
		try {
			text = await play();
			hashes.add(text);
		} catch (error) {
			text = `FAILED: ${error.message.split("\n")[0]}`;
			process.exitCode = 1;
		}
	}
	console.log(`  ${name.padEnd(20)}${text}${play ? `  ${describe()}` : ""}`);
}
if (hashes.size > 1) process.exitCode = 1;
console.log(hashes.size > 1 ? "they DIFFER" : `the same in ${machines.filter(([, , play]) => play).length} machines`);
