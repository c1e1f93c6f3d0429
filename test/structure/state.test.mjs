import assert from 'node:assert/strict';
import { test } from 'node:test';
import { assertNone, codeOf, definitionIn, differences, read, sourcesBelow } from './sources.mjs';

const ROOMS = ['agents', 'broadphase', 'search', 'handlers', 'collision'];
const MOST_THINGS = 10;

const rows = (text) => [...text.matchAll(/^\|(.*)\|$/gm)].map(([, row]) => row.split('|').map((cell) => cell.trim()));
const things = read('docs/state.md');
const fields = read('docs/fields.md');

/** The fields that a class declares, static ones too; constants keep nothing. */
function fieldsOf(text) {
	return [...codeOf(text).matchAll(/^ {8}(?:public|private|protected|internal|engine) (?:static )?var (\w+)/gm)].map(([, name]) => name);
}

/** Of each class that the page lists: its fields, and the numbers of the things that it keeps. A class may have several rows. */
const listed = new Map();
for (const [name, kind, names] of rows(fields).slice(2)) {
	const at = name.replaceAll('`', '');
	const entry = listed.get(at) ?? { numbers: [], names: [] };
	assert.match(kind, /^(kept \d+|set|room)$/);
	entry.names.push(...names.split(' '));
	if (kind.startsWith('kept')) {
		entry.numbers.push(Number(kind.slice(5)));
	}
	listed.set(at, entry);
}

const sources = ROOMS.flatMap((room) => sourcesBelow(`src/starlogo/${room}`)).map((file) => [definitionIn(file).split('.').pop(), read(file)]);

test('docs/fields.md lists every field between update and the tests of two shapes, once', () => {
	const ofClass = (name, names) => names.map((field) => `${name}.${field}`);
	assertNone(sources.flatMap(([name, text]) => differences('docs/fields.md', ofClass(name, listed.get(name)?.names ?? []), ofClass(name, fieldsOf(text)))));
	assert.ok(listed.size > 30);
	const classes = new Set(sources.map(([name]) => name));
	assertNone([...listed.keys()].filter((name) => !classes.has(name)).map((name) => `there is no ${name}`));
});

test(`it tells at most ${MOST_THINGS} things that outlive a frame, and fields of each`, () => {
	const numbers = rows(things).map(([number]) => Number(number)).filter((number) => number > 0);
	assert.deepEqual(numbers, numbers.map((_, i) => i + 1));
	assert.ok(numbers.length <= MOST_THINGS);
	const used = new Set([...listed.values()].flatMap((entry) => entry.numbers));
	assert.deepEqual([...used].sort((a, b) => a - b), numbers);
});

test('agents keep nothing of colliders: no field of an agent has a type of theirs', () => {
	const text = codeOf(read('src/starlogo/agents/Agent.as'));
	const types = [...text.matchAll(/ var \w+:([\w.<>]+)/g)].map(([, type]) => type);
	assert.ok(types.length > 10);
	assertNone(types.filter((type) => !/^(Boolean|int|Number|String|Placement|PlatformLink|Turn|Matrix3D|Vector3D|Vector\.<(Number|String)>)$/.test(type)));
});
