import assert from 'node:assert/strict';
import { test } from 'node:test';
import { codeOf, definitionIn, read, sourcesBelow } from './sources.mjs';

const ROOMS = ['agents', 'broadphase', 'search', 'handlers', 'collision'];
const MOST_THINGS = 5;

const page = read('docs/state.md');
const rows = (text) => [...text.matchAll(/^\|(.*)\|$/gm)].map(([, row]) => row.split('|').map((cell) => cell.trim()));
const [things, fields] = page.split('## Every field');

/** The fields that a class declares, static ones too; constants keep nothing. */
function fieldsOf(text) {
	return [...codeOf(text).matchAll(/^ {8}(?:public|private|protected|internal|engine) (?:static )?var (\w+)/gm)].map(([, name]) => name);
}

/** Of each class that the page lists: its kept fields by the number of the thing, and the others. */
const listed = new Map(rows(fields).slice(2).map(([name, kept, others, room]) => {
	const numbers = kept.split(';').filter((each) => each !== '').map((each) => {
		const [, number, names] = /^\s*(\d): (.*)$/.exec(each);
		return [Number(number), names.trim().split(/\s+/)];
	});
	const words = [others, room].flatMap((cell) => cell.split(/\s+/).filter((word) => word !== ''));
	return [name.replaceAll('`', ''), { numbers, names: [...numbers.flatMap(([, names]) => names), ...words] }];
}));

const sources = ROOMS.flatMap((room) => sourcesBelow(`src/starlogo/${room}`)).map((file) => [definitionIn(file).split('.').pop(), read(file)]);

test('docs/state.md lists every field between update and the tests of two shapes, once', () => {
	const wrong = [];
	for (const [name, text] of sources) {
		const declared = fieldsOf(text).sort();
		const said = [...(listed.get(name)?.names ?? [])].sort();
		if (declared.join() !== said.join()) {
			wrong.push(`${name} declares ${declared.join(' ')}; the page has ${said.join(' ')}`);
		}
	}
	assert.equal(wrong.join('\n'), '');
	assert.ok(listed.size > 30);
	const classes = new Set(sources.map(([name]) => name));
	assert.deepEqual([...listed.keys()].filter((name) => !classes.has(name)), [], 'classes that there are not');
});

test(`it tells at most ${MOST_THINGS} things that outlive a frame, and fields of each`, () => {
	const numbers = rows(things).map(([number]) => Number(number)).filter((number) => number > 0);
	assert.deepEqual(numbers, numbers.map((_, i) => i + 1));
	assert.ok(numbers.length <= MOST_THINGS);
	const used = new Set([...listed.values()].flatMap(({ numbers: kept }) => kept.map(([number]) => number)));
	assert.deepEqual([...used].sort(), numbers);
});

test('agents keep nothing of colliders: no field of an agent has a type of theirs', () => {
	const text = ['Agent', 'AgentBody'].map((name) => codeOf(read(`src/starlogo/agents/${name}.as`))).join('\n');
	const types = [...text.matchAll(/ var \w+:([\w.<>]+)/g)].map(([, type]) => type);
	assert.ok(types.length > 10);
	assert.deepEqual(types.filter((type) => !/^(Boolean|int|Number|String|Placement|Matrix3D|Vector3D|Vector\.<(Number|String)>)$/.test(type)), []);
});
