/** Play, in the browser. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { SIZES, begin, open, ready } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

/** What the world of the open page is; the page lends it for this. */
const agents = (page, breed) => page.evaluate((which) => globalThis.playground.world.agents.filter((agent) => agent.breed === which)
	.map(({ x, y, z, heading, color, size }) => ({ x, y, z, heading, color, size })), breed);
const say = (page) => page.textContent('.game .status');
const press = (page, name) => page.getByRole('button', { name, exact: true }).click();

/** Takes steps of one frame each. */
async function step(page, count) {
	for (let i = 0; i < count; i++) {
		await press(page, 'Step');
	}
}

const number = (value) => ({ shadow: { type: 'math_number', fields: { NUM: value } } });
const create = (breed, shape, inner) => ({ type: 'starlogo_create', fields: { BREED: breed, SHAPE: shape }, inputs: { COUNT: number(1), ...(inner && { DO: { block: inner } }) } });
const start = (block) => ({ type: 'starlogo_start', inputs: { DO: { block } } });
const each = (breed, block) => ({ type: 'starlogo_each', fields: { BREED: breed }, inputs: { DO: { block } } });
const program = (...scripts) => JSON.stringify({ blocks: { languageVersion: 0, blocks: scripts } });

/** Opens a program from a file, as the user does. */
async function openProgram(page, text) {
	await page.setInputFiles('.program input[type=file]', { name: 'program.json', mimeType: 'application/json', buffer: Buffer.from(text) });
	await page.waitForTimeout(300);
}

async function keysMoveTheBear(page, size) {
	const [before] = await agents(page, 'bears');
	await press(page, 'Run');
	await page.locator('.world').focus();
	await page.keyboard.down('ArrowUp');
	await page.waitForFunction(() => globalThis.playground.world.agents.find(({ breed }) => breed === 'bears').x > 0.3);
	await page.keyboard.up('ArrowUp');
	await page.keyboard.down('ArrowLeft');
	await page.waitForFunction(() => globalThis.playground.world.agents.find(({ breed }) => breed === 'bears').heading > 20);
	await page.keyboard.up('ArrowLeft');
	await press(page, 'Stop');
	assert.equal(before.heading, 0);
	// a turtle in front of the bear
	await press(page, 'Reset');
	await page.evaluate(() => {
		const { world } = globalThis.playground;
		const bear = world.agents.find(({ breed }) => breed === 'bears');
		for (const agent of world.agents.filter((other) => other !== bear)) {
			agent.jumpTo(-10, agent.y, agent.z);
		}
		const turtle = world.agents.find(({ breed }) => breed === 'turtles');
		turtle.size = 3;
		turtle.jumpTo(bear.x + 4, bear.y, 0);
		globalThis.target = turtle;
	});
	const was = await page.evaluate(() => globalThis.target.color);
	if (size.hasTouch) {
		await page.getByRole('button', { name: 'Throw' }).tap();
	} else {
		await page.locator('.world').focus();
		await page.keyboard.press('Space');
	}
	await step(page, 1);
	assert.equal((await agents(page, 'paintballs')).length, 1, 'a ball is thrown');
	await step(page, 19);
	assert.notEqual(await page.evaluate(() => globalThis.target.color), was);
	assert.equal((await agents(page, 'paintballs')).length, 0, 'the ball is gone');
}

/** What a page does with one program after the other. */
const PROGRAMS = {
	'keys move the bear, and a thrown ball colours a turtle': (page) => keysMoveTheBear(page, SIZES.desktop),

	'a program does what its blocks say': async (page) => {
		const forward = { type: 'starlogo_forward', inputs: { STEPS: number(0.5) } };
		const grow = { type: 'starlogo_size', inputs: { SIZE: number(2) } };
		await openProgram(page, program(start(create('turtles', 'turtle', grow)), each('turtles', forward)));
		await step(page, 4);
		const [turtle] = await agents(page, 'turtles');
		assert.equal(turtle.x, 2);
		assert.equal(turtle.size, 2);
		await press(page, 'Reset');
		assert.equal((await agents(page, 'turtles'))[0].x, 0);
	},

	'a block that is changed in the editor changes what happens': async (page) => {
		await openProgram(page, program(start(create('turtles', 'turtle')), each('turtles', { type: 'starlogo_forward', inputs: { STEPS: number(0.5) } })));
		await page.locator('.blocklyMainBackground ~ * .blocklyEditableField:has-text("0.5"), .blocklyBlockCanvas .blocklyEditableField:has-text("0.5")').first().click();
		await page.keyboard.press('Control+A');
		await page.keyboard.type('2');
		await page.keyboard.press('Enter');
		await page.waitForTimeout(300);
		await step(page, 2);
		assert.equal((await agents(page, 'turtles'))[0].x, 4);
	},

	'a program is saved to a file that opens again': async (page) => {
		await openProgram(page, program(start(create('walls', 'wall'))));
		const [download] = await Promise.all([page.waitForEvent('download'), press(page, 'Save')]);
		const text = readFileSync(await download.path(), 'utf8');
		await page.getByLabel('Program', { exact: true }).selectOption('paintball');
		assert.equal((await agents(page, 'walls')).length, 5);
		await openProgram(page, text);
		assert.equal((await agents(page, 'walls')).length, 1);
	},

	'an endless loop is stopped and named, and so is a mistake in a block': async (page) => {
		const endless = { type: 'controls_whileUntil', fields: { MODE: 'WHILE' }, inputs: { BOOL: { block: { type: 'logic_boolean', fields: { BOOL: 'TRUE' } } } } };
		await openProgram(page, program(start(create('turtles', 'turtle')), each('turtles', endless)));
		await press(page, 'Run');
		await page.waitForSelector('.game .status.problem');
		assert.match(await say(page), /^The program stopped: the loop “repeat while” never comes to an end/);
		await openProgram(page, program(start({ type: 'starlogo_collide_as', fields: { WHO: 'me', AS: 'box' } })));
		assert.match(await say(page), /the block “collide as” is about an agent, but there is none here|is about an agent/);
		const depth = { type: 'starlogo_depth', fields: { WHO: 'turtles' }, inputs: { DEPTH: number(1.5) } };
		await openProgram(page, program(start(depth)));
		assert.match(await say(page), /The block "set collision depth" needs a whole number/);
	},

	'a broken program says so, and leaves what was there': async (page) => {
		await page.getByLabel('Program', { exact: true }).selectOption('paintball');
		await openProgram(page, '{"blocks": 7}');
		assert.equal(await say(page), 'This is no program of the playground.');
		await openProgram(page, program({ type: 'no_such_block' }));
		assert.equal(await say(page), 'This is no program of the playground.');
		assert.equal((await agents(page, 'bears')).length, 1);
	},
};

/** Which systems find a near miss: by the example's name. */
const NEAR_MISSES = {
	helmet: { 'unit spheres': false, 'tightest fits': true, hierarchies: true, exact: true },
	wing: { 'unit spheres': true, 'tightest fits': true, hierarchies: false, exact: false },
	wall: { 'unit spheres': true, 'tightest fits': false, hierarchies: false, exact: false },
};

for (const [example, expected] of Object.entries(NEAR_MISSES)) {
	PROGRAMS[`switching systems changes the outcome: ${example}`] = async (page) => {
		await page.getByLabel('Program', { exact: true }).selectOption(example);
		const found = {};
		for (const system of Object.keys(expected)) {
			await page.getByLabel('Collision system').selectOption(system);
			await step(page, 2);
			found[system] = (await agents(page, 'turtles'))[0].color === 0xe5484d;
		}
		assert.deepEqual(found, expected);
	};
}

// a page is opened once: that is what takes the time
test('programs, one after the other', async (t) => {
	const { page, context, said } = await open(site, 'play');
	for (const [title, check] of Object.entries(PROGRAMS)) {
		await t.test(title, async () => {
			await check(page);
			assert.deepEqual(said, []);
		});
	}
	await t.test('a program comes back after a reload, and through its link', async () => {
		await openProgram(page, program(start(create('walls', 'wall')), each('walls', { type: 'starlogo_up', inputs: { STEPS: number(1) } })));
		await page.reload();
		await ready(page, 'play');
		await step(page, 3);
		assert.equal((await agents(page, 'walls'))[0].z, 3);
		await press(page, 'Copy a link');
		await page.waitForFunction(() => location.hash.length > 20);
		assert.deepEqual(said, []);
		const other = await open(site, page.url().split('#')[1]);
		await step(other.page, 2);
		assert.equal((await agents(other.page, 'walls'))[0].z, 2);
		assert.deepEqual(other.said, []);
		await other.context.close();
	});
	await context.close();
});

test('keys move the bear, and a thrown ball colours a turtle, on a phone', async () => {
	const { page, context, said } = await open(site, 'play', SIZES.phone);
	await keysMoveTheBear(page, SIZES.phone);
	assert.deepEqual(said, []);
	await context.close();
});

test('a broken link says so', async () => {
	const { page, context } = await open(site, 'play/nonsense');
	assert.equal(await say(page), 'The program in this link could not be read.');
	await context.close();
});
