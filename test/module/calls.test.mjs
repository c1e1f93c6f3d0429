/** The page of calls: what it says that a frame passes is what runs, as V8 counts it. Checks starlogo.collision. */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { Agent, BuiltInModel, Collision, GreatLand, TightestFitCollider } from "../../bin/module/starlogo-collision.js";
import { beginCoverage } from "../runner/coverage.mjs";

const at = (file) => fileURLToPath(new URL(`../../${file}`, import.meta.url));
const code = readFileSync(at("bin/module/starlogo-collision.js"), "utf8");
const page = readFileSync(at("docs/calls.md"), "utf8").split("\n## ")[1];

const ROOMS = ["agents", "broadphase", "search", "handlers", "collision"];
const inRooms = new Set(ROOMS.flatMap((room) => readdirSync(at(`src/starlogo/${room}`), { recursive: true }))
	.filter((file) => file.endsWith(".as")).map((file) => file.split(/[\\/]/).pop().slice(0, -3)));

// a class's static methods are functions behind it: Name$method
const parts = [...code.matchAll(/^(?:(?:const \w+ = .*)?class (\w+)|function ([A-Z][a-zA-Z\d]*)\$)/gm)]
	.map(({ 1: ofClass, 2: ofFunction, index }) => ({ name: ofClass ?? ofFunction, start: index, end: code.indexOf("\n}", index) }));

/** The classes of the rooms of which something runs in a call. */
function classesThatRun(call) {
	const take = beginCoverage(false);
	take();
	call();
	const { functions } = take().find(({ url }) => url.endsWith("starlogo-collision.js"));
	const starts = functions.map(({ ranges }) => ranges[0]).filter(({ count }) => count > 0).map(({ startOffset }) => startOffset);
	const ran = parts.filter(({ name, start, end }) => inRooms.has(name) && starts.some((each) => each >= start && each < end));
	return [...new Set(ran.map(({ name }) => name))];
}

test("docs/calls.md lists the classes that a frame passes, and those that it leaves out", () => {
	const land = new GreatLand();
	land.addModel(BuiltInModel.cube());
	const collision = new Collision(new TightestFitCollider(land));
	let calls = 0;
	collision.onCollision("turtles", "turtles", () => calls++);
	const agents = Array.from({ length: 400 }, () => new Agent("cube"));
	const move = () => agents.forEach((agent, i) => agent.moveTo(0.9 * (i % 20) + 0.01 * (calls % 7), 0.9 * Math.floor(i / 20), 0));
	for (let i = 0; i < 5; i++) {
		move();
		collision.update(agents);
	}
	move();
	const before = calls;
	const ran = classesThatRun(() => collision.update(agents));
	assert.ok(calls - before > 1000, "handlers ran");
	const listed = [...page.matchAll(/^\d+\. `(\w+)`/gm)].map(([, name]) => name);
	const leftOut = [...page.match(/leaves out ([^]*?)\.\n\n/)[1].matchAll(/`(\w+)`/g)].map(([, name]) => name);
	assert.match(page, new RegExp(`passes ${listed.length} classes`));
	assert.deepEqual([...listed, ...leftOut].filter((name) => inRooms.has(name)).sort(), ran.sort());
});
