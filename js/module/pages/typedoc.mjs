#!/usr/bin/env node
/**
 * Writes the JavaScript API's documentation as pages, from the types of the package: the same bytes everywhere.
 *
 *   node js/module/pages/typedoc.mjs bin/module bin/typedoc
 */
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { unzlibSync, zlibSync } from "fflate";
import { Application } from "typedoc";

const [from, to] = process.argv.slice(2).map((folder) => resolve(folder));
const { name, version } = JSON.parse(readFileSync(join(from, "package.json"), "utf8"));

const here = fileURLToPath(new URL(".", import.meta.url));
const app = await Application.bootstrapWithPlugins({
	name: `${name} ${version}`,
	entryPoints: ["index.d.ts", "three/index.d.ts"].map((file) => join(from, file)),
	tsconfig: join(here, "typedoc.json"),
	favicon: join(here, "../../playground/icon.svg"),
	readme: join(from, "README.md"),
	projectDocuments: [join(from, "docs/*.md")],
	// three.js's own types are not here, and the package's have been checked by its tests
	skipErrorChecking: true,
	excludePrivate: true,
	disableSources: true,
	disableGit: true,
	hideGenerator: true,
	githubPages: false,
	logLevel: "Error",
	sort: ["kind", "alphabetical"],
});
const project = await app.convert();
if (!project) throw new Error("typedoc has read nothing");
await app.generateDocs(project, to);

// zlib's output depends on the processor; fflate's does not
for (const file of readdirSync(join(to, "assets")).filter((each) => each.endsWith(".js"))) {
	const at = join(to, "assets", file);
	const text = readFileSync(at, "utf8");
	const packed = text.replace(/^(window\.\w+ = ")([A-Za-z0-9+/=]+)(")/, (_, start, data, end) =>
		start + Buffer.from(zlibSync(unzlibSync(Buffer.from(data, "base64")), { level: 9 })).toString("base64") + end);
	writeFileSync(at, packed);
}
