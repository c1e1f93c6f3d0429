#!/usr/bin/env node
/**
 * Serves the built playground on loopback, and prints the address.
 *
 *   node playground/serve.mjs FOLDER [PORT]
 */
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import path from "node:path";
import { pathToFileURL } from "node:url";

const TYPES = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".json": "application/json", ".png": "image/png", ".gif": "image/gif" };

/**
 * Serves a folder below a path.
 *
 * @param {string} folder what to serve
 * @param {{port?: number, below?: string}} options the port, any free one unless told; the path, "/" unless told
 * @returns {Promise<{url: string, close: () => void}>}
 */
export async function serveFolder(folder, { port = 0, below = "/" } = {}) {
	const root = path.resolve(folder);
	const server = createServer((request, response) => {
		const { pathname } = new URL(request.url, "http://localhost");
		const file = path.join(root, decodeURIComponent(pathname.slice(below.length)).replace(/\/$|^$/, "") || "index.html");
		try {
			if (!pathname.startsWith(below) || !file.startsWith(root)) throw new Error("outside");
			const content = readFileSync(file);
			response.writeHead(200, { "content-type": TYPES[path.extname(file)] ?? "application/octet-stream", "cache-control": "no-cache" }).end(content);
		} catch {
			response.writeHead(404).end("nothing is here");
		}
	});
	await new Promise((resolve, reject) => {
		server.once("error", reject);
		server.listen(port, "127.0.0.1", resolve);
	});
	return {
		url: `http://127.0.0.1:${server.address().port}${below}`,
		close: () => {
			server.close();
			server.closeAllConnections?.();
		},
	};
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
	const [folder, port] = process.argv.slice(2);
	const { url } = await serveFolder(folder, { port: Number(port ?? 0) });
	console.log(`the playground is at ${url} (stop with Ctrl+C)`);
}
