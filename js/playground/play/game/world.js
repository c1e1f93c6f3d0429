/** The game that a program plays: agents, keys, time, collisions. Nothing here draws. */
import { Collision, CollisionBlocks, StructureBlocks, TraitBlocks } from "starlogo-collision";
import { Input } from "../../shared/input.js";
import { texts } from "../../shared/language.js";
import { ProgramError, breedOf } from "./actions.js";
import { Being } from "./being.js";
import { History, beginning } from "./history.js";
import { lateEngine } from "./late.js";
import { HALF_WIDTH, Moves } from "./moves.js";
import { Rounds, Thread, compile } from "./program.js";

export const FRAMES_A_SECOND = 60;
/** The seed of random numbers if no other one is given. A lesson always has it, so that its checks see the same game again. */
export const SEED = 20150601;
const MOST_AGENTS = 2000;
/** The number of meetings in the list. */
const MOST_MEETINGS = 60;
/** The seconds for which an agent's words are shown. */
const SECONDS_SAID = 2;

export class World {
	rounds = new Rounds();
	agents = [];
	me = null;
	collidee = null;
	input = new Input();
	/** The milliseconds of the last frame: what the engine took to find the pairs, and what scripts and the page's own lists took. */
	collisionMs = 0;
	scriptMs = 0;
	/** The milliseconds of this frame's handlers. The engine calls them, but their time is not the engine's. */
	#handled = 0;
	/** Whether the pairs that touch are listed in each frame, by their numbers. */
	isWatched = false;
	/** Whether blocks may not change the collision system. */
	isSystemFixed = false;
	/** The sounds of this frame's blocks: names and notes. */
	sounds = [];
	/** The messages of the frame before, which are received in this one. */
	#received = [];
	#scripts = [];
	#areSensesOld = true;
	/** Whether the pairs are found again, in a frame that stands still. */
	#isAgain = false;
	/** The blocks of the late engine, once a program uses them. */
	#lateBlocks = null;

	/** @param {object} greatLand has every shape that programs name */
	constructor(greatLand) {
		this.greatLand = greatLand;
		this.collisions = new CollisionBlocks(greatLand, this.agents);
		this.traits = new TraitBlocks(this.agents);
		this.structures = new StructureBlocks(this.collisions);
		this.moves = new Moves(this);
		this.history = new History(this);
		this.#forget();
	}

	#forget(seed = SEED) {
		Object.assign(this, beginning(seed));
		this.agents.length = this.sounds.length = 0;
		this.collisions.collision.terrain = this.collisions.collision.bounds = null;
		this.hasHills = false;
		this.input.endFrame();
		this.restoreBlocks();
	}

	/** The blocks that answer questions, those for contacts, for the ground and the edges, and those that walk. */
	get lateBlocks() {
		if (this.#lateBlocks) return this.#lateBlocks;
		const { ContactBlocks, DetectionBlocks, TerrainBlocks, WalkBlocks } = lateEngine;
		const detection = new DetectionBlocks(this.collisions);
		this.#lateBlocks = { detection, contacts: new ContactBlocks(this.collisions), edges: new TerrainBlocks(this.collisions, detection), walker: new WalkBlocks(detection) };
		return this.#lateBlocks;
	}

	/**
	 * Begins a program. The program may choose the collision system.
	 *
	 * @param {object} program in Blockly's notation
	 * @param {number} seed the same program with the same seed plays the same game
	 */
	begin(program, seed = SEED) {
		this.#forget(seed);
		this.collisions.forgetScripts();
		this.history.clear();
		if (!this.isSystemFixed) this.useSystem(CollisionBlocks.systemNames.includes(program.system) ? program.system : CollisionBlocks.TIGHTEST_FITS);
		this.#scripts = [];
		this.#scripts = compile(program, this);
		// all pairs that touch, also those without scripts
		this.collisions.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, (a, b) => this.#timed(() => {
			a.touched = b.touched = this.frame;
			if (this.isWatched && a.number < b.number) this.pairs.set(`${a.number} ${b.number}`, [a, b]);
		}));
		this.collisions.whenTouchingStarts(Collision.ANY_BREED, Collision.ANY_BREED, (a, b, { point }) => this.#timed(() => {
			if (a.id < b.id) this.#recordMeeting(a, b, point);
		}));
		for (const { event, fields, code } of this.#scripts) this.#listen(event, fields, code);
		this.rounds.begin();
		for (const { event, code } of this.#scripts) if (event === "start") this.#start(code, null, null);
	}

	#listen(event, fields, code) {
		const add = { collision: "onCollision", touchStart: "whenTouchingStarts", touchEnd: "whenTouchingEnds" }[event];
		if (!add) return;
		if (fields.OTHER === Collision.TERRAIN) this.needTerrain();
		if (fields.OTHER === Collision.EDGE) this.needEdges();
		// the ground and the edges are no agents for blocks
		this.collisions[add](breedOf(fields.BREED), breedOf(fields.OTHER), (collider, collidee) => (this.#isAgain && event === "collision") || this.#timed(() => this.#start(code, collider, collidee instanceof Being ? collidee : null)));
	}

	/** Does what a handler is for. Its time is no time of the engine. */
	#timed(action) {
		const start = performance.now();
		action();
		this.#handled += performance.now() - start;
	}

	/** Begins a script, unless it is still running for the same agents. */
	#start(code, me, collidee) {
		if (this.threads.some((each) => each.code === code && each.me === me && each.collidee === collidee)) return;
		this.#go(new Thread(code, me, collidee));
	}

	#go(thread) {
		if (!thread.run(this)) this.threads.push(thread);
	}

	#recordMeeting(a, b, { x, y, z }) {
		// agents that touch from the beginning have not hit each other
		if (this.frame > 1) a.hit = b.hit = this.frame;
		const names = [a.breed, b.breed].sort().join("\n");
		this.totals.set(names, (this.totals.get(names) ?? 0) + 1);
		this.meetingCount++;
		this.meetings.unshift({ frame: this.frame, a, b, names: [a.breed, b.breed], point: { x, y, z } });
		this.meetings.length = Math.min(this.meetings.length, MOST_MEETINGS);
	}

	/** Does one frame: scripts, then collisions. */
	step() {
		const start = performance.now();
		this.history.goOn();
		this.frame++;
		// the sounds of the start are heard with the first frame
		if (this.frame > 1) this.sounds.length = 0;
		this.rounds.begin();
		this.#areSensesOld = true;
		for (const agent of this.agents) {
			agent.before[0] = agent.x;
			agent.before[1] = agent.y;
			agent.before[2] = agent.z;
			agent.before[3] = agent.heading;
		}
		this.#received = this.messages;
		this.messages = [];
		const { threads } = this;
		this.threads = threads.filter(({ until }) => until > this.frame);
		for (const thread of threads) if (thread.until <= this.frame && (thread.me?.isAlive ?? true)) this.#go(thread);
		for (const { event, fields, seconds, code } of this.#scripts) {
			if (this.#isDue(event, fields, seconds)) this.#forEach(fields.BREED, event, code);
		}
		this.input.endFrame();
		const listed = [...this.agents];
		this.collide();
		if (this.limit && this.frame >= this.limit.until) this.ended ??= { how: "lost", text: this.limit.text };
		this.history.add(listed);
		this.scriptMs = performance.now() - start - this.collisionMs;
	}

	/** Finds the pairs that touch once more in a frame that stands still. Scripts of collisions do not run: they have run in it already. */
	collideAgain() {
		this.sounds.length = 0;
		this.collide(true);
	}

	/** Finds the pairs that touch, at the end of a frame or again. */
	collide(isAgain = false) {
		this.#isAgain = isAgain;
		if (this.isWatched) this.pairs = new Map();
		this.#handled = 0;
		const start = performance.now();
		this.collisions.collision.update(this.agents);
		this.collisionMs = Math.max(0, performance.now() - start - this.#handled);
		this.touching = this.collisions.collision.statistics.collisions;
		this.#areSensesOld = true;
	}

	#isDue(event, fields, seconds) {
		if (event === "each") return true;
		if (event === "click") return this.input.clicked !== null;
		if (event === "receive") return this.#received.includes(fields.MESSAGE);
		if (event === "key") return this.input.wasPressed(fields.KEY) || (fields.MODE === "held" && this.input.isDown(fields.KEY));
		return event === "timer" && this.frame % Math.max(1, Math.round(seconds() * FRAMES_A_SECOND)) === 0;
	}

	#forEach(breed, event, code) {
		// agents that are created meanwhile begin with the next frame
		for (const agent of event === "click" ? [this.input.clicked] : [...this.agents]) {
			if (agent.isAlive && (breed === "anyone" || agent.breed === breed)) this.#start(code, agent, null);
		}
	}

	/** Changes the collision system, for a block or the user. The user is told if a block does it. */
	useSystem(name) {
		if (this.collisions.systemName === name) return;
		this.collisions.useCollisionSystem(name);
		this.onSystem?.(name);
	}

	/** A new agent at its parent's place, or in the middle; null if there are too many. */
	add(shape, breed, parent) {
		if (this.agents.length >= MOST_AGENTS) return null;
		if (!this.greatLand.hasModel(shape)) throw new ProgramError(texts.play.noModel(shape));
		const agent = new Being(shape, breed);
		agent.born = this.frame;
		agent.number = ++this.made;
		if (parent) {
			agent.jumpTo(parent.x, parent.y, parent.z);
			agent.heading = parent.heading;
		}
		agent.before = [agent.x, agent.y, agent.z, agent.heading];
		this.agents.push(agent);
		this.#welcome(agent);
		this.#areSensesOld = true;
		return agent;
	}

	remove(agent) {
		const at = this.agents.indexOf(agent);
		if (at < 0) return;
		this.agents.splice(at, 1);
		agent.isAlive = false;
		this.#areSensesOld = true;
	}

	/** The agents that a block is about: one agent, or all of a breed. */
	subjects(whom) {
		return typeof whom === "string" ? this.agents.filter(({ breed }) => breed === whom) : [whom];
	}

	become(agent, breed) {
		agent.breed = breed;
		this.#welcome(agent);
	}

	/** Gives an agent the settings of its breed. */
	#welcome(agent) {
		this.traits.welcome(agent);
		agent.sweeps = this.sweeping[agent.breed] ?? agent.sweeps;
	}

	/** Sets a trait by one of the engine's blocks. For a breed it counts for agents that join it later, too. */
	setTrait(block, whom, value) {
		this.traits[block](whom, value);
		if (typeof whom === "string") this.breedTraits = new Map(this.breedTraits).set(`${block} ${whom}`, [block, whom, value]);
	}

	/** Shows the bounding structures of an agent or of a breed, or no more. */
	showStructures(whom, isOn) {
		this.structures.show(whom, isOn);
		this.shownStructures = new Map(this.shownStructures).set(whom, isOn);
	}

	/** Tells the engine's blocks of breeds and structures what this frame says of them, because it is another one than theirs. */
	restoreBlocks() {
		this.traits.forgetBreeds();
		for (const [block, breed, value] of this.breedTraits.values()) this.traits[block](breed, value);
		this.structures.showNone();
		for (const [whom, isOn] of this.shownStructures) this.structures.show(whom, isOn);
		if (this.#lateBlocks || this.solid.length > 0) this.lateBlocks.walker.solidBreeds = this.solid;
		this.#areSensesOld = true;
	}

	/** Has an agent collide along its way, or not. For a breed it counts for agents that join it later, too. */
	sweep(whom, isOn) {
		for (const agent of this.subjects(whom)) agent.sweeps = isOn;
		if (typeof whom === "string") this.sweeping = { ...this.sweeping, [whom]: isOn };
	}

	/** Makes a breed solid, or not. */
	setSolid(breed, isOn) {
		const { walker } = this.lateBlocks;
		walker.setSolid(breed, isOn);
		this.solid = walker.solidBreeds;
	}

	/** The blocks for contacts. */
	get contacts() {
		return this.lateBlocks.contacts;
	}

	/** The blocks for the ground and the edges. */
	get edges() {
		return this.lateBlocks.edges;
	}

	/** Walks, falls and jumps over the ground and solid agents, which are where they were when the frame began. */
	get walking() {
		this.#updateSenses();
		return this.lateBlocks.walker;
	}

	/** The ground that agents stand on; null if the program has no block about it. */
	get terrain() {
		return this.collisions.collision.terrain;
	}

	/** The ground, if the program builds hills or walls on it; else null. */
	get hills() {
		return this.hasHills ? this.terrain : null;
	}

	/** Called when a block about the ground is compiled, so that all frames of its game have it. */
	needTerrain(hasHills = false) {
		this.hasHills ||= hasHills;
		this.collisions.collision.terrain ??= new lateEngine.Terrain(2 * HALF_WIDTH + 1, 2 * HALF_WIDTH + 1, 1, -HALF_WIDTH, -HALF_WIDTH);
	}

	/** Called when a block about the edges of the world is compiled. Then agents do not come in on the other side by themselves. */
	needEdges() {
		this.collisions.collision.bounds ??= new lateEngine.WorldBounds(-HALF_WIDTH, -HALF_WIDTH, -Infinity, HALF_WIDTH, HALF_WIDTH, Infinity);
	}

	/** Colours an agent, or all of a breed. */
	paint(whom, colour) {
		for (const agent of this.subjects(whom)) agent.color = colour;
	}

	/** Sends a message to all agents. Their scripts receive it in the next frame. */
	broadcast(message) {
		this.messages = [...this.messages, message];
	}

	/** Sets a variable of an agent. */
	setOwn(agent, name, value) {
		agent.own = { ...agent.own, [name]: value };
	}

	/** Shows a variable above all agents that have it, or no more. */
	showOwn(name, isOn) {
		this.shownVariables = [...this.shownVariables.filter((each) => each !== name), ...(isOn ? [name] : [])];
	}

	say(agent, text) {
		agent.said = { text, until: this.frameIn(SECONDS_SAID) };
	}

	traitOf(agent, trait) {
		return trait === "age" ? (this.frame - agent.born) / FRAMES_A_SECOND : agent[trait];
	}

	/** The queries of the agents. They see the others as they were when the frame began, or when an agent was last created or deleted. */
	get senses() {
		this.#updateSenses();
		return this.lateBlocks.detection;
	}

	#updateSenses() {
		if (!this.#areSensesOld) return;
		this.lateBlocks.detection.update();
		this.#areSensesOld = false;
	}

	/** The number of the frame that is this many seconds away, at least the next one. */
	frameIn(seconds) {
		return this.frame + Math.max(1, Math.round(seconds * FRAMES_A_SECOND));
	}

	/** The seconds that are left, or null if the game has no limit of time. */
	get secondsLeft() {
		return this.limit ? Math.max(0, this.limit.until - this.frame) / FRAMES_A_SECOND : null;
	}

	get seconds() {
		return this.frame / FRAMES_A_SECOND;
	}

	/** A random number, by a generator of Park and Miller. */
	random() {
		this.seed = (this.seed * 48271) % 2147483647;
		return this.seed / 2147483647;
	}
}
