/**
 * Prints how many bytes a frame of 10,000 moving agents leaves to the garbage collector, as JSON.
 *
 *   node --expose-gc --min-semi-space-size=64 --max-semi-space-size=64 test/module/garbage.mjs
 */
import { garbageOf as garbage } from "./bytes.mjs";
import * as engine from "../../bin/module/starlogo-collision.js";

const { Agent, BinCollider, BuiltInModel, Collision, GreatLand, Terrain, TightestFitCollider } = engine;

const COUNT = 10000;

const greatLand = new GreatLand();
greatLand.addModel(BuiltInModel.sphere());
greatLand.addModel(BuiltInModel.cube());

// each to and fro along a way of its own; the numbers are there before, and so make none
const agents = [];
const motionX = new Float64Array(COUNT);
const motionY = new Float64Array(COUNT);
let seed = 7;
const random = () => (seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 4294967296;
for (let i = 0; i < COUNT; i++) {
	const agent = new Agent("sphere", i % 2 === 0 ? "bears" : "balls");
	agent.moveTo(100 * random() - 50, 100 * random() - 50, 0.2 * random());
	agents.push(agent);
	motionX[i] = random() - 0.5;
	motionY[i] = random() - 0.5;
}

let time = 0;
function move() {
	const step = 0.3 * Math.sin(time++);
	for (let i = 0; i < COUNT; i++) {
		const agent = agents[i];
		agent.moveTo(agent.x + step * motionX[i], agent.y + step * motionY[i], agent.z);
	}
}

const kept = new Array(COUNT).fill(null);
// others than those that collide, which would not be the same afterwards
const turned = agents.map(() => new Agent("sphere"));
let isThere = false;
function turn() {
	isThere = !isThere;
	const headings = isThere ? motionX : motionY;
	for (let i = 0; i < COUNT; i++) turned[i].heading = headings[i];
}

const result = { objects: 0, moving: 0, turning: 0, frames: {}, pairs: {}, sweeps: {}, touches: {} };
result.objects = garbage(() => {
	for (let i = 0; i < COUNT; i++) kept[i] = { i };
});
result.moving = garbage(move);
result.turning = garbage(turn);
for (const [name, System] of Object.entries({ "a BinCollider": BinCollider, "a TightestFitCollider": TightestFitCollider })) {
	const collider = new System(greatLand);
	const out = [];
	result.frames[name] = garbage(() => {
		move();
		collider.findCollisions(agents, out);
	}) - result.moving;
	result.pairs[name] = out.length / 2;
}
const collision = new Collision(new BinCollider(greatLand));
let calls = 0;
collision.onCollision("bears", "balls", () => { calls++; });
result.frames["a Collision with handlers"] = garbage(() => {
	move();
	calls = 0;
	collision.update(agents);
}) - result.moving;
result.pairs["a Collision with handlers"] = 2 * calls;

let isFew = false;
result.frames["a Collision, few agents moving in every other frame"] = garbage(() => {
	isFew = !isFew;
	if (isFew) for (let i = 0; i < 20; i++) agents[i].moveTo(agents[i].x, agents[i].y, agents[i].z + 1e-3);
	else move();
	calls = 0;
	collision.update(agents);
}) - result.moving / 2;
result.pairs["a Collision, few agents moving in every other frame"] = 2 * calls;

// the same agents, half of them cubes now, sweep over hills
const terrain = new Terrain(101, 101, 1, -50, -50);
for (let i = 0; i < 100; i++) terrain.raiseMound(100 * random() - 50, 100 * random() - 50, 10, random() - 0.5);
for (let i = 0; i < COUNT; i++) {
	agents[i].sweeps = true;
	if (i % 4 < 2) agents[i].shape = "cube";
}
for (const [isBlocky, name, System] of [[false, "a BinCollider, on slopes", BinCollider], [true, "a TightestFitCollider, on columns", TightestFitCollider]]) {
	const swept = new Collision(new System(greatLand));
	swept.terrain = terrain;
	terrain.isBlocky = isBlocky;
	for (const breed of ["bears", "balls"]) swept.onCollision(breed, Collision.TERRAIN, () => { calls++; });
	result.sweeps[name] = garbage(() => {
		move();
		calls = 0;
		swept.update(agents);
	}, { calls: 20 }) - result.moving;
	result.touches[name] = calls;
}
console.log(JSON.stringify(result));
