/** The game that a program plays: agents, keys, time, collisions. Nothing here draws. */
import { Agent, CollisionBlocks, StructureBlocks, TraitBlocks } from "starlogo-collision";
import { Rounds, breedOf, compile } from "./program.js";
import { COLOURS } from "./colours.js";

/** Half the width of the ground; who leaves it comes in on the other side. */
export const HALF_WIDTH = 12;
export const FRAMES_A_SECOND = 60;
const MOST_AGENTS = 2000;

/** An agent of a game, with what blocks ask about it. */
class Being extends Agent {
	born = 0;
	/** Where it was when the frame began: x, y, z, heading. */
	before = [0, 0, 0, 0];
}

export class World {
	rounds = new Rounds();
	agents = [];
	variables = {};
	me = null;
	collidee = null;
	held = new Set();
	frame = 0;
	/** What the last frame's collision detection took, in milliseconds. */
	collisionMs = 0;
	#pressed = new Set();
	#scripts = [];
	#seed = 1;
	#system = null;

	/**
	 * @param {object} greatLand has every shape that programs name
	 */
	constructor(greatLand) {
		this.collisions = new CollisionBlocks(greatLand, this.agents);
		this.traits = new TraitBlocks(this.agents);
		this.structures = new StructureBlocks(this.collisions);
	}

	/** Makes the world the beginning of a program. */
	begin(program) {
		this.agents.length = 0;
		this.collisions.forgetScripts();
		this.traits.forgetBreeds();
		this.structures.showNone();
		this.variables = {};
		this.frame = 0;
		this.#seed = 20150601;
		this.#pressed.clear();
		this.#scripts = [];
		this.#scripts = compile(program, this);
		for (const { event, fields, run } of this.#scripts) this.#listen(event, fields, run);
		this.rounds.begin();
		for (const { event, run } of this.#scripts) if (event === "start") this.#as(null, null, run);
	}

	#listen(event, fields, run) {
		const add = { collision: "onCollision", touchStart: "whenTouchingStarts", touchEnd: "whenTouchingEnds" }[event];
		if (!add) return;
		this.collisions[add](breedOf(fields.BREED), breedOf(fields.OTHER), (collider, collidee) => this.#as(collider, collidee, run));
	}

	#as(me, collidee, run) {
		this.me = me;
		this.collidee = collidee;
		try {
			run();
		} finally {
			this.me = this.collidee = null;
		}
	}

	/** One frame: scripts, then collisions. */
	step() {
		this.frame++;
		this.rounds.begin();
		for (const agent of this.agents) {
			agent.before[0] = agent.x;
			agent.before[1] = agent.y;
			agent.before[2] = agent.z;
			agent.before[3] = agent.heading;
		}
		for (const { event, fields, seconds, run } of this.#scripts) {
			if (this.#isDue(event, fields, seconds)) this.#forEach(fields.BREED, run);
		}
		this.#pressed.clear();
		this.collide();
	}

	/** The end of a frame: who touches whom. */
	collide() {
		const start = performance.now();
		this.collisions.collision.update(this.agents);
		this.collisionMs = performance.now() - start;
	}

	#isDue(event, fields, seconds) {
		if (event === "each") return true;
		if (event === "key") return fields.MODE === "pressed" ? this.#pressed.has(fields.KEY) : this.held.has(fields.KEY);
		return event === "timer" && this.frame % Math.max(1, Math.round(seconds() * FRAMES_A_SECOND)) === 0;
	}

	#forEach(breed, run) {
		// who is created meanwhile begins with the next frame
		for (const agent of this.agents.filter((each) => breed === "anyone" || each.breed === breed)) {
			if (this.agents.includes(agent)) this.#as(agent, null, run);
		}
	}

	press(key) {
		if (!this.held.has(key)) this.#pressed.add(key);
		this.held.add(key);
	}

	release(key) {
		this.held.delete(key);
	}

	releaseAll() {
		this.held.clear();
	}

	/** Uses a system, by a block or by the user, who is told of blocks'. */
	useSystem(name) {
		if (this.#system === name) return;
		this.collisions.useCollisionSystem(name);
		this.#system = name;
		this.onSystem?.(name);
	}

	/** A new agent where its parent is, or in the middle; null if there are too many. */
	add(shape, breed, parent) {
		if (this.agents.length >= MOST_AGENTS) return null;
		const agent = new Being(shape, breed);
		agent.color = COLOURS.grey;
		agent.born = this.frame;
		if (parent) {
			agent.jumpTo(parent.x, parent.y, parent.z);
			agent.heading = parent.heading;
		}
		agent.before = [agent.x, agent.y, agent.z, agent.heading];
		this.agents.push(agent);
		this.traits.welcome(agent);
		return agent;
	}

	remove(agent) {
		const at = this.agents.indexOf(agent);
		if (at >= 0) this.agents.splice(at, 1);
	}

	removeBreed(breed) {
		for (let i = this.agents.length - 1; i >= 0; i--) if (this.agents[i].breed === breed) this.agents.splice(i, 1);
	}

	forward(agent, steps) {
		const angle = (agent.heading * Math.PI) / 180;
		const x = agent.x + steps * Math.cos(angle);
		const y = agent.y + steps * Math.sin(angle);
		const wrappedX = wrapped(x);
		const wrappedY = wrapped(y);
		if (wrappedX === x && wrappedY === y) agent.moveTo(x, y, agent.z);
		else agent.jumpTo(wrappedX, wrappedY, agent.z);
	}

	scatter(agent) {
		agent.jumpTo((this.random() * 2 - 1) * (HALF_WIDTH - 2), (this.random() * 2 - 1) * (HALF_WIDTH - 2), agent.z);
		agent.heading = this.random() * 360;
	}

	/** Undoes the frame's steps and turns: who touches nobody before never gets stuck. */
	goBack(agent) {
		const [x, y, z, heading] = agent.before;
		agent.jumpTo(x, y, z);
		agent.heading = heading;
	}

	/** Colours an agent, or all of a breed. */
	paint(whom, colour) {
		for (const agent of typeof whom === "string" ? this.agents.filter(({ breed }) => breed === whom) : [whom]) agent.color = colour;
	}

	traitOf(agent, trait) {
		return trait === "age" ? (this.frame - agent.born) / FRAMES_A_SECOND : agent[trait];
	}

	/** The same games for the same programs: a generator of Park and Miller. */
	random() {
		this.#seed = (this.#seed * 48271) % 2147483647;
		return this.#seed / 2147483647;
	}
}

const wrapped = (coordinate) => (coordinate > HALF_WIDTH ? coordinate - 2 * HALF_WIDTH : coordinate < -HALF_WIDTH ? coordinate + 2 * HALF_WIDTH : coordinate);
