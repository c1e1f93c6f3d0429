/**
 * Writes the page once more, as one file that a browser opens by a double click. Browsers load no modules and fetch no files for a page
 * that no server sent, so everything is inside of it: scripts, styles, models, pictures.
 */
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";

const TYPES = { ".svg": "image/svg+xml", ".png": "image/png", ".gif": "image/gif", ".cur": "image/x-icon" };

const addressOf = (file) => `data:${TYPES[path.extname(file)]};base64,${readFileSync(file).toString("base64")}`;
const hashOf = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

/** The module in place of shared/files/served.js. */
function servedInside(out) {
	const models = Object.fromEntries(readdirSync(path.join(out, "models")).filter((file) => file.endsWith(".json")).map((file) => [path.parse(file).name, readFileSync(path.join(out, "models", file), "utf8")]));
	return `
		export const ICON = ${JSON.stringify(addressOf(path.join(out, "icon.svg")))};
		export const MEDIA = "";
		export const DOCS = null;
		const MODELS = ${JSON.stringify(models)};
		export const readModel = async (name) => MODELS[name];
		const LEVEL = "${gzipSync(readFileSync(path.join(out, "models/level.glb")), { level: 9 }).toString("base64")}";
		export const readLevel = () => new Response(new Blob([Uint8Array.from(atob(LEVEL), (letter) => letter.charCodeAt(0))]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
		export const loadRapier = null;
	`;
}

const filesInside = (out) => ({
	name: "files-inside",
	setup({ onLoad }) {
		onLoad({ filter: /shared[/\\]files[/\\]served\.js$/ }, () => ({ contents: servedInside(out), loader: "js" }));
	},
});

/** Puts the content of Blockly's pictures in place of their addresses. */
export function picturesInside(text, media) {
	const found = text.replace(/<<<PATH>>>\/([\w-]+\.\w+)/g, (_, file) => addressOf(path.join(media, file)))
		.replace(/\$\{[\w.]*pathToMedia\}([\w-]+\.svg)/g, (_, file) => addressOf(path.join(media, file)));
	if (found === text) throw new Error("Blockly is not as it was: look how it names its pictures");
	return found;
}

/**
 * Writes the file.
 *
 * @param {string} out the folder with the page as it is served
 * @param {string} name the file's name in it
 * @param {object} settings of esbuild
 */
export async function writeSingle(out, name, { plugins, ...settings }) {
	const { outputFiles: [{ text }] } = await build({ ...settings, plugins: [filesInside(out), ...plugins], format: "iife", splitting: false, metafile: false, write: false });
	// in a script element, a comment of HTML would begin there
	const script = text.replaceAll("<!--", "<\\!--");
	if (/<\/script/i.test(script)) throw new Error("the script ends its own element");
	const style = readFileSync(path.join(out, "style.css"), "utf8");
	const policy = `default-src 'none'; script-src ${hashOf(script)}; style-src ${hashOf(style)}; img-src data:; base-uri 'none'; form-action 'none'`;
	const change = (page, from, to) => {
		if (!page.includes(from)) throw new Error(`index.html has no ${from}`);
		return page.replaceAll(from, () => to);
	};
	let page = readFileSync(new URL("index.html", import.meta.url), "utf8");
	page = page.replace(/(Content-Security-Policy" content=")[^"]*/, (_, before) => before + policy);
	page = change(page, "\t<script src=\"open.js\"></script>\n", "");
	page = change(page, "\t<script type=\"module\" src=\"main.js\"></script>\n", "");
	page = change(page, "<link rel=\"stylesheet\" href=\"style.css\">", `<style>${style}</style>`);
	page = change(page, "icon.svg", addressOf(path.join(out, "icon.svg")));
	const licences = readFileSync(path.join(out, "LICENSES.txt"), "utf8").replaceAll("--", "==");
	page = change(page, "</body>", `<script>${script}</script>\n</body>`) + `<!--\n${licences}-->\n`;
	writeFileSync(path.join(out, name), page);
}
