import http from 'node:http';
import sirv from 'sirv';

/**
 * Serves folders, each below a path of its own, and one page at `/`.
 *
 * @param {string | null} page the page's HTML, if there is one
 * @param {Record<string, string>} folders what to serve: path ('/assets', or '' for all other) to folder; the first that fits counts
 * @param {{port?: number, host?: string, headers?: Record<string, string>, isKept?: boolean}} options the port, any free one unless told; the address to
 * listen on, loopback unless told; what every answer says; whether no file changes meanwhile: then browsers keep them, and compile scripts once
 * @returns {Promise<{url: string, close: () => void}>}
 */
export async function serve(page, folders, { port = 0, host = '127.0.0.1', headers = {}, isKept = false } = {}) {
	const mounts = Object.entries(folders).map(([path, folder]) => ({
		path,
		handle: sirv(folder, isKept ? { maxAge: 86400, immutable: true } : { dev: true, etag: false }),
	}));
	const server = http.createServer((request, response) => {
		for (const [name, value] of Object.entries(headers)) {
			response.setHeader(name, value);
		}
		if (request.url === '/' && page !== null) {
			response.setHeader('Content-Type', 'text/html; charset=utf-8');
			response.end(page);
			return;
		}
		const notFound = () => {
			response.statusCode = 404;
			response.end(`nothing is served at ${request.url}`);
		};
		const mount = mounts.find(({ path }) => request.url.startsWith(path + '/'));
		if (!mount) {
			notFound();
			return;
		}
		request.url = request.url.slice(mount.path.length);
		mount.handle(request, response, notFound);
	});
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
