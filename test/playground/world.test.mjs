/** The worlds that programs of the playground move, without a page. */
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { deflateRawSync } from 'node:zlib';
import { models } from '../../assets/generator/models/index.mjs';
import { palette } from '../../assets/generator/palette.mjs';
import { flatten } from '../../assets/generator/scene.mjs';
import { root } from './browser.mjs';
import { made, makeLand, models as shapes, parts } from './parts.mjs';

const { number, chain, program, start, each, create, move: forward } = parts.notation;
const inside = (...blocks) => ({ DO: parts.notation.inside(...blocks) });
const greatLand = makeLand();
const value = (type, fields, inputs) => ({ block: { type, fields, inputs } });

/** A world after some frames of a program. */
function played(state, frames, system) {
	const world = new parts.World(greatLand);
	world.begin(system ? { ...state, system } : state);
	for (let i = 0; i < frames; i++) {
		world.step();
	}
	return world;
}

test('the same program plays the same game', () => {
	const places = () => played(parts.GAMES.paintball, 100).agents.map(({ x, y, heading }) => `${x} ${y} ${heading}`).join();
	assert.equal(places(), places());
});

test('no field of a game\'s agents hides one of the engine\'s', () => {
	const [agent] = played(parts.GAMES.paintball, 1).agents;
	const engine = Object.getOwnPropertyNames(parts.Agent.prototype);
	assert.deepEqual(Object.keys(agent).filter((name) => engine.includes(name)), []);
	assert.equal(agent.color, parts.OWN_COLOURS);
});

test('another seed plays another game, and frames that are rewound have the same numbers again', () => {
	const places = ({ agents }) => agents.map(({ x, y, heading }) => `${x} ${y} ${heading}`).join();
	const from = (seed) => {
		const world = new parts.World(greatLand);
		world.begin(parts.GAMES.paintball, seed);
		for (let i = 0; i < 60; i++) world.step();
		return world;
	};
	const [first, again, other] = [from(7), from(7), from(8)];
	assert.equal(places(first), places(again));
	assert.notEqual(places(first), places(other));
	first.history.show(30);
	for (let i = 0; i < 30; i++) first.step();
	assert.equal(places(first), places(again));
});

test('a breed collides along its way whenever its agents come: “collide along the way” stands before “create”', () => {
	const sweep = (WHO, ON) => ({ type: 'starlogo_sweep', fields: { WHO, ON } });
	const world = played(program(
		start(sweep('balls', 'on'), create(1, 'balls', 'sphere'), create(1, 'walls', 'wall'), sweep('old', 'off')),
		each('walls', { type: 'starlogo_hatch', fields: { BREED: 'balls', SHAPE: 'sphere' } }, { type: 'starlogo_become', fields: { WHO: 'me', BREED: 'balls' } }),
		{ type: 'starlogo_timer', fields: { BREED: 'balls' }, inputs: { SECONDS: number(0.1), ...inside({ type: 'starlogo_become', fields: { WHO: 'me', BREED: 'old' } }) } },
	), 0);
	assert.deepEqual(world.agents.map(({ breed, sweeps }) => [breed, sweeps]), [['balls', true], ['walls', false]]);
	world.step();
	assert.deepEqual(world.agents.map(({ breed, sweeps }) => [breed, sweeps]), [['balls', true], ['balls', true], ['balls', true]]);
	for (let i = 0; i < 6; i++) world.step();
	assert.deepEqual(world.agents.map(({ breed, sweeps }) => [breed, sweeps]), Array(3).fill(['old', false]));
});

test('a key is named after what it does, also within a condition', () => {
	const name = (...blocks) => parts.keysOf(program({ type: 'starlogo_key', fields: { KEY: 'space', MODE: 'pressed', BREED: 'bears' }, inputs: inside(...blocks) })).get('space');
	const throwing = { type: 'starlogo_hatch', fields: { BREED: 'paintballs', SHAPE: 'sphere' } };
	const condition = (...blocks) => ({ type: 'controls_if', inputs: { IF0: value('starlogo_on_ground'), DO0: parts.notation.inside(...blocks) } });
	assert.equal(name(throwing), 'throw');
	assert.equal(name(condition(throwing)), 'throw');
	assert.equal(name({ type: 'math_change', fields: { VAR: { id: 'n' } }, inputs: { DELTA: number(1) } }, condition({ type: 'starlogo_up', inputs: { STEPS: number(1) } })), 'up');
	assert.equal(name(condition()), 'space');
	assert.equal(name({ type: 'starlogo_become', fields: { WHO: 'me', BREED: 'old' } }), 'become');
});

test('every block of the toolbox has a meaning', () => {
	const world = new parts.World(greatLand);
	const types = parts.TOOLBOX.contents.flatMap(({ contents = [] }) => contents).map(({ type }) => type);
	assert.ok(types.length > 30);
	for (const type of types) {
		const { fields = {}, output, isHat } = described(type);
		const block = { type, id: type, fields };
		const top = isHat ? block : start(output ? { type: 'starlogo_size', id: 'size', inputs: { SIZE: { block } } } : block);
		assert.doesNotThrow(() => parts.compile(program(top), world), type);
		assert.equal(parts.compile(program(top), world).length, 1, type);
	}
});

/** What a block is: the playground's by its definition, Blockly's own by name. */
function described(type) {
	const own = parts.DEFINITIONS.find((each) => each.type === type);
	const isValue = own ? 'output' in own : /^(math|logic)_/.test(type);
	const fields = { OP: 'ADD', NUM: 1, BOOL: 'TRUE' };
	for (const { type: kind, name, options } of own?.args0 ?? []) {
		if (kind === 'field_dropdown') {
			[[, fields[name]]] = options;
		}
	}
	return { fields, output: isValue, isHat: own !== undefined && !('previousStatement' in own) && !isValue };
}

test('loops, conditions, variables and arithmetic', () => {
	const get = value('variables_get', { VAR: { id: 'n' } });
	const state = program(start(
		{ type: 'controls_repeat_ext', inputs: { TIMES: number(5), ...inside({ type: 'math_change', fields: { VAR: { id: 'n' } }, inputs: { DELTA: number(2) } }) } },
		{ type: 'controls_if', extraState: { elseIfCount: 1, hasElse: true }, inputs: {
			IF0: value('logic_compare', { OP: 'LT' }, { A: get, B: number(10) }), DO0: { block: create(1, 'walls', 'wall') },
			IF1: value('logic_operation', { OP: 'AND' }, { A: value('logic_boolean', { BOOL: 'TRUE' }), B: value('logic_compare', { OP: 'EQ' }, { A: get, B: number(10) }) }),
			DO1: { block: create(3, 'bears', 'bear', { type: 'starlogo_size', inputs: { SIZE: value('math_arithmetic', { OP: 'DIVIDE' }, { A: get, B: number(4) }) } }) },
			ELSE: { block: create(1, 'turtles', 'turtle') },
		} },
	));
	assert.deepEqual(played(state, 0).agents.map(({ breed, size }) => [breed, size]), Array(3).fill(['bears', 2.5]));
});

test('keys that are held, pressed, and timers', () => {
	const key = (KEY, MODE, ...blocks) => ({ type: 'starlogo_key', fields: { KEY, MODE, BREED: 'bears' }, inputs: inside(...blocks) });
	const up = { type: 'starlogo_up', inputs: { STEPS: number(1) } };
	const world = played(program(start(create(1, 'bears', 'bear')), key('up', 'held', forward(1)), key('space', 'pressed', up),
		{ type: 'starlogo_timer', fields: { BREED: 'bears' }, inputs: { SECONDS: number(0.5), ...inside({ type: 'starlogo_size', inputs: { SIZE: number(3) } }) } }), 0);
	const [bear] = world.agents;
	world.input.press('up');
	world.input.press('space');
	for (let i = 0; i < 3; i++) {
		world.step();
	}
	assert.deepEqual([bear.x, bear.z, bear.size], [3, 1, 1]);
	world.input.release('up');
	for (let i = 0; i < 27; i++) {
		world.step();
	}
	assert.deepEqual([bear.x, bear.size], [3, 3]);
});

test('a message is received in the next frame, by those of a breed who are there then; agents have variables of their own', () => {
	const own = (type, NAME, inputs) => ({ type, fields: { NAME }, inputs });
	const state = program(
		start(create(2, 'bears', 'bear', own('starlogo_own_set', 'lives', { VALUE: number(3) })), create(1, 'walls', 'wall'), { type: 'starlogo_own_show', fields: { NAME: 'lives', ON: 'on' } }, { type: 'starlogo_broadcast', fields: { MESSAGE: 'go' } }),
		{ type: 'starlogo_receive', fields: { MESSAGE: 'go', BREED: 'bears' }, inputs: inside(own('starlogo_own_change', 'lives', { DELTA: number(-1) }), { type: 'starlogo_broadcast', fields: { MESSAGE: 'gone' } }) },
		{ type: 'starlogo_receive', fields: { MESSAGE: 'gone', BREED: 'anyone' }, inputs: inside({ type: 'starlogo_size', inputs: { SIZE: value('starlogo_own', { NAME: 'lives' }) } }, { type: 'starlogo_up', inputs: { STEPS: number(1) } }) },
	);
	const bears = (world) => world.agents.slice(0, 2).map(({ own: { lives }, z }) => [lives, z]);
	const world = new parts.World(greatLand);
	world.begin(program(...state.blocks.blocks.slice(0, 2)));
	assert.deepEqual(bears(world), [[3, 0], [3, 0]]);
	world.step();
	assert.deepEqual([bears(world), world.agents[2].own], [[[2, 0], [2, 0]], {}]);
	world.step();
	assert.deepEqual(bears(world), [[2, 0], [2, 0]], 'it is received once');
	world.history.show(1);
	world.step();
	assert.deepEqual([bears(world), world.shownVariables], [[[2, 0], [2, 0]], ['lives']], 'the same again after going back');
	world.begin(program(...state.blocks.blocks.map((block, i) => (i === 0 ? { ...block, inputs: inside(create(2, 'bears', 'bear', own('starlogo_own_set', 'lives', { VALUE: number(3) })), { type: 'starlogo_broadcast', fields: { MESSAGE: 'go' } }) } : block))));
	world.step();
	world.step();
	assert.deepEqual(world.agents.map(({ size, z }) => [size, z]), [[2, 1], [2, 1]]);
	const text = parts.javascriptOf(state, 'messages', made);
	for (const line of ['me.own.lives = (me.own.lives ?? 0) + -1;', 'broadcast("go");', 'whenReceiving("gone", Collision.ANY_BREED, ', 'received = messages;']) assert.ok(text.includes(line), line);
	assert.ok(!parts.javascriptOf(program(start(create(1, 'bears', 'bear'))), 'none', made).includes('messages'));
});

test('the ground is raised at places, and a place outside of it is an error that names the block', () => {
	const raise = (x, y, by) => ({ type: 'starlogo_raise', id: `at ${x}`, inputs: { HEIGHT: number(by), X: number(x), Y: number(y) } });
	const world = played(program(start(raise(2, 3, 2), raise(2, 3, -0.5))), 0);
	assert.deepEqual([world.hills.heightAt(2, 3), world.hills.heightAt(4, 3)], [1.5, 0]);
	assert.throws(() => played(program(start(raise(50, 0, 1))), 0), { block: 'at 50', message: /"raise the ground" cannot build here/ });
	assert.match(parts.javascriptOf(program(start(raise(2, 3, 2))), 'ground', made), /terrain\.raiseWall\(2, 3, 2\);/);
});

test('touches start and end; the one in the middle is a collision', () => {
	const colours = (breed, type, name) => ({ type, fields: { BREED: 'paintballs', OTHER: breed }, inputs: inside({ type: 'starlogo_colour', fields: { WHO: 'collidee' }, inputs: { COLOUR: value('starlogo_pick', { COLOUR: name }) } }) });
	const world = played(program(
		start(create(1, 'walls', 'wall'), create(1, 'paintballs', 'sphere', { type: 'starlogo_size', inputs: { SIZE: number(0.2) } }, forward(-1))),
		each('paintballs', forward(0.25)), colours('walls', 'starlogo_touch_start', 'red'), colours('walls', 'starlogo_touch_end', 'green')), 0);
	const seen = [];
	for (let i = 0; i < 8; i++) {
		world.step();
		seen.push(world.agents[0].color);
	}
	const [grey, red, green] = [seen[0], 0xe5484d, 0x46a758];
	assert.deepEqual([...new Set(seen)], [grey, red, green]);
});

test('too many agents, and blocks that are about nobody, are errors that name the block', () => {
	assert.throws(() => played(program(start({ ...create(5000, 'bears', 'bear'), id: 'many' })), 0), { block: 'many', message: /^there are 2000 agents already/ });
	assert.throws(() => played(program(start({ ...forward(1), id: 'lost' })), 0), { block: 'lost', message: /the block “forward” is about an agent/ });
	const paint = { type: 'starlogo_colour', id: 'who', fields: { WHO: 'collidee' }, inputs: { COLOUR: value('starlogo_pick', { COLOUR: 'red' }) } };
	assert.throws(() => played(program(start(create(1, 'bears', 'bear', paint))), 0), { block: 'who', message: /^the block “set colour of … to” uses the collidee/ });
});

test('nested endless loops name the inner one', () => {
	const always = value('logic_boolean', { BOOL: 'TRUE' });
	const inner = { type: 'controls_whileUntil', id: 'inner', fields: { MODE: 'WHILE' }, inputs: { BOOL: always } };
	const outer = { type: 'controls_whileUntil', id: 'outer', fields: { MODE: 'WHILE' }, inputs: { BOOL: always, ...inside(inner) } };
	assert.throws(() => played(program(start(outer)), 0), { block: 'inner' });
});

/** A bear that keys move, and that goes back where it touches a wall. */
const walker = (...walls) => program(
	start(create(1, 'bears', 'bear'), ...walls),
	...[['up', forward(0.12)], ['down', forward(-0.08)], ...['left', 'right'].map((DIRECTION) => [DIRECTION, { type: 'starlogo_turn', fields: { DIRECTION }, inputs: { DEGREES: number(3) } }])]
		.map(([KEY, block]) => ({ type: 'starlogo_key', fields: { KEY, MODE: 'held', BREED: 'bears' }, inputs: inside(block) })),
	{ type: 'starlogo_collision', fields: { BREED: 'bears', OTHER: 'walls' }, inputs: inside({ type: 'starlogo_back' }) },
);
const sized = (size) => ({ type: 'starlogo_size', inputs: { SIZE: number(size) } });
const go = (x, y, z) => ({ type: 'starlogo_go', inputs: { X: number(x), Y: number(y), Z: number(z) } });
const hold = (world, key, frames) => {
	world.input.releaseAll();
	world.input.press(key);
	for (let i = 0; i < frames; i++) {
		world.step();
	}
	world.input.releaseAll();
};

test('who goes back from a wall never gets stuck in it', () => {
	const world = played(walker(create(5, 'walls', 'wall', { type: 'starlogo_scatter' }, sized(4))), 0);
	const bear = world.agents.find(({ breed }) => breed === 'bears');
	const keys = ['up', 'left', 'up', 'down', 'right'];
	let touched = 0;
	for (let i = 0; i < 4000; i++) {
		if (i % 40 === 0) {
			world.input.releaseAll();
			world.input.press(keys[Math.floor(world.random() * keys.length)]);
		}
		world.step();
		touched += bear.before.every((each, k) => each === [bear.x, bear.y, bear.z, bear.heading][k]) ? 1 : 0;
	}
	assert.ok(touched > 20, `walls were met in ${touched} frames`);
	assert.ok(touched < 3000, `stuck for ${touched} frames`);
});

test('after a change of the collision system at a wall, the bear turns, backs off, and goes no deeper', () => {
	const world = played(walker(create(1, 'walls', 'wall', sized(9), go(2.5, 1.5, 0))), 0, 'exact');
	const [bear] = world.agents;
	bear.size = 2;
	bear.heading = 40;
	hold(world, 'up', 60);
	const at = bear.x;
	assert.ok(at > 0.3 && at < 2.4, `the bear is at the wall: ${at}`);
	world.useSystem('tightest fits');
	world.step();
	assert.ok(world.collisions.collision.statistics.collisions > 0, 'as boxes they overlap');
	hold(world, 'up', 30);
	assert.ok(bear.x <= at + 1e-9, 'it goes no deeper');
	const { heading } = bear;
	hold(world, 'left', 10);
	assert.notEqual(bear.heading, heading);
	hold(world, 'down', 40);
	assert.ok(bear.x < at - 0.5, `it is free: ${bear.x}`);
	assert.equal(world.collisions.collision.statistics.collisions, 0);
});

test('however far an agent goes, it stays on the ground and comes in on the other side', () => {
	for (const steps of [100, -1000, 24 * 7 + 1]) {
		const [{ x, y }] = played(program(start(create(1, 'bears', 'bear', forward(steps)))), 0).agents;
		assert.ok(Math.abs(x) <= parts.HALF_WIDTH && y === 0, `${steps}: ${x}`);
		assert.ok(Math.abs((((x - steps) % 24) + 24) % 24) < 1e-9 || Math.abs((((x - steps) % 24) + 24) % 24 - 24) < 1e-9, `${steps}: ${x}`);
	}
});

test('all that touch are counted and listed, whoever has scripts', () => {
	const walk = program(start(create(1, 'turtles', 'turtle', go(-2, 0, 0)), create(1, 'walls', 'wall', sized(3))), each('turtles', forward(0.1)));
	const world = played(walk, 0);
	let touching = 0;
	for (let i = 0; i < 60; i++) {
		world.step();
		touching += world.collisions.collision.statistics.collisions;
	}
	assert.ok(touching > 5, `${touching}`);
	assert.deepEqual([...world.totals], [['turtles\nwalls', 1]]);
	assert.equal(world.meetings.length, 1);
	const [{ frame, point, a, b }] = world.meetings;
	assert.ok(frame > 5 && frame < 30 && Math.abs(point.x) < 0.5, `${frame} ${point.x}`);
	assert.deepEqual([a.breed, b.breed].sort(), ['turtles', 'walls']);
});

const wait = (seconds) => ({ type: 'starlogo_wait', inputs: { SECONDS: number(seconds) } });

test('scripts wait, in loops and for the agents that they make, and do not begin anew meanwhile', () => {
	const world = played(program(
		start(create(2, 'bears', 'bear', wait(0.5), sized(2)), create(1, 'walls', 'wall')),
		each('walls', { type: 'controls_repeat_ext', inputs: { TIMES: number(3), ...inside(forward(1), wait(1)) } }),
	), 0);
	const seen = [];
	for (let i = 0; i < 200; i++) {
		world.step();
		seen.push([...world.agents.filter(({ breed }) => breed === 'bears').map(({ size }) => size), world.agents.filter(({ breed }) => breed === 'walls').map(({ x }) => x)].join(' '));
	}
	// the second bear is made when the script of the first one goes on, the wall after that
	assert.deepEqual([5, 40, 70, 125].map((i) => seen[i]), ['1 ', '2 1 ', '2 2 1', '2 2 2']);
	assert.equal(world.agents.length, 3);
	assert.deepEqual(world.agents.filter(({ breed }) => breed === 'bears').map(({ size }) => size), [2, 2]);
	const wall = world.agents.find(({ breed }) => breed === 'walls');
	assert.equal(wall.x, 3);
});

test('a mound lifts who stands on the ground; set back by frames, the ground is what it was', () => {
	const world = played(program(
		start(create(1, 'bears', 'bear', go(-2, 0, 0)), create(1, 'seagulls', 'seagull', go(0, 0, 8))),
		{ type: 'starlogo_timer', fields: { BREED: 'seagulls' }, inputs: { SECONDS: number(0.5), ...inside({ type: 'starlogo_mound', inputs: { HEIGHT: number(2), WIDTH: number(8) } }) } },
		each('bears', { type: 'starlogo_stand' }),
		each('anyone', { type: 'controls_if', inputs: { IF0: value('starlogo_on_ground'), DO0: { block: { type: 'starlogo_say', inputs: { TEXT: value('text', { TEXT: 'ground' }) } } } } }),
	), 70);
	const [bear, seagull] = world.agents;
	const height = 4 * 0.75 ** 2;
	assert.deepEqual([bear.z, world.terrain.heightAt(0, 0)], [height, 4]);
	assert.deepEqual([bear.said.text, seagull.said.text], ['ground', '']);
	world.history.show(20);
	assert.deepEqual([bear.z, world.terrain.heightAt(0, 0)], [height / 2, 2]);
	world.history.show(60);
	assert.deepEqual([bear.z, world.terrain.heightAt(0, 0)], [0, 0]);
	for (let i = 0; i < 60; i++) {
		world.step();
	}
	assert.deepEqual([bear.z, world.terrain.heightAt(0, 0)], [height, 4]);
	world.begin(program(start(create(1, 'bears', 'bear'))));
	assert.equal(world.terrain, null, 'a program without hills has none');
});

test('a script begins when an agent comes to the ground, and another one when it leaves it', () => {
	const say = (TEXT) => ({ type: 'starlogo_say', inputs: { TEXT: value('text', { TEXT }) } });
	const up = (steps) => ({ type: 'starlogo_up', inputs: { STEPS: number(steps) } });
	const event = (type, ...blocks) => ({ type, fields: { BREED: 'bears', OTHER: '*terrain' }, inputs: inside(...blocks) });
	const falling = program(
		start(create(1, 'bears', 'bear', go(0, 0, 0.25)), create(1, 'walls', 'wall', go(5, 5, 0))),
		{ type: 'starlogo_each', fields: { BREED: 'bears' }, inputs: inside(up(-0.1)) },
		event('starlogo_touch_start', say('ground')), event('starlogo_collision', up(0.3)), event('starlogo_touch_end', say('air')),
	);
	const world = played(falling, 2);
	const [bear] = world.agents;
	const said = [];
	for (let i = 0; i < 3; i++) {
		world.step();
		said.push(bear.said.text);
	}
	assert.deepEqual(said, ['ground', 'air', 'air']);
	assert.ok(Math.abs(bear.z - 0.05) < 1e-9, String(bear.z));
	assert.match(parts.javascriptOf(falling, 'falling', made), /whenColliding\("bears", Collision\.TERRAIN, function\* \(me\) \{/);
	assert.match(parts.javascriptOf(falling, 'falling', made), /new Terrain\(25, 25, 1, -12, -12\)/);
});

test('a program has a terrain as JavaScript if a block is about it, and only then', () => {
	const written = (condition) => parts.javascriptOf(program(each('bears', { type: 'controls_if', inputs: { IF0: condition, DO0: { block: { type: 'starlogo_until', fields: { HOW: 'slide', BREED: 'anyone' }, inputs: { STEPS: number(1) } } } } })), 'my terrain', made);
	assert.match(written(value('starlogo_on_ground')), /new Terrain\(25, 25, 1, -12, -12\)/);
	assert.match(written(value('starlogo_ground_height')), /new Terrain\(/);
	assert.doesNotMatch(written(value('starlogo_touching', { BREED: 'anyone' })), /Terrain/);
});

test('a random number between random numbers is between them', () => {
	const between = (from, to) => value('math_random_int', {}, { FROM: from, TO: to });
	const SCORE = between(between(number(1), number(3)), number(5));
	const world = played(program(start(create(1, 'bears', 'bear')), each('bears', { type: 'starlogo_score_change', inputs: { SCORE } })), 0);
	const found = new Set();
	for (let i = 0; i < 500; i++) {
		const before = world.score;
		world.step();
		found.add(world.score - before);
	}
	assert.deepEqual([...found].sort(), [1, 2, 3, 4, 5]);
});

test('a frame that stands still is searched again: collisions have run in it already, but touches may begin', () => {
	const score = (type, OTHER, SCORE) => ({ type, fields: { BREED: 'bears', OTHER }, inputs: inside({ type: 'starlogo_score_change', inputs: { SCORE: number(SCORE) } }) });
	const world = played(program(start(create(1, 'bears', 'bear'), create(1, 'walls', 'wall'), create(1, 'turtles', 'turtle', go(9, 9, 0))),
		score('starlogo_collision', 'walls', 1), score('starlogo_collision', 'turtles', 10), score('starlogo_touch_start', 'turtles', 100)), 1);
	assert.equal(world.score, 1);
	for (const system of ['exact', 'unit spheres', 'tightest fits']) {
		world.useSystem(system);
		world.collideAgain();
	}
	assert.deepEqual([world.score, world.collisions.collision.statistics.collisions], [1, 1]);
	world.agents[2].jumpTo(0, 0, 0);
	world.collideAgain();
	assert.equal(world.score, 101);
	world.step();
	assert.equal(world.score, 112);
});

test('every object\'s names are no names of programs; a game of a link leaves no best time for the next link', () => {
	assert.deepEqual(['constructor', 'toString', 'lesson-constructor', 'maze', 'lesson-wing'].map(parts.isBuiltIn), [false, false, false, true, true]);
	const kept = new Map();
	globalThis.localStorage = { getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => kept.set(key, text), removeItem: (key) => kept.delete(key) };
	const shelf = new parts.Shelf();
	for (const id of ['maze', 'link']) {
		shelf.putRecord(id, 3);
		shelf.putCamera(id, 'eyes');
	}
	assert.deepEqual(['maze', 'link'].map((id) => [shelf.recordOf(id), shelf.cameraOf(id)]), [[3, 'eyes'], [null, null]]);
	// a full storage may take the name of the last program, but not the programs
	globalThis.localStorage.setItem = (key, text) => {
		if (text.length > 40) throw new Error('full');
		kept.set(key, text);
	};
	shelf.put({ id: 'own-a-b', name: 'Mine', program: program(start(create(1, 'bears', 'bear'))), changed: 1 });
	shelf.last = 'own-a-b';
	assert.deepEqual([shelf.isKept, shelf.find('own-a-b').name, shelf.last], [false, 'Mine', 'own-a-b']);
	delete globalThis.localStorage;
});

test('an address leads to a program: what is shown first is what the user has made of a lesson, and a wrong address says why', async () => {
	const own = { id: 'own-a-b', name: 'Mine', program: program(start(create(1, 'bears', 'bear'))), lesson: 'wing', changed: 1 };
	const shelf = { all: [own], last: null, find: (id) => (id === own.id ? own : null) };
	const finder = new parts.Finder(shelf);
	for (const address of ['lesson-wing', 'own-a-b', '', await parts.toLink({ name: 'Mine', ...own.program })]) assert.deepEqual(await finder.first(address), { name: 'own-a-b', program: own.program, title: 'Mine', lesson: 'wing' }, address);
	const other = await finder.find(await parts.toLink({ name: 'Yours', lesson: 'see', ...own.program }));
	assert.deepEqual([other.name, other.title, other.lesson], ['link', 'Yours', 'see']);
	await assert.rejects(finder.find('constructor'), { message: /^Nothing is at the address “constructor”/ });
	await assert.rejects(finder.find('own-c-d'), { message: /another browser keeps/ });
	assert.deepEqual(['all', '', 'maze'].map((address) => finder.isHome(address)), [true, false, false]);
});

test('set back by frames, the game goes on as it did', () => {
	const game = program(
		start(create(20, 'turtles', 'turtle', { type: 'starlogo_scatter' }), create(8, 'walls', 'wall', { type: 'starlogo_scatter' }, sized(4))),
		each('turtles', forward(0.1), { type: 'starlogo_turn', fields: { DIRECTION: 'left' }, inputs: { DEGREES: value('math_random_int', {}, { FROM: number(-9), TO: number(9) }) } }),
		{ type: 'starlogo_touch_start', fields: { BREED: 'turtles', OTHER: 'walls' }, inputs: inside({ type: 'starlogo_score_change', inputs: { SCORE: number(1) } }, wait(0.3), sized(0.8), { type: 'starlogo_bounce' }) },
		{ type: 'starlogo_touch_start', fields: { BREED: 'turtles', OTHER: 'turtles' }, inputs: inside({ type: 'starlogo_delete', fields: { WHO: 'me' } }) },
	);
	const places = (world) => JSON.stringify([world.score, world.frame, [...world.totals], world.agents.map(({ x, y, heading, size, breed }) => [x, y, heading, size, breed])]);
	const world = played(game, 300);
	const end = places(world);
	assert.ok(world.score > 3 && world.agents.length < 28, `${world.score} met, ${world.agents.length} left`);
	world.history.show(200);
	assert.equal(world.frame, 100);
	assert.notEqual(places(world), end);
	world.history.show(10);
	world.history.show(150);
	for (let i = 0; i < 150; i++) {
		world.step();
	}
	assert.equal(places(world), end);
});

test('set back by frames, breeds have the settings of then, and questions see the agents of then', () => {
	const at = (frame, block) => each('walls', { type: 'controls_if', inputs: { IF0: value('logic_compare', { OP: 'EQ' }, { A: value('starlogo_clock'), B: number(frame / 60) }), DO0: { block } } });
	const world = played(program(
		start(create(2, 'bears', 'bear'), create(1, 'walls', 'wall', go(9, 9, 0))), each('bears', forward(0.1)),
		at(10, { type: 'starlogo_hierarchical', fields: { WHO: 'bears', ON: 'on' } }), at(10, { type: 'starlogo_show', fields: { WHO: 'bears', ON: 'on' } }), at(10, { type: 'starlogo_hatch', fields: { SHAPE: 'bear', BREED: 'bears' } }),
	), 12);
	const [bear, other] = world.agents;
	const born = () => world.add('bear', 'bears', null);
	assert.deepEqual([born().hierarchical, world.structures.isShown(bear), world.senses.queries.touching(bear).includes(other)], [true, true, true]);
	world.history.show(7);
	assert.deepEqual([world.frame, born().hierarchical, bear.hierarchical, world.structures.isShown(bear)], [5, false, false, false]);
	for (let i = 0; i < 7; i++) world.step();
	assert.deepEqual([born().hierarchical, world.structures.isShown(bear)], [true, true], 'it goes the same way again');
	other.moveTo(5, 5, 0);
	world.collide();
	assert.ok(!world.senses.queries.touching(bear).includes(other), 'an agent that was dragged is seen at its place');
	world.history.show(1);
	assert.ok(world.senses.queries.touching(bear).includes(other));
});

test('one game hears the keys of another: under the same system it is the same, under another one others touch', () => {
	const game = program(...parts.GAMES.paintball.blocks.blocks, start({ type: 'starlogo_system', fields: { SYSTEM: 'exact' } }));
	const play = (system) => {
		const [first, second] = [new parts.World(greatLand), new parts.World(greatLand)];
		first.useSystem('exact');
		second.useSystem(system);
		second.isSystemFixed = first.isWatched = second.isWatched = true;
		for (const world of [first, second]) {
			world.begin(game);
		}
		let differences = 0;
		for (let frame = 0; frame < 240; frame++) {
			first.input[frame % 60 < 30 ? 'press' : 'release']('left');
			first.input[frame % 40 < 30 ? 'press' : 'release']('up');
			if (frame % 15 === 0) {
				first.input.press('space');
				first.input.release('space');
			}
			second.input.copyFrom(first.input, second.agents);
			second.step();
			first.step();
			differences += [...first.pairs.keys()].join() === [...second.pairs.keys()].join() ? 0 : 1;
		}
		assert.equal(second.collisions.systemName, system, 'blocks leave it as it is');
		return { differences, places: [first, second].map((world) => JSON.stringify(world.agents.map(({ number: name, x, y, heading, color }) => [name, x, y, heading, color]))) };
	};
	const { differences, places } = play('exact');
	assert.equal(differences, 0);
	assert.equal(places[0], places[1]);
	assert.ok(play('unit spheres').differences > 20);
});

test('what agents know of others, and how they move by it', () => {
	const nearest = (BREED) => value('starlogo_nearest', { BREED }, { DISTANCE: number(50) });
	const set = (name, block) => ({ type: 'variables_set', fields: { VAR: { id: name } }, inputs: { VALUE: block } });
	const world = played(program(
		start(create(1, 'bears', 'bear', sized(0.5)), create(1, 'walls', 'wall', sized(2), go(3, 0, 0)), create(2, 'turtles', 'turtle', go(6, 0, 0)), create(1, 'turtles', 'turtle', go(0, 5, 0))),
		each('bears', set('count', value('starlogo_count', { BREED: 'turtles' }, { DISTANCE: number(5.5) })), set('far', value('starlogo_distance', {}, { AGENT: nearest('walls') })),
			set('seen', value('starlogo_can_see', {}, { AGENT: nearest('turtles') })), set('touching', value('starlogo_touching', { BREED: 'walls' })),
			set('unpainted', value('starlogo_number_of', { BREED: 'turtles' }, { COLOUR: value('starlogo_pick', { COLOUR: 'own' }) })),
			{ type: 'starlogo_until', fields: { HOW: 'moveUntilTouch', BREED: 'walls' }, inputs: { STEPS: number(1) } }),
		{ type: 'starlogo_key', fields: { KEY: 'w', MODE: 'pressed', BREED: 'bears' }, inputs: inside({ type: 'starlogo_face', inputs: { AGENT: nearest('turtles') } },
			{ type: 'starlogo_ask', inputs: { AGENT: nearest('turtles'), ...inside({ type: 'starlogo_become', fields: { WHO: 'me', BREED: 'friends' } }, { type: 'starlogo_say', inputs: { TEXT: { shadow: { type: 'text', fields: { TEXT: 'Hi' } } } } }) } }) },
	), 1);
	const { count, far, seen, touching, unpainted } = world.variables;
	assert.deepEqual([count, seen, touching, unpainted], [1, true, false, 3]);
	assert.ok(far > 2 && far < 3, `${far}`);
	for (let i = 0; i < 6; i++) {
		world.step();
	}
	const [bear] = world.agents;
	assert.ok(bear.x > 2 && bear.x < 2.9, `it stands at the wall: ${bear.x}`);
	assert.equal(world.variables.touching, true);
	world.input.press('w');
	world.step();
	assert.deepEqual(world.agents.filter(({ breed }) => breed === 'friends').map(({ said }) => said.text), ['Hi']);
	assert.ok(Math.abs(bear.heading) < 1, `${bear.heading}`);
});

test('the paintball game is won by painting all turtles', () => {
	const world = played(parts.GAMES.paintball, 5);
	assert.equal(world.score, 0);
	assert.match(world.goal, /turtles/);
	const turtles = world.agents.filter(({ breed }) => breed === 'turtles');
	turtles.slice(1).forEach((turtle) => {
		turtle.color = 0xff0000;
	});
	world.step();
	assert.deepEqual([world.score, world.ended], [turtles.length - 1, null]);
	turtles[0].color = 0xff0000;
	world.step();
	assert.deepEqual([world.score, world.ended.how], [turtles.length, 'won']);
});

test('links are a third of what they were, and bring the same program', async () => {
	// the paintball game's link of the release before, with Blockly's names and places
	let n = 0;
	const named = JSON.parse(JSON.stringify(parts.GAMES.paintball), (key, each) => (each !== null && typeof each === 'object' && 'type' in each
		? { ...each, id: createHash('sha1').update(String(n++)).digest('base64').slice(0, 20), ...(['starlogo_start', 'starlogo_each'].includes(each.type) && { x: n * 10.5, y: n * 101.5 }) } : each));
	const before = deflateRawSync(JSON.stringify(named)).toString('base64url').length;
	const link = await parts.toLink(named);
	console.log(`a link of ${link.length} characters, before ${before}`);
	assert.ok(link.length * 3 <= before, `${link.length} of ${before}`);
	assert.deepEqual((await parts.fromLink(link)).blocks.blocks, parts.GAMES.paintball.blocks.blocks);
	assert.deepEqual(await parts.fromLink(deflateRawSync(JSON.stringify(named)).toString('base64url')), named, 'links of before');
});

/** A program with something changed in it. */
const changed = (state, change) => {
	const copy = structuredClone(state);
	change(copy.blocks.blocks);
	return copy;
};
const script = (type, BREED, ...blocks) => ({ type, fields: { BREED }, inputs: inside(...blocks) });
const nearestTurtle = value('starlogo_nearest', { BREED: 'turtles' }, { DISTANCE: number(50) });
const say = (what) => ({ type: 'starlogo_say', inputs: { TEXT: what } });
const SYSTEMS = ['unit spheres', 'tightest fits', 'hierarchies', 'combination', 'exact'];
const NONE = [];

/** The systems in which a solved lesson is done, and those in which it is done as it is given. Of the others all and none. */
const SOLVED = { helmet: SYSTEMS.slice(1), wing: ['hierarchies', 'exact'], main: ['combination'], jump: SYSTEMS.slice(1) };
const GIVEN = { helmet: SYSTEMS.slice(1), wing: ['hierarchies', 'exact'] };
const LESSONS = Object.keys(parts.LESSONS);
const LONGEST_LESSON = 1900;

/** Whether a lesson is done by a program, which a system plays; the lesson main names its own in a block. */
function does(name, state, system, most) {
	const world = played(state, 0);
	world.useSystem(system);
	const memory = {};
	for (let frame = 0; frame < most; frame++) {
		world.step();
		if (parts.LESSONS[name].isDone(world, memory)) {
			return true;
		}
	}
	return false;
}

for (const name of LESSONS) {
	test(`the lesson ${name} is done by what it teaches, and not before, in every collision system`, () => {
		const { program: state } = parts.LESSONS[name];
		assert.deepEqual(SYSTEMS.filter((system) => does(name, state, system, 620)), GIVEN[name] ?? NONE, 'as it is given');
		assert.deepEqual(SYSTEMS.filter((system) => does(name, parts.solved(name), system, LONGEST_LESSON)), SOLVED[name] ?? SYSTEMS, 'solved');
		const { challenge, why } = parts.texts.lessons.list[name];
		assert.ok(challenge.length > 10 && why.length > 10);
	});
}

/** Scripts with a block put below the first one of the start. */
const atStart = (scripts, block) => {
	const { inputs } = scripts.find(({ type }) => type === 'starlogo_start');
	const { next, ...first } = inputs.DO.block;
	inputs.DO.block = { ...first, next: { block: { ...block, next } } };
};
const hierarchical = (WHO) => ({ type: 'starlogo_hierarchical', fields: { WHO, ON: 'on' } });
const sweeping = (WHO) => ({ type: 'starlogo_sweep', fields: { WHO, ON: 'on' } });
const without = (WHO) => ({ type: 'starlogo_delete', fields: { WHO } });
const inEach = (scripts, breed, ...blocks) => {
	scripts.find(({ type, fields }) => type === 'starlogo_each' && fields.BREED === breed).inputs = inside(...blocks);
};

/** Wrong solutions of each lesson: what is said of it, a change of its program or none, and the system. */
const MISTAKES = {
	blocks: [['still'], ['once', (scripts) => {
		scripts.find(({ type }) => type === 'starlogo_start').inputs.DO.block.inputs = { COUNT: number(5), ...inside({ type: 'starlogo_scatter' }, wait(0.2), forward(1)) };
	}],
		['none', (scripts) => parts.append(scripts, 'starlogo_start', without('turtles'))]],
	helmet: [['through'], ['changed', (scripts) => parts.append(scripts, 'starlogo_start', without('firemen')), 'exact']],
	wing: [['air'], ['air', null, 'unit spheres'], ['changed', (scripts) => parts.append(scripts, 'starlogo_start', without('dragons')), 'exact']],
	main: [['box'], ['system', null, 'exact'], ['balls', (scripts) => ['dragons', 'paintballs'].forEach((breed) => atStart(scripts, hierarchical(breed)))],
		['changed', (scripts) => parts.append(scripts, 'starlogo_start', chain(hierarchical('dragons'), without('paintballs')))]],
	fast: [['through'], ['slow', (scripts) => inEach(scripts, 'paintballs', forward(0.5))], ['walls', (scripts) => parts.append(scripts, 'starlogo_start', sweeping('walls'))]],
	starts: [['frames'], ['few', (scripts) => {
		scripts.find(({ type }) => type === 'starlogo_collision').inputs = {};
	}]],
	room: [['out'], ['gone', (scripts) => parts.append(scripts, 'starlogo_start', without('walls'))],
		['still', (scripts) => inEach(scripts, 'bears', { type: 'starlogo_until', fields: { HOW: 'slide', BREED: 'walls' }, inputs: { STEPS: number(0.1) } })]],
	near: [['silent'], ['others', (scripts) => scripts.push(script('starlogo_each', 'turtles', say(value('starlogo_count', { BREED: 'turtles' }, { DISTANCE: number(5) }))))],
		['other', (scripts) => scripts.push(script('starlogo_each', 'bears', say(value('text', { TEXT: 'Hello' }))))], ['none', (scripts) => parts.append(scripts, 'starlogo_start', without('bears'))]],
	see: [['silent'], ['others', (scripts) => scripts.push(script('starlogo_each', 'turtles', say(value('text', { TEXT: 'Hello' }))))],
		['other', (scripts) => scripts.push(script('starlogo_each', 'bears', say(value('starlogo_can_see', {}, { AGENT: value('starlogo_nearest', { BREED: 'bears' }, { DISTANCE: number(10) }) }))))], ['none', (scripts) => parts.append(scripts, 'starlogo_start', without('bears'))]],
	hunt: [['straight'], ['none', (scripts) => parts.append(scripts, 'starlogo_start', without('bears'))],
		['late', (scripts) => inEach(scripts, 'bears', { type: 'starlogo_face', inputs: { AGENT: nearestTurtle } }, forward(0.005))]],
	jump: [['air'], ['through', (scripts) => parts.append(scripts, 'starlogo_each', parts.notation.fall)],
		['gap', (scripts) => {
			parts.append(scripts, 'starlogo_each', parts.notation.fall);
			parts.append(scripts, 'starlogo_start', parts.notation.solid('platforms'));
		}], ['changed', (scripts) => parts.append(scripts, 'starlogo_start', without('coins'))]],
};

test('a wrong solution of a lesson is told what is wrong with it, and a right one is not', () => {
	assert.deepEqual(Object.keys(MISTAKES), LESSONS);
	/** What is said of a game, in order, until it is done. */
	const told = (name, state, system) => {
		const world = played(state, 0);
		if (system) world.useSystem(system);
		const [memory, said] = [{}, new Set()];
		for (let frame = 0; frame < LONGEST_LESSON; frame++) {
			world.step();
			if (parts.LESSONS[name].isDone(world, memory)) return [...said, 'done'];
			said.add(parts.LESSONS[name].wrong(world, memory));
		}
		return [...said];
	};
	for (const [name, mistakes] of Object.entries(MISTAKES)) {
		const { program: state } = parts.LESSONS[name];
		const words = Object.keys(parts.texts.mistakes[name]);
		assert.deepEqual(words.filter((word) => !mistakes.some(([each]) => each === word)), [], `${name}: each is tried`);
		for (const [what, change, system] of mistakes) {
			const said = told(name, change ? changed(state, change) : state, system);
			assert.ok(said.includes(what) && !said.includes('done'), `${name}: ${what} of ${said}`);
			assert.ok(said.every((each) => each === null || words.includes(each)), `${name}: ${said}`);
		}
		for (const system of SOLVED[name] ?? SYSTEMS) assert.deepEqual(told(name, parts.solved(name), system).filter((each) => each !== null), ['done'], `${name}, ${system}`);
	}
});

test('all lessons are tried, and begin with a system in which they are not done yet', () => {
	assert.deepEqual(LESSONS, Object.keys(parts.texts.lessons.list));
	assert.equal(LESSONS.length, 11);
	for (const name of LESSONS) {
		assert.ok(!GIVEN[name]?.includes(played(parts.LESSONS[name].program, 0).collisions.systemName), name);
	}
});

test('a program is played with its own collision system, or else with the default one, whatever was played before', () => {
	const world = new parts.World(greatLand);
	world.begin({ ...parts.EXAMPLES.helmet, system: 'exact' });
	assert.equal(world.collisions.systemName, 'exact');
	world.begin(parts.EXAMPLES.wing);
	assert.equal(world.collisions.systemName, 'tightest fits');
	world.begin({ ...parts.EXAMPLES.wing, system: 'none that there is' });
	assert.equal(world.collisions.systemName, 'tightest fits');
	// its blocks have the last word
	world.begin({ ...parts.LESSONS.main.program, system: 'exact' });
	assert.equal(world.collisions.systemName, 'combination');
});

test('a link brings the collision system and the name of a program', async () => {
	const { name, system, blocks } = await parts.fromLink(await parts.toLink({ name: 'Mine', ...parts.EXAMPLES.wing, system: 'exact' }));
	assert.deepEqual([name, system, blocks.blocks.length], ['Mine', 'exact', parts.EXAMPLES.wing.blocks.blocks.length]);
});

const all = (world, breed) => world.agents.filter((agent) => agent.breed === breed);
const angleTo = (from, to) => ((((Math.atan2(to.y - from.y, to.x - from.x) * 180) / Math.PI - from.heading) % 360) + 540) % 360 - 180;

/** Turns and walks an agent towards a place with the arrow keys. */
function steer(world, agent, to, isWalking = true) {
	const angle = angleTo(agent, to);
	world.input.releaseAll();
	if (Math.abs(angle) > 2) {
		world.input.press(angle > 0 ? 'left' : 'right');
	}
	if (isWalking && Math.abs(angle) < 40) {
		world.input.press('up');
	}
	return Math.abs(angle);
}

const nearestTo = (agent, others) => others.reduce((best, other) => (Math.hypot(other.x - agent.x, other.y - agent.y) < Math.hypot(best.x - agent.x, best.y - agent.y) ? other : best));

const awayFrom = (one, other) => Math.hypot(other.x - one.x, other.y - one.y);

/** Whether a place is further away than so much from all of the way between two others. */
function isFar(place, from, to, distance) {
	const [x, y] = [to.x - from.x, to.y - from.y];
	const part = Math.min(1, Math.max(0, ((place.x - from.x) * x + (place.y - from.y) * y) / (x * x + y * y)));
	return awayFrom(place, { x: from.x + part * x, y: from.y + part * y }) > distance;
}

/** Players that win the games by keys alone. */
const PLAYERS = {
	paintball(world) {
		const [bear] = all(world, 'bears');
		const left = all(world, 'turtles').filter(({ color }) => color === -1);
		if (left.length > 0 && steer(world, bear, nearestTo(bear, left)) < 8 && world.frame % 20 === 0) {
			world.input.press('space');
		}
	},
	chase(world) {
		const [[person], [dragon], [fortress]] = ['people', 'dragons', 'fortresses'].map((breed) => all(world, breed));
		const gems = all(world, 'gems');
		const ring = Array.from({ length: 12 }, (_, i) => ({ x: 9 * Math.cos((i * Math.PI) / 6), y: 9 * Math.sin((i * Math.PI) / 6) }));
		// where the dragon does not come first, nor is on the way
		const isFree = (place) => isFar(dragon, person, place, 3) && awayFrom(dragon, place) > 0.4 * awayFrom(person, place) + 3;
		const free = (gems.length > 0 ? gems : [fortress]).filter(isFree);
		const safe = ring.filter(isFree).sort((one, other) => awayFrom(dragon, other) - awayFrom(dragon, one));
		steer(world, person, free.length > 0 ? nearestTo(person, free) : safe[0] ?? { x: 2 * person.x - dragon.x, y: 2 * person.y - dragon.y });
	},
	maze(world, memory) {
		const [person] = all(world, 'people');
		memory.way ??= [];
		if (memory.way.length === 0 || (person.x === -9 && person.y === -9)) {
			memory.way = [[-9, 7], [-6, 7], [-3, 6], [-1.7, 1], [-1.7, -4], [-1.5, -7], [1, -7], [4.5, -5], [4.5, 0], [3, 7], [6, 7], [10, 6], [10, 2], [10, -3], [9, -9]].map(([x, y]) => ({ x, y }));
		}
		const [next] = memory.way;
		if (Math.hypot(next.x - person.x, next.y - person.y) < 0.8 && memory.way.length > 1) {
			memory.way.shift();
		}
		steer(world, person, memory.way[0]);
	},
	space(world) {
		const [ship] = all(world, 'spaceships');
		const rocks = all(world, 'rocks');
		if (rocks.length > 0 && steer(world, ship, nearestTo(ship, rocks), false) < 10 && world.frame % 12 === 0) {
			world.input.press('space');
		}
	},
	catch(world) {
		const [turtle] = all(world, 'turtles');
		const [pearl] = all(world, 'pearls').sort((a, b) => a.z - b.z);
		world.input.releaseAll();
		if (pearl && Math.abs(pearl.x - turtle.x) > 0.3) {
			world.input.press(pearl.x > turtle.x ? 'right' : 'left');
		}
	},
	tag(world) {
		const [player] = all(world, 'players');
		const people = all(world, 'people');
		if (people.length > 0) {
			steer(world, player, nearestTo(player, people));
		}
	},
	pinball(world) {
		const [[paddle], [ball]] = [all(world, 'paddles'), all(world, 'balls')];
		world.input.releaseAll();
		if (Math.abs(ball.x - paddle.x) > 0.3) {
			world.input.press(ball.x > paddle.x ? 'right' : 'left');
		}
	},
	hills(world) {
		const [person] = all(world, 'people');
		const gems = all(world, 'gems');
		if (gems.length > 0) {
			steer(world, person, nearestTo(person, gems));
		}
	},
};
const LONGEST_GAME = 180 * 60;
PLAYERS.jump = (world) => {
	const [[person], [lift], [turtle], [house]] = ['people', 'lifts', 'turtles', 'houses'].map((breed) => all(world, breed));
	const coins = all(world, 'coins').sort((a, b) => a.x - b.x);
	const to = coins[0] ?? house;
	world.input.releaseAll();
	const below = world.walking.standsOn(person);
	world.input.press(to.x > person.x ? 'right' : 'left');
	const gap = below && to.x > person.x && person.x > below.x + below.size / 2 - 0.35;
	const isLiftNear = person.x > -4 && person.x < -2 ? lift.x < -0.6 : true;
	if (gap && !isLiftNear) world.input.releaseAll();
	if ((gap && isLiftNear) || (below && Math.abs(to.x - person.x) < 1.3 && to.z > person.z + 0.9) || (turtle && below && Math.abs(turtle.x - person.x) < 1.6 && Math.abs(turtle.z - person.z) < 0.5)) world.input.press('space');
};
PLAYERS.drive = (world, memory) => {
	const [car] = all(world, 'cars');
	memory.way ??= [[-8, 8], [-4, 8], [-4, -8], [0, -8], [0, 6], [4, 6], [4, -8], [4, 7], [8, 7], [8, -8]].map(([x, y]) => ({ x, y }));
	if (awayFrom(car, memory.way[0]) < 0.6 && memory.way.length > 1) memory.way.shift();
	steer(world, car, memory.way[0]);
};

for (const name of Object.keys(PLAYERS)) {
	test(`the game ${name} has a goal, is won by who plays it with keys, and not by who does nothing`, () => {
		const idle = played(parts.GAMES[name], LONGEST_GAME / 4);
		assert.equal(idle.goal, parts.texts.programs[name].goal);
		assert.notEqual(idle.ended?.how, 'won', 'nobody plays');
		const world = played(parts.GAMES[name], 0);
		const memory = {};
		while (!world.ended && world.frame < LONGEST_GAME) {
			PLAYERS[name](world, memory);
			world.step();
		}
		console.log(`${name}: ${world.ended?.text} after ${world.seconds.toFixed(1)} s, score ${world.score}; left alone: ${idle.ended?.text}`);
		assert.equal(world.ended?.how, 'won', `${world.ended?.text} after ${world.seconds} s, score ${world.score}`);
	});
}

test('agents fall onto solid breeds, jump, are carried and turn at the edge; set back by frames, it goes the same way again', () => {
	const solid = (BREED, ON = 'on') => ({ type: 'starlogo_solid', fields: { BREED, ON } });
	const walk = (steps) => ({ type: 'starlogo_walk', inputs: { STEPS: number(steps) } });
	const if_ = (condition, ...blocks) => ({ type: 'controls_if', inputs: { IF0: condition, DO0: { block: chain(...blocks) } } });
	const fall = { type: 'starlogo_fall' };
	const world = played(program(
		start(solid('platforms'), create(1, 'platforms', 'platform', { type: 'starlogo_size', inputs: { SIZE: number(4) } }, go(0, 0, 2)), create(1, 'heroes', 'cube', go(0, 0, 5))),
		each('platforms', forward(0.02)),
		each('heroes', fall, walk(0)),
		parts.notation.key('space', 'pressed', 'heroes', { type: 'starlogo_jump', inputs: { HEIGHT: number(2) } }),
		parts.notation.key('down', 'pressed', 'heroes', solid('platforms', 'off')),
	), 60);
	const [platform, hero] = world.agents;
	const near = (a, b, by = 1e-6) => assert.ok(Math.abs(a - b) < by, `${a}, not ${b}`);
	near(hero.z, 3);
	assert.equal(world.walking.standsOn(hero), platform);
	const before = hero.x - platform.x;
	for (let i = 0; i < 30; i++) world.step();
	near(hero.x - platform.x, before, 0.021);
	assert.ok(hero.x > 0.5, 'carried');
	world.input.press('space');
	const way = () => Array.from({ length: 60 }, () => {
		world.step();
		world.input.releaseAll();
		return `${hero.x} ${hero.z} ${hero.rise}`;
	});
	const first = way();
	near(Math.max(...first.map((each) => Number(each.split(' ')[1]))), 5, 0.01);
	near(hero.z, 3);
	world.history.show(60);
	world.input.press('space');
	assert.deepEqual(way(), first);
	world.input.press('down');
	for (let i = 0; i < 60; i++) world.step();
	near(hero.z, 0);
	world.history.show(60);
	assert.deepEqual(world.walking.solidBreeds, ['platforms']);

	const ways = Object.fromEntries(['stopAt', 'bounceOff', 'wrapAt'].map((HOW) => {
		const [turtle] = played(program(start(create(1, 'turtles', 'cube', go(11, 0, 0))), each('turtles', forward(0.1), { type: 'starlogo_edge', fields: { HOW } }, if_(value('starlogo_at_edge', { EDGE: 'east' }), { type: 'starlogo_colour', fields: { WHO: 'me' }, inputs: { COLOUR: value('starlogo_pick', { COLOUR: 'red' }) } }))), 20).agents;
		return [HOW, [turtle.x.toFixed(1), Math.round(Math.cos((turtle.heading * Math.PI) / 180)), turtle.color !== -1]];
	}));
	assert.deepEqual(ways, { stopAt: ['11.5', 1, true], bounceOff: ['10.0', -1, true], wrapAt: ['-11.0', 1, true] });
});

test('blocks tell which side was hit, how fast, and what is ahead', () => {
	const scoreOf = (VALUE) => ({ type: 'starlogo_score_set', inputs: { SCORE: VALUE } });
	const told = (VALUE, place = go(-3, 0, 0), way = forward(0.1)) => played(program(
		start(create(1, 'walls', 'cube'), create(1, 'turtles', 'cube', place)), each('turtles', way),
		parts.notation.touch('turtles', 'walls', { type: 'controls_if', inputs: { IF0: VALUE, DO0: { block: scoreOf(value('starlogo_touch', { TOUCH: 'speed' })) } } }),
	), 40).score;
	const side = (WHO, SIDE) => value('starlogo_side', { WHO, SIDE });
	assert.ok(Math.abs(told(side('me', 'front')) - 0.1) < 1e-9);
	assert.ok(told(side('collidee', 'back')) > 0);
	assert.equal(told(side('collidee', 'top')), null);
	assert.ok(told(side('collidee', 'top'), go(0, 0, 3), { type: 'starlogo_up', inputs: { STEPS: number(-0.08) } }) > 0);
	const ahead = played(program(start(create(1, 'walls', 'cube'), create(1, 'turtles', 'cube', go(-3, 0, 0))),
		each('turtles', scoreOf(value('starlogo_free', { BREED: 'walls' }, { DISTANCE: number(5) })), { type: 'starlogo_ask', inputs: { AGENT: value('starlogo_ahead', { BREED: 'walls' }, { DISTANCE: number(1) }), ...inside(forward(9)) } })), 1);
	assert.ok(Math.abs(ahead.score - 2) < 1e-6);
	assert.equal(ahead.agents[0].x, 0, 'the wall is farther away than 1');
});

test('who slides along something that leans stays on the ground', () => {
	const world = played(program(start(create(1, 'people', 'person'), create(1, 'trees', 'tree', { type: 'starlogo_go', inputs: { X: number(3), Y: number(0.3), Z: number(0) } })),
		each('people', { type: 'starlogo_until', fields: { HOW: 'slide', BREED: 'trees' }, inputs: { STEPS: number(0.1) } })), 60);
	assert.equal(all(world, 'people')[0].z, 0);
});

test('the page has a game for each name, with idle models among them', () => {
	assert.deepEqual(Object.keys(parts.GAMES), Object.keys(parts.texts.play.games));
	assert.deepEqual(Object.keys(PLAYERS), Object.keys(parts.GAMES));
	const used = JSON.stringify(parts.GAMES);
	for (const shape of ['fortress', 'spaceship', 'kelp', 'tree', 'person']) {
		assert.ok(used.includes(`"SHAPE":"${shape}"`), shape);
	}
	assert.deepEqual(Object.keys(parts.texts.blocks.grounds), Object.keys(parts.GROUNDS));
});

test('models are drawn in the colours that their parts have', () => {
	const area = (a, b, c) => {
		const [[ux, uy, uz], [vx, vy, vz]] = [b, c].map((corner) => corner.map((each, i) => each - a[i]));
		return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
	};
	for (const { name, format, build } of models) {
		const { colours } = JSON.parse(readFileSync(path.join(root, 'bin/playground/models', `${name}.json`), 'utf8'));
		const reader = format === 'COLLADA' ? parts.ColladaModel : parts.ObjModel;
		const { vertices, triangles } = reader.fromBytes(name, new Uint8Array(readFileSync(path.join(root, 'assets', `${name}.${format === 'COLLADA' ? 'dae' : 'obj'}`))));
		const corner = (i) => [0, 1, 2].map((axis) => vertices[3 * triangles[i] + axis]);
		const [drawn, wanted] = [{}, {}];
		let at = 0;
		for (const [count, colour] of colours) {
			for (let end = at + count; at < end; at++) {
				drawn[colour] = (drawn[colour] ?? 0) + area(corner(3 * at), corner(3 * at + 1), corner(3 * at + 2));
			}
		}
		assert.equal(3 * at, triangles.length, name);
		for (const { colour, mesh: { points, faces } } of flatten(build())) {
			for (const face of faces) {
				for (let i = 2; i < face.length; i++) {
					wanted[palette[colour]] = (wanted[palette[colour]] ?? 0) + area(points[face[0]], points[face[i - 1]], points[face[i]]);
				}
			}
		}
		const all = (areas) => Object.values(areas).reduce((sum, each) => sum + each);
		for (const colour of Object.keys(wanted)) {
			const [part, is] = [wanted[colour] / all(wanted), drawn[colour] / all(drawn)];
			assert.ok(Math.abs(part - is) < 0.002 + 0.01 * part, `${name} ${colour}: ${is} of it, not ${part}`);
		}
	}
});

test('outlines stand out from ground and sky three to one, by day and at dusk', () => {
	const bright = (colour) => {
		const [red, green, blue] = [16, 8, 0].map((shift) => ((colour >> shift) & 255) / 255).map((each) => (each <= 0.04045 ? each / 12.92 : ((each + 0.055) / 1.055) ** 2.4));
		return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
	};
	for (const [name, theme] of Object.entries(parts.GROUNDS).flatMap(([ground, byLight]) => Object.entries(byLight).map(([light, each]) => [`${ground}, ${light}`, each]))) {
		const { zenith, horizon, field, around, ink } = theme;
		for (const colour of [zenith, horizon, ...[...field, ...around].map((each) => Number.parseInt(each.slice(1), 16))]) {
			const [low, high] = [bright(colour), bright(ink)].sort((one, other) => one - other);
			assert.ok((high + 0.05) / (low + 0.05) >= 3, `${name} ${colour.toString(16)}: ${(high + 0.05) / (low + 0.05)}`);
		}
	}
});

/** A program with all that blocks are: each in a place where it has a meaning. */
const everything = () => {
	const set = (id, VALUE) => ({ type: 'variables_set', fields: { VAR: { id } }, inputs: { VALUE } });
	const get = (id) => value('variables_get', { VAR: { id } });
	const op = (OP, A, B) => value('math_arithmetic', { OP }, { A, B });
	const nearest = value('starlogo_nearest', { BREED: 'anyone' }, { DISTANCE: number(9) });
	const paint = (WHO, COLOUR) => ({ type: 'starlogo_colour', fields: { WHO }, inputs: { COLOUR } });
	const any = value('starlogo_any_colour');
	const grow = (by) => ({ type: 'starlogo_size', inputs: { SIZE: by } });
	return { system: 'combination', variables: [{ id: 'a', name: 'n' }, { id: 'b', name: 'my own' }], ...program(
		start(
			create(4, 'turtles', 'turtle', { type: 'starlogo_scatter' }, grow(number(2)), wait(0.5), create(2, 'balls', 'sphere', go(1, 2, 0), { type: 'starlogo_heading', inputs: { HEADING: value('math_random_int', {}, { FROM: number(1), TO: number(90) }) } })),
			create(2, 'walls', 'wall', grow(number(5)), { type: 'starlogo_scatter' }),
			create(1, 'bears', 'bear', grow(number(2))),
			...[['starlogo_hierarchical', { WHO: 'bears', ON: 'on' }], ['starlogo_collide_as', { WHO: 'turtles', AS: 'sphere' }], ['starlogo_sweep', { WHO: 'balls', ON: 'on' }], ['starlogo_show', { WHO: 'bears', ON: 'on' }]].map(([type, fields]) => ({ type, fields })),
			{ type: 'starlogo_depth', fields: { WHO: 'bears' }, inputs: { DEPTH: number(3) } },
			create(1, 'climbers', 'bear', go(-3, -3, 0), { type: 'starlogo_flat' }, { type: 'starlogo_mound', inputs: { HEIGHT: number(2), WIDTH: number(6) } }, { type: 'starlogo_wall', inputs: { HEIGHT: number(0.5) } }, grow(value('starlogo_ground_height'))),
			{ type: 'starlogo_goal', fields: { TEXT: 'A "goal"' } }, { type: 'starlogo_limit', fields: { TEXT: 'late' }, inputs: { SECONDS: number(4.5) } }, { type: 'starlogo_sound', fields: { SOUND: 'ding' } }, { type: 'starlogo_note', inputs: { NOTE: number(64) } }, { type: 'starlogo_ground', fields: { GROUND: 'sea' } }, set('a', number(3)), set('b', op('POWER', number(-2), number(2))),
		),
		{ type: 'starlogo_touch_start', fields: { BREED: 'climbers', OTHER: '*terrain' }, inputs: inside(paint('me', any)) },
		start({ type: 'starlogo_solid', fields: { BREED: 'platforms', ON: 'on' } }, create(3, 'platforms', 'platform', grow(number(6)), go(-6, 6, 0.3)), create(1, 'heroes', 'person', go(-8, 6, 4)), create(1, 'coins', 'coin', go(-6, 6, 1.7))),
		{ type: 'starlogo_touch_start', fields: { BREED: 'heroes', OTHER: '*edge' }, inputs: inside(paint('me', any)) },
		{ type: 'starlogo_touch_start', fields: { BREED: 'heroes', OTHER: 'coins' }, inputs: inside({ type: 'controls_if', inputs: { IF0: value('starlogo_side', { WHO: 'me', SIDE: 'front' }), DO0: { block: grow(value('starlogo_touch', { TOUCH: 'z' })) } } }, { type: 'starlogo_push' }, { type: 'starlogo_say', inputs: { TEXT: value('starlogo_touch', { TOUCH: 'speed' }) } }) },
		each('heroes', { type: 'starlogo_walk', inputs: { STEPS: number(0.11) } }, { type: 'starlogo_fall' }, { type: 'starlogo_edge', fields: { HOW: 'bounceOff' } },
			{ type: 'controls_if', inputs: { IF0: value('starlogo_standing', { BREED: 'platforms' }), DO0: { block: { type: 'starlogo_jump', inputs: { HEIGHT: number(2) } } } } },
			{ type: 'controls_if', inputs: { IF0: value('starlogo_at_edge', { EDGE: 'east' }), DO0: { block: paint('me', any) } } },
			{ type: 'starlogo_ask', inputs: { AGENT: value('starlogo_ahead', { BREED: 'coins' }, { DISTANCE: number(4) }), ...inside({ type: 'starlogo_up', inputs: { STEPS: op('MULTIPLY', number(1e-7), value('starlogo_free', { BREED: 'anyone' }, { DISTANCE: number(2) })) } }) } },
			{ type: 'starlogo_ask', inputs: { AGENT: value('starlogo_floor'), ...inside(paint('me', any)) } }),
		each('climbers', forward(0.02), { type: 'controls_if', inputs: { IF0: value('starlogo_on_ground'), DO0: { block: paint('me', any) } } }, { type: 'starlogo_stand' }),
		each('balls', forward(0.1), { type: 'starlogo_turn', fields: { DIRECTION: 'left' }, inputs: { DEGREES: op('MINUS', get('a'), number(-1)) } }, {
			type: 'controls_if', extraState: { elseIfCount: 1, hasElse: true }, inputs: {
				IF0: value('logic_operation', { OP: 'AND' }, { A: value('starlogo_touching', { BREED: 'walls' }), B: value('logic_negate', {}, { BOOL: value('logic_boolean', { BOOL: 'FALSE' }) }) }), DO0: { block: paint('me', any) },
				IF1: value('logic_compare', { OP: 'GT' }, { A: value('starlogo_count', { BREED: 'balls' }, { DISTANCE: number(3) }), B: number(2) }), DO1: { block: { type: 'starlogo_up', inputs: { STEPS: number(0.01) } } },
				ELSE: { block: paint('turtles', any) },
			},
		}),
		{ type: 'starlogo_timer', fields: { BREED: 'turtles' }, inputs: { SECONDS: number(0.7), ...inside({ type: 'starlogo_hatch', fields: { BREED: 'balls', SHAPE: 'sphere' }, inputs: inside(forward(1)) },
			{ type: 'starlogo_face', inputs: { AGENT: nearest } }, { type: 'starlogo_until', fields: { HOW: 'slide', BREED: 'walls' }, inputs: { STEPS: number(0.4) } }) } },
		{ type: 'starlogo_key', fields: { KEY: 'up', MODE: 'held', BREED: 'bears' }, inputs: inside({ type: 'starlogo_until', fields: { HOW: 'moveUntilTouch', BREED: 'anyone' }, inputs: { STEPS: number(0.15) } }) },
		{ type: 'starlogo_click', fields: { BREED: 'anyone' }, inputs: inside(grow(number(3))) },
		start({ type: 'starlogo_raise', inputs: { HEIGHT: number(1.5), X: number(-2), Y: number(-4) } }, { type: 'starlogo_own_show', fields: { NAME: 'lives', ON: 'on' } }, { type: 'starlogo_broadcast', fields: { MESSAGE: 'go' } }),
		{ type: 'starlogo_receive', fields: { MESSAGE: 'go', BREED: 'bears' }, inputs: inside({ type: 'starlogo_own_set', fields: { NAME: 'my lives' }, inputs: { VALUE: number(2) } }, { type: 'starlogo_own_change', fields: { NAME: 'lives' }, inputs: { DELTA: number(0.25) } }, forward(value('starlogo_own', { NAME: 'lives' })), wait(0.5), { type: 'starlogo_broadcast', fields: { MESSAGE: 'go' } }) },
		{ type: 'starlogo_touch_start', fields: { BREED: 'balls', OTHER: 'turtles' }, inputs: inside({ type: 'starlogo_score_change', inputs: { SCORE: number(1) } }, wait(0.2), { type: 'starlogo_bounce' }, { type: 'math_change', fields: { VAR: { id: 'a' } }, inputs: { DELTA: number(0.5) } }) },
		{ type: 'starlogo_touch_end', fields: { BREED: 'balls', OTHER: 'walls' }, inputs: inside({ type: 'starlogo_become', fields: { WHO: 'me', BREED: 'old' } }, paint('me', value('starlogo_colour_of', { WHO: 'collidee' }))) },
		{ type: 'starlogo_collision', fields: { BREED: 'turtles', OTHER: 'walls' }, inputs: inside({ type: 'starlogo_back' }, { type: 'starlogo_ask', inputs: { AGENT: nearest, ...inside({ type: 'starlogo_turn', fields: { DIRECTION: 'right' }, inputs: { DEGREES: number(7) } }) } }) },
		each('old', { type: 'controls_repeat_ext', inputs: { TIMES: op('DIVIDE', number(5), number(2)), ...inside(forward(0.02)) } }, { type: 'controls_whileUntil', fields: { MODE: 'UNTIL' }, inputs: { BOOL: value('logic_compare', { OP: 'LTE' }, { A: value('starlogo_trait', { TRAIT: 'heading' }), B: number(0) }), ...inside({ type: 'starlogo_turn', fields: { DIRECTION: 'right' }, inputs: { DEGREES: number(40) } }) } },
			{ type: 'controls_ifelse', inputs: { IF0: value('starlogo_can_see', {}, { AGENT: nearest }), DO0: { block: paint('me', value('starlogo_pick', { COLOUR: 'red' })) }, ELSE: { block: paint('me', any) } } },
			{ type: 'starlogo_say', inputs: { TEXT: value('starlogo_distance', {}, { AGENT: nearest }) } }),
		{ type: 'starlogo_timer', fields: { BREED: 'bears' }, inputs: { SECONDS: number(2), ...inside({ type: 'starlogo_system', fields: { SYSTEM: 'exact' } }, { type: 'starlogo_score_set', inputs: { SCORE: value('math_modulo', {}, { DIVIDEND: value('starlogo_clock'), DIVISOR: number(3) }) } }) } },
		{ type: 'starlogo_timer', fields: { BREED: 'bears' }, inputs: { SECONDS: number(4), ...inside({ type: 'starlogo_delete', fields: { WHO: 'old' } }, { type: 'starlogo_end', fields: { HOW: 'won', TEXT: 'x' } }) } },
		each('bears', { type: 'controls_if', inputs: { IF0: value('starlogo_key_down', { KEY: 'space' }), DO0: { block: forward(0.05) } } },
			{ type: 'starlogo_score_change', inputs: { SCORE: value('starlogo_number_of', { BREED: 'balls' }, { COLOUR: value('starlogo_pick', { COLOUR: 'own' }) }) } },
			{ type: 'controls_if', inputs: { IF0: value('logic_compare', { OP: 'GT' }, { A: value('starlogo_mouse', { MOUSE: 'x' }), B: number(2) }), DO0: { block: forward(-0.05) } } },
			{ type: 'starlogo_ask', inputs: { AGENT: value('starlogo_agent', { WHO: 'me' }), ...inside({ type: 'starlogo_turn', fields: { DIRECTION: 'left' }, inputs: { DEGREES: value('starlogo_score') } }) } }, { type: 'starlogo_say', inputs: { TEXT: value('text', { TEXT: 'Hi' }) } }),
	) };
};

test('a program as JavaScript is a module on the package that plays the same game', async () => {
	const folder = path.join(root, 'bin/generated/javascript');
	mkdirSync(folder, { recursive: true });
	const engine = pathToFileURL(path.join(root, 'bin/module/starlogo-collision.js')).href;
	const written = (name, state) => {
		const file = path.join(folder, `${name}.mjs`);
		const text = parts.javascriptOf(state, name, shapes, name);
		writeFileSync(file, text.replace('"starlogo-collision"', JSON.stringify(engine)));
		return { file, text };
	};
	const all = { everything: everything(), ...parts.GAMES, ...Object.fromEntries(Object.entries(parts.LESSONS).map(([name, { program: state }]) => [`lesson-${name}`, state])) };
	const types = new Set(JSON.stringify(all.everything).match(/"type":"\w+"/g).map((each) => each.slice(8, -1)));
	assert.deepEqual(parts.DEFINITIONS.map(({ type }) => type).filter((type) => !types.has(type) && type !== 'math_number'), [], 'every block is tried');
	const seen = ({ agents, score, frame, ended }) => [frame, score ?? 0, ended?.how, ...agents.map(({ breed, x, y, z, heading, size, color }) => [breed, x, y, z, heading, size, color].join(' '))].join('\n');
	const keys = ['up', 'left', 'space', 'right', 'down'];
	// a part of them; all with -Dfull
	const tried = Object.entries(all).filter(([name]) => process.env.FULL_TESTS === 'true' || /everything|pinball|hills|starts/.test(name));
	assert.ok(tried.length >= 3);
	for (const [name, state] of tried) {
		const { file } = written(name, state);
		// the same without the ten seconds that it plays by itself
		writeFileSync(file, readFileSync(file, 'utf8').replace(/^for \(let i = 0; i < 600 .*\nconsole\.log.*$/m, ''));
		const world = played(state, 0);
		const module = await import(pathToFileURL(file).href);
		let moved = 0;
		for (let frame = 0; frame < 300; frame++) {
			if (frame % 25 === 0) {
				const key = keys[(frame / 25) % keys.length];
				for (const each of keys) [world.input, module].forEach((game) => game.release(each));
				[world.input, module].forEach((game) => game.press(key));
			}
			if (frame === 40) [world.input.clicked] = world.agents;
			if (frame === 40) module.click(module.agents[0]);
			if (frame === 60 && module.mouse) [world.input, module].forEach(({ mouse }) => Object.assign(mouse, { x: 3 }));
			const places = () => world.agents.map(({ x, y, z }) => `${x} ${y} ${z}`).join();
			const before = places();
			world.step();
			module.step();
			moved += places() === before ? 0 : 1;
			assert.equal(seen({ ...module.game, agents: module.agents }), seen(world), `${name}, frame ${frame + 1}`);
		}
		if (name in parts.GAMES || name === 'everything') assert.ok(moved > 30, `${name}: ${moved} frames in which somebody moved`);
	}
});

test('a text in a variable counts as its number, in the game and as JavaScript', async () => {
	const VAR = { id: 'v' };
	const state = { ...program(start(create(1, 'bears', 'bear',
		{ type: 'variables_set', fields: { VAR }, inputs: { VALUE: value('text', { TEXT: '5' }) } }, { type: 'math_change', fields: { VAR }, inputs: { DELTA: number(1) } },
		{ type: 'starlogo_own_set', fields: { NAME: 'n' }, inputs: { VALUE: value('text', { TEXT: '2' }) } }, { type: 'starlogo_own_change', fields: { NAME: 'n' }, inputs: { DELTA: value('starlogo_own', { NAME: 'n' }) } },
		{ type: 'starlogo_score_set', inputs: { SCORE: value('math_arithmetic', { OP: 'ADD' }, { A: value('variables_get', { VAR }), B: value('starlogo_own', { NAME: 'n' }) }) } }))), variables: [{ id: 'v', name: 'v' }] };
	const text = parts.javascriptOf(state, 'texts', made).replace(/^for \(let i = 0; i < 600 .*\nconsole\.log.*$/m, '');
	const file = path.join(root, 'bin/generated/javascript/texts.mjs');
	mkdirSync(path.dirname(file), { recursive: true });
	writeFileSync(file, text.replace('"starlogo-collision"', JSON.stringify(pathToFileURL(path.join(root, 'bin/module/starlogo-collision.js')).href)));
	const { game } = await import(pathToFileURL(file).href);
	assert.deepEqual([played(state, 0).score, game.score], [10, 10]);
	assert.ok(!parts.javascriptOf(everything(), 'none', made).includes('Number('), 'and is left out where no variable is a text');
});

test('a program as JavaScript runs in Node as its first line says, with the package beside it and no other file', async () => {
	const folder = path.join(mkdtempSync(path.join(tmpdir(), 'game-')), 'here');
	mkdirSync(path.join(folder, 'node_modules'), { recursive: true });
	symlinkSync(path.join(root, 'bin/module'), path.join(folder, 'node_modules/starlogo-collision'));
	try {
		for (const name of ['chase', 'hills']) {
			// a model of the user's own, with a name that is none of JavaScript
			const game = JSON.stringify(parts.GAMES[name]);
			const [shape] = [...game.matchAll(/"SHAPE":"(\w+)"/g)].map((match) => match[1]).filter((found) => shapes.has(found));
			const state = JSON.parse(game.replaceAll(`"SHAPE":"${shape}"`, '"SHAPE":"my own"'));
			const text = parts.javascriptOf(state, name, new Map([...shapes, ['my own', shapes.get(shape)]]), name);
			assert.match(text, /my own/);
			const [, command] = /picture: node (.+)$/m.exec(text);
			writeFileSync(path.join(folder, command), text);
			const { stdout } = await promisify(execFile)(process.execPath, [command], { cwd: folder });
			assert.match(stdout, /^\d+ agents after \d+ frames/);
		}
	} finally {
		rmSync(path.dirname(folder), { recursive: true });
	}
});
