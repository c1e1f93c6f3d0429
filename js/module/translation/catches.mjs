/** Finds which classes of errors the sources catch. The compiler drops the classes, so its output catches everything. */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT, SOURCES } from "../names.mjs";

const FOLDERS = [...SOURCES, join(ROOT, "test")];

/** For each catch in a file, in order: the error's variable and its class; null for every error. */
export function caughtIn(file, written) {
	const path = FOLDERS.map((folder) => join(folder, file.replace(/js$/, "as"))).find(existsSync);
	const source = path ? readFileSync(path, "utf8") : "";
	const caught = [...source.matchAll(/\bcatch \((\w+):([\w*]+)\)/g)].map(([, name, type]) => ({ name, type: qualified(type, source) }));
	const names = [...written.matchAll(/\bcatch \((\w+)\)/g)].map((match) => match[1]);
	if (String(names) !== String(caught.map(({ name }) => name))) throw new Error(`${file}: what it catches is not in the order of its source`);
	return caught;
}

function qualified(name, source) {
	if (/^(Error|\*)$/.test(name)) return null;
	if (/^(ArgumentError|RangeError|TypeError)$/.test(name)) return name;
	const imported = new RegExp(String.raw`^\s*import ([\w.]+\.${name});`, "m").exec(source)?.[1];
	return imported ?? `${/^package ([\w.]+)/.exec(source)[1]}.${name}`;
}
