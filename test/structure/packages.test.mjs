import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { assertNone, codeOf, definitionIn, importsIn, layout, packageOf, read, root, sourcesBelow, usesIn } from './sources.mjs';

const MOST_LINES = 450;
const REASON = 'This file is long because';

const order = layout().get('src/starlogo');
const sources = new Map(sourcesBelow('src').map((file) => [definitionIn(file), file]));
const tests = sourcesBelow('test').map(definitionIn);
const uses = new Map([...sources].map(([name, file]) => [name, usesIn(name, read(file), sources.keys())]));

/** A package's place in CONTRIBUTING.md's list. The files of package starlogo but for the namespace stand for GreatLand. */
function placeOf(name) {
	const [, room, ...rest] = name.split('.');
	return order.indexOf(rest.length > 0 ? room : room === 'engine' ? 'engine.as' : 'GreatLand.as');
}

const isEngine = (name) => name.startsWith('starlogo.');
const isClient = (name) => name === 'Client' || name.startsWith('client.');
const mayUseAway3d = (name) => name.startsWith('starlogo.away3d.') || isClient(name);

test('no source has a character that nobody sees: a pattern says \\s, and a text \\uFEFF', () => {
	assertNone([...sourcesBelow('src'), ...sourcesBelow('js')].filter((file) => /[\u00AD\u200B-\u200F\u2028-\u202E\u2060\uFEFF]/.test(read(file))));
});

test('the engine has files, and they use one another', () => {
	assert.ok([...sources.keys()].filter(isEngine).length > 80);
	assert.ok([...uses.values()].flat().length > 500);
});

test('a room of the engine, with its folders, depends only on those above it in CONTRIBUTING.md\'s list', () => {
	const wrong = [];
	for (const [name, used] of uses) {
		for (const other of isEngine(name) ? used : []) {
			if (!isEngine(other) || placeOf(name) < 0 || placeOf(other) < 0 || placeOf(other) > placeOf(name)) {
				wrong.push(`${name} uses ${other}`);
			}
		}
	}
	assertNone(wrong);
});

test('only a class itself writes its static variables: where a module writes those of another, both are loaded wherever one is', () => {
	const wrong = [];
	for (const [name, file] of sources) {
		for (const [write, before, after] of codeOf(read(file)).matchAll(/(?:\+\+|--)([A-Z]\w*)\.\w+|(?<![\w.])([A-Z]\w*)\.\w+ *(?:\+\+|--|[-+*/|&]?=(?!=))/g)) {
			if (!name.endsWith(`.${before ?? after}`)) wrong.push(`${name} has ${write}`);
		}
	}
	assertNone(wrong);
});

test('no two packages outside of the engine depend on each other', () => {
	const arrows = new Map();
	for (const [name, used] of [...uses].filter(([each]) => !isEngine(each))) {
		for (const other of used.filter((each) => packageOf(each) !== packageOf(name))) {
			arrows.set(`${packageOf(name)} > ${packageOf(other)}`, `${name} uses ${other}`);
		}
	}
	const both = [...arrows].filter(([arrow]) => arrows.has(arrow.split(' > ').reverse().join(' > '))).map(([, use]) => use);
	assertNone(both);
});

test('src uses nothing of test', () => {
	const onlyInTest = tests.filter((name) => !sources.has(name));
	const wrong = [];
	for (const [name, file] of sources) {
		const text = read(file);
		const isKnown = (each) => sources.has(each) || each.startsWith('flash.') || (mayUseAway3d(name) && each.startsWith('away3d.'));
		wrong.push(...importsIn(text).filter((each) => !isKnown(each)).map((each) => `${name} imports ${each}`));
		wrong.push(...usesIn(name, text, onlyInTest).map((each) => `${name} uses ${each}`));
	}
	assertNone(wrong);
});

test('no script outside of test imports one of test', { skip: !existsSync(path.join(root, '.git')) && 'this is no repository' }, () => {
	const scripts = execFileSync('git', ['ls-files', '*.mjs', '*.js'], { cwd: root, encoding: 'utf8' }).trim().split('\n').filter((file) => !file.startsWith('test/'));
	assert.ok(scripts.length > 150);
	const wrong = scripts.filter((file) => /\b(?:from|import) ?\(?["'](?:\.\.\/)+test\//.test(read(file)));
	assertNone(wrong);
});

test('no file of the engine declares a function outside of its package: it would be looked up by name in every call', () => {
	const outside = (text) => /^(?:\w+ )?function \w+/m.exec(codeOf(text))?.[0];
	assert.equal(outside('package a\n{\n    function b():void\n    {\n    }\n}\n\nfunction c():void\n{\n}\n'), 'function c');
	const wrong = [...sources].filter(([name]) => isEngine(name)).flatMap(([name, file]) => {
		const found = outside(read(file));
		return found ? [`${name}: ${found}`] : [];
	});
	assertNone(wrong);
});

test('the engine but for the adapters does not name Away3D', () => {
	const wrong = [...sources].filter(([name, file]) => !mayUseAway3d(name) && /away3d/i.test(codeOf(read(file))));
	assertNone(wrong.map(([name]) => name));
	assert.ok([...sources].some(([name, file]) => mayUseAway3d(name) && /away3d/.test(codeOf(read(file)))));
});

test('the client in small uses public names alone', () => {
	const wrong = [...sources].filter(([name, file]) => isClient(name) && /\bengine\b/.test(codeOf(read(file))));
	assertNone(wrong.map(([name]) => name));
	assert.ok([...sources.keys()].some(isClient));
});

/** The comment that a file begins with, before its package: whoever reads the documentation does not see it. */
function headOf(text) {
	return /^(?:\/\/.*\n)*/.exec(text)[0].replace(/\s*\n\/\/\s*/g, ' ');
}

test(`a file of the engine has at most ${MOST_LINES} lines, or a comment before its package says why not ("// ${REASON} ...")`, () => {
	assert.ok(headOf(`// Of rows. ${REASON.slice(0, 12)}\n// ${REASON.slice(13)} of loops.\npackage a\n`).includes(REASON));
	assert.equal(headOf(`package a\n{\n    /** ${REASON} of loops. */\n`), '');
	const wrong = [];
	for (const [name, file] of [...sources].filter(([each]) => isEngine(each))) {
		const text = read(file);
		const lines = text.split('\n').length - 1;
		if (lines > MOST_LINES && !headOf(text).includes(REASON)) {
			wrong.push(`${name}: ${lines} lines`);
		}
	}
	assertNone(wrong);
});

test('no documentation tells its readers how long its file is', () => {
	const comments = (text) => text.match(/\/\*\*[^]*?\*\//g) ?? [];
	const isWrong = (file) => comments(read(file)).some((comment) => /\bthis file is long\b/i.test(comment.replace(/\s*\n\s*\*\s*/g, ' ')));
	assertNone([...sources.values(), ...sourcesBelow('js/standins')].filter(isWrong));
});

test('the engine leaves no function open to the player: sines and the like come from Trigonometry', () => {
	const open = /\bMath\.(sin|cos|tan|asin|acos|atan|atan2|exp|log|pow|random)\b/;
	const wrong = [...sources].filter(([name, file]) => isEngine(name) && open.test(codeOf(read(file))));
	assertNone(wrong.map(([name]) => name));
});

test('constants that are named are there: in JavaScript a misspelt one is no error', () => {
	const classes = new Map([...sources].filter(([name]) => isEngine(name)).map(([name, file]) => [name.split('.').at(-1), read(file)]));
	const missing = [...sourcesBelow('src'), ...sourcesBelow('test')].flatMap((file) => [...codeOf(read(file)).matchAll(/(?<![\w.])([A-Z]\w*)\.([A-Z][A-Z_\d]+)\b/g)]
		.filter(([, name, constant]) => classes.has(name) && !new RegExp(`\\b${constant}\\b`).test(classes.get(name))).map(([use]) => `${file}: ${use}`));
	assertNone(missing);
});

test('a list grows from its first entry on: Flash throws for an entry past the end, and a = b = 0 sets b first', () => {
	const wrong = sourcesBelow('src').filter((file) => {
		const code = codeOf(read(file));
		return !code.includes(', true)') && [...code.matchAll(/\b(\w+)\[(\d+)\] = \1\[(\d+)\] = /g)].some(([, , first, second]) => Number(second) > Number(first));
	});
	assertNone(wrong);
});

test('ASDoc does not show what only a package sees: it leaves out internal classes by itself, functions if they are @private', () => {
	const shown = sourcesBelow('src').filter((file) => /^ {4}internal function/m.test(read(file)) && !read(file).includes('@private'));
	assertNone(shown);
});
