/** Play, in the browser. 3D is drawn where a test is about what is drawn, and with the keys; else nothing is, as the processor would have to. */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { isChromium } from '../../build/headless/browsers.mjs';
import { SIZES, begin, drop, finger, hold, newPage, open, own, press, ready, rest, tabTo, tap, titled } from './browser.mjs';

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

const Desktop = SIZES.desktop;

let common;
/** A page that tests share which leave nothing of theirs there but the program that is open. */
async function shared() {
	common ??= await open(site, 'play/paintball', Desktop);
	return common;
}

/** What the world of the open page is; the page lends it for this. */
const agents = (page, breed) => page.evaluate((which) => globalThis.playground.world.agents.filter((agent) => agent.breed === which)
	.map(({ x, y, z, heading, color, size }) => ({ x, y, z, heading, color, size })), breed);
const say = (page) => page.textContent('.game .status');
/** Waits until Play says what matches. */
const told = (page, { source }) => page.waitForFunction((pattern) => new RegExp(pattern).test(document.querySelector('.game .status').textContent), source);

/** Takes steps of one frame each: the first by the pointer. */
async function step(page, count) {
	await press(page, 'Step');
	await page.getByRole('button', { name: 'Step', exact: true }).evaluate((button, more) => {
		for (let i = 0; i < more; i++) button.click();
	}, count - 1);
}

const number = (value) => ({ shadow: { type: 'math_number', fields: { NUM: value } } });
const create = (breed, shape, inner) => ({ type: 'starlogo_create', fields: { BREED: breed, SHAPE: shape }, inputs: { COUNT: number(1), ...(inner && { DO: { block: inner } }) } });
const start = (block) => ({ type: 'starlogo_start', inputs: { DO: { block } } });
const each = (breed, block) => ({ type: 'starlogo_each', fields: { BREED: breed }, inputs: { DO: { block } } });
const program = (...scripts) => JSON.stringify({ blocks: { languageVersion: 0, blocks: scripts } });

/** Opens a program from a file, as the user does. */
async function openProgram(page, text) {
	await page.evaluate(() => {
		document.querySelector('.controls .status').textContent = '';
	});
	await page.setInputFiles('.program input[type=file]', { name: 'program.json', mimeType: 'application/json', buffer: Buffer.from(text) });
	await page.waitForFunction(() => document.querySelector('.controls .status').textContent !== '');
}

/** Opens what an address names: one that the page brings, or one of the user's by its id. */
async function choose(page, name) {
	await page.evaluate((argument) => {
		delete document.querySelector('main').dataset.ready;
		location.hash = `play/${argument}`;
	}, name);
	await ready(page, 'play');
}

/** Waits until the user has so many programs. */
const has = (page, count) => page.waitForFunction((wanted) => globalThis.playground.programs.shelf.all.length === wanted, count);
const idOf = (page, name) => page.evaluate((title) => globalThis.playground.programs.shelf.all.find((each) => each.name === title).id, name);
const blocks = (page) => page.evaluate(() => globalThis.playground.editor.workspace.getAllBlocks().length);
/** Waits for what Blockly tells after a change. */
const settle = (page) => rest(page, 150);

for (const name of ['desktop', 'phone']) {
	test(`keys move the bear, and a thrown ball colours a turtle (${name})`, async () => {
		const { page, said, leave } = await open(site, 'play/paintball', { ...SIZES[name], isDrawn: name === 'desktop' });
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
		if (name === 'phone') {
			await tap(page.getByRole('button', { name: 'Throw' }));
		} else {
			await page.locator('.world').focus();
			await page.keyboard.press('Space');
		}
		await step(page, 1);
		assert.equal((await agents(page, 'paintballs')).length, 1, 'a ball is thrown');
		await step(page, 19);
		assert.notEqual(await page.evaluate(() => globalThis.target.color), was);
		assert.equal((await agents(page, 'paintballs')).length, 0, 'the ball is gone');
		assert.deepEqual(said, []);
		await leave();
	});
}

test('a program does what its blocks say', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	const forward = { type: 'starlogo_forward', inputs: { STEPS: number(0.5) } };
	const grow = { type: 'starlogo_size', inputs: { SIZE: number(2) } };
	await openProgram(page, program(start(create('turtles', 'turtle', grow)), each('turtles', forward)));
	await step(page, 4);
	const [turtle] = await agents(page, 'turtles');
	assert.equal(turtle.x, 2);
	assert.equal(turtle.size, 2);
	await press(page, 'Reset');
	assert.equal((await agents(page, 'turtles'))[0].x, 0);
	// a breed of one's own, that says something
	const hello = { type: 'starlogo_say', inputs: { TEXT: { shadow: { type: 'text', fields: { TEXT: 'Hello!' } } } } };
	await openProgram(page, program(start(create('turtles', 'bear', hello))));
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].setFieldValue('new breed', 'BREED'));
	await page.locator('.ask input').fill('dogs');
	await page.keyboard.press('Enter');
	await page.waitForFunction(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].getFieldValue('BREED') === 'dogs');
	await step(page, 1);
	assert.equal((await agents(page, 'dogs')).length, 1);
	assert.equal(await page.textContent('.bubble'), 'Hello!');
	// the bear fills the picture, and its words stay in it
	await page.getByLabel('Camera').selectOption({ index: 0 });
	await page.waitForFunction(() => {
		const [bubble, world] = ['.bubble', '.world'].map((name) => document.querySelector(name).getBoundingClientRect());
		return bubble.height > 0 && bubble.top >= world.top && bubble.bottom < world.bottom;
	});
	await page.getByRole('button', { name: 'Full screen' }).click();
	await page.waitForFunction(() => document.fullscreenElement?.className === 'theatre');
	await page.locator('.theatre .controls').waitFor();
	await page.evaluate(() => document.exitFullscreen());
	// ten times slower
	await page.getByLabel('Speed').fill('0');
	await press(page, 'Run');
	const [frame, begun] = await page.evaluate(() => [globalThis.playground.world.frame, performance.now()]);
	await page.waitForFunction((before) => globalThis.playground.world.frame > before + 3, frame);
	const seconds = await page.evaluate((before) => (performance.now() - before) / 1000, begun);
	assert.ok(seconds > 0.4, `4 frames at a tenth of 60 in ${seconds} s`);
	await press(page, 'Stop');
	assert.deepEqual(said, []);
	await leave();
});

test('a block that is changed in the editor changes what happens', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	await openProgram(page, program(start(create('turtles', 'turtle')), each('turtles', { type: 'starlogo_forward', inputs: { STEPS: number(0.5) } })));
	await page.locator('.blocklyMainBackground ~ * .blocklyEditableField:has-text("0.5"), .blocklyBlockCanvas .blocklyEditableField:has-text("0.5")').first().click();
	await page.keyboard.press('Control+A');
	await page.keyboard.type('2');
	await page.keyboard.press('Enter');
	await settle(page);
	await step(page, 2);
	assert.equal((await agents(page, 'turtles'))[0].x, 4);
	// what was typed is taken back, and done again; no program comes or goes by that
	const edit = page.locator('.edit');
	await edit.getByRole('button', { name: 'Undo' }).click();
	await settle(page);
	await step(page, 2);
	assert.equal((await agents(page, 'turtles'))[0].x, 1);
	// there is nothing more to take back: the button says so, and does nothing
	assert.equal(await edit.getByRole('button', { name: 'Undo' }).getAttribute('aria-disabled'), 'true');
	await edit.getByRole('button', { name: 'Undo' }).click({ force: true });
	assert.equal((await agents(page, 'turtles')).length, 1);
	await edit.getByRole('button', { name: 'Redo' }).click();
	await settle(page);
	await step(page, 2);
	assert.equal((await agents(page, 'turtles'))[0].x, 4);
	assert.deepEqual(said, []);
	await leave();
});

/** Which systems find a near miss: by the example's name. */
const NEAR_MISSES = {
	helmet: { 'unit spheres': false, 'tightest fits': true, hierarchies: true, exact: true },
	wing: { 'unit spheres': true, 'tightest fits': true, hierarchies: false, exact: false },
	wall: { 'unit spheres': true, 'tightest fits': false, hierarchies: false, exact: false },
};

for (const [example, expected] of Object.entries(NEAR_MISSES)) {
	test(`switching systems changes the outcome: ${example}`, async () => {
		const { page, said } = await shared();
		await choose(page, example);
		const found = {};
		for (const system of Object.keys(expected)) {
			await page.getByLabel('Collision system').selectOption(system);
			await step(page, 2);
			found[system] = await page.evaluate(() => globalThis.playground.world.agents[0].color === 0xe5484d);
		}
		assert.deepEqual(found, expected);
		assert.deepEqual(said.splice(0), []);
	});
}

test('broken programs and links say so, and leave what was there', async () => {
	const { page, leave } = await open(site, 'play/paintball', Desktop);
	await openProgram(page, '{"blocks": 7}');
	assert.equal(await say(page), 'This is no program of the playground.');
	await openProgram(page, program({ type: 'no_such_block' }));
	assert.equal(await say(page), 'This is no program of the playground.');
	assert.equal((await agents(page, 'bears')).length, 1);
	await leave();
	const other = await open(site, 'play/nonsense', Desktop);
	assert.equal(await say(other.page), 'Nothing is at the address “nonsense”. Perhaps a letter is wrong. Here are the lessons and games.');
	await other.leave();
});

test('an endless loop is stopped and named, and so is a mistake in a block', async () => {
	const { page, said } = await shared();
	const endless = { type: 'controls_whileUntil', fields: { MODE: 'WHILE' }, inputs: { BOOL: { block: { type: 'logic_boolean', fields: { BOOL: 'TRUE' } } } } };
	await openProgram(page, program(start(create('turtles', 'turtle')), each('turtles', endless)));
	await press(page, 'Run');
	await page.waitForSelector('.game .status.problem');
	assert.match(await say(page), /^The program stopped: the loop “repeat while” never comes to an end. Its condition has to become false/);
	const marked = await page.evaluate(() => {
		const path = document.querySelector('.failed > .blocklyPath');
		return { stroke: getComputedStyle(path).stroke, fill: path.getAttribute('fill') };
	});
	assert.deepEqual(marked, { stroke: 'rgb(208, 2, 27)', fill: '#3d6a80' }, 'its words are as readable as before');
	await openProgram(page, program(start({ type: 'starlogo_collide_as', fields: { WHO: 'me', AS: 'box' } })));
	assert.match(await say(page), /the block “collide as” is about an agent, but there is none here|is about an agent/);
	const depth = { type: 'starlogo_depth', fields: { WHO: 'turtles' }, inputs: { DEPTH: number(1.5) } };
	await openProgram(page, program(start(depth)));
	assert.match(await say(page), /The block "set collision depth" needs a whole number/);
	assert.deepEqual(said.splice(0), []);
});

test('a student\'s own program is never lost: not by examples, links, nor broken ones', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	await openProgram(page, program(start(create('walls', 'wall'))));
	assert.deepEqual(await own(page), ['program']);
	await choose(page, 'wing');
	await page.evaluate(() => {
		location.hash = 'play/nonsense';
	});
	await page.waitForSelector('.gallery .status.problem');
	await choose(page, 'paintball');
	await page.reload();
	await ready(page, 'play');
	assert.equal((await agents(page, 'turtles')).length, 10, 'what was open last is open');
	await choose(page, await idOf(page, 'program'));
	assert.equal((await agents(page, 'walls')).length, 1);
	// one step leads back from what replaced it
	await choose(page, 'helmet');
	await press(page, 'Back to “program”');
	assert.equal((await agents(page, 'walls')).length, 1);
	assert.equal((await agents(page, 'firemen')).length, 0);
	// an example that is changed becomes one more
	await choose(page, 'helmet');
	await page.evaluate(() => globalThis.playground.editor.workspace.getTopBlocks()[0].dispose());
	await has(page, 2);
	assert.deepEqual(await own(page), ['program', 'The fireman\'s helmet (mine)']);
	assert.deepEqual(said, []);
	await leave();
});

test('undo in the blocks after an example leaves the example', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	await openProgram(page, program(start(create('walls', 'wall'))));
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].dispose());
	await settle(page);
	await choose(page, 'helmet');
	await settle(page);
	const count = await blocks(page);
	for (let i = 0; i < 3; i++) {
		await page.evaluate(() => globalThis.playground.editor.workspace.undo(false));
	}
	await settle(page);
	assert.equal(await blocks(page), count);
	assert.deepEqual(said, []);
	await leave();
});

test('the figures have all that touched since the last look, whoever has scripts', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	const scatter = { type: 'starlogo_scatter' };
	const crowd = (breed, shape, count) => ({ ...create(breed, shape, scatter), inputs: { COUNT: number(count), DO: { block: scatter } } });
	await openProgram(page, program(start({ ...crowd('turtles', 'turtle', 14), next: { block: crowd('walls', 'wall', 14) } }), each('turtles', { type: 'starlogo_forward', inputs: { STEPS: number(0.3) } })));
	await press(page, 'Run');
	const look = () => Number([...document.querySelectorAll('.figures div')].find((each) => each.textContent.endsWith('touching')).querySelector('dd').textContent);
	await page.waitForFunction(look);
	const looks = [];
	for (let i = 0; i < 8; i++) {
		looks.push(await page.evaluate(look));
		await rest(page, 250);
	}
	await press(page, 'Stop');
	assert.ok(looks.every((each) => each > 0), looks.join());
	const met = await page.locator('.met li').allTextContents();
	assert.match(met[0], /^\d+\.\d s (walls|turtles) \d+ met (walls|turtles) \d+$/);
	assert.match((await page.locator('.totals li').allTextContents()).join(), /turtles × walls \d+/);
	// rewound, the list is what it was
	const frames = await page.evaluate(() => globalThis.playground.world.frame);
	await page.getByLabel('Rewind').fill('-20');
	assert.equal(await page.evaluate(() => globalThis.playground.world.frame), frames - 20);
	assert.equal(await say(page), `Frame ${frames - 20}`);
	await step(page, 1);
	assert.equal(await page.evaluate(() => globalThis.playground.world.frame), frames - 19);
	assert.deepEqual(said, []);
	await leave();
});

test('after a choice of system the arrow keys play, and at a wall the bear is not stuck', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	await page.getByLabel('Collision system').selectOption('exact');
	await page.evaluate(() => {
		const { world } = globalThis.playground;
		const [bear, wall] = ['bears', 'walls'].map((breed) => world.agents.find((agent) => agent.breed === breed));
		for (const agent of world.agents) agent.jumpTo(agent.x, 11, agent.z);
		bear.jumpTo(-3, -8, 0);
		bear.heading = 45;
		wall.heading = 0;
		wall.size = 9;
		wall.jumpTo(-1, -8, 0);
	});
	const bear = async () => (await agents(page, 'bears'))[0];
	const hold = async (key, frames) => {
		await page.evaluate((name) => globalThis.playground.world.input.press(name), key);
		await step(page, frames);
		await page.evaluate((name) => globalThis.playground.world.input.release(name), key);
	};
	await hold('up', 8);
	await page.getByLabel('Collision system').selectOption('tightest fits');
	await step(page, 1);
	assert.ok(await page.evaluate(() => globalThis.playground.world.agents.find(({ breed }) => breed === 'bears').touched > 0), 'as boxes they overlap');
	const at = await bear();
	await hold('left', 3);
	assert.equal((await bear()).heading, 54);
	await hold('down', 3);
	assert.ok((await bear()).x < at.x - 0.05, `${(await bear()).x} after ${at.x}`);
	// the same by the keys themselves, while it runs
	await press(page, 'Run');
	await page.getByLabel('Collision system').selectOption('unit spheres');
	await page.keyboard.press('ArrowLeft', { delay: 300 });
	await page.waitForFunction(() => globalThis.playground.world.agents.find(({ breed }) => breed === 'bears').heading > 54);
	assert.equal(await page.getByLabel('Collision system').inputValue(), 'unit spheres');
	assert.deepEqual(said, []);
	await leave();
});

test('on a phone fingers scroll the page over the world, and Run is in sight beside the blocks', { skip: isChromium ? false : 'fingers that move are Chromium\'s' }, async () => {
	const { page, said, leave } = await open(site, 'play/paintball', SIZES.phone);
	const touch = await finger(page);
	const swipe = async (selector) => {
		// in its middle, or as near to that as there is no block, which the finger would move
		const { x, y } = await page.evaluate((name) => {
			const box = document.querySelector(name).getBoundingClientRect();
			const places = Array.from({ length: 40 }, (_, i) => ({ x: box.left + (box.width * (10 + (i % 10))) / 20, y: box.top + box.height / 2 + 20 * Math.floor(i / 10) }));
			return places.find((place) => !document.elementFromPoint(place.x, place.y)?.closest('.blocklyDraggable'));
		}, selector);
		await touch('touchStart', { x, y });
		for (let i = 1; i <= 10; i++) {
			await touch('touchMove', { x, y: y - 20 * i });
			await rest(page);
		}
		await touch('touchEnd');
	};
	const isRunSeen = () => page.evaluate(() => {
		const { top, bottom } = document.querySelector('.primary').getBoundingClientRect();
		return top >= 0 && bottom <= innerHeight;
	});
	assert.ok(await isRunSeen());
	await swipe('.world');
	await page.waitForFunction(() => scrollY > 50);
	assert.ok(await isRunSeen());
	await press(page, 'Blocks');
	assert.ok(await isRunSeen());
	await swipe('.blocks');
	await page.waitForFunction(() => globalThis.playground.editor.workspace.scrollY < -40);
	assert.ok(await isRunSeen());
	await press(page, 'Run');
	assert.ok(await page.locator('.world').isVisible());
	assert.deepEqual(said, []);
	await leave();
});

test('neither zoom nor a moved view loses the world, and all of it is one choice away', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	const inSight = () => page.evaluate(() => {
		const { stage } = globalThis.playground;
		return [[0, 0], [-12, -12], [12, 12]].map(([x, y]) => stage.pixelOf(x, y, 0)).filter(({ isSeen }) => isSeen).length;
	});
	assert.equal(await page.getByLabel('Camera').inputValue(), 'follow');
	await page.getByLabel('Camera').selectOption('all');
	assert.equal(await inSight(), 3);
	const { x, y, width, height } = await page.locator('.world').boundingBox();
	await page.mouse.move(x + width / 2, y + height / 2);
	for (let i = 0; i < 40; i++) {
		await page.mouse.wheel(0, 1000);
	}
	await page.mouse.down({ button: 'right' });
	await page.mouse.move(x + 5, y + 5, { steps: 3 });
	await page.mouse.up({ button: 'right' });
	await settle(page);
	const view = await page.evaluate(() => {
		const { camera, controls } = globalThis.playground.stage;
		return { distance: camera.position.distanceTo(controls.target), x: controls.target.x, y: controls.target.y };
	});
	assert.ok(view.distance <= 73 && Math.abs(view.x) <= 12 && Math.abs(view.y) <= 12, JSON.stringify(view));
	await page.getByLabel('Camera').selectOption('eyes');
	await page.getByLabel('Camera').selectOption('all');
	assert.equal(await inSight(), 3);
	assert.deepEqual(said, []);
	await leave();
});

test('a crowd in ever new colours is drawn at once', async () => {
	const { page, said, leave } = await open(site, 'play/paintball');
	const paint = { type: 'starlogo_colour', fields: { WHO: 'me' }, inputs: { COLOUR: { block: { type: 'math_random_int', inputs: { FROM: number(1), TO: number(16777215) } } } } };
	await openProgram(page, program(start({ ...create('turtles', 'cube', { type: 'starlogo_scatter' }), inputs: { COUNT: number(1900), DO: { block: { type: 'starlogo_scatter' } } } }), each('turtles', paint)));
	await step(page, 2);
	const { colours, calls, ms } = await page.evaluate(() => {
		const { world, stage } = globalThis.playground;
		const begin = performance.now();
		for (let i = 0; i < 5; i++) stage.showAgents(world.agents, globalThis.playground.models);
		return { colours: new Set(world.agents.map(({ color }) => color)).size, calls: stage.renderer.info.render.calls, ms: (performance.now() - begin) / 5 };
	});
	console.log(`${colours} colours: ${calls} draw calls, ${ms.toFixed(1)} ms to prepare them`);
	assert.ok(colours > 1800 && calls < 20, `${colours} colours, ${calls} calls`);
	if (isChromium) {
		assert.equal(await page.evaluate(() => globalThis.playground.stage.renderer.getContextAttributes().antialias), false, 'the processor draws: edges are not smoothed');
	}
	// 300 that walk and turn: what the page itself does in a frame, without what WebGL does with it
	await openProgram(page, program(
		start({ ...create('turtles', 'turtle'), inputs: { COUNT: number(300), DO: { block: { type: 'starlogo_scatter' } } } }),
		each('turtles', { type: 'starlogo_forward', inputs: { STEPS: number(0.05) }, next: { block: { type: 'starlogo_turn', fields: { DIRECTION: 'left' }, inputs: { DEGREES: number(2) } } } })));
	// nothing asks for sizes between frames, for which the browser would lay out the page at once: not even who says something
	if (isChromium) {
		await page.evaluate(() => {
			const { world } = globalThis.playground;
			for (const agent of world.agents.slice(0, 5)) agent.said = { text: 'Hi', until: Infinity };
		});
		const client = await page.context().newCDPSession(page);
		await client.send('Performance.enable');
		const layouts = async () => (await client.send('Performance.getMetrics')).metrics.find(({ name }) => name === 'LayoutCount').value;
		const before = await layouts();
		await page.evaluate(() => {
			const { playground } = globalThis;
			for (let i = 0; i < 30; i++) {
				playground.world.step();
				playground.panel.count();
				playground.draw(1);
			}
		});
		const count = await layouts() - before;
		assert.ok(count < 5, `the page was laid out ${count} times in 30 frames that nobody saw`);
	}
	const [frame, drawing] = await page.evaluate(() => {
		const { playground } = globalThis;
		const { world, panel, stage } = playground;
		const gl = stage.renderer.getContext();
		let draws = 0;
		for (const name in gl) if (/^(draw|buffer|clear$)/.test(name) && typeof gl[name] === 'function') gl[name] = () => draws++;
		const times = [];
		for (let i = 0; i < 120; i++) {
			const begin = performance.now();
			world.step();
			panel.count();
			playground.draw(1);
			times.push(performance.now() - begin);
		}
		return [times.sort((a, b) => a - b)[60], draws / 120];
	});
	console.log(`300 agents: ${frame.toFixed(2)} ms a frame for the page's own part, ${drawing.toFixed(0)} calls that draw or upload`);
	assert.ok(drawing > 5 && drawing < 60, `${drawing} calls a frame`);
	assert.deepEqual(said, []);
	await leave();
});

test('refused storage, another tab, and dropped files are said in words', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	const dropped = async (name, text) => {
		await drop(page, [name, Buffer.from(text)]);
		await settle(page);
	};
	await dropped('mine.json', program(start(create('walls', 'wall'))));
	assert.deepEqual(await own(page), ['mine']);
	await dropped('picture.png', 'x');
	await told(page, /^picture\.png is neither a program/);
	// a model of one's own is a shape
	await dropped('cone.obj', 'v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n');
	await told(page, /^Agents can have the shape “cone” now/);
	assert.equal(await page.evaluate(() => {
		const [made] = globalThis.playground.editor.workspace.getBlocksByType('starlogo_create');
		// as when its menu opens
		made.getField('SHAPE').getOptions(false);
		made.setFieldValue('cone', 'SHAPE');
		return made.getFieldValue('SHAPE');
	}), 'cone');
	await press(page, 'Step');
	assert.equal(await page.evaluate(() => globalThis.playground.world.agents[0].shape), 'cone');
	// the same file again is the same model
	await dropped('again.obj', 'v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n');
	await told(page, /“cone” now.*This browser keeps it/);
	await dropped('broken.obj', 'v 1 2 x\n');
	await told(page, /^broken\.obj cannot be shown\. Line 1: expected/);
	const other = await page.context().newPage();
	await other.goto(page.url());
	await ready(other, 'play');
	// the browser has the model for every page, until it is to forget it
	assert.equal(await other.evaluate(() => globalThis.playground.world.agents[0].shape), 'cone');
	await other.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].dispose());
	await page.waitForFunction(() => /^“mine” was changed in another tab/.test(document.querySelector('.game .status').textContent));
	await page.bringToFront();
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].setFieldValue('bears', 'BREED'));
	await has(page, 2);
	assert.deepEqual(await own(page), ['mine', 'mine (mine)']);
	await other.close();
	await page.evaluate(() => {
		Storage.prototype.setItem = () => {
			throw new DOMException('full', 'QuotaExceededError');
		};
		globalThis.playground.editor.workspace.getBlocksByType('starlogo_create')[0].setFieldValue('turtles', 'BREED');
	});
	await page.waitForSelector('.game .status.problem');
	await told(page, /^This browser keeps no programs/);
	await page.evaluate(() => {
		IDBObjectStore.prototype.put = () => {
			throw new DOMException('full', 'QuotaExceededError');
		};
	});
	await dropped('cone.obj', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\n');
	await told(page, /^Agents can have the shape “cone 2” now, as long as this page is open\. This browser keeps no models/);
	// what is kept can be looked at, and forgotten
	await press(page, 'Lessons and games');
	const cards = page.locator('.gallery section', { hasText: 'Your models' });
	await cards.getByRole('button', { name: 'cone', exact: true }).click();
	await page.waitForFunction(() => globalThis.playground.world.agents[0]?.shape === 'cone');
	await press(page, 'Lessons and games');
	await cards.getByRole('button', { name: 'Delete cone', exact: true }).click();
	await page.waitForFunction(() => /forgets the model “cone”/.test(document.querySelector('.game .status').textContent));
	await page.reload();
	await ready(page, 'play');
	assert.deepEqual(await page.evaluate(() => [globalThis.playground.modelShelf.names, globalThis.playground.models.has('cone')]), [[], false]);
	assert.deepEqual(said, []);
	await leave();
});

test('at first sight: what this is, the goal, the keys, Run, and words of 14 pixels', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', { viewport: { width: 1366, height: 768 } });
	for (const [width, height] of [[1366, 768], [1920, 1080], [390, 844]]) {
		await page.setViewportSize({ width, height });
		await settle(page);
		for (const selector of ['.goal', '.keys', '.primary', '.world']) {
			const box = await page.locator(selector).boundingBox();
			assert.ok(box && box.y >= 0 && box.y + Math.min(box.height, 200) <= height && box.x >= 0 && box.x + box.width <= width, `${selector} at ${width} x ${height}: ${JSON.stringify(box)}`);
		}
	}
	const heights = await page.evaluate(() => [...document.querySelectorAll('.blocklyBlockCanvas .blocklyText')].map((text) => parseFloat(getComputedStyle(text).fontSize) * globalThis.playground.editor.workspace.scale));
	assert.ok(heights.length > 10 && heights.every((size) => size >= 14), `${Math.min(...heights)} pixels`);
	// and of the first screen: what this is, and the first lesson
	await choose(page, 'all');
	for (const [width, height] of [[1366, 768], [1920, 1080], [390, 844]]) {
		await page.setViewportSize({ width, height });
		await settle(page);
		for (const selector of ['.gallery .intro', '.gallery .next']) {
			const box = await page.locator(selector).boundingBox();
			assert.ok(box && box.y >= 0 && box.y + box.height <= height && box.x >= 0 && box.x + box.width <= width, `${selector} at ${width} x ${height}: ${JSON.stringify(box)}`);
		}
	}
	assert.deepEqual(said, []);
	await leave();
});

test('a click on an agent tells of it, what the engine sees is shown, and a won game begins again', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', Desktop);
	const at = await page.evaluate(() => {
		const { world, stage } = globalThis.playground;
		const bear = world.agents.find(({ breed }) => breed === 'bears');
		const { x, y } = stage.pixelOf(bear.x, bear.y, 1.2);
		const box = stage.host.getBoundingClientRect();
		return { x: box.left + x, y: box.top + y, number: bear.number };
	});
	await page.mouse.click(at.x, at.y);
	assert.match(await page.textContent('.inspector'), new RegExp(`^bears ${at.number}a bear, seen by tightest fits`));
	// and one of a breed after the other, without a mouse
	for (const name of ['turtles 2', 'turtles 3', 'seagulls 12']) {
		await press(page, name.startsWith('turtles') ? 'turtles 10' : 'seagulls 6');
		assert.match(await page.textContent('.inspector'), new RegExp(`^${name}a`));
	}
	const paint = () => page.evaluate(() => {
		const all = [];
		globalThis.playground.stage.actors.traverse(({ isInstancedMesh, geometry, count }) => isInstancedMesh && all.push([...geometry.attributes.paint.array.subarray(0, 4 * count)].join()));
		return all;
	});
	await press(page, 'Step');
	const colours = await paint();
	assert.ok(colours.length > 4 && await page.evaluate(() => globalThis.playground.world.touching > 0));
	await page.getByLabel('What the engine sees').check();
	assert.deepEqual(await paint(), colours, 'agents that touch keep their colours');
	const solids = () => page.evaluate(() => globalThis.playground.stage.marks.boxes.mesh.count);
	const few = await solids();
	assert.ok(few > 5 && few <= 22, `${few} boxes`);
	await page.getByLabel('Collision system').selectOption('hierarchies');
	assert.ok(await solids() > 5 * few, 'trees of boxes');
	await page.evaluate(() => {
		for (const agent of globalThis.playground.world.agents) if (agent.breed === 'turtles') agent.color = 0xff0000;
	});
	await press(page, 'Run');
	await page.waitForSelector('.end');
	assert.match(await page.textContent('.end'), /You have won!.*It took \d+\.\d seconds\./s);
	assert.equal(await page.textContent('.score'), 'Score 10');
	await press(page, 'Play again');
	await page.waitForFunction(() => document.querySelector('.score').textContent === 'Score 0');
	assert.ok(!(await page.locator('.end').isVisible()));
	assert.deepEqual(said, []);
	await leave();
});

test('a lesson is opened, done and left for the next; the first screen has all programs, and takes names', async () => {
	const { page, said, leave } = await open(site, 'play', Desktop);
	await page.waitForSelector('.gallery .intro');
	await page.locator('.gallery .next').click();
	await press(page, 'A hint');
	assert.ok(await page.getByText('under Movement, goes into the script').isVisible());
	await press(page, 'Next');
	await page.waitForFunction(() => /^Lesson 2 of 11Why is the helmet missed\?/.test(document.querySelector('.lesson').textContent));
	assert.equal(await page.evaluate(() => location.hash), '#play/lesson-helmet');
	assert.equal(await page.getByLabel('Collision system').inputValue(), 'unit spheres');
	await step(page, 2);
	assert.equal(await page.textContent('.lesson .why'), '');
	// the choice is all that is asked for
	await page.getByLabel('Collision system').selectOption('tightest fits');
	await page.waitForSelector('.confetti', { state: 'attached' });
	assert.match(await page.textContent('.lesson .why'), /^Done! A unit sphere is as wide as the fireman/);
	// the system is the lesson's, and goes with it
	await press(page, 'Next');
	await page.waitForFunction(() => /^Lesson 3/.test(document.querySelector('.lesson').textContent));
	assert.equal(await page.getByLabel('Collision system').inputValue(), 'tightest fits');
	await press(page, 'Back');
	await page.waitForFunction(() => /^Lesson 2/.test(document.querySelector('.lesson').textContent));
	assert.equal(await page.getByLabel('Collision system').inputValue(), 'unit spheres');
	// what is made of its program is the student's, and in the lesson
	await page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_size')[0].getInputTargetBlock('SIZE').setFieldValue(2, 'NUM'));
	await has(page, 1);
	assert.match(await page.textContent('.lesson'), /^Lesson 2/);
	// who leaves the lesson keeps what was made
	await press(page, 'Leave the lesson');
	assert.ok(!(await page.locator('.lesson').isVisible()));
	assert.equal((await agents(page, 'firemen'))[0].size, 2);
	await press(page, 'Lessons and games');
	await page.waitForSelector('.gallery .open');
	assert.equal(await page.locator('.gallery .open').count(), 11 + 10 + 2 + 3);
	assert.deepEqual(await page.locator('.gallery .open', { has: page.locator('.tick') }).locator('.name').allTextContents(), ['Why is the helmet missed?']);
	await page.getByLabel('Rename Why is the helmet missed? (mine)').fill('Smaller');
	await page.keyboard.press('Enter');
	assert.deepEqual(await own(page), ['Smaller']);
	await page.locator('.gallery').getByRole('button', { name: 'Delete Why' }).click();
	await told(page, /^“Smaller” is deleted/);
	assert.deepEqual(await own(page), []);
	await page.locator('.status').getByRole('button', { name: 'Undo' }).click();
	await titled(page, 'Smaller');
	assert.deepEqual(await own(page), ['Smaller']);
	assert.equal((await agents(page, 'firemen'))[0].size, 2);
	// an address leads away from the first screen, to the program that is open as well
	await choose(page, 'all');
	await page.waitForSelector('.gallery');
	await choose(page, await idOf(page, 'Smaller'));
	await page.waitForSelector('.gallery', { state: 'detached' });
	assert.ok(await page.getByLabel('Collision system').isVisible());
	assert.deepEqual(said, []);
	await leave();
});

test('the same game under two systems: from the same start, with the same keys, with what differs', async () => {
	const { page, said } = await shared();
	await choose(page, 'helmet');
	await page.getByLabel('Collision system').selectOption('unit spheres');
	await page.getByLabel('And beside it').selectOption('exact');
	await page.waitForFunction(() => document.querySelectorAll('.screens .world canvas').length === 2);
	assert.match(await page.textContent('.differences'), /^Both report the same so far/);
	await step(page, 2);
	assert.deepEqual(await page.locator('.caption').allTextContents(), ['Unit spheres\n0 touching, 0 met', 'Exact\n1 touching, 1 met']);
	assert.match(await page.textContent('.differences'), /^They differ in 2 frames\. The first time, after 0\.0 s, only exact had firemen 1 touch paintballs 2\./);
	// both are marked, in both pictures
	const marked = () => page.evaluate(() => globalThis.playground.scene.differing.size);
	assert.equal(await marked(), 2);
	await page.getByLabel('Rewind').fill('-1');
	assert.match(await page.textContent('.differences'), /^They differ in 1 frame\./);
	await page.getByLabel('Collision system').selectOption('hierarchies');
	await step(page, 1);
	assert.equal(await marked(), 0);
	// the keys play both
	await choose(page, 'paintball');
	await press(page, 'Run');
	await page.keyboard.down('ArrowLeft');
	await page.keyboard.down('ArrowUp');
	await page.waitForFunction(() => globalThis.playground.world.agents[0].heading > 30);
	await page.keyboard.up('ArrowUp');
	await page.keyboard.up('ArrowLeft');
	await press(page, 'Stop');
	const bears = await page.evaluate(() => globalThis.playground.games.map(({ world: { frame, agents: [bear] } }) => [frame, bear.breed, bear.x, bear.y, bear.heading]));
	assert.deepEqual(bears[0], bears[1]);
	assert.ok(bears[0][2] !== 0 && bears[0][4] > 30, bears[0].join());
	// both are seen from where one of them is turned to
	const { x, y, width, height } = await page.locator('.screens .world').nth(1).boundingBox();
	await page.mouse.move(x + width / 2, y + height / 2);
	await page.mouse.down();
	await page.mouse.move(x + width / 2 + 40, y + height / 2, { steps: 3 });
	await page.mouse.up();
	const eyes = await page.evaluate(() => globalThis.playground.games.map(({ stage }) => stage.camera.position.toArray().map((at) => at.toFixed(6)).join()));
	assert.equal(eyes[0], eyes[1]);
	await page.getByLabel('And beside it').selectOption('');
	assert.equal(await page.locator('.screens .world').count(), 1);
	assert.equal(await page.locator('.caption:visible').count(), 0);
	assert.deepEqual(said.splice(0), []);
});

test('the world comes before the blocks; the keyboard alone plays, edits, chooses and goes everywhere', async () => {
	const { page, said } = await newPage(site, Desktop);
	const release = await hold(page, '**/parts/editor-*.js');
	await page.goto(`${site.url}#play/paintball`);
	await page.waitForSelector('.goal:visible');
	assert.match(await page.textContent('.cast'), /bears 1.*turtles 10/);
	assert.equal(await say(page), 'Loading…');
	assert.equal(await page.locator('.blocklySvg').count(), 0);
	release();
	await ready(page, 'play');
	// plays, and scores
	await tabTo(page, 'Run');
	await page.keyboard.press('Enter');
	await page.keyboard.down('ArrowUp');
	await page.waitForFunction(() => globalThis.playground.world.agents[0].x > 0.3);
	await page.keyboard.up('ArrowUp');
	await page.evaluate(() => {
		const { agents: [bear, turtle] } = globalThis.playground.world;
		turtle.size = 4;
		turtle.jumpTo(bear.x + 4, bear.y, 0);
	});
	await page.keyboard.press('Space');
	await page.waitForFunction(() => document.querySelector('.score').textContent === 'Score 1');
	await tabTo(page, 'Stop', 'Shift+Tab');
	await page.keyboard.press('Enter');
	assert.equal(await say(page), 'Stopped');
	// edits a block: its number
	/** The type of the block that has the focus; those of the toolbox are none. */
	const block = () => page.evaluate(() => {
		const { activeElement: element } = document;
		return element.closest('.blocklyFlyout') ? null : globalThis.playground.editor.workspace.getBlockById(element.closest('.blocklyDraggable')?.dataset.id)?.type;
	});
	// they are before the world
	for (let i = 0; i < 20 && !(await block()); i++) {
		await page.keyboard.press('Shift+Tab');
		await rest(page);
	}
	assert.ok(await block(), 'a block has the focus');
	const size = () => page.evaluate(() => globalThis.playground.editor.workspace.getBlocksByType('starlogo_size')[0].getInputTargetBlock('SIZE').getFieldValue('NUM'));
	assert.equal(await size(), 0.4);
	for (let i = 0; i < 20 && await block() !== 'starlogo_size'; i++) {
		await page.keyboard.press('ArrowDown');
	}
	await page.keyboard.press('ArrowRight');
	await page.keyboard.press('Enter');
	await page.waitForSelector('.blocklyHtmlInput');
	await page.keyboard.type('3');
	await page.keyboard.press('Enter');
	assert.equal(await size(), 3);
	await titled(page, 'Paintball (mine)');
	await page.keyboard.press('Escape');
	// changes the system, looks at an agent, opens a lesson and the other views
	await tabTo(page, 'Collision system');
	await page.keyboard.press('ArrowUp');
	assert.equal(await page.getByLabel('Collision system').inputValue(), 'unit spheres');
	await tabTo(page, 'bears 1');
	await page.keyboard.press('Enter');
	assert.match(await page.textContent('.inspector'), /^bears 1/);
	await tabTo(page, 'Lessons and games', 'Shift+Tab');
	await page.keyboard.press('Enter');
	await page.waitForSelector('.gallery');
	await tabTo(page, '1Blocks make turtles moveBegin here');
	await page.keyboard.press('Enter');
	await page.waitForSelector('.lesson');
	await page.waitForFunction(() => document.activeElement.textContent === 'Blocks make turtles move');
	for (const view of ['Inspect', 'Compare']) {
		await tabTo(page, view, 'Shift+Tab');
		await page.keyboard.press('Enter');
		await ready(page, view.toLowerCase());
	}
	assert.deepEqual(said, []);
	await page.context().close();
});
