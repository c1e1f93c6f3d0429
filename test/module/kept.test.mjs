/** What is gone from a game is not kept: it can be collected. What is kept of a level is little. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { measure } from "./bytes.mjs";

const folder = fileURLToPath(new URL("../../bin/module", import.meta.url));
const manifest = JSON.parse(readFileSync(path.join(folder, "package.json"), "utf8"));
const { Agent, BuiltInModel, Collision, CollisionBlocks, GreatLand, Model, StructureBlocks, TightestFitCollider } = await import(pathToFileURL(path.join(folder, manifest.exports["."].default)));

setFlagsFromString("--expose-gc");
const collect = runInNewContext("gc");

// In a function of its own: what its variables held is not held any more when it has returned.
function show(agents) {
	const land = new GreatLand();
	land.addModel(BuiltInModel.sphere());
	const blocks = new StructureBlocks(new CollisionBlocks(land, agents));
	for (const agent of agents) blocks.show(agent, true);
	return { blocks, left: new WeakRef(agents.pop()) };
}

test("blocks that show the structures of an agent do not keep it when it has left", async () => {
	const agents = [new Agent("sphere"), new Agent("sphere")];
	const { blocks, left } = show(agents);
	// a WeakRef holds its agent until the turn is over
	await new Promise((resolve) => setTimeout(resolve, 10));
	collect();
	assert.equal(left.deref(), undefined);
	assert.ok(blocks.isShown(agents[0]), "the one that stays is shown");
});

// The model of the last agent of a list, which is replaced.
function replace(collider, land, agents) {
	const model = new Model("replaced", [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
	land.addModel(model);
	collider.findCollisions(agents);
	land.addModel(new Model("replaced", [0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1]));
	collider.findCollisions(agents);
	return new WeakRef(model);
}

test("a collider does not keep a model that was replaced", async () => {
	const land = new GreatLand();
	land.addModel(BuiltInModel.sphere());
	const collider = new TightestFitCollider(land);
	const agents = [new Agent("sphere"), new Agent("replaced")];
	const replaced = replace(collider, land, agents);
	await new Promise((resolve) => setTimeout(resolve, 10));
	collect();
	assert.equal(replaced.deref(), undefined);
	assert.equal(collider.findCollisions(agents).length, 2, "the collider is still there");
});

// A collider and the list of a frame, which the next frame has not any more.
function exchange(collision) {
	const collider = new TightestFitCollider(collision.land);
	collision.collisionSystem = collider;
	const agents = [new Agent("sphere"), new Agent("sphere")];
	collision.update(agents);
	collision.collisionSystem = new TightestFitCollider(collision.land);
	return [new WeakRef(collider), new WeakRef(agents)];
}

test("a Collision keeps neither a collider that was exchanged nor a game's list", async () => {
	const land = new GreatLand();
	land.addModel(BuiltInModel.sphere());
	const collision = new Collision(new TightestFitCollider(land));
	collision.land = land;
	collision.onCollision("turtles", "turtles", (collider, collidee, contact) => assert.ok(contact.depth > 0));
	collision.onCollisionStart("turtles", "turtles", () => undefined);
	const gone = exchange(collision);
	assert.equal(collision.statistics.handlerCalls, 4);
	collision.update([]);
	await new Promise((resolve) => setTimeout(resolve, 10));
	collect();
	assert.deepEqual(gone.map((one) => one.deref()), [undefined, undefined]);
});

// Bytes a triangle: the corners of a triangle alone are 12. Extents of all triangles would be 48 more.
const MOST = { added: 45, ray: 60, cast: 60, walks: 80 };

// Collisions of agents that leave after a snapshot without traits, as the module for developers notes it.
async function snapshotAndLeave() {
	const { Agent: OwnAgent, BinCollider, Collision: OwnCollision } = await import(pathToFileURL(path.join(folder, manifest.exports["."].node)));
	const collision = new OwnCollision(new BinCollider());
	const left = [1, 2, 3].map(() => {
		const agent = new OwnAgent("sphere");
		collision.update([agent]);
		collision.snapshot();
		return new WeakRef(agent);
	});
	collision.update([]);
	return { collision, left };
}

test("a Collision does not keep the agents of its snapshots", async () => {
	const { collision, left } = await snapshotAndLeave();
	await new Promise((resolve) => setTimeout(resolve, 10));
	collect();
	assert.deepEqual(left.map((each) => each.deref()), [undefined, undefined, undefined]);
	assert.equal(collision.lastAgents.length, 0);
});

test("a level keeps few bytes for each of its triangles", () => {
	const bytes = measure("kept.mjs", "100");
	assert.ok(bytes.walked > 30, `${bytes.walked} walkers are in the level`);
	assert.ok(bytes.ray > bytes.added + 8, `${bytes.ray} bytes a triangle: the measure sees the corners`);
	for (const [name, most] of Object.entries(MOST)) assert.ok(bytes[name] <= most, `${name}: ${bytes[name]} bytes a triangle`);
});
