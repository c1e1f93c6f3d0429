/**
 * Blocks beside the engine's own calls: in random games each block answers what a question, a contact or plain arithmetic says, and moves agents as they do.
 *
 * Checks starlogo.blocks.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { engine } from "./engine.mjs";
import { randomNumbers } from "./random.mjs";

const { Agent, AgentQueries, BuiltInModel, Collision, CollisionBlocks, ContactBlocks, DetectionBlocks, Footing, GreatLand, StructureBlocks, Terrain, TerrainBlocks, TraitBlocks, WalkBlocks, WorldBounds } = engine;
const GAMES = 6;
const SHAPES = ["sphere", "cube", "slab"];
const BREEDS = ["bears", "balls", "hasOwnProperty"];
const HALF = 5;
const CLOSE = 1e-6;

function makeLand() {
	const land = new GreatLand();
	land.addModel(BuiltInModel.sphere());
	land.addModel(BuiltInModel.cube());
	land.addModel(BuiltInModel.box(2, 1, 0.4, "slab"));
	return land;
}

/** A game with all blocks, and questions of its own about the same agents. */
class Game {
	constructor(seed) {
		const random = randomNumbers(seed);
		this.between = (low, high) => low + (high - low) * random();
		this.one = (list) => list[Math.floor(random() * list.length)];
		this.agents = Array.from({ length: 14 }, () => this.#newAgent());
		this.blocks = new CollisionBlocks(makeLand(), this.agents);
		this.blocks.collision.terrain = new Terrain(2 * HALF + 1, 2 * HALF + 1, 1, -HALF, -HALF);
		this.blocks.collision.bounds = new WorldBounds(-HALF, -HALF, -HALF, HALF, HALF, HALF);
		this.blocks.useCollisionSystem(this.one(CollisionBlocks.systemNames));
		this.detection = new DetectionBlocks(this.blocks);
		this.contacts = new ContactBlocks(this.blocks);
		this.edges = new TerrainBlocks(this.blocks, this.detection);
		this.traits = new TraitBlocks(this.agents);
		this.walker = new WalkBlocks(this.detection);
		this.structures = new StructureBlocks(this.blocks);
		this.update();
	}

	#newAgent() {
		const agent = new Agent(this.one(SHAPES), this.one(BREEDS));
		agent.size = this.between(0.4, 1.5);
		agent.color = this.one([1, 2, 3]);
		this.place(agent);
		return agent;
	}

	place(agent) {
		agent.moveTo(this.between(-HALF, HALF), this.between(-HALF, HALF), this.between(-0.5, 2));
		agent.heading = this.between(-180, 180);
	}

	/** Both sides see the agents where they are now. */
	update() {
		this.detection.update();
		this.questions = new AgentQueries(this.blocks.collision);
		this.questions.update(this.agents);
		this.blocks.collision.update(this.agents);
	}

	get two() {
		const agent = this.one(this.agents);
		return [agent, this.one(this.agents.filter((each) => each !== agent))];
	}
}

/** Plays some games, and calls what checks them in each. */
function inGames(check) {
	for (let seed = 1; seed <= GAMES; seed++) check(new Game(seed));
}

const ahead = ({ heading }) => [Math.cos(heading * Math.PI / 180), Math.sin(heading * Math.PI / 180)];
const isNear = (value, wanted, said) => assert.ok(Math.abs(value - wanted) <= CLOSE || value === wanted, `${said}: ${value}, not ${wanted}`);

test("the blocks that count, find and see answer as questions do", () => {
	const seen = new Set();
	inGames((game) => {
		const { detection, questions, one } = game;
		for (let i = 0; i < 30; i++) {
			const [agent, other] = game.two;
			const breed = one([...BREEDS, Collision.ANY_BREED]);
			const filter = (accepts = null) => (breed === Collision.ANY_BREED ? { exceptBreeds: [Collision.TERRAIN], accepts } : { breeds: [breed], accepts });
			const isOfColour = (each) => each.color === 2;
			const distance = one([0, game.between(0, 4), Infinity]);
			const near = questions.nearest(agent, distance, filter());
			assert.equal(detection.countWithin(agent, breed, distance), questions.countNear(agent, distance, filter()));
			assert.equal(detection.nearestWithin(agent, breed, distance), near);
			assert.equal(detection.countWith(agent, breed, "color", 2), questions.countNear(agent, Infinity, filter(isOfColour)));
			assert.equal(detection.nearestWith(agent, breed, "color", 2), questions.nearest(agent, Infinity, filter(isOfColour)));
			assert.equal(detection.isTouching(agent, breed), questions.touchesAny(agent, filter()));
			assert.equal(detection.isTouching(agent, other), questions.touching(agent).includes(other));
			assert.equal(detection.canSee(agent, other), questions.canSee(agent, other));
			assert.equal(detection.distanceTo(agent, other), questions.distance(agent, other));
			const reach = game.between(0, 6);
			const hit = questions.castAgent(agent, reach * ahead(agent)[0], reach * ahead(agent)[1], 0, filter());
			assert.equal(detection.ahead(agent, breed, reach), hit && hit.agent);
			isNear(detection.distanceAhead(agent, breed, reach), hit ? hit.time * reach : Infinity, "ahead");
			seen.add(`${near !== null} ${hit !== null}`).add(String(detection.isTouching(agent, other)));
		}
	});
	assert.equal(seen.size, 6);
});

test("the blocks of contacts have the contact of the frame, and push out in all three directions", () => {
	const sides = new Map();
	inGames((game) => {
		const { blocks, contacts } = game;
		const system = blocks.systemNamed(blocks.systemName);
		blocks.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, (agent, other, contact) => {
			if (!game.agents.includes(other)) return;
			const { x, y, z } = contact.normal;
			const [cos, sin] = ahead(agent);
			const parts = { front: -x * cos - y * sin, back: x * cos + y * sin, left: x * sin - y * cos, right: y * cos - x * sin, top: -z, bottom: z };
			const side = contacts.sideHit(agent, other);
			assert.ok(parts[side] > Math.max(...Object.values(parts)) - 1e-8, side);
			sides.set(side, (sides.get(side) ?? 0) + 1);
			const point = contacts.touchPoint(agent, other);
			assert.deepEqual([point.x, point.y, point.z, contacts.touchSpeed(agent, other)], [contact.point.x, contact.point.y, contact.point.z, contact.approachSpeed]);
			const literal = { x: 0, y: 0, z: 0 };
			assert.equal(contacts.touchPoint(agent, other, literal), literal);
			assert.deepEqual(literal, { x: point.x, y: point.y, z: point.z });
		});
		for (let frame = 0; frame < 5; frame++) {
			for (const agent of game.agents) game.place(agent);
			game.update();
		}
		for (let i = 0; i < 40; i++) {
			const [agent, other] = game.two;
			agent.moveTo(other.x + game.between(-0.5, 0.5), other.y + game.between(-0.5, 0.5), other.z + game.between(-0.5, 0.5));
			const isTouching = system.areColliding(agent, other);
			const before = [agent.x, agent.y, agent.z];
			contacts.pushAway(agent, other);
			const way = [agent.x - before[0], agent.y - before[1], agent.z - before[2]];
			if (!isTouching) assert.deepEqual(way, [0, 0, 0]);
			else {
				agent.moveTo(...before.map((each, k) => each + (1 + CLOSE) * way[k] + CLOSE * Math.sign(way[k])));
				assert.ok(!system.areColliding(agent, other), `${agent} and ${other} part`);
			}
		}
	});
	assert.deepEqual([...sides.keys()].sort(), [...ContactBlocks.sideNames].sort());
});

test("the blocks of the ground and the edges build, stop, bounce and wrap by plain arithmetic", () => {
	const found = new Set();
	inGames((game) => {
		const { blocks, edges, detection } = game;
		const { terrain } = blocks.collision;
		for (let i = 0; i < 30; i++) {
			const [agent] = game.two;
			game.place(agent);
			const [x, y] = [Math.round(agent.x), Math.round(agent.y)];
			const height = game.between(-1, 1);
			const before = terrain.heightAt(x, y);
			if (i % 3 === 0) edges.raiseGround(x, y, height);
			else if (i % 3 === 1) edges.buildWall(agent, height);
			else edges.buildMound(agent, 3, height);
			if (i % 3 === 0) isNear(terrain.heightAt(x, y), before + height, "a raised place");
			isNear(edges.terrainHeight(agent), terrain.heightAt(agent.x, agent.y), "the ground");
			detection.update();
			assert.equal(edges.isTouchingGround(agent), detection.queries.touching(agent).includes(terrain.agent));
			const axis = i % 6 >> 1;
			const at = [agent.x, agent.y, agent.z].map((each, k) => (k === axis ? (i % 2 ? -1 : 1) * game.between(HALF, 2 * HALF) : game.between(-2, 2)));
			agent.moveTo(...at);
			assert.ok(edges.isTouchingEdge(agent));
			assert.equal(edges.edgeTouched(agent), TerrainBlocks.edgeNames[i % 6]);
			found.add(i % 6);
			const heading = ahead(agent);
			edges.bounceOffEdge(agent);
			const [cos, sin] = ahead(agent);
			const into = axis < 2 && heading[axis] * (i % 2 ? -1 : 1) > 0;
			isNear(cos, into && axis === 0 ? -heading[0] : heading[0], "the heading's x");
			isNear(sin, into && axis === 1 ? -heading[1] : heading[1], "the heading's y");
			const inside = [agent.x, agent.y, agent.z];
			inside.forEach((each, k) => (k === axis ? assert.ok(Math.abs(each) < HALF + CLOSE) : assert.equal(each, at[k])));
			agent.moveTo(...at);
			edges.stopAtEdge(agent);
			[agent.x, agent.y, agent.z].forEach((each, k) => isNear(each, inside[k], "stopped"));
			agent.moveTo(...at);
			edges.wrapAtEdge(agent);
			[agent.x, agent.y, agent.z].forEach((each, k) => isNear(each, k === axis ? at[k] - (i % 2 ? -2 : 2) * HALF : at[k], "wrapped"));
		}
		edges.resetTerrain();
		assert.equal(terrain.heightAt(0, 0), 0);
	});
	assert.equal(found.size, 6);
});

test("the blocks that walk move agents as walks and motions do, and traits and structures are those that were set", () => {
	let [standing, falling, bumped, level] = [0, 0, 0, 0];
	inGames((game) => {
		const { agents, blocks, traits, structures, walker } = game;
		walker.setSolid("bears", true);
		walker.setSolid("balls", true);
		walker.setSolid("balls", false);
		assert.deepEqual([...walker.solidBreeds], ["bears"]);
		const twins = new AgentQueries(blocks.collision);
		// it has made no search, so it sees agents where they are now
		const unused = new CollisionBlocks(blocks.greatLand, agents).systemNamed(blocks.systemName);
		const solid = { breeds: ["bears"] };
		const obstacles = { breeds: ["bears", Collision.TERRAIN] };
		// does something with an agent, and goes back
		const after = (agent, move) => {
			const { x, y, z } = agent;
			game.detection.update();
			twins.update(agents);
			const result = move();
			const place = [agent.x, agent.y, agent.z];
			agent.jumpTo(x, y, z);
			return [result, ...place];
		};
		for (let i = 0; i < 20; i++) {
			const [agent] = game.two;
			game.place(agent);
			const steps = game.between(-1, 1);
			const [x, y] = ahead(agent).map((each) => steps * each);
			const alike = (block, question, said) => {
				const [own, ...place] = after(agent, block);
				const [wanted, ...end] = after(agent, question);
				place.forEach((each, k) => isNear(each, end[k], said));
				if (wanted !== undefined) isNear(own, wanted, said);
				return own;
			};
			const { z } = agent;
			const depths = () => agents.filter((each) => each.breed === "bears" && each !== agent).map((each) => unused.contactOf(agent, each).depth);
			const before = depths();
			after(agent, () => {
				walker.forward(agent, steps);
				assert.equal(agent.z, z);
				depths().forEach((depth, k) => assert.ok(depth <= before[k] + CLOSE, `forward, ${depth} deep, not ${before[k]}`));
			});
			// along upright walls it is a slide
			if (Math.abs(after(agent, () => twins.slide(agent, x, y, 0, solid))[3] - z) < 1e-12) {
				level++;
				alike(() => walker.forward(agent, steps), () => void twins.slide(agent, x, y, 0, solid), "forward");
			}
			alike(() => walker.walk(agent, steps), () => void twins.walk(agent, x, y, { fall: 0, filter: obstacles }), "walk");
			const speed = game.between(-0.3, 0.3);
			const next = alike(() => walker.fall(agent, speed), () => {
				if (speed > 0) return twins.moveUntilTouch(agent, 0, 0, speed, obstacles) < 1 ? 0 : speed - walker.gravity;
				const footing = new Footing();
				twins.walk(agent, 0, 0, { fall: walker.gravity - speed, filter: obstacles }, footing);
				return footing.stands ? 0 : speed - walker.gravity;
			}, "fall");
			if (next !== 0) falling++;
			else if (speed > 0) bumped++;
			twins.update(agents);
			const stands = walker.isStanding(agent);
			assert.equal(stands, walker.standsOn(agent) !== null);
			standing += stands ? 1 : 0;
			const jump = walker.jump(agent, 1, speed);
			// the heights of all frames of a rise add up to a patch
			let risen = 0;
			for (let rising = jump; rising > 0; rising -= walker.gravity) risen += rising;
			if (stands) isNear(risen, 1, "jump");
			else assert.equal(jump, speed);
		}
		const [bears, others] = [agents.filter(({ breed }) => breed === "bears"), agents.filter(({ breed }) => breed !== "bears")];
		traits.collideAs("bears", Agent.BOX);
		traits.setOneWay("bears", true);
		traits.setCollisionDepth("bears", 3);
		traits.setHierarchical("bears", true);
		const cub = new Agent("cube", "bears");
		traits.welcome(cub);
		for (const each of [...bears, cub]) assert.deepEqual([each.collideAs, each.isOneWay, each.traversalDepth, each.hierarchical], [Agent.BOX, true, 3, true]);
		for (const each of others) assert.deepEqual([each.collideAs, each.isOneWay, each.traversalDepth, each.hierarchical], [Agent.TIGHTEST, false, 0, false]);
		assert.throws(() => traits.setCollisionDepth("bears", 2 ** 31), /needs a whole number/);
		for (const breed of ["balls", "bears", "hasOwnProperty"]) structures.show(breed, true);
		structures.show("balls", false);
		structures.show("hasOwnProperty", false);
		structures.show(others[0], true);
		assert.deepEqual(agents.filter((each) => structures.isShown(each)), agents.filter((each) => each.breed === "bears" || each === others[0]));
	});
	assert.ok(standing > 5 && falling > 20 && bumped > 0 && level > 20, `${standing} ${falling} ${bumped} ${level}`);
});
