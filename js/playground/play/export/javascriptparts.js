/** Texts for the modules of programs: the functions that blocks need in addition to the language and the engine. */
import { COLOURS } from "../game/colours.js";
import { FRAMES_A_SECOND } from "../game/world.js";

/** A colour as a number in JavaScript. */
export function hex(colour) {
	return colour < 0 ? String(colour) : `0x${colour.toString(16).padStart(6, "0")}`;
}

/** Functions by their names. A module contains the ones that it uses. */
export const HELPERS = {
	add: `/** A new agent where its parent is, or in the middle. */
function add(shape, breed, parent = null) {
	const agent = new Being(shape, breed);
	agent.born = game.frame;
	if (parent) {
		agent.jumpTo(parent.x, parent.y, parent.z);
		agent.heading = parent.heading;
	}
	agent.before = [agent.x, agent.y, agent.z, agent.heading];
	agents.push(agent);/*welcome*//*old*/
	return agent;
}`,
	remove: `function remove(agent) {
	const at = agents.indexOf(agent);
	if (at < 0) return;
	agents.splice(at, 1);
	agent.isAlive = false;/*old*/
}`,
	all: `/** All agents of a breed. */
function all(breed) {
	return agents.filter((agent) => agent.breed === breed);
}`,
	senses: `/** Answers about all agents, as they were when the frame began. */
function senses() {
	if (areSensesOld) detection.update();
	areSensesOld = false;
	return detection;
}`,
	forward: `function forward(agent, steps) {
	const angle = (agent.heading * Math.PI) / 180;
	moveInside(agent, agent.x + steps * Math.cos(angle), agent.y + steps * Math.sin(angle));
}`,
	forwardAlongSolid: `function forwardAlongSolid(agent, steps) {
	if (walking().solidBreeds.length === 0) return forward(agent, steps);
	walking().forward(agent, steps);
	moveInside(agent, agent.x, agent.y);
}`,
	walk: `function walk(agent, steps) {
	walking().walk(agent, steps);
	moveInside(agent, agent.x, agent.y);
}`,
	walking: `/** Walks, falls and jumps over the ground and solid agents, as they were when the frame began. */
function walking() {
	senses();
	return walker;
}`,
	floorOf: `/** The agent below; null for the ground. */
function floorOf(agent) {
	const below = walking().standsOn(agent);
	return below instanceof Being ? below : null;
}`,
	speedOf: `/** The steps of a frame that bring two agents together. */
function speedOf(agent, other) {
	const { normal } = collisions.collision.collisionSystem.contactOf(agent, other);
	return Math.max(0, ["x", "y", "z"].reduce((sum, axis, i) => sum - normal[axis] * (agent[axis] - agent.before[i] - other[axis] + other.before[i]), 0));
}`,
	moveInside: `/** Who leaves the ground comes in on the other side. */
function moveInside(agent, x, y) {
	const [insideX, insideY] = [wrapped(x), wrapped(y)];
	if (insideX === x && insideY === y) agent.moveTo(x, y, agent.z);
	else agent.jumpTo(insideX, insideY, agent.z);
}`,
	wrapped: `function wrapped(coordinate) {
	if (Math.abs(coordinate) <= HALF_WIDTH) return coordinate;
	const width = 2 * HALF_WIDTH;
	return ((((coordinate + HALF_WIDTH) % width) + width) % width) - HALF_WIDTH;
}`,
	advance: `/** Forward, until it touches one of a breed ("moveUntilTouch") or along that ("slide"); as high as it was. */
function advance(agent, steps, breed, how) {
	const { z } = agent;
	const angle = (agent.heading * Math.PI) / 180;
	const filter = breed === Collision.ANY_BREED ? { exceptBreeds: [Collision.TERRAIN] } : { breeds: [breed] };
	senses().queries[how](agent, steps * Math.cos(angle), steps * Math.sin(angle), 0, filter);
	agent.z = z;
	moveInside(agent, agent.x, agent.y);
}`,
	groundBelow: `function groundBelow({ x, y }) {
	return terrain.heightAt(x, y) || 0;
}`,
	face: `function face(agent, other) {
	if (other && (other.x !== agent.x || other.y !== agent.y)) agent.heading = degrees(other.x - agent.x, other.y - agent.y);
}`,
	degrees: `function degrees(x, y) {
	return (Math.atan2(y, x) * 180) / Math.PI;
}`,
	bounce: `/** Turns an agent that moves into another one as light is mirrored. */
function bounce(agent, other) {
	const { normal } = collisions.collision.collisionSystem.contactOf(agent, other);
	const angle = (agent.heading * Math.PI) / 180;
	const [x, y] = [Math.cos(angle), Math.sin(angle)];
	const into = x * normal.x + y * normal.y;
	if (into < 0) agent.heading = degrees(x - 2 * into * normal.x, y - 2 * into * normal.y);
}`,
	scatter: `function scatter(agent) {
	agent.jumpTo((random() * 2 - 1) * (HALF_WIDTH - 2), (random() * 2 - 1) * (HALF_WIDTH - 2), agent.z);
	agent.heading = random() * 360;
}`,
	goBack: `/** Undoes the frame's steps and turns, unless that leads deeper into the other one. */
function goBack(agent, other) {
	const { x, y, z, heading } = agent;
	const deep = other ? depthOf(agent, other) : 0;
	const [beforeX, beforeY, beforeZ, beforeHeading] = agent.before;
	agent.jumpTo(beforeX, beforeY, beforeZ);
	agent.heading = beforeHeading;
	if (!other || depthOf(agent, other) === 0) return;
	agent.heading = heading;
	if (deep <= depthOf(agent, other)) agent.jumpTo(x, y, z);
}`,
	depthOf: `/** How deep two overlap as they are now; 0 if they do not touch. A system that has searched tells contacts of that search, so another one is asked. */
function depthOf(agent, other) {
	if (!collisions.collision.collisionSystem.areColliding(agent, other)) return 0;
	return Math.max(Number.MIN_VALUE, systemsOfNow.systemNamed(collisions.systemName).contactOf(agent, other).depth);
}`,
	random: `/** The same numbers in every game: a generator of Park and Miller. */
function random() {
	seed = (seed * 48271) % 2147483647;
	return seed / 2147483647;
}`,
	randomBetween: `function randomBetween(a, b) {
	const from = Math.min(a, b);
	return from + Math.floor(random() * (Math.abs(b - a) + 1));
}`,
	distanceTo: `function distanceTo(agent, other) {
	return other ? senses().distanceTo(agent, other) : 1000000;
}`,
	canSee: `function canSee(agent, other) {
	return other !== null && senses().canSee(agent, other);
}`,
	become: `function become(agent, breed) {
	agent.breed = breed;/*welcome*/
}`,
	sweep: `function sweep(breed, isOn) {
	sweeping[breed] = isOn;
	for (const agent of all(breed)) agent.sweeps = isOn;
}`,
	anyColour: `function anyColour() {
	return [${Object.values(COLOURS).slice(0, 6).map(hex).join(", ")}][Math.floor(random() * 6)];
}`,
	wait: `/** What a script yields to wait, with the agent that it is about meanwhile. */
function wait(seconds, me) {
	return { frames: Math.max(1, Math.round(seconds * ${FRAMES_A_SECOND})), me };
}`,
	useSystem: `function useSystem(name) {
	if (collisions.systemName !== name) collisions.useCollisionSystem(name);
}`,
	whenTheGameStarts: `function whenTheGameStarts(script) {
	starts.push(script);
}`,
	everyFrame: `function everyFrame(breed, script) {
	scripts.push({ isDue: () => true, breed, script });
}`,
	whileKey: `/** A key that is pressed for less than a frame is held in it. */
function whileKey(key, mode, breed, script) {
	scripts.push({ isDue: () => pressed.has(key) || (mode === "held" && held.has(key)), breed, script });
}`,
	broadcast: `/** Sends a message to all agents, which receive it in the next frame. */
function broadcast(message) {
	messages.push(message);
}`,
	whenReceiving: `function whenReceiving(message, breed, script) {
	scripts.push({ isDue: () => received.includes(message), breed, script });
}`,
	everySeconds: `function everySeconds(seconds, breed, script) {
	scripts.push({ isDue: () => game.frame % Math.max(1, Math.round(seconds() * ${FRAMES_A_SECOND})) === 0, breed, script });
}`,
	whenClicked: `function whenClicked(breed, script) {
	scripts.push({ isDue: () => clicked !== null, isOfClicked: true, breed, script });
}`,
	whenColliding: `function whenColliding(breed, other, script) {
	collisions.onCollision(breed, other, (collider, collidee) => start(script, collider, collidee));
}`,
	whenTouchingStarts: `function whenTouchingStarts(breed, other, script) {
	collisions.whenTouchingStarts(breed, other, (collider, collidee) => start(script, collider, collidee));
}`,
	whenTouchingEnds: `function whenTouchingEnds(breed, other, script) {
	collisions.whenTouchingEnds(breed, other, (collider, collidee) => start(script, collider, collidee));
}`,
};

/** The helpers of a world with edges. */
export const INSIDE_EDGES = {
	moveInside: `function moveInside(agent, x, y) {
	agent.moveTo(x, y, agent.z);
}`,
};

/** Part of every module, before anything runs. */
export const BEING = `/** An agent, and what blocks ask about it. */
class Being extends Agent {
	born = 0;
	before = [0, 0, 0, 0];
	isAlive = true;
	rise = 0; // its upward speed
	said = "";/*own*/

	constructor(shape, breed) {
		super(shape, breed);
		this.color = -1; // the model's own colours
	}
}`;

/** Part of every module: the code that runs in every frame. */
export const ENGINE = `/** Begins a script, unless it still waits for the same agents. */
function start(script, me, collidee) {
	if (threads.some((each) => each.script === script && each.me === me && each.collidee === collidee)) return;
	goOn({ script, me, collidee, run: script(me, collidee), until: 0 });
}

/** Goes on with a script until it ends or waits. */
function goOn(thread) {
	const { done, value } = thread.run.next();
	if (done) return;
	thread.until = game.frame + value.frames;
	thread.me = value.me;
	threads.push(thread);
}

/** One frame, a sixtieth of a second: scripts, then collisions. */
export function step() {
	game.frame++;/*old*//*receive*/
	for (const agent of agents) agent.before = [agent.x, agent.y, agent.z, agent.heading];
	const waiting = threads;
	threads = waiting.filter(({ until }) => until > game.frame);
	for (const thread of waiting) if (thread.until <= game.frame && (thread.me?.isAlive ?? true)) goOn(thread);
	for (const { isDue, isOfClicked, breed, script } of scripts) {
		if (!isDue()) continue;
		// who is made meanwhile begins with the next frame
		for (const agent of isOfClicked ? [clicked] : [...agents]) if (agent.isAlive && (breed === Collision.ANY_BREED || agent.breed === breed)) start(script, agent, null);
	}
	pressed.clear();
	clicked = null;
	collisions.collision.update(agents);/*limit*/
}

export function press(key) {
	if (!held.has(key)) pressed.add(key);
	held.add(key);
}

export function release(key) {
	held.delete(key);
}

export function click(agent) {
	clicked = agent;
}`;
