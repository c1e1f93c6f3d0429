/** What the adapter to the StarLogo Nova client shows, in Chromium, where the environment's NOVA names the client's folder. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { begin, script } from "./nova-page.mjs";
import { NOVA } from "./nova-real.mjs";

const options = { skip: NOVA ? false : "NOVA does not name the client's folder" };

let site;
before(async () => {
	if (NOVA) site = await begin();
});
after(() => site?.close());

/** Opens FishAlgae for a test, which fails if the page told an error. */
async function open(context, settings) {
	const { page, said } = await site.open("FishAlgae", settings);
	context.after(async () => {
		await page.close();
		assert.deepEqual(said, []);
	});
	return page;
}

/** In the page: what the overlay has drawn, against where agents are and what the client itself draws. */
async function compareLines({ options, part }) {
	const installation = StarLogoCollision.installInto(window, { ...options, overlay: true });
	await loaded();
	let pairs = [];
	const { getCollisions } = Execution.Collisions;
	Execution.Collisions.getCollisions = () => (pairs = getCollisions());
	// until somebody collides who then lives on, which a fish does
	for (let i = 0; i < 400 && pairs.length === 0; i++) tick();
	const hit = new Set(pairs.flatMap(({ a, b }) => [a, b]).filter((agent) => !agent.isDead));
	viewport.needsUpdate = true;
	viewport.render(part);
	const objects = viewport.scene.children.filter((child) => child instanceof THREE.LineSegments);
	const [red, yellow] = objects.map(({ geometry, visible }) => (visible ? [...geometry.attributes.position.array.slice(0, 3 * geometry.drawRange.count)] : []));
	const at = ({ state, prevState }, name) => prevState[name] + part * (state[name] - prevState[name]);
	const agents = alive().filter(({ breed }) => ["Fish", "Algae"].includes(breed.name));

	// the corners that the client draws, of files and of shapes that it has itself
	const corners = (agent) => {
		let turn = agent.state.heading - agent.prevState.heading;
		if (Math.abs(turn) > 180) turn -= 360 * Math.sign(turn);
		const heading = (agent.prevState.heading + part * turn) * Math.PI / 180;
		const size = at(agent, "size");
		const drawn = [];
		for (const { attributes: { position } } of viewport.modelManager.getModel(agent.state.shape).getGeometries()) {
			for (let i = 0; i < position.array.length; i += 3) {
				const [x, y, z] = position.array.slice(i, i + 3);
				drawn.push([at(agent, "x") + size * (x * Math.cos(heading) - y * Math.sin(heading)), at(agent, "y") + size * (x * Math.sin(heading) + y * Math.cos(heading)), at(agent, "z") + size * z]);
			}
		}
		return drawn;
	};
	const drawnBy = new Map(agents.map((agent) => [agent, options.exact ? corners(agent) : []]));
	// how far an end of a line is from where it may be of an agent
	const gapTo = (agent, x, y, z) => (options.exact ? Math.min(...drawnBy.get(agent).map((corner) => Math.hypot(x - corner[0], y - corner[1], z - corner[2])))
		: Math.abs(Math.hypot(x - at(agent, "x"), y - at(agent, "y"), z - at(agent, "z")) - at(agent, "size") / 2));
	// in single precision
	const CLOSE = 5e-5;
	const shown = new Set();
	let astray = 0;
	[red, yellow].forEach((ends, isYellow) => {
		for (let i = 0; i < ends.length; i += 3) {
			const [x, y, z] = ends.slice(i, i + 3);
			const owners = agents.filter((agent) => Math.hypot(x - at(agent, "x"), y - at(agent, "y")) < 2 * agent.state.size && gapTo(agent, x, y, z) < CLOSE);
			for (const owner of owners) shown.add(owner);
			if (!owners.some((owner) => hit.has(owner) !== Boolean(isYellow))) astray++;
		}
	});
	// each corner is an end
	let uncovered = 0;
	if (options.exact) {
		const cells = new Set();
		const key = (point, shift) => point.map((value, i) => Math.round(value * 100 + (shift >> i & 1) * 0.5)).join();
		for (const ends of [red, yellow]) for (let i = 0; i < ends.length; i += 3) for (let shift = 0; shift < 8; shift++) cells.add(`${shift} ${key(ends.slice(i, i + 3), shift)}`);
		for (const list of drawnBy.values()) for (const corner of list) if (![0, 1, 2, 3, 4, 5, 6, 7].some((shift) => cells.has(`${shift} ${key(corner, shift)}`))) uncovered++;
	}
	const result = {
		objects: objects.length, lines: (red.length + yellow.length) / 6, astray, uncovered, agents: agents.length, shown: shown.size, hits: hit.size,
	};
	installation.showOverlay(false);
	result.left = viewport.scene.children.filter((child) => child instanceof THREE.LineSegments).length + Number(Object.hasOwn(viewport, "render"));
	installation.uninstall();
	return result;
}

test("the wireframe is where agents are, what collides is red; by triangles it has the corners that the client draws", options, async (context) => {
	const page = await open(context, { isSolid: true });
	await page.evaluate(() => setUp());
	// what the client draws is there
	await page.waitForFunction(() => {
		viewport.needsUpdate = true;
		viewport.render(1);
		return alive().every(({ breed, state }) => !["Fish", "Algae"].includes(breed.name) || viewport.modelManager.getModel(state.shape).getGeometries().length > 0);
	});
	for (const [settings, part] of [[{ system: "bins" }, 1], [{ system: "bins" }, 0.4], [{ system: "hierarchical", exact: true }, 1], [{ system: "hierarchical", exact: true }, 0.4]]) {
		const seen = await page.evaluate(compareLines, { options: settings, part });
		context.diagnostic(`${JSON.stringify(settings)}, ${part}: ${JSON.stringify(seen)}`);
		assert.deepEqual([seen.objects, seen.astray, seen.uncovered, seen.shown, seen.left], [2, 0, 0, seen.agents, 0]);
		assert.ok(seen.agents > 20 && seen.hits > 0 && seen.lines > 5 * seen.agents);
	}
});

test("the button chooses what decides, and whether it is shown; the bookmarklet brings and takes it", options, async (context) => {
	const page = await open(context);
	await page.route("https://example.org/nova.js", (route) => route.fulfill({ path: script, contentType: "text/javascript" }));
	const [bookmarklet] = /^javascript:.*$/m.exec(readFileSync(new URL("../../docs/nova.md", import.meta.url), "utf8"));
	const click = () => page.evaluate((code) => (0, eval)(code), bookmarklet.slice("javascript:".length));
	const state = () => page.evaluate(() => {
		const installed = Execution.Collisions[Symbol.for("starlogo-collision.nova")];
		return installed ? [installed.options.system, installed.options.exact, Boolean(installed.options.overlay)].join() : "none";
	});
	const button = page.locator("#starlogoCollisionLi > a");
	const choose = async (text) => {
		await button.click();
		await page.locator("#starlogoCollisionLi .dropdown-menu a", { hasText: text }).click();
		return state();
	};
	await page.evaluate(() => {
		globalThis.StarLogoCollision = undefined;
		return setUp();
	});
	await click();
	await button.waitFor();
	assert.equal(await state(), "bins,false,false");
	assert.equal(await choose("Tightest fits"), "tightest,false,false");
	assert.equal(await choose("Wireframe"), "tightest,false,true");
	assert.equal(await choose("Triangles"), "hierarchical,true,true");
	await page.evaluate(() => tick(5));
	assert.equal(await choose("Hierarchies"), "hierarchical,false,true");
	assert.equal(await choose("Combination"), "combination,false,true");
	assert.equal(await choose("The client's own"), "none");
	assert.equal(await choose("Bins"), "bins,false,true");
	assert.equal(await choose("Wireframe"), "bins,false,false");
	assert.equal(await button.getAttribute("aria-expanded"), "false");
	await button.click();
	assert.equal(await button.getAttribute("aria-expanded"), "true");
	assert.deepEqual(await page.locator("#starlogoCollisionLi [aria-checked=true]").allTextContents(), ["\u2713 Bins"]);
	assert.ok(await page.locator("#starlogoCollisionLi .dropdown-menu").isVisible());
	await page.keyboard.press("Escape");
	assert.ok(!await page.locator("#starlogoCollisionLi .dropdown-menu").isVisible());
	await click();
	assert.equal(await button.count(), 0);
	assert.equal(await state(), "none");
	await click();
	assert.equal(await state(), "bins,false,false");
});

test("blocks from the drawer are compiled into programs and set traits", options, async (context) => {
	const page = await open(context);
	const seen = await page.evaluate(async () => {
		const { workspace } = sb.WebLogoDemo;
		const inDrawers = () => workspace.getDrawers().flatMap((drawer) => drawer.getChildBlocks().map((block) => block.getName())).filter((name) => /^starlogo/.test(name));
		const added = StarLogoCollision.addBlocks(window);
		const names = inDrawers();
		const program = workspace.getPageByName("Fish");
		const [run] = program.getChildBlocks().filter((block) => block.getName() === "wgt-button-toggle");
		let last = run.getArguments().find((argument) => argument.getDataType() === "command").getValue();
		while (last.getAfterBlock()) last = last.getAfterBlock();
		const values = { hierarchical: "true", depth: "2", structure: "capsule" };
		for (const [trait, value] of Object.entries(values)) {
			const block = new sb.Block(sb.BlockSpec.extend(sb.ScriptBlocksJSON.genusMap[`starlogo-collision-${trait}`]));
			block.getArguments()[0].setValue(value);
			program.addBlock(block);
			last.connectAfterBlock(block);
			last = block;
		}
		const calls = [];
		await setUp();
		tick(3);
		const installation = StarLogoCollision.installInto(window, { system: "combination" });
		const { changeTraits } = installation;
		installation.changeTraits = (agent, traits) => {
			calls.push(`${agent.breed.name} ${JSON.stringify(traits)}`);
			return changeTraits.call(installation, agent, traits);
		};
		tick(2);
		installation.uninstall();
		tick(2);
		added.remove();
		return { names, calls: [...new Set(calls)], left: inDrawers() };
	});
	assert.deepEqual(seen.names, ["hierarchical", "depth", "sweeps", "structure"].map((trait) => `starlogo-collision-${trait}`));
	assert.deepEqual(seen.calls, ['Fish {"hierarchical":true}', 'Fish {"depth":2}', 'Fish {"structure":"capsule"}']);
	assert.deepEqual(seen.left, []);
});

test("memory stays as it is while games run, systems are exchanged, and the engine comes and goes", options, async (context) => {
	const page = await open(context, { isSolid: true });
	const heapsOf = (isOurs) => page.evaluate(async (isOurs) => {
		const systems = [{ system: "bins" }, { system: "tightest" }, { system: "hierarchical" }, { system: "hierarchical", exact: true }, { system: "combination" }];
		const heaps = [];
		for (let round = 0; round < 8; round++) {
			await setUp();
			for (const settings of systems) {
				const installation = isOurs ? StarLogoCollision.installInto(window, { overlay: true }) : null;
				await loaded();
				installation?.exchange(settings);
				for (let i = 0; i < 20; i++) {
					tick(3);
					viewport.render(1);
				}
				installation?.uninstall();
				tick();
			}
			await new Promise((resolve) => setTimeout(resolve, 50));
			gc();
			heaps.push(performance.memory.usedJSHeapSize / 1e6);
		}
		return heaps;
	}, isOurs);
	// the client keeps something of each game itself
	const [own, ours] = [await heapsOf(false), await heapsOf(true)].map((heaps) => {
		context.diagnostic(`MB after each 305 ticks: ${heaps.map((heap) => heap.toFixed(2)).join(" ")}`);
		return (heaps.at(-1) - heaps[2]) / (heaps.length - 3);
	});
	assert.ok(ours < Math.max(own, 0) + 0.3, `${ours} MB a round, the client's own ${own}`);
});
