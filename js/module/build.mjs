#!/usr/bin/env node
/**
 * Writes the npm package of the engine.
 *
 * node js/module/build.mjs TRANSPILED OUT
 *
 * TRANSPILED is the output of Apache's compiler. It may have more than the engine: only what the public classes use is taken.
 */
import { copyFileSync, cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { buildSync, transformSync } from "esbuild";
import { standinsForUsers, standinsText, translate } from "./assemble.mjs";
import { writeDeclarations } from "./types/declarations.mjs";
import { writePages } from "./pages/guide.mjs";
import { manglingOf, minified } from "./minified.mjs";
import { ROOT, moduleRoots, publicSignatures } from "./names.mjs";

const [transpiled, out] = process.argv.slice(2);
const NAME = "starlogo-collision";
const MANGLED_FOLDER = join(ROOT, "bin/generated/module");

const types = publicSignatures();
const program = translate(transpiled, types, { roots: moduleRoots(types) });
const classes = program.text();
const lost = /(?<![\w$.])\$missing\("(.*?)"\)/.exec(classes);
if (lost) throw new Error(`the engine uses ${lost[1]}, which has no stand-in`);

const { version, repository } = JSON.parse(readFileSync(join(ROOT, "package.json"), "utf8"));
const values = [...types.keys()].filter((qname) => types.get(qname).kind !== "interface").map((qname) => program.exportName(qname) ?? fail(qname));
const text = moduleText(standinsText(), classes);

rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
const readableFile = `${NAME}.js`;
const minifiedFile = `${NAME}.min.js`;
writeFileSync(join(out, readableFile), text);
// the lines have the same numbers, for the map
const productionText = moduleText(standinsForUsers(), withoutWarnings(classes));
const mangling = manglingOf(program, productionText);
const { code: minifiedCode, map } = minified(productionText, mangling, `../${readableFile}`);
mkdirSync(join(out, "maps"));
writeFileSync(join(out, "maps", `${minifiedFile}.map`), map);
writeFileSync(join(out, minifiedFile), `${minifiedCode}//# sourceMappingURL=maps/${minifiedFile}.map\n`);
// for the page, which divides it
mkdirSync(MANGLED_FOLDER, { recursive: true });
writeFileSync(join(MANGLED_FOLDER, "short.js"), transformSync(productionText, { ...mangling, format: "esm", target: "es2022" }).code);
writeFileSync(join(out, "index.d.ts"), writeDeclarations(types));
copyFileSync(join(ROOT, "LICENSE"), join(out, "LICENSE"));
copyFileSync(join(ROOT, "js/module/cook.mjs"), join(out, "cook.mjs"));
copyFileSync(join(ROOT, "js/standins/module/warnings/spelling.mjs"), join(out, "spelling.mjs"));
writePages(out);
writeFileSync(join(out, "CHANGELOG.md"), newestChanges(readFileSync(join(ROOT, "CHANGELOG.md"), "utf8")));
copyFileSync(join(ROOT, "js/module/picture.svg"), join(out, "picture.svg"));
cpSync(join(ROOT, "js/adapters/three"), join(out, "three"), { recursive: true, filter: (file) => /(?:\.js|\.d\.ts|^three)$/.test(basename(file)) });
cpSync(join(ROOT, "js/adapters/nova"), join(out, "nova"), { recursive: true, filter: (file) => /(?:\.js|\.d\.ts|^nova)$/.test(basename(file)) });
// the adapter and the engine as a classic script
buildSync({
	entryPoints: [join(out, "nova/index.js")],
	outfile: join(out, "nova.js"),
	alias: { [NAME]: resolve(out, minifiedFile) },
	bundle: true,
	minify: true,
	format: "iife",
	globalName: "StarLogoCollision",
	target: "es2022",
	legalComments: "inline",
});
// last, because with this file the package counts as made
writeFileSync(join(out, "package.json"), `${JSON.stringify(manifest(), null, 2)}\n`);
console.log(`written: ${out} (${Math.round(minifiedCode.length / 1024)} KB minified); in a project's folder: npm install $(npm pack ${resolve(out)})`);

/**
 * The text without Flash's error numbers (the engine itself removes those of streams), and with escapes for characters that make tools
 * treat the file as binary.
 */
function cleaned(code) {
	return code.replaceAll(/(["`])Error #\d{4}: (?!Stream)/g, "$1")
		.replaceAll(/[\0-\x08\x0b-\x1f]/g, (control) => `\\x${control.charCodeAt(0).toString(16).padStart(2, "0")}`);
}

/** Code that warns of nothing, with as many lines. What a warning alone depends on goes too. */
function withoutWarnings(code) {
	const warning = String.raw`\t*\$(?:warn\w*|refuse\w+)\(.*\);`;
	return code.replaceAll(new RegExp(`^\\t*if \\(.*\\) \\{\n${warning}\n\\t*\\}$`, "gm"), "\n\n").replaceAll(new RegExp(`^${warning}$`, "gm"), "");
}

/** The changes of the newest version, or those since it. The project's changelog has those of all. */
function newestChanges(changelog) {
	const [head, newest] = changelog.split(/^(?=## )/m);
	const since = newest.startsWith("## Unreleased") ? `This package is newer than ${version}, whose number it has until the next release.\n\n` : "";
	return `${head}${since}${newest}Older versions are in the project's CHANGELOG.md.\n`;
}

/** The whole module, with some text of the stand-ins and of the classes. */
function moduleText(standins, code) {
	return cleaned(`/*! ${NAME} ${version}, MIT */
${standins}
${code}
export {
	${[...values, "ArgumentError", "ByteArray"].sort().join(",\n\t")}
};
`);
}

function fail(qname) {
	throw new Error(`${qname} is public, but was not compiled`);
}

function manifest() {
	const engine = { types: "./index.d.ts", node: `./${readableFile}`, development: `./${readableFile}`, default: `./${minifiedFile}` };
	return {
		name: NAME,
		version,
		description: "The collision engine of StarLogo Nova: which agents of a game have collided, exactly, as they move, and what is near",
		license: "MIT",
		keywords: ["collision-detection", "collision", "broadphase", "spatial-query", "raycast", "bounding-volume", "bvh",
			"continuous-collision", "game", "3d", "starlogo"],
		homepage: "https://www.slnova.org/",
		...(repository ? { repository } : {}),
		type: "module",
		sideEffects: false,
		engines: { node: ">=18" },
		types: "./index.d.ts",
		exports: {
			".": engine,
			"./readable": { types: "./index.d.ts", default: `./${readableFile}` },
			"./package.json": "./package.json",
			"./three": { types: "./three/index.d.ts", default: "./three/index.js" },
			"./nova": { types: "./nova/index.d.ts", default: "./nova/index.js" },
		},
		peerDependencies: { three: ">=0.180.0" },
		peerDependenciesMeta: { three: { optional: true } },
		bin: { "starlogo-cook": "./cook.mjs" },
		files: ["*.js", "*.mjs", "*.d.ts", "*.md", "*.svg", "docs", "maps", "three", "nova"],
	};
}
