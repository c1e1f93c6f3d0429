#!/usr/bin/env node
/**
 * Plays the soak in every machine that is here, and compares the hashes of all that its game has seen.
 *
 *   node test/same/run.mjs TESTS FRAMES [SWF [AVM_SWF]]
 *
 * TESTS is what the build made of the engine and the tests together; SWF is the soak's for Ruffle, AVM_SWF the same for Adobe's VM. Machines that
 * are not installed are named. Exit status: 1 if a hash differs or a machine fails.
 */
import { execFile, execFileSync } from "node:child_process";
import { existsSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { bundle, inBrowser } from "./browser.mjs";

const PATIENCE_MS = 1800000;

const root = fileURLToPath(new URL("../..", import.meta.url));
const [tests, frames = "2000", swf, avmSwf] = process.argv.slice(2);
const run = promisify(execFile);

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
	const { stdout } = await said("node", ["build/headless/run.mjs", file, "--stall", "600", "--player", player, "--param", `frames=${frames}`, "--param", `single=${single}`], { cwd: root, timeout: PATIENCE_MS });
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

const inFirefox = async () => hashIn(await inBrowser(firefox, script, frames, PATIENCE_MS));

const firefox = here(process.env.FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox");
const jsc = here(process.env.JSC, "/usr/bin/jsc");
const shell = process.env.AVMSHELL;
const script = await bundle(tests);
const machines = [
	["V8 (Node)", () => process.versions.v8, inNode],
	["Ruffle", () => "in Chromium", swf && (() => inPlayer(swf, "ruffle"))],
	["Adobe's VM", () => "avmshell", shell && avmSwf && (() => inPlayer(avmSwf, "avmshell")), "AVMSHELL names no folder"],
	["  single matrices", () => "avmshell", shell && avmSwf && (() => inPlayer(avmSwf, "avmshell", true)), "AVMSHELL names no folder"],
	["SpiderMonkey", () => version(firefox), firefox && inFirefox, "Debian's firefox-esr is not installed"],
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
