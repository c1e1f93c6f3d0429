/** The playground's modules without a page, and the engine's models for their worlds. */
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { root } from './browser.mjs';

const manifest = path.join(root, 'bin/module/package.json');
if (!existsSync(manifest)) throw new Error('bin/module is not built: ./antw module builds it');

const { buildSync } = createRequire(path.join(root, 'js/playground/package.json'))('esbuild');
const MODULES = ['play/game/world.js', 'play/game/moves.js', 'play/builtin/examples.js', 'play/builtin/games.js', 'play/game/program.js', 'play/blocks/blocks.js', 'play/programs/shelf.js', 'play/programs/programtext.js', 'play/programs/finder.js', 'play/builtin/builtin.js', 'play/builtin/lessons.js', 'play/export/javascript.js', 'teach/solutions.js', 'shared/language.js', 'shared/drawing/colours.js', 'shared/files/generatedmodels.js'];
const FILES = ['bear.obj', 'seagull.dae', 'fireman.dae', 'dragon.dae', 'person.dae', 'fortress.obj', 'spaceship.obj', 'kelp.obj', 'tree.obj'];
const folder = path.join(root, 'bin/generated');

/** Writes a file of this folder in one go, because another process may read it meanwhile. */
function write(name, text) {
	const file = path.join(folder, name);
	writeFileSync(`${file}.${process.pid}`, text);
	renameSync(`${file}.${process.pid}`, file);
	return file;
}

mkdirSync(folder, { recursive: true });
const { exports } = JSON.parse(readFileSync(manifest, 'utf8'));
const from = (file) => JSON.stringify(path.join(root, 'js/playground', file));
// words come before what is made of them
const english = write('english.mjs', `import { texts } from ${from('languages/en.js')};\nimport { texts as further } from ${from('languages/game/en.js')};\nimport { addWords } from ${from('shared/language.js')};\naddWords(texts);\naddWords(further);\n`);
const { outputFiles: [{ text }] } = buildSync({
	stdin: { contents: [`import ${JSON.stringify(english)};`, ...MODULES.map((file) => `export * from "./${file}";`), 'import "./play/game/lateengine.js";', 'export * as notation from "./play/builtin/notation.js";', 'export * from "starlogo-collision";'].join('\n'), resolveDir: path.join(root, 'js/playground') },
	bundle: true, format: 'esm', write: false, logLevel: 'warning', nodePaths: [path.join(root, 'js/playground/node_modules')],
	alias: { 'starlogo-collision/three': path.join(root, 'bin/module', exports['./three'].default), 'starlogo-collision': path.join(root, 'bin/module', exports['.'].default) },
});

/** What the modules export, with the engine's names; notation has the functions for programs. */
export const parts = await import(pathToFileURL(write('playground-world.mjs', text)));

/** The turtle and the wall, which are made by the page. */
export const made = new Map(Object.entries(parts.MADE).map(([name, make]) => [name, make()]));

/** The models of all shapes that programs have, by their names. */
export const models = new Map([...made, ['sphere', parts.BuiltInModel.sphere()], ['cube', parts.BuiltInModel.cube()], ['cylinder', parts.BuiltInModel.cylinder()], ...FILES.map((file) => {
	const [name] = file.split('.');
	const bytes = new Uint8Array(readFileSync(path.join(root, 'assets', file)));
	return [name, file.endsWith('.obj') ? parts.ObjModel.fromBytes(name, bytes) : parts.ColladaModel.fromBytes(name, bytes)];
})]);

/** A land of all these models. */
export function makeLand() {
	const greatLand = new parts.GreatLand();
	for (const model of models.values()) greatLand.addModel(model);
	return greatLand;
}
