/** The soak in a browser: one script, a page that runs it, and what it says. */
import { spawn } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import http from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";

const LOOKS_MS = 200;

const root = fileURLToPath(new URL("../..", import.meta.url));
const tools = createRequire(path.join(root, "js/module/package.json"));

/** Writes the engine, the tests and what plays the soak as one script, and gives its name. @param {string} tests what the build made of the two */
export async function bundle(tests) {
	const out = path.join(root, "bin/same/machine.js");
	mkdirSync(path.dirname(out), { recursive: true });
	await tools("esbuild").build({
		entryPoints: [path.join(root, "test/same/machine.mjs")],
		bundle: true,
		format: "iife",
		outfile: out,
		logLevel: "error",
		nodePaths: [path.join(root, "js/module/node_modules")],
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

/**
 * A browser opens a page that plays the soak.
 *
 * @param {(pid: number) => void} [onStart] is told of its process
 * @returns {Promise<string>} what the soak says in the end
 */
export async function inBrowser(command, script, frames, patience, onStart = () => {}) {
	const profile = mkdtempSync(path.join(tmpdir(), "same-"));
	let say;
	const said = new Promise((resolve, reject) => {
		say = resolve;
		setTimeout(() => reject(new Error("it has said nothing")), patience).unref();
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
		onStart(browser.pid);
		return await Promise.race([said, left]);
	} finally {
		browser.kill();
		server.close();
		server.closeAllConnections();
		await new Promise((resolve) => setTimeout(resolve, LOOKS_MS));
		rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
	}
}
