/** The package beside each version of three.js that it is tested with, as if both were installed. */
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

export const root = fileURLToPath(new URL("../..", import.meta.url));

const INSTALLED = path.join(root, "js/module/node_modules/three");
const RELEASES = path.join(root, "js/adapters/three/node_modules");
const { devDependencies } = JSON.parse(readFileSync(path.join(root, "js/adapters/three/package.json"), "utf8"));

/** Where each is installed: the one that the module is measured beside, then the last releases. */
const folders = [INSTALLED, ...Object.keys(devDependencies).filter((name) => name.startsWith("three-")).map((name) => path.join(RELEASES, name))];

/**
 * Makes a folder below which the package, this three.js and its types are installed.
 *
 * @param {string} name of the folder
 * @param {string} three where three.js is
 * @returns {string}
 */
export function install(name, three = INSTALLED) {
	const folder = path.join(root, "bin/generated/adapters", name);
	rmSync(folder, { recursive: true, force: true });
	mkdirSync(path.join(folder, "node_modules/@types"), { recursive: true });
	// a copy: from a link three.js would be looked for where it leads to
	cpSync(path.join(root, "bin/module"), path.join(folder, "node_modules/starlogo-collision"), { recursive: true });
	symlinkSync(three, path.join(folder, "node_modules/three"));
	symlinkSync(path.join(RELEASES, "@types/three"), path.join(folder, "node_modules/@types/three"));
	writeFileSync(path.join(folder, "package.json"), '{ "type": "module" }\n');
	return folder;
}

/** All of them: what each exports, with its version. */
export async function peers() {
	if (!existsSync(path.join(root, "bin/module/three"))) throw new Error("bin/module is not built: ./antw test builds it");
	const all = [];
	for (const three of folders) {
		const { version } = JSON.parse(readFileSync(path.join(three, "package.json"), "utf8"));
		const folder = install(`three-${version}`, three);
		writeFileSync(path.join(folder, "peers.mjs"), 'export * as THREE from "three";\nexport * as engine from "starlogo-collision";\nexport * as adapter from "starlogo-collision/three";\n');
		all.push({ version, folder, ...await import(pathToFileURL(path.join(folder, "peers.mjs"))) });
	}
	return all;
}
