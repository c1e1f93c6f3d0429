/** Changes the packages that the page bundles, as esbuild reads them: Blockly and Rapier. leanthree.mjs does so for three.js. */
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { picturesInside } from "./single.mjs";

/** Where the packages are. */
export const NPM = fileURLToPath(new URL("node_modules", import.meta.url));

const STYLE = /style:"display: none;"/g;
const WARNINGS = /[\w$]+\(\s*"Blockly\.Workspace\.get\w*Variable\w*",\s*"v12",\s*"v13",\s*"[^"]+"\s*\);/g;

/**
 * Changes two things in Blockly. It sets a style attribute, which the page's policy forbids; an SVG attribute has the same effect. And it
 * writes console warnings about deprecated methods that it calls itself.
 */
export const tameBlockly = (isSingle) => ({
	name: "tame-blockly",
	setup({ onLoad, onResolve, resolve }) {
		// its keyboard plugin imports all of it
		onResolve({ filter: /^blockly$/ }, ({ kind, resolveDir }) => resolve("blockly/core", { kind, resolveDir }));
		onLoad({ filter: /blockly_compressed\.js$/ }, ({ path: file }) => {
			const styled = replaced(file, readFileSync(file, "utf8"), STYLE, 'display:"none"', "whether it needs taming");
			const tame = replaced(file, styled, WARNINGS, "", "whether it needs taming");
			return { contents: isSingle ? picturesInside(tame, path.join(NPM, "blockly/media")) : tame, loader: "js" };
		});
	},
});

/** Rapier writes a console warning about how it calls its own WebAssembly. */
export const tameRapier = {
	name: "tame-rapier",
	setup({ onLoad }) {
		onLoad({ filter: /rapier3d-compat[/\\]rapier\.mjs$/ }, ({ path: file }) => {
			const warning = /console\.warn\("using deprecated parameters for the initialization function[^"]*"\)/;
			return { contents: replaced(file, readFileSync(file, "utf8"), warning, "0", "whether it needs taming"), loader: "js" };
		});
	},
};

/** Keeps only those of Blockly's messages that bundled code names, in each language. */
export const fewMessages = {
	name: "few-messages",
	setup({ onLoad }) {
		onLoad({ filter: /blockly\/msg\/\w+\.js$/ }, ({ path: file }) => {
			const plugin = path.join(NPM, "@blockly/keyboard-navigation/src");
			const files = [path.join(NPM, "blockly/blockly_compressed.js"), ...readdirSync(plugin, { recursive: true }).filter((each) => each.endsWith(".ts")).map((each) => path.join(plugin, each))];
			const sources = files.map((each) => readFileSync(each, "utf8")).join("\n");
			const text = readFileSync(file, "utf8");
			const kept = text.replace(/^Blockly\.Msg\["(\w+)"\] = .*$/gm, (line, name) => (new RegExp(`\\b${name}\\b`).test(sources) ? line : ""));
			if (kept.length > 0.8 * text.length) throw new Error(`${file} is not as it was: look how its messages are written`);
			return { contents: kept, loader: "js" };
		});
	},
};

/**
 * A text of a package in which a pattern has been replaced.
 *
 * @param {string} file where the text is from
 * @param {string} text
 * @param {RegExp} pattern
 * @param {string | Function} by as String.replace takes it
 * @param {string} what if there is nothing to replace, another version of the package has come: where to look then
 */
export function replaced(file, text, pattern, by, what) {
	if (text.search(pattern) < 0) throw new Error(`${file} is not as it was: look ${what}`);
	return text.replace(pattern, by);
}
