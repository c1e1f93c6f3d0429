import http from 'node:http';
import sirv from 'sirv';

/**
 * Serves folders, each below a path of its own, and one page at `/`.
 *
 * @param {string | null | ((path: string) => string | null)} page the page's HTML, if there is one; or what finds the page at a path
 * @param {Record<string, string | string[]>} folders what to serve: path ('/assets', or '' for all other) to folder; the first path
 *     that fits counts, and of its folders the first that has the file
 * @param {{port?: number, host?: string, headers?: Record<string, string>, isKept?: boolean}} options the port, any free one unless
 *     told; the address to listen on, loopback unless told; what every answer says; whether no file changes meanwhile: then browsers
 *     keep them, and compile scripts once
 * @returns {Promise<{url: string, close: () => void}>}
 */
export async function serve(page, folders, { port = 0, host = '127.0.0.1', headers = {}, isKept = false } = {}) {
	const pageAt = typeof page === 'function' ? page : (path) => (path === '/' ? page : null);
	const settings = isKept ? { maxAge: 86400, immutable: true } : { dev: true, etag: false };
	const mounts = Object.entries(folders).map(([path, below]) => ({ path, handlers: [below].flat().map((folder) => sirv(folder, settings)) }));
	const server = http.createServer((request, response) => {
		for (const [name, value] of Object.entries(headers)) {
			response.setHeader(name, value);
		}
		const { url } = request;
		const html = pageAt(url.replace(/[?#].*/, ''));
		if (html !== null) {
			response.setHeader('Content-Type', 'text/html; charset=utf-8');
			response.end(html);
			return;
		}
		const { path, handlers } = mounts.find((mount) => url.startsWith(mount.path + '/')) ?? { path: '', handlers: [] };
		request.url = url.slice(path.length);
		const tryNext = ([handle, ...others]) => {
			if (handle) {
				handle(request, response, () => tryNext(others));
				return;
			}
			response.statusCode = 404;
			response.end(`nothing is served at ${url}`);
		};
		tryNext(handlers);
	});
	// no idle connection is closed: one that a busy client of this process uses again at that moment would be reset
	server.keepAliveTimeout = 0;
	await new Promise((resolve, reject) => {
		server.once('error', reject);
		server.listen(port, host, resolve);
	});
	return {
		url: `http://${host === '0.0.0.0' || host === '::' ? '127.0.0.1' : host}:${server.address().port}/`,
		close: () => {
			server.close();
			server.closeAllConnections?.();
		},
	};
}
