/** Tests of the adapter to three.js, with each version of three.js that it is for. What three.js says is the truth. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { animatedFile } from "./animated.mjs";
import { peers, root } from "./peers.mjs";
import { Scenes, drawnCorners } from "./scenes.mjs";
import { warningsIn } from "./warnings.mjs";

const all = await peers();
const SCENES = { first: 200, others: 60 };
const PICKS = { first: 4000, others: 2000 };

/** The corners of a model's triangles in the world of an agent, in the axes of a scene. */
function cornersOf(model, agent, up) {
	const { rawData: m } = agent.transform;
	return model.triangles.flatMap((corner) => {
		const [x, y, z] = model.vertices.slice(3 * corner, 3 * corner + 3);
		const [a, b, c] = [0, 1, 2].map((row) => m[row] * x + m[row + 4] * y + m[row + 8] * z + m[row + 12]);
		return up === "y" ? [a, c, -b] : [a, b, c];
	});
}

/** A geometry whose triangles are named by an index. */
function withIndex(geometry) {
	const indexed = geometry.clone();
	indexed.setIndex(Array.from({ length: geometry.attributes.position.count }, (_, i) => i));
	return indexed;
}

/** The largest difference of corners, those of triangles that are mirrored being turned round. */
function differenceOf(found, { corners, flips }) {
	assert.equal(found.length, corners.length);
	let most = 0;
	flips.forEach((isFlipped, triangle) => [0, 1, 2].forEach((corner) => [0, 1, 2].forEach((axis) => {
		const other = isFlipped ? [0, 2, 1][corner] : corner;
		most = Math.max(most, Math.abs(found[9 * triangle + 3 * corner + axis] - corners[9 * triangle + 3 * other + axis]));
	})));
	return most;
}

// the random ones are different with each version
for (const [number, { version, folder, THREE, engine, adapter }] of all.entries()) {
	const [sceneCount, pickCount] = [SCENES, PICKS].map(({ first, others }) => (number === 0 ? first : others));
	const { Agent, BinCollider, Collision, Model, Terrain, Vector3D } = engine;
	const { ThreeAgentBinding, bindInstance, faceOf, levelFromObject, modelFromObject, TerrainGeometry, terrainFromMesh, ThreeWireframe, toEngine, toScene } = adapter;

	test(`three ${version}: what is drawn in ${sceneCount} random scenes is where the engine has it, whichever of the two leads`, () => {
		const scenes = new Scenes(THREE, 25 + number);
		const { dice } = scenes;
		const land = new THREE.Scene();
		let most = 0;
		let triangles = 0;
		for (let i = 0; i < sceneCount; i++) {
			const source = scenes.tree();
			const up = dice.isLuckyIn(2) ? "y" : "z";
			const landUp = dice.isLuckyIn(4) ? "y" : "z";
			scenes.place(source);
			land.add(source);
			const truth = drawnCorners(THREE, source);
			if (truth.flips.length === 0) continue;
			const model = modelFromObject("any", source, { up, scaling: [Model.FOOTPRINT, Model.VOLUME, Model.AS_GIVEN][dice.below(3)] });
			const agent = new Agent("any");
			const binding = new ThreeAgentBinding(agent, source, model, { up: landUp });
			binding.updateAgent();
			most = Math.max(most, differenceOf(cornersOf(model, agent, landUp), truth));
			const revision = JSON.stringify([agent.transform.rawData]);
			binding.updateObject();
			assert.equal(JSON.stringify([agent.transform.rawData]), revision);
			// and the agent leads
			agent.moveTo(dice.number(-5, 5), dice.number(-5, 5), dice.number(-5, 5));
			agent.heading = dice.number(-180, 180);
			agent.pitch = dice.isLuckyIn(3) ? 90 : dice.number(-180, 180);
			agent.roll = dice.number(-180, 180);
			agent.size = dice.number(0.2, 3);
			binding.updateObject();
			const drawn = drawnCorners(THREE, source);
			most = Math.max(most, differenceOf(cornersOf(model, agent, landUp), drawn));
			triangles += drawn.flips.length;
			land.remove(source);
		}
		assert.ok(most <= 1e-12, `${most}`);
		assert.ok(most > 0 && triangles > 20 * sceneCount, `${triangles} triangles`);
		for (const kind of ["plain", "indexed", "interleaved", "quantized", "a draw range", "groups", "instanced", "skinned", "morphed", "mirrored", "mirrored twice",
			"levels of detail", "near gimbal lock", "placed by its matrix"]) assert.ok(scenes.counts[kind] >= sceneCount / 10, `${kind}: ${scenes.counts[kind]}`);
	});

	const scenes = new Scenes(THREE, 7);
	const { dice } = scenes;
	const box = () => new THREE.Mesh(new THREE.BoxGeometry(2, 4, 1), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
	const matrixOf = (agent) => agent.transform.rawData;

	test(`three ${version}: a model has each position once, and triangles as three.js winds them, in mirrors too`, () => {
		const group = new THREE.Group();
		const mirrored = box();
		mirrored.scale.x = -1;
		mirrored.position.set(10, 0, 0);
		group.add(box(), mirrored);
		const { vertices, triangles } = modelFromObject("boxes", group, { scaling: Model.AS_GIVEN });
		assert.equal(vertices.length, 3 * 16);
		assert.equal(triangles.length, 3 * 24);
		for (let i = 0; i < triangles.length; i += 3) {
			const [a, b, c] = [0, 1, 2].map((k) => new THREE.Vector3().fromArray(vertices, 3 * triangles[i + k]));
			const middle = new THREE.Vector3(triangles[i] < 8 ? 0 : 10, 0, 0);
			assert.ok(b.clone().sub(a).cross(c.clone().sub(a)).dot(a.clone().sub(middle)) > 0, `triangle ${i / 3} faces outwards`);
		}
		const upright = modelFromObject("box", new THREE.BoxGeometry(2, 4, 1));
		assert.deepEqual([Math.max(...upright.vertices), upright.source.unit], [2, 2]);
	});

	test(`three ${version}: positions may be halves of floats, or the first three of more numbers`, () => {
		const corners = [[0, 0, 0], [1, 0, 0.5], [0.25, 2, 0]];
		const halves = new THREE.Float16BufferAttribute(corners.flat().map((value) => THREE.DataUtils.toHalfFloat(value)), 3);
		const fours = new THREE.BufferAttribute(new Float32Array(corners.flatMap((corner) => [...corner, 1])), 4);
		const plain = new THREE.Float32BufferAttribute(corners.flat(), 3);
		const [expected, ...others] = [plain, halves, fours].map((position) => modelFromObject("any", new THREE.BufferGeometry().setAttribute("position", position), { scaling: Model.AS_GIVEN }));
		for (const other of others) assert.deepEqual(other.vertices, expected.vertices);
		assert.deepEqual([...expected.vertices], [0, 0, 0, 1, -0.5, 0, 0.25, 0, 2]);
	});

	test(`three ${version}: a level is the same model as one of its vertices and triangles`, () => {
		const scenes = new Scenes(THREE, 60 + number);
		const land = new THREE.Scene();
		let triangles = 0;
		for (let i = 0; i < 20; i++) {
			const source = scenes.tree();
			scenes.place(source);
			land.add(source);
			if (drawnCorners(THREE, source).corners.length === 0) continue;
			const level = levelFromObject("level", source);
			const same = new Model("level", level.vertices, level.triangles, Model.AS_GIVEN);
			same.setMeshes(level.meshes, level.meshNames);
			same.setMaterials(level.materials, level.materialNames);
			assert.ok(level.vertices.every((value) => !Object.is(value, -0)));
			for (const name of ["vertices", "triangles", "meshes", "meshNames", "materials", "materialNames"]) assert.deepEqual(level[name], same[name], name);
			assert.deepEqual([level.source.unit, level.source.offset, level.source.matrix.rawData], [same.source.unit, same.source.offset, same.source.matrix.rawData]);
			triangles += level.triangles.length / 3;
		}
		assert.ok(triangles > 1000);
	});

	test(`three ${version}: a level collides where it is drawn, without a binding`, () => {
		const trees = new Scenes(THREE, 43);
		const land = new THREE.Scene();
		let [most, triangles, placed] = [0, 0, 0];
		for (let i = 0; i < 30; i++) {
			const source = trees.tree();
			const up = trees.dice.isLuckyIn(2) ? "y" : "z";
			trees.place(source);
			land.add(source);
			const truth = drawnCorners(THREE, source);
			if (truth.flips.length === 0) continue;
			most = Math.max(most, differenceOf(cornersOf(levelFromObject("level", source, { up }), new Agent("level"), up), truth));
			triangles += truth.flips.length;
			placed += source.position.length() > 0.1 ? 1 : 0;
			land.remove(source);
		}
		assert.ok(most <= 1e-12, `${most}`);
		assert.ok(triangles > 600 && placed > 10, `${triangles} triangles, ${placed} placed`);
		assert.throws(() => levelFromObject("level", {}), /expected an Object3D/);
		assert.throws(() => levelFromObject("level", new THREE.BoxGeometry(), { up: "x" }), /up must be/);
	});

	test(`three ${version}: a room stops who walks in it if it has an opening or thick walls; if not, the engine warns`, () => {
		const wall = new THREE.MeshStandardMaterial({ side: THREE.DoubleSide });
		const room = (...materials) => new THREE.Mesh(new THREE.BoxGeometry(10, 4, 10).translate(0, 2, 0), materials.length === 1 ? materials[0] : materials);
		const boxes = new THREE.Group();
		const addWall = (x, y, z, ...size) => boxes.add(new THREE.Mesh(new THREE.BoxGeometry(...size).translate(x, y, z), wall));
		for (const y of [-0.5, 4.5]) addWall(0, y, 0, 12, 1, 12);
		for (const x of [-5.5, 5.5]) addWall(x, 2, 0, 1, 4, 12);
		for (const z of [-5.5, 5.5]) addWall(0, 2, z, 12, 4, 1);
		const inner = new THREE.BoxGeometry(10, 4, 10).translate(0, 2, 0);
		inner.index.array.reverse();
		const solidified = new THREE.Group().add(new THREE.Mesh(new THREE.BoxGeometry(11, 5, 11).translate(0, 2, 0)), new THREE.Mesh(inner));
		const hole = room(wall);
		hole.geometry.setDrawRange(3, Infinity);
		const openTunnel = new THREE.Mesh(new THREE.CylinderGeometry(3, 3, 30, 24, 1, true).rotateZ(Math.PI / 2).translate(0, 2, 0));
		const tunnel = new THREE.Mesh(new THREE.CylinderGeometry(3, 3, 30, 24).rotateZ(Math.PI / 2).translate(0, 2, 0));
		/** Where a character ends that walks along x, what it stands on, and what was warned of. */
		let plays = 0;
		const play = (level, exact, dx) => {
			const name = `level ${++plays}`; // a shape is warned of once
			const land = new engine.GreatLand();
			land.addModel(engine.BuiltInModel.capsule(0.3, 1.8, "hero"));
			land.loadTightestFit = false;
			land.addModel(levelFromObject(name, level));
			const collider = new engine.CombinationCollider(land);
			collider.exact = exact;
			const queries = new engine.AgentQueries(collider);
			const agent = new Agent(name);
			agent.hierarchical = true;
			const hero = new Agent("hero");
			hero.z = 0.4;
			queries.update([agent]);
			const warnings = warningsIn(() => {
				for (let i = 0; i < 200; i++) queries.walk(hero, dx, 0);
			});
			return { x: hero.x, z: hero.z, warnings };
		};
		for (const [name, level] of Object.entries({ noCeiling: room(wall, wall, null, wall, wall, wall), hole, boxes, solidified })) {
			const { x, z, warnings } = play(level, true, 0.1);
			assert.ok(Math.abs(x - 4.7) < 1e-6 && Math.abs(z) < 1e-6, `${name}: ${x}, ${z}`);
			assert.deepEqual(warnings, [], name);
		}
		const through = play(openTunnel, true, 0.05);
		assert.ok(Math.abs(through.x - 10) < 0.01 && through.z > -1 && through.warnings.length === 0, JSON.stringify(through));
		for (const [level, exact] of [[room(wall), true], [room(wall), false], [boxes, false], [tunnel, true]]) {
			const { x, z, warnings } = play(level, exact, 0.1);
			assert.ok(x > 6 && z < -9, `${x}, ${z}`);
			assert.equal(warnings.length, 1);
			assert.match(warnings[0], /^starlogo-collision: agent \d+ \(.*shape "hero"\) begins a motion at \(.*\), [\d.]+ deep inside of agent \d+ \(breed "turtles", shape "level \d+"\), which does not stop it\. What is inside/);
		}
	});

	test(`three ${version}: a level's model is not bound, and the engine warns of what is drawn elsewhere than it collides`, () => {
		const said = warningsIn((soFar) => {
			const land = new THREE.Scene();
			const lift = new THREE.Mesh(new THREE.BoxGeometry(3, 0.4, 3));
			land.add(lift);
			lift.position.set(5, 2, 3);
			const [placed, moved] = [levelFromObject("lift", lift), modelFromObject("lift", lift, { scaling: Model.AS_GIVEN })];
			const agent = new Agent("lift", "lifts");
			assert.throws(() => new ThreeAgentBinding(agent, lift, placed), /^ArgumentError: model "lift" is of levelFromObject and has its object's place in it: .*modelFromObject\(name, object, \{ scaling: Model\.AS_GIVEN \}\)$/);
			new ThreeAgentBinding(agent, lift, moved).updateAgent();
			assert.deepEqual([agent.x, agent.y, agent.z], [5, -3, 2]);
			// without the model nothing is wrong if it has the mesh's units, or if the agent has another shape
			new ThreeAgentBinding(agent, lift);
			new ThreeAgentBinding(new Agent("hero"), lift);
			lift.position.set(0, 0, 0);
			new ThreeAgentBinding(agent, lift, levelFromObject("lift", lift));
			assert.deepEqual(soFar, []);
			modelFromObject("narrow", lift);
			for (let i = 0; i < 2; i++) new ThreeAgentBinding(new Agent("narrow"), lift);
			lift.scale.set(2, 2, 2);
			new ThreeAgentBinding(agent, lift, moved);
			lift.scale.set(4, 0.4, 2);
			new ThreeAgentBinding(agent, lift, moved);
			land.rotation.x = -Math.PI / 2;
			levelFromObject("level", lift, { up: "z" });
			land.updateMatrixWorld();
			levelFromObject("turned", lift);
			land.add(new THREE.Group().add(lift));
			lift.parent.scale.setScalar(2);
			levelFromObject("level", lift);
		});
		const expected = [/draws agent \d+ \(.*shape "narrow"\) elsewhere.* the model "narrow" was made of the object\. Pass it as the third argument$/, /\(breed "lifts".* scale of its own, \(4, 0\.4, 2\), .*bind the group$/,
			/levelFromObject\("turned"\): the object's parent is moved, turned or scaled.* 1 times its size/,
			/levelFromObject\("level"\): the object's parent is moved, turned or scaled.* 2 times its size/];
		assert.equal(said.length, expected.length, said.join("\n"));
		expected.forEach((pattern, i) => assert.match(said[i], pattern));
	});

	test(`three ${version}: the engine warns of agents that are put back to their objects, of objects that jump to a new agent, and of instances that move together`, () => {
		const bound = (x = 0) => {
			const object = new THREE.Object3D();
			object.position.set(x, 0, 0);
			const agent = new Agent(`box ${++shapes}`);
			return { agent, object, binding: new ThreeAgentBinding(agent, object) };
		};
		let shapes = 0;
		const said = warningsIn((soFar) => {
			// an object that leads, with an agent that walks in between and takes its object along; a coin that bobs; an agent that was put where its object is
			const [dragged, bobbing, placed] = [bound(), bound(), bound(5)];
			placed.agent.moveTo(5, 0, 0);
			for (let i = 1; i < 40; i++) {
				dragged.object.position.x += 0.1;
				dragged.binding.updateAgent();
				dragged.agent.moveTo(dragged.agent.x, i, 0);
				dragged.binding.updateObject();
				bobbing.agent.x = i;
				bobbing.binding.updateObject();
				bobbing.object.position.y += 0.1;
				placed.binding.updateAgent();
				placed.agent.moveTo(5 + i, 0, 0);
				placed.object.position.x = 5 + i;
			}
			// going back with objects that go back, too, and with an agent that leads
			const collision = new Collision(new BinCollider());
			const [lift, hero] = [bound(), bound()];
			const frame = (step) => {
				lift.object.position.x += step;
				lift.binding.updateAgent();
				hero.agent.x += 1;
				collision.update([lift.agent, hero.agent]);
				hero.binding.updateObject();
			};
			frame(1);
			const bytes = collision.snapshot(true);
			const goBack = () => {
				frame(1);
				collision.restore(bytes, [lift.agent, hero.agent]);
			};
			goBack();
			for (const { binding } of [lift, hero]) binding.updateObject();
			frame(1);
			// a saved game: another object, bound anew
			const saved = new Agent("saved");
			collision.update([saved]);
			const other = bound(7);
			collision.restore(collision.snapshot(true), [saved]);
			new ThreeAgentBinding(saved, other.object).updateObject();
			assert.equal(other.object.position.x, 0);
			collision.update([lift.agent, hero.agent]);
			lift.object.position.x = 1;
			collision.restore(bytes, [lift.agent, hero.agent]);
			lift.binding.updateAgent();
			// a crate whose model stands on its origin; an agent that is put at the origin; an object that waits unseen; sparks that are one agent
			const crate = new THREE.Mesh(new THREE.BoxGeometry());
			crate.position.y = 0.5;
			new ThreeAgentBinding(new Agent("crate"), crate, modelFromObject("crate", crate)).updateObject();
			const [begun, unseen] = [bound(5), bound(5)];
			begun.agent.moveTo(0, 0, 0);
			unseen.object.visible = false;
			for (const { binding } of [begun, unseen]) binding.updateObject();
			const sparks = new THREE.InstancedMesh(new THREE.BoxGeometry(), undefined, 3);
			new ThreeAgentBinding(new Agent("sparks"), sparks).updateObject();
			// objects that lead into a wall, at an even pace and at another, and are pushed out of it with their agents
			const walking = [bound(), bound()];
			for (let i = 1; i < 40; i++) {
				for (const [k, { agent, object, binding }] of walking.entries()) {
					object.position.x += 0.25 + k * 0.01 * (i % 3);
					binding.updateAgent();
					if (agent.x <= 2) continue;
					agent.moveTo(2, 0, 0);
					object.position.x = 2;
					object.updateMatrix(); // as it is drawn
				}
			}
			// a lift that follows the game's own time, back by some frames and on again
			const timed = bound();
			let time = 0;
			const rise = () => {
				timed.object.position.y = 3 * Math.sin(++time / 60);
				timed.binding.updateAgent();
				collision.update([timed.agent]);
				return { bytes: collision.snapshot(true), time };
			};
			const kept = [];
			for (let i = 0; i < 500; i++) {
				kept.push(rise());
				const back = i < 60 ? 0 : [0, 1, 0, 2, 5, 30][i % 6];
				if (back === 0) continue;
				const then = kept.at(-1 - back);
				collision.restore(then.bytes, [timed.agent]);
				time = then.time;
				kept.length -= back;
				for (let k = 0; k < back; k++) kept.push(rise());
			}
			assert.deepEqual(soFar, []);
			collision.update([lift.agent, hero.agent]);
			for (let i = 0; i < 2; i++) goBack();
			frame(1);
			// an agent that should lead
			const coin = bound();
			coin.binding.updateAgent();
			for (let i = 1; i < 30; i++) {
				coin.agent.moveTo(i, 0, 0);
				coin.binding.updateAgent();
			}
			// an object that should lead, and one that is moved to be drawn
			for (const isDrawn of [true, false]) {
				const gem = bound();
				for (let i = 1; i < 30; i++) {
					gem.binding.updateObject();
					if (!isDrawn) gem.object.updateMatrix();
					gem.object.position.x += 0.1;
					if (isDrawn) gem.object.updateMatrix();
				}
			}
			for (let i = 0; i < 2; i++) bound(5).binding.updateObject();
			const mesh = new THREE.InstancedMesh(new THREE.BoxGeometry(), undefined, 3);
			const model = modelFromObject("one of three", mesh.geometry);
			new ThreeAgentBinding(new Agent("all of three"), mesh, modelFromObject("all of three", mesh));
			bindInstance(new Agent("one of three"), mesh, 1, model).updateObject();
			for (let i = 0; i < 2; i++) new ThreeAgentBinding(new Agent("one of three"), mesh, model);
			for (let i = 0; i < 2; i++) new ThreeAgentBinding(new Agent("sparks"), sparks);
			// a level in its own units, and the same with a size
			const levels = new engine.GreatLand();
			levels.addLevel(levelFromObject("scaled level", new THREE.Mesh(new THREE.BoxGeometry(4, 1, 4))));
			for (const size of [1, 3]) {
				const game = new Collision(new engine.CombinationCollider(levels));
				const level = Object.assign(new Agent("scaled level"), { hierarchical: true, size });
				for (let i = 0; i < 70; i++) game.update([level]);
			}
		});
		const expected = [/restore\(\) has put agent \d+ .* back, and updateAgent\(\) undoes it.*binding\.updateObject\(\) after restore\(\)/, /was moved before each of 10 updateAgent\(\) in turn/,
			/the object of agent \d+ .* was moved before each of 10 updateObject\(\) in turn/,
			/updateObject\(\) takes the object of agent .* from \(5, 0, 0\) to the origin/, /updateObject\(\) takes the object of agent .* from \(5, 0, 0\) to the origin/, /moves all 3 instances of the mesh of agent .*bindInstance/, /moves all 3 instances of the mesh of agent \d+ \(.*"sparks"\)/,
			/shape "scaled level"\) has the size 3, and its model is of levelFromObject.* stays at the origin, with size 1/];
		assert.equal(said.length, expected.length, said.join("\n"));
		expected.forEach((pattern, i) => assert.match(said[i], pattern));
	});

	test(`three ${version}: options that there are not, and objects that are no level, are refused with what to do`, () => {
		const geometry = new THREE.BoxGeometry();
		const object = new THREE.Mesh(geometry);
		const terrain = new Terrain(2, 2);
		for (const make of [() => modelFromObject("any", geometry, { upAxis: "z" }), () => levelFromObject("any", geometry, { upAxis: "z" }), () => terrainFromMesh(geometry, 2, 2, 1, 0, 0, { upAxis: "z" }),
			() => new TerrainGeometry(terrain, { upAxis: "z" }), () => new ThreeAgentBinding(new Agent("any"), object, null, { upAxis: "z" }), () => new ThreeWireframe({ upAxis: "z" })]) {
			assert.throws(make, /^ArgumentError: \w+: options\.upAxis is no option; (?:the nearest is up; there are|there is) (?:up|color, up)\b/);
		}
		const notOptions = /^ArgumentError: \w+: options must be a literal such as \{ up: "y" \}, not "as given"$/;
		for (const make of [() => modelFromObject("any", object, Model.AS_GIVEN), () => levelFromObject("any", object, Model.AS_GIVEN), () => new ThreeAgentBinding(new Agent("box"), object, null, Model.AS_GIVEN)]) assert.throws(make, notOptions);
		const crowd = new THREE.InstancedMesh(geometry, undefined, 3);
		for (const none of [null, [], 5]) {
			for (const make of [() => modelFromObject("any", geometry, none), () => levelFromObject("any", geometry, none), () => terrainFromMesh(geometry, 2, 2, 1, 0, 0, none), () => new TerrainGeometry(terrain, none),
				() => new ThreeAgentBinding(new Agent("any"), object, null, none), () => bindInstance(new Agent("any"), crowd, 0, null, none), () => new ThreeWireframe(none)]) {
				assert.throws(make, /^ArgumentError: \w+: options must be a literal such as \{ up: "y" \}, not (null|\[\]|5)$/);
			}
		}
		// an index that is not there would bind the whole mesh
		for (const index of [undefined, null, 3, -1, 0.5, "0"]) assert.throws(() => bindInstance(new Agent("any"), crowd, index), /^RangeError: the mesh has instances 0 to 2, not /);
		assert.throws(() => levelFromObject("any", { scene: object }), /^ModelError: model "any": expected an Object3D or a BufferGeometry, not a plain object\. Its scene is an Object3D$/);
		assert.throws(() => new ThreeAgentBinding(new Agent("any"), { scene: object }), /^ArgumentError: ThreeAgentBinding: object must be an Object3D, not a plain object\. Its scene is one$/);
		assert.throws(() => new ThreeAgentBinding(new Agent("any"), object, null, { modelUp: "x" }), /^ArgumentError: ThreeAgentBinding: options\.modelUp must be "y" or "z"/);
		const group = new THREE.Group();
		group.name = "hall";
		assert.throws(() => levelFromObject("any", group), /^ModelError: model "any": no vertices: Group "hall" has no meshes with triangles yet$/);
		const floor = new THREE.Mesh(new THREE.BufferGeometry());
		floor.name = "floor";
		assert.throws(() => levelFromObject("any", floor), /^ModelError: model "any": no vertices: Mesh "floor": its geometry has no positions$/);
		assert.throws(() => modelFromObject("any", floor.geometry), /^ModelError: model "any": no vertices: the geometry has no positions$/);
		assert.throws(() => toScene(undefined), /^ArgumentError: toScene: x, y and z must be numbers/);
	});

	test(`three ${version}: points of a scene become the engine's, and the other way round`, () => {
		const { dice: chance } = new Scenes(THREE, 44);
		const agent = new Agent("any");
		const object = new THREE.Object3D();
		const binding = new ThreeAgentBinding(agent, object);
		for (let i = 0; i < 20; i++) {
			object.position.set(chance.number(-5, 5), chance.number(-5, 5), chance.number(-5, 5));
			binding.updateAgent();
			const point = toEngine(object.position);
			assert.ok(point instanceof Vector3D);
			assert.deepEqual([point.x, point.y, point.z], [agent.x, agent.y, agent.z]);
			const back = toScene(agent);
			assert.ok(back instanceof THREE.Vector3 && back.equals(object.position));
			assert.equal(toScene(point, point), point);
			assert.deepEqual([point.x, point.y, point.z], object.position.toArray());
		}
		assert.ok(Object.is(toEngine(new THREE.Vector3()).y, 0));
		assert.throws(() => toEngine(null), /x, y and z must be numbers, as a Vector3 has them, not null/);
		assert.throws(() => toScene({ x: 1, y: "2", z: 3 }), /must be numbers.*not a plain object/);
	});

	test(`three ${version}: a terrain is drawn where it is, as slopes and as blocks, and again when it has changed`, () => {
		const { dice: chance } = new Scenes(THREE, 41);
		const caster = new THREE.Raycaster();
		for (const up of ["y", "z"]) {
			const terrain = new Terrain(12, 9, 0.5, -3, 2);
			const geometry = new TerrainGeometry(terrain, { up });
			const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial());
			const place = (x, y, z) => (up === "y" ? new THREE.Vector3(x, z, -y) : new THREE.Vector3(x, y, z));
			const heightAt = (x, y) => {
				caster.set(place(x, y, 100), place(0, 0, -1));
				return 100 - caster.intersectObject(mesh)[0].distance;
			};
			const firstOf = (from, direction) => {
				caster.set(place(...from), place(...direction));
				return caster.intersectObject(mesh)[0];
			};
			for (const isBlocky of [false, true, false]) {
				terrain.isBlocky = isBlocky;
				for (let i = 0; i < 5; i++) terrain.raiseMound(chance.number(-3, 2.5), chance.number(2, 6), chance.number(1, 4), chance.number(-2, 3));
				assert.equal(geometry.update(), true);
				assert.equal(geometry.update(), false);
				for (let i = 0; i < 200; i++) {
					const [x, y] = [chance.number(-2.99, 2.49), chance.number(2.01, 5.99)];
					assert.ok(Math.abs(heightAt(x, y) - terrain.heightAt(x, y)) < 1e-4, `${x}, ${y}, ${isBlocky}`);
				}
			}
			terrain.reset();
			assert.equal(geometry.update(), true);
			assert.equal(geometry.boundingBox.getSize(new THREE.Vector3()).dot(place(0, 0, 1)), 0);
			// walls face the lower blocks: the mesh's material has one side only
			terrain.isBlocky = true;
			terrain.setHeight(5, 4, 2);
			geometry.update();
			for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
				const hit = firstOf([-0.5 - 2 * dx, 4 - 2 * dy, 1], [dx, dy, 0]);
				assert.ok(Math.abs(hit.distance - 1.75) < 1e-6, `${hit?.distance}`);
				assert.ok(hit.face.normal.distanceTo(place(-dx, -dy, 0)) < 1e-6);
			}
			// at the border they go down to the lowest height
			for (const isBlocky of [false, true]) {
				terrain.isBlocky = isBlocky;
				terrain.raiseMound(-3, 4, 3, 1);
				terrain.setHeight(11, 0, -2);
				geometry.update();
				for (const z of [-1.9, 0.9]) {
					const hit = firstOf([-9, 4, z], [1, 0, 0]);
					assert.ok(Math.abs(hit.distance - (isBlocky ? 5.75 : 6)) < 1e-6, `${hit?.distance}`);
					assert.ok(hit.face.normal.distanceTo(place(-1, 0, 0)) < 1e-6);
				}
			}
		}
		assert.throws(() => new TerrainGeometry({}), /Terrain is needed/);
		assert.throws(() => new TerrainGeometry(new Terrain(2, 2), { up: "x" }), /up must be/);
	});

	test(`three ${version}: a terrain of a mesh has its highest triangles' heights`, () => {
		const { dice: chance } = new Scenes(THREE, 42);
		for (const up of ["y", "z"]) {
			const group = new THREE.Group();
			for (let i = 0; i < 6; i++) {
				const mesh = new THREE.Mesh(new THREE.IcosahedronGeometry(chance.number(0.5, 2), 2), new THREE.MeshBasicMaterial());
				mesh.position.set(chance.number(-4, 4), chance.number(-4, 4), chance.number(-4, 4));
				mesh.rotation.set(chance.number(-3, 3), chance.number(-3, 3), chance.number(-3, 3));
				group.add(mesh);
			}
			group.position.set(0.3, 0.2, 0.1);
			group.rotation.set(0.1, 0.2, 0.3);
			const terrain = terrainFromMesh(group, 40, 30, 0.25, -5, -4, { up });
			const caster = new THREE.Raycaster();
			let [hits, least] = [0, Infinity];
			const missing = new Set();
			for (let row = 0; row < 30; row++) for (let column = 0; column < 40; column++) {
				const [x, y] = [-5 + column / 4, -4 + row / 4];
				if (up === "y") caster.set(new THREE.Vector3(x, 100, -y), new THREE.Vector3(0, -1, 0));
				else caster.set(new THREE.Vector3(x, y, 100), new THREE.Vector3(0, 0, -1));
				const [hit] = caster.intersectObject(group);
				if (!hit) {
					missing.add(terrain.getHeight(column, row));
					continue;
				}
				hits++;
				least = Math.min(least, terrain.getHeight(column, row));
				assert.ok(Math.abs(terrain.getHeight(column, row) - 100 + hit.distance) < 1e-4, `${column}, ${row}`);
			}
			assert.ok(hits > 50, `${hits}`);
			assert.deepEqual([...missing], [least]);
		}
		const back = terrainFromMesh(new TerrainGeometry(terrainFromMesh(new THREE.BufferGeometry(), 3, 3)), 3, 3);
		assert.equal(back.heightAt(1, 1), 0);
		const flat = terrainFromMesh(new THREE.PlaneGeometry(8, 8, 8, 8).translate(4, 4, 7), 9, 9, 1, 0, 0, { up: "z" });
		for (let i = 0; i < 81; i++) assert.equal(flat.getHeight(i % 9, Math.floor(i / 9)), 7);
		assert.throws(() => terrainFromMesh(new THREE.Group(), 1, 1), RangeError);
		assert.throws(() => terrainFromMesh({}, 3, 3), /expected an Object3D/);
	});

	test(`three ${version}: a model follows the bones, morph targets and children of its object`, () => {
		const scenes = new Scenes(THREE, 925 + number);
		const { dice } = scenes;
		let most = 0;
		let moved = 0;
		let posed = 0;
		for (let i = 0; i < sceneCount; i++) {
			const source = scenes.tree();
			const up = dice.isLuckyIn(2) ? "y" : "z";
			if (drawnCorners(THREE, source).flips.length === 0) continue;
			const model = modelFromObject("any", source, { up, scaling: Model.AS_GIVEN });
			const agent = new Agent("any");
			const binding = new ThreeAgentBinding(agent, source, model, { up });
			const before = [...model.vertices];
			source.traverse((object) => {
				if (object.isBone) object.quaternion.copy(scenes.quaternion());
				if (object.morphTargetInfluences) object.morphTargetInfluences[0] = dice.number();
				if (object.isMesh && object !== source && object.matrixAutoUpdate) object.position.x += dice.number(-1, 1);
			});
			binding.updateAgent();
			binding.updateModel();
			// a mirrored child stays mirrored
			most = Math.max(most, differenceOf(cornersOf(model, agent, up), drawnCorners(THREE, source)));
			moved += model.vertices.some((coordinate, k) => coordinate !== before[k]) ? 1 : 0;
			posed++;
		}
		assert.ok(most <= 1e-11, `${most}`);
		assert.ok(moved > posed / 2, `${moved} of ${posed}`);
		const source = new THREE.Mesh(new THREE.BoxGeometry());
		const model = modelFromObject("box", source.geometry);
		const binding = new ThreeAgentBinding(new Agent("box"), source, model);
		source.geometry.scale(1, 2, 1);
		binding.updateModel();
		assert.equal(Math.max(...model.vertices.filter((_, i) => i % 3 === 2)), 1.5);
		assert.throws(() => new ThreeAgentBinding(new Agent("box"), source).updateModel(), /the binding of agent \d+ .*has no model: it is the third argument/);
		const before = [...model.vertices];
		for (const other of [new THREE.Group(), new THREE.Mesh(new THREE.SphereGeometry()), new THREE.Mesh(new THREE.PlaneGeometry()), new THREE.Mesh(new THREE.BufferGeometry())]) {
			assert.throws(() => new ThreeAgentBinding(new Agent("box"), other, model).updateModel(), /^ArgumentError: .* other meshes/);
		}
		assert.deepEqual([...model.vertices], before);
		// two meshes that change places in their group
		const pair = new THREE.Group().add(new THREE.Mesh(new THREE.BoxGeometry()), new THREE.Mesh(new THREE.BoxGeometry(2, 3, 4)));
		const ofPair = modelFromObject("pair", pair);
		const asMade = [...ofPair.vertices];
		pair.children.reverse();
		new ThreeAgentBinding(new Agent("pair"), pair, ofPair).updateModel();
		assert.deepEqual([...ofPair.vertices], asMade);
		// a mesh of the source beside the clone of another, and instances that another mesh had
		const box = pair.children.find(({ geometry }) => geometry.parameters.width === 1);
		pair.remove(box).add(box.clone());
		const crowds = new THREE.Group().add(new THREE.InstancedMesh(box.geometry, null, 3), new THREE.InstancedMesh(box.geometry, null, 3));
		crowds.children[0].count = 2;
		const ofCrowds = modelFromObject("crowds", crowds);
		crowds.children.forEach((each, i) => each.count = 3 - i);
		for (const [object, own] of [[pair, ofPair], [crowds, ofCrowds], [crowds.clone(), ofCrowds]]) {
			assert.throws(() => new ThreeAgentBinding(new Agent("pair"), object, own).updateModel(), /^ArgumentError: .* other meshes/);
		}
		assert.throws(() => new ThreeAgentBinding(new Agent("box"), source, new Model("own", model.vertices)).updateModel(), /modelFromObject/);
		assert.throws(() => bindInstance(new Agent("box"), new THREE.InstancedMesh(source.geometry, source.material, 2), 1, model).updateModel(), /instance/);
	});

	test(`three ${version}: the engine warns of a figure that collides as its first pose, and of one that two bindings pose, and refuses a mesh without its skeleton`, () => {
		/** A box, two high and with one bone; what it collides as is posed by its binding. */
		const figure = (name) => {
			const geometry = new THREE.BoxGeometry(1, 2, 1).translate(0, 1, 0);
			const { count } = geometry.attributes.position;
			geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(new Uint16Array(4 * count), 4));
			geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0)), 4));
			const mesh = new THREE.SkinnedMesh(geometry, new THREE.MeshBasicMaterial());
			mesh.name = name;
			assert.throws(() => modelFromObject(name, new THREE.Group().add(mesh)), { name: "ModelError", message: `model "${name}": the SkinnedMesh "${name}" has no skeleton: call mesh.bind(skeleton) first` });
			const bone = new THREE.Bone();
			mesh.add(bone);
			mesh.bind(new THREE.Skeleton([bone]));
			return { mesh, bone, model: modelFromObject(name, mesh, { scaling: Model.AS_GIVEN }) };
		};
		const { BuiltInModel, CombinationCollider, GreatLand, HierarchicalCollider, TightestFitCollider } = engine;
		/** Plays frames with figures whose bones move by so much in each. */
		const play = (figures, { Collider = CombinationCollider, traits = {}, reach = 0.05, others = [], eachFrame = () => {} }) => {
			const land = new GreatLand();
			for (const { model } of figures) if (!land.hasModel(model.name)) land.addModel(model);
			const agents = figures.map(({ model }) => Object.assign(new Agent(model.name, "figures"), traits));
			const bindings = figures.map(({ mesh, model }, i) => new ThreeAgentBinding(agents[i], mesh, model));
			const collisions = [Collider, ...others].map((Other) => new Collision(new Other(land)));
			for (let i = 0; i < 70; i++) {
				figures.forEach(({ bone }, k) => bone.position.x = reach * i * (k === 0 ? 1 : -1));
				for (const binding of bindings) binding.updateModel();
				eachFrame(land, figures[0].model);
				for (const collision of collisions) collision.update(agents);
			}
		};
		const twins = (name, otherModel) => {
			const [one, other] = [figure(name), figure(name)];
			return [one, { ...other, model: otherModel ?? one.model }];
		};
		const said = warningsIn((soFar) => {
			play([figure("tree")], { traits: { hierarchical: true } });
			play([figure("of trees")], { Collider: HierarchicalCollider });
			play([figure("of bins")], { Collider: BinCollider });
			play([figure("sways")], { reach: 0 });
			play([figure("is fitted again")], { eachFrame: (land, model) => land.boundingStructures.add(model.name, model.vertices) });
			play([figure("is fitted to all")], { eachFrame: (land, { name }) => land.boundingStructures.add(name, BuiltInModel.box(20, 20, 20, "all").vertices) });
			play([figure("has a tree elsewhere")], { Collider: TightestFitCollider, others: [HierarchicalCollider] });
			const traits = { hierarchical: true };
			play([figure("own 1"), figure("own 2")], { traits });
			play(twins("alike"), { traits, reach: 0 });
			assert.deepEqual(soFar, []);
			play([figure("first pose")], {});
			play(twins("shared"), { traits });
		});
		assert.equal(said.length, 2, said.join("\n"));
		assert.match(said[0], /^starlogo-collision: agent \d+ \(.*shape "first pose"\) collides as the structure around the first pose of its model: a pose moves the tree alone\. Set hierarchical, in a CombinationCollider, or fit again/);
		assert.match(said[1], /^starlogo-collision: the model "shared" was posed by two bindings between two updates, and has the last pose for both\. .*modelFromObject\("shared2", object\)$/);
	});

	test(`three ${version}: bones may be anywhere, groups may overlap, and many positions may be equal`, () => {
		const geometry = new THREE.BoxGeometry();
		const { count } = geometry.attributes.position;
		geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(new Uint16Array(4 * count), 4));
		geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(Array.from({ length: 4 * count }, (_, i) => (i % 4 === 0 ? 1 : 0)), 4));
		const mesh = new THREE.SkinnedMesh(geometry, new THREE.MeshBasicMaterial());
		const [land, arm, bone] = [new THREE.Group(), new THREE.Group(), new THREE.Bone()];
		land.add(new THREE.Group().add(mesh), arm.add(bone));
		mesh.bind(new THREE.Skeleton([bone]));
		land.children[0].position.set(5, 6, 7);
		arm.position.set(1, 2, 3);
		bone.scale.y = 2;
		const { vertices } = modelFromObject("bone", mesh, { up: "z", scaling: Model.AS_GIVEN });
		const ofAxis = (axis) => vertices.filter((_, i) => i % 3 === axis);
		assert.deepEqual([0, 1, 2].map((axis) => [Math.min(...ofAxis(axis)), Math.max(...ofAxis(axis))]), [[-4.5, -3.5], [-5, -3], [-4.5, -3.5]]);
		const grouped = new THREE.Mesh(new THREE.BoxGeometry(), [new THREE.MeshBasicMaterial(), new THREE.MeshBasicMaterial()]);
		grouped.geometry.clearGroups();
		grouped.geometry.addGroup(0, 24, 0);
		grouped.geometry.addGroup(12, 24, 1);
		assert.equal(modelFromObject("groups", grouped).triangles.length, 36);
		if (number > 0) return;
		const many = Float32Array.from({ length: 450000 }, () => Math.fround(dice.number()));
		const soup = new THREE.BufferGeometry();
		soup.setAttribute("position", new THREE.BufferAttribute(Float32Array.from([...many, ...many]), 3));
		const model = modelFromObject("many", soup, { up: "z", scaling: Model.AS_GIVEN });
		assert.deepEqual([model.vertices.length, model.triangles.length], [450000, 300000]);
		assert.ok(model.triangles.every((corner, i) => corner === i % 150000) && model.vertices.every((coordinate, i) => coordinate === many[i]));
	});

	test(`three ${version}: nothing changes where nothing has changed`, () => {
		const object = scenes.place(new THREE.Object3D());
		const agent = new Agent("any");
		const binding = new ThreeAgentBinding(agent, object);
		agent.heading = 725;
		agent.moveTo(1, 2, 3);
		binding.updateObject();
		object.position.x = 7;
		// the same rotation
		object.quaternion.set(...object.quaternion.toArray().map((number) => -number));
		binding.updateAgent();
		object.quaternion.set(...object.quaternion.toArray().map((number) => -number));
		binding.updateAgent();
		assert.deepEqual([agent.heading, agent.x, agent.y, agent.z], [725, 7, 2, 3]);
		let writes = 0;
		object.quaternion._onChange(() => writes++);
		agent.moveTo(8, 2, 3);
		binding.updateObject();
		assert.deepEqual([object.position.x, object.position.y, object.position.z, writes], [8, 3, -2, 0]);
		const copy = object.position.copy;
		object.position.copy = () => assert.fail("nothing has changed");
		binding.updateObject();
		binding.updateAgent();
		object.position.copy = copy;
		// whoever calls leads, also if the other has changed
		object.position.set(0, 0, 0);
		binding.updateObject();
		assert.equal(object.position.x, 8);
		agent.moveTo(0, 0, 0);
		binding.updateAgent();
		assert.equal(agent.x, 8);
		assert.deepEqual([binding.agent, binding.object], [agent, object]);
	});

	test(`three ${version}: instances are bound, in single precision`, () => {
		const mesh = new THREE.InstancedMesh(new THREE.ConeGeometry(0.6, 1.5, 6), new THREE.MeshBasicMaterial(), 20);
		const model = modelFromObject("cone", mesh.geometry);
		mesh.computeBoundingSphere();
		for (let i = 0; i < 20; i++) {
			const agent = new Agent("cone");
			agent.moveTo(dice.number(-5, 5), dice.number(-5, 5), dice.number(-5, 5));
			agent.setQuaternion(...scenes.quaternion().toArray());
			agent.size = dice.number(0.2, 3);
			const expected = matrixOf(agent);
			const binding = bindInstance(agent, mesh, i, model);
			const { version: before } = mesh.instanceMatrix;
			binding.updateObject();
			binding.updateObject();
			assert.equal(mesh.instanceMatrix.version, before + 1);
			const isThere = () => {
				const place = new THREE.Matrix4();
				mesh.getMatrixAt(i, place);
				const corners = cornersOf(model, agent, "y");
				mesh.geometry.index.array.forEach((vertex, k) => {
					const point = new THREE.Vector3().fromBufferAttribute(mesh.geometry.attributes.position, vertex).applyMatrix4(place);
					assert.ok(point.distanceTo(new THREE.Vector3(...corners.slice(3 * k, 3 * k + 3))) < 1e-5);
				});
				return place;
			};
			// mirrored twice
			mesh.setMatrixAt(i, isThere().setPosition(1, 2, 3).scale(new THREE.Vector3(-1, -1, 1)));
			binding.updateAgent();
			isThere();
			assert.ok(matrixOf(agent).some((element, k) => Math.abs(element - expected[k]) > 1e-3));
		}
		assert.equal(mesh.boundingSphere, null);
	});

	test(`three ${version}: a model that was turned when it was made is drawn where it collides`, () => {
		const geometry = new THREE.TorusGeometry(1, 0.3, 5, 7);
		const positions = Float64Array.from(geometry.attributes.position.array);
		const turns = (...factors) => new engine.ModelTransform(new engine.Vector3D(30, 40, 50), new engine.Vector3D(...factors), new engine.Vector3D(1, 2, 3));
		const source = `${Array.from({ length: positions.length / 3 }, (_, i) => `v ${positions.slice(3 * i, 3 * i + 3).join(" ")}`).join("\n")}\n${Array.from({ length: geometry.index.count / 3 }, (_, i) => `f ${[0, 1, 2].map((k) => geometry.index.getX(3 * i + k) + 1).join(" ")}`).join("\n")}\n`;
		const model = new engine.ObjModel("torus", source, turns(2, 2, 2), Model.VOLUME);
		const agent = new Agent("torus");
		agent.moveTo(1, 2, 3);
		agent.setQuaternion(...scenes.quaternion().toArray());
		const object = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial());
		for (const up of ["z", "y"]) {
			const binding = new ThreeAgentBinding(agent, object, model, { up, modelUp: "z" });
			binding.updateObject();
			assert.ok(differenceOf(cornersOf(model, agent, up), drawnCorners(THREE, object)) < 1e-12);
			const before = matrixOf(agent);
			object.position.x += 1;
			binding.updateAgent();
			object.position.x -= 1;
			// rounded, as files have it
			object.quaternion.set(...object.quaternion.toArray().map((number) => number * (1 + 5e-7)));
			binding.updateAgent();
			assert.ok(matrixOf(agent).every((element, i) => Math.abs(element - before[i]) < 1e-12));
		}
		assert.throws(() => new ThreeAgentBinding(agent, object, new engine.ObjModel("flat", source, turns(2, 2, 1))), /ArgumentError: model "flat" is mirrored or stretched/);
	});

	test(`three ${version}: a refused update of the agent loses nothing, and what is there already stays to the last bit`, () => {
		const object = box();
		const agent = new Agent("box");
		const binding = new ThreeAgentBinding(agent, object);
		binding.updateObject();
		agent.moveTo(3, 0, 0);
		object.scale.y = 2;
		assert.throws(() => binding.updateAgent(), /uniformly scaled/);
		object.scale.y = 1;
		binding.updateObject();
		assert.equal(object.position.x, 3);
		for (let i = 0; i < 300; i++) {
			const walker = new Agent("box");
			Object.assign(walker, { size: i === 0 ? 1e6 : 0.1 + 0.013 * i, heading: 1.7 * i, pitch: 0.3 * i });
			const { size } = walker;
			const width = i === 0 ? 0.9 : 1 + 0.7 * i;
			const mesh = new THREE.Mesh(new THREE.BoxGeometry(width, width, width));
			const own = new ThreeAgentBinding(walker, mesh, modelFromObject("box", mesh));
			own.updateObject();
			walker.moveTo(1, 2, 3);
			own.updateAgent();
			assert.equal(walker.size, size);
			walker.moveTo(0.1 * i, 1 / 3, 0.7 * i);
			own.updateObject();
			walker.color = i + 1;
			own.updateAgent();
			assert.deepEqual([walker.x, walker.y, walker.z], [0.1 * i, 1 / 3, 0.7 * i]);
		}
	});

	test(`three ${version}: an object with a pivot, and an instance with a model of all, are refused`, () => {
		const object = Object.assign(box(), { pivot: new THREE.Vector3(1, 0, 0) });
		assert.throws(() => new ThreeAgentBinding(new Agent("box"), object), /^ArgumentError: ThreeAgentBinding: object "" must have no pivot: put it into a Group/);
		const [moved, later] = [new Agent("box"), box()];
		const binding = new ThreeAgentBinding(moved, later);
		later.pivot = object.pivot;
		moved.moveTo(3, 0, 0);
		for (const call of ["updateObject", "updateAgent"]) assert.throws(() => binding[call](), /^ArgumentError: ThreeAgentBinding: object "" must have no pivot/);
		assert.deepEqual([moved.x, later.position.x], [3, 0]);
		later.pivot = null;
		binding.updateObject();
		assert.equal(later.position.x, 3);
		const crowd = new THREE.InstancedMesh(new THREE.BoxGeometry(), new THREE.MeshBasicMaterial(), 2);
		[0, 5].forEach((x, i) => crowd.setMatrixAt(i, new THREE.Matrix4().makeTranslation(x, 0, 0)));
		assert.throws(() => bindInstance(new Agent("all"), crowd, 0, modelFromObject("all", crowd)), /^ArgumentError: model "all" was made of all instances: an instance has a model of the mesh's geometry$/);
		bindInstance(new Agent("one"), crowd, 0, modelFromObject("one", crowd.geometry));
	});

	test(`three ${version}: clones of a ground and of a wireframe are their own`, () => {
		const ground = new TerrainGeometry(new Terrain(4, 4), { up: "z" });
		const copy = ground.clone();
		assert.deepEqual(copy.attributes.position.array, ground.attributes.position.array);
		assert.ok(copy instanceof TerrainGeometry && copy.terrain === ground.terrain && copy.attributes.position !== ground.attributes.position);
		Object.assign(ground, { name: "ground", userData: { grass: 1 } });
		assert.deepEqual([ground.clone().name, ground.clone().userData], ["ground", { grass: 1 }]);
		const other = new TerrainGeometry(new Terrain(3, 3)).copy(ground);
		ground.terrain.setHeight(1, 1, 2);
		assert.ok(other.terrain === ground.terrain && other.update() && ground.update());
		assert.deepEqual(other.attributes.position.array, ground.attributes.position.array);
		const agent = new Agent("any");
		const lines = new ThreeWireframe({ up: "z" }).showLines([0, 0, 0, 1, 1, 1], agent);
		const scene = new THREE.Scene().add(lines).clone();
		const [twin] = scene.children;
		agent.moveTo(2, 0, 0);
		for (const each of [lines, twin]) {
			each.update();
			assert.deepEqual([...each.geometry.attributes.position.array.slice(0, 6)], [2, 0, 0, 3, 1, 1]);
		}
		twin.clearLines().showLines([5, 5, 5, 6, 6, 6]);
		assert.deepEqual([...lines.geometry.attributes.position.array.slice(0, 6)], [2, 0, 0, 3, 1, 1]);
		assert.equal(lines.copy(lines).geometry.drawRange.count, 2);
		let disposals = 0;
		twin.geometry.addEventListener("dispose", () => disposals++);
		twin.copy(lines);
		assert.equal(disposals, 1);
	});

	test(`three ${version}: what an agent cannot be is refused, and leaves it as it was`, () => {
		const agent = new Agent("any");
		agent.moveTo(1, 2, 3);
		const before = JSON.stringify(matrixOf(agent));
		const refuse = (change, message) => {
			const object = new THREE.Object3D();
			change(object);
			assert.throws(() => new ThreeAgentBinding(agent, object).updateAgent(), message);
			assert.equal(JSON.stringify(matrixOf(agent)), before);
		};
		refuse(({ scale }) => scale.set(1, 2, 1), /^ArgumentError: agent \d+ \(breed "turtles", shape "any"\) can't be as its object is: .* not scale 1, 2, 1\. Put what is scaled or mirrored into a Group, .* bind the group$/);
		refuse(({ scale }) => scale.set(-1, 1, 1), /not scale -1, 1, 1\. Put /);
		refuse(({ scale }) => scale.set(-1, -1, -1), /not scale -1, -1, -1\. Put /);
		refuse(({ scale }) => scale.set(0, 0, 0), /not scale 0, 0, 0$/);
		refuse(({ scale }) => scale.set(1, 1, NaN), /not scale 1, 1, NaN$/);
		refuse(({ quaternion }) => quaternion.set(0, 0, 0, 2), /the quaternion must be of length 1, not 2$/);
		refuse(({ position }) => position.set(0, Infinity, 0), /ArgumentError: .* the position must be finite numbers, not \(0, /);
		refuse(({ position }) => position.set(0, 1e200, 0), /^RangeError: .* can't be of size 1 at \(0, 1e\+200, 0\)/);
		refuse(({ position }) => position.set(1e308, 1e308, 0), /^RangeError: .* can't be of size 1 at/);
		refuse(({ scale }) => scale.setScalar(1e200), /^RangeError: .* can't be of size 1e\+200/);
		refuse((object) => {
			object.matrixAutoUpdate = false;
			object.matrix.makeShear(0.01, 0, 0, 0, 0, 0);
		}, /^ArgumentError: .* not matrix 1, 0/);
		refuse((object) => {
			object.matrixAutoUpdate = false;
			object.matrix.elements[15] = 2;
		}, /^ArgumentError: .* not matrix 1, 0/);
		const mesh = new THREE.InstancedMesh(new THREE.BoxGeometry(), new THREE.MeshBasicMaterial(), 3);
		mesh.setMatrixAt(1, new THREE.Matrix4().makeScale(1, 1, 2));
		assert.throws(() => bindInstance(agent, mesh, 1).updateAgent(), /ArgumentError: .* not matrix 1, 0/);
		for (const index of [-1, 3, 0.5, NaN, "1"]) assert.throws(() => bindInstance(agent, mesh, index), /^RangeError: the mesh has instances 0 to 2, not /);
		assert.throws(() => bindInstance(agent, new THREE.Mesh(), 0), /^ArgumentError: bindInstance: mesh must be an InstancedMesh, not an object of class Mesh: it comes after the agent, before the index$/);
		const object = new THREE.Object3D();
		for (const wrong of [null, {}, "bear"]) assert.throws(() => new ThreeAgentBinding(wrong, object), /^ArgumentError: ThreeAgentBinding: agent must be an Agent, not /);
		assert.throws(() => new ThreeAgentBinding(object, agent), /^ArgumentError: ThreeAgentBinding: agent must be an Agent, not an object of class Object3D$/);
		for (const wrong of [null, {}, new THREE.BoxGeometry()]) assert.throws(() => new ThreeAgentBinding(agent, wrong), /^ArgumentError: ThreeAgentBinding: object must be an Object3D, not /);
		assert.throws(() => new ThreeAgentBinding(agent, object, object), /^ArgumentError: ThreeAgentBinding: model must be a Model or null, not an object of class Object3D: it comes third, before the options$/);
		assert.throws(() => new ThreeAgentBinding(agent, object, null, { up: "x" }), /^ArgumentError: ThreeAgentBinding: options\.up must be "y" or "z", not "x"/);
		assert.throws(() => modelFromObject("any", new THREE.BoxGeometry(), { up: "Y" }), /^ArgumentError: modelFromObject: options\.up must be "y" or "z", not "Y"/);
		for (const wrong of [null, undefined, {}, "bear.glb"]) assert.throws(() => modelFromObject("any", wrong), /^ModelError: model "any": expected an Object3D or a BufferGeometry, not /);
		for (const make of [modelFromObject, levelFromObject]) assert.throws(() => make(box(), "any"), /^ArgumentError: (modelFromObject|levelFromObject): the model's name comes first and is a string, not an object of class Mesh$/);
		assert.throws(() => modelFromObject("any", new THREE.Group()), /^ModelError: model "any": no vertices/);
		assert.throws(() => modelFromObject("", new THREE.BoxGeometry()), /^ModelError: .*needs a name/);
		const broken = box();
		broken.name = "hull";
		broken.geometry.index.setX(4, 999);
		assert.throws(() => modelFromObject("any", broken), /^ModelError: model "any", mesh "hull": a triangle names vertex 999, the last one is 23/);
		const endless = box();
		endless.geometry.attributes.position.setX(3, NaN);
		assert.throws(() => modelFromObject("any", endless), /^ModelError: model "any": vertex 3 of its geometry must be at finite numbers, not at \(NaN, /);
		for (const vertex of [2, 1, 23]) {
			const crate = box();
			crate.name = "crate";
			crate.geometry.attributes.position.setX(vertex, NaN);
			const said = new RegExp(`^ModelError: model "any", mesh "crate": vertex ${vertex} of its geometry must be at finite numbers`);
			assert.throws(() => modelFromObject("any", new THREE.Group().add(box(), crate)), said);
		}
		assert.throws(() => modelFromObject("any", new THREE.BatchedMesh(1, 24, 36, new THREE.MeshBasicMaterial())), /^ModelError: model "any": no vertices/);
	});

	test(`three ${version}: hits tell the mesh and the material`, () => {
		const [stone, glass] = ["stone", "glass"].map((name) => Object.assign(new THREE.MeshBasicMaterial(), { name }));
		const named = (mesh, name, x) => {
			mesh.name = name;
			mesh.position.set(x, 0, 0);
			return mesh;
		};
		const unnamed = new THREE.MeshBasicMaterial();
		const crates = named(new THREE.InstancedMesh(new THREE.BoxGeometry(), glass, 2), "crates", 0);
		[20, 30].forEach((x, i) => crates.setMatrixAt(i, new THREE.Matrix4().makeTranslation(x, 0, 0)));
		// the third of a box's groups is its top
		const several = named(new THREE.Mesh(new THREE.BoxGeometry(), [stone, stone, glass, stone, stone, stone]), "several", 10);
		const batch = named(new THREE.BatchedMesh(1, 24, 36, unnamed), "", 40);
		batch.addInstance(batch.addGeometry(new THREE.BoxGeometry()));
		const group = new THREE.Group().add(named(new THREE.Mesh(new THREE.BoxGeometry(), stone), "floor", 0), several, crates, batch);
		const model = levelFromObject("level", group);
		assert.deepEqual(model.meshNames, ["floor", "several", "crates", ""]);
		assert.deepEqual(model.materialNames, ["stone", "glass", ""]);
		const greatLand = new engine.GreatLand();
		greatLand.addModel(model);
		const collider = new engine.HierarchicalCollider(greatLand);
		collider.exact = true;
		const queries = new engine.AgentQueries(new engine.Collision(collider));
		queries.update([new Agent("level")]);
		const below = (x) => {
			const hit = queries.cast(new Vector3D(x + 0.1, 0.2, 5), new Vector3D(0, 0, -1));
			return [model.meshNames[hit.mesh], hit.materialName];
		};
		assert.deepEqual([0, 10, 20, 30, 40].map(below), [["floor", "stone"], ["several", "glass"], ["crates", "glass"], ["crates", "glass"], ["", ""]]);
		assert.deepEqual(modelFromObject("model", group).meshNames, model.meshNames);
		const drawnAt = (x) => faceOf(model, queries.cast(new Vector3D(x + 0.1, 0.2, 5), new Vector3D(0, 0, -1)).triangle);
		group.updateMatrixWorld();
		for (const x of [0, 10, 20, 30, 40]) {
			const [first] = new THREE.Raycaster(new THREE.Vector3(x + 0.1, 5, -0.2), new THREE.Vector3(0, -1, 0)).intersectObject(group);
			assert.deepEqual(drawnAt(x), { object: first.object, faceIndex: first.faceIndex, instanceId: first.instanceId ?? first.batchId ?? null });
		}
		assert.equal(faceOf(model, -1), null);
		for (const triangle of [-2, 60, 0.5, "1", undefined]) assert.throws(() => faceOf(model, triangle), /^RangeError: faceOf: triangle must be a whole number from -1 to 59, not /);
		for (const other of [modelFromObject("box", new THREE.BoxGeometry()), engine.BuiltInModel.cube(), null, group]) {
			assert.throws(() => faceOf(other, 0), /^ArgumentError: faceOf: model must be one that modelFromObject or levelFromObject has made of an Object3D, not /);
		}
		// a box has a group for each side: the draw range leaves out all but the first two
		const sides = new THREE.Mesh(new THREE.BoxGeometry(), [stone, glass, unnamed, unnamed, unnamed, unnamed]);
		sides.geometry.setDrawRange(0, 9);
		const drawn = modelFromObject("sides", sides);
		assert.deepEqual([drawn.materialNames, drawn.materials], [["stone", "glass"], [0, 0, 1]]);
		assert.deepEqual([0, 1, 2].map((triangle) => faceOf(drawn, triangle).faceIndex), [0, 1, 2]);
		const { meshNames, materialNames } = modelFromObject("box", new THREE.BoxGeometry());
		assert.deepEqual([meshNames, materialNames], [null, null]);
	});

	test(`three ${version}: a BatchedMesh is the meshes of its instances`, () => {
		const scenes = new Scenes(THREE, 77 + number);
		const { dice } = scenes;
		let count = 0;
		for (let i = 0; i < 60; i++) {
			const isIndexed = dice.isLuckyIn(2);
			const shapes = [new THREE.BoxGeometry(1, 2, 1), new THREE.ConeGeometry(0.5, 1, 5), new THREE.TetrahedronGeometry(1)]
				.map((shape) => (shape.index ? shape : withIndex(shape))).map((shape) => (isIndexed ? shape : shape.toNonIndexed()));
			const batch = new THREE.BatchedMesh(12, 400, isIndexed ? 600 : 0, new THREE.MeshBasicMaterial());
			// room that is kept for more, and a geometry that is gone, move the others along
			const reserved = dice.below(20);
			const ids = shapes.map((shape) => batch.addGeometry(shape, shape.attributes.position.count + reserved, isIndexed ? shape.index.count + 3 * reserved : -1));
			const instances = Array.from({ length: 8 }, () => ({ shape: dice.below(3) })).map(({ shape }) => ({ shape, id: batch.addInstance(ids[shape]) }));
			for (const { id } of instances) {
				const scale = new THREE.Vector3(dice.number(0.3, 1), dice.number(0.3, 1), dice.isLuckyIn(2) ? 0.5 : -0.5);
				batch.setMatrixAt(id, new THREE.Matrix4().compose(new THREE.Vector3(...dice.direction()), scenes.quaternion(), scale));
				if (dice.isLuckyIn(3)) batch.setVisibleAt(id, false);
			}
			const gone = new Set(instances.filter(() => dice.isLuckyIn(4)).map(({ id }) => id));
			for (const id of gone) batch.deleteInstance(id);
			if (dice.isLuckyIn(3)) {
				batch.deleteGeometry(ids[2]);
				for (const { shape, id } of instances) if (shape === 2) gone.add(id);
				batch.optimize?.();
			}
			const group = new THREE.Group();
			for (const { shape, id } of instances) {
				if (gone.has(id)) continue;
				const mesh = new THREE.Mesh(shapes[shape]);
				batch.getMatrixAt(id, mesh.matrix);
				mesh.matrixAutoUpdate = false;
				group.add(mesh);
			}
			if (group.children.length === 0) continue;
			for (const object of [batch, group]) object.position.set(1, 2, 3);
			const up = dice.isLuckyIn(2) ? "y" : "z";
			for (const make of [modelFromObject, levelFromObject]) {
				const [found, expected] = [batch, group].map((object) => make("any", object, { up }));
				assert.deepEqual([...found.vertices], [...expected.vertices]);
				assert.deepEqual([...found.triangles], [...expected.triangles]);
				count += found.triangles.length / 3;
			}
		}
		assert.ok(count > 5000, `${count} triangles`);
	});

	test(`three ${version}: only whole triangles count, and an index may have a plain array`, () => {
		for (const count of [4, 5, 7]) {
			const geometry = new THREE.ConeGeometry(0.5, 1, 5).toNonIndexed();
			const cut = new THREE.BufferGeometry().setAttribute("position", new THREE.BufferAttribute(geometry.attributes.position.array.slice(0, 3 * count), 3));
			const batch = new THREE.BatchedMesh(1, 10, 0, new THREE.MeshBasicMaterial());
			batch.addInstance(batch.addGeometry(cut));
			const [found, expected] = [batch, new THREE.Mesh(cut)].map((object) => modelFromObject("cut", object));
			assert.equal(found.triangles.length, count - (count % 3));
			assert.deepEqual([...found.triangles], [...expected.triangles]);
			assert.deepEqual([...found.vertices], [...expected.vertices]);
		}
		const plain = new THREE.BoxGeometry();
		const expected = modelFromObject("box", plain.clone());
		plain.index.array = [...plain.index.array];
		assert.deepEqual([...modelFromObject("box", plain).triangles], [...expected.triangles]);
		plain.setDrawRange(3, 6);
		assert.equal(modelFromObject("box", plain).triangles.length, 6);
	});

	test(`three ${version}: a wireframe is where the structures are, in one object`, () => {
		for (const up of ["y", "z"]) {
			const greatLand = new engine.GreatLand();
			const model = modelFromObject("torus", new THREE.TorusGeometry(1, 0.3, 5, 7));
			greatLand.addModel(model);
			const agent = new Agent("torus");
			const wireframe = new ThreeWireframe({ up, color: "red" });
			assert.deepEqual([wireframe.isLineSegments, wireframe.material.color.getHex(), wireframe.geometry.drawRange.count], [true, 0xff0000, 0]);
			const root = greatLand.hierarchies.root("torus");
			const fit = greatLand.boundingStructures.tightestFit("torus");
			const contact = Object.assign(new engine.Contact(), { depth: 0.5 });
			contact.point.setTo(1, 2, 3);
			contact.normal.setTo(0, 0, 1);
			const lines = [[fit, null], [fit, agent]].map(([structure, whose]) => [engine.Wireframes.ofStructure(structure), whose]);
			lines.push([engine.Wireframes.ofLevel(root, 3), agent]);
			wireframe.showStructure(fit).showStructure(fit, agent).showLevel(root, 3, agent).showContact(contact).showRay(contact.point, new engine.Vector3D(0, 2, 0), 6);
			lines.push([[1, 2, 3, 1, 2, 3.5], null], [[1, 2, 3, 1, 8, 3], null]);
			const check = () => {
				const { position } = wireframe.geometry.attributes;
				let at = 0;
				for (const [numbers, whose] of lines) {
					if (whose === null && numbers.length === 6 && numbers[5] === 3.5) at += 6;
					for (let i = 0; i < numbers.length; i += 3) {
						const point = new THREE.Vector3().fromArray(numbers, i);
						if (whose) point.applyMatrix4(new THREE.Matrix4().fromArray(matrixOf(whose)));
						const expected = up === "y" ? new THREE.Vector3(point.x, point.z, -point.y) : point;
						assert.ok(new THREE.Vector3().fromBufferAttribute(position, at++).distanceTo(expected) < 1e-5);
					}
				}
				assert.equal(wireframe.geometry.drawRange.count, at);
			};
			check();
			agent.moveTo(4, 5, 6);
			agent.setQuaternion(...scenes.quaternion().toArray());
			agent.size = 2;
			wireframe.update();
			check();
			const { version: before } = wireframe.geometry.attributes.position;
			agent.size = 3;
			wireframe.update();
			assert.equal(wireframe.geometry.attributes.position.version, before + 2);
			agent.size = 2;
			wireframe.update();
			const { version: after } = wireframe.geometry.attributes.position;
			wireframe.update();
			assert.equal(wireframe.geometry.attributes.position.version, after);
			const hit = Object.assign(new engine.RayHit(), { distance: 2 });
			hit.normal.setTo(0, -1, 0);
			wireframe.clearLines().showRay(contact.point, new engine.Vector3D(0, 2, 0), 6, hit);
			assert.equal(wireframe.geometry.drawRange.count, 2 + 6 + 2);
			assert.throws(() => wireframe.showRay(contact.point, new engine.Vector3D()), /^ArgumentError: the direction must be finite and not 0/);
			assert.throws(() => wireframe.showLines([1, 2, 3]), /^ArgumentError: a line is six numbers: 3 /);
			for (const lines of [null, undefined, 5, "lines1", [1, 2, 3, 4, 5, NaN], [1, 2, 3, 4, 5, "6"]]) assert.throws(() => wireframe.showLines(lines), /^ArgumentError: /);
			for (const value of [null, undefined, {}, 5, { point: contact.point }]) assert.throws(() => wireframe.showContact(value), /^ArgumentError: ThreeWireframe\.showContact: /);
			for (const point of [null, undefined, {}, [1, 2, 3]]) {
				assert.throws(() => wireframe.showRay(point, contact.normal), /^ArgumentError: ThreeWireframe\.showRay: /);
				assert.throws(() => wireframe.showRay(contact.point, point), /^ArgumentError: ThreeWireframe\.showRay: /);
			}
			assert.throws(() => wireframe.showRay(contact.point, contact.normal, Infinity), /^ArgumentError: a line is six finite numbers/);
			assert.throws(() => wireframe.showRay(contact.point, contact.normal, 1, {}), /^ArgumentError: ThreeWireframe\.showRay: /);
			assert.throws(() => wireframe.showStructure(fit, {}), /^ArgumentError: ThreeWireframe: agent must be an Agent, not a plain object$/);
			assert.throws(() => wireframe.showLevel(root, 0), /^RangeError/);
			assert.equal(wireframe.geometry.drawRange.count, 2 + 6 + 2);
			wireframe.dispose();
		}
	});

	test(`three ${version}: ${pickCount} picks by triangles are the Raycaster's`, () => {
		const scenes = new Scenes(THREE, 3 + number, { isForRays: true });
		const { dice } = scenes;
		const land = new THREE.Scene();
		const greatLand = new engine.GreatLand();
		const agents = [];
		const agentOf = new Map();
		for (let i = 0; i < 40; i++) {
			const object = scenes.place(scenes.tree());
			if (drawnCorners(THREE, object).flips.length === 0) continue;
			object.position.multiplyScalar(3);
			land.add(object);
			const model = modelFromObject(`model ${i}`, object);
			greatLand.addModel(model);
			const agent = new Agent(model.name);
			new ThreeAgentBinding(agent, object, model).updateAgent();
			agents.push(agent);
			object.traverse((part) => agentOf.set(part, agent));
		}
		land.updateMatrixWorld(true);
		const exact = new engine.HierarchicalCollider(greatLand);
		exact.exact = true;
		const queries = new engine.AgentQueries(exact);
		queries.update(agents);
		const raycaster = new THREE.Raycaster();
		let hits = 0;
		for (let i = 0; i < pickCount; i++) {
			const origin = new THREE.Vector3(...dice.direction()).multiplyScalar(80);
			const target = new THREE.Vector3(dice.number(-22, 22), dice.number(-22, 22), dice.number(-22, 22));
			raycaster.set(origin, target.sub(origin).normalize());
			const [first] = raycaster.intersectObject(land);
			const { direction } = raycaster.ray;
			const hit = queries.cast(new engine.Vector3D(origin.x, -origin.z, origin.y), new engine.Vector3D(direction.x, -direction.z, direction.y));
			assert.equal(hit?.agent.shape, first && agentOf.get(first.object).shape, `ray ${i}`);
			if (!hit) continue;
			hits++;
			assert.ok(Math.abs(hit.distance - first.distance) < 1e-9, `ray ${i}: ${hit.distance} and ${first.distance}`);
			assert.ok(first.point.distanceTo(new THREE.Vector3(hit.point.x, hit.point.z, -hit.point.y)) < 1e-9);
			const { object, faceIndex, instanceId } = faceOf(greatLand.modelOf(hit.agent.shape), hit.triangle);
			assert.equal(object, first.object, `ray ${i}`);
			assert.deepEqual([faceIndex, instanceId], [first.faceIndex, first.instanceId ?? null], `ray ${i}`);
		}
		assert.ok(hits > 0.2 * pickCount && hits < 0.9 * pickCount, `${hits} hits`);
	});

	test(`three ${version}: an animation of a glTF file poses the model as its mixer poses the object`, async () => {
		const { GLTFLoader } = await import(pathToFileURL(path.join(folder, "node_modules/three/examples/jsm/loaders/GLTFLoader.js")));
		const { dice } = new Scenes(THREE, 1125 + number);
		for (const interpolation of ["LINEAR", "STEP", "CUBICSPLINE"]) {
			for (let file = 0; file < 5; file++) {
				const bytes = animatedFile(dice, interpolation);
				const { scene, animations: [clip] } = await new GLTFLoader().parseAsync(bytes.slice().buffer, "");
				const mixer = new THREE.AnimationMixer(scene);
				const action = mixer.clipAction(clip);
				action.setLoop(THREE.LoopOnce);
				action.clampWhenFinished = true;
				action.play();
				const model = engine.GltfModel.fromBytes("walker", bytes, null, Model.AS_GIVEN);
				const animations = new engine.GltfAnimations("walker", bytes);
				assert.deepEqual([animations.count, animations.indexOf("walk"), animations.indexOf("run"), animations.durationOf(0)], [1, 0, -1, 2]);
				for (const time of [0, 0.2, 0.5, 1, 1.9, dice.number(0, 2)]) {
					mixer.setTime(time);
					model.pose(animations.verticesAt(0, time));
					const most = differenceOf(cornersOf(model, new Agent("walker"), "y"), drawnCorners(THREE, scene));
					assert.ok(most < 1e-5, `${interpolation}, ${time}: ${most}`);
				}
				assert.deepEqual([...animations.verticesAt(0, -1)], [...animations.verticesAt(0, 0)]);
				assert.deepEqual([...animations.verticesAt(0, 9)], [...animations.verticesAt(0, 2)]);
			}
		}
	});

	test(`three ${version}: what its loader makes of a glTF file is where a GltfModel of the file is, and the model of the object is the same`, async () => {
		const { GLTFLoader } = await import(pathToFileURL(path.join(folder, "node_modules/three/examples/jsm/loaders/GLTFLoader.js")));
		for (const name of ["bear", "seagull"]) {
			const bytes = readFileSync(path.join(root, `examples/three/${name}.glb`));
			const { scene } = await new GLTFLoader().parseAsync(Uint8Array.from(bytes).buffer, "");
			const read = engine.GltfModel.fromBytes(name, bytes);
			const model = modelFromObject(name, scene);
			for (let axis = 0; axis < 3; axis++) {
				const extents = [read, model].map(({ vertices }) => vertices.filter((_, i) => i % 3 === axis)).map((all) => [Math.min(...all), Math.max(...all)]);
				extents[0].forEach((extent, i) => assert.ok(Math.abs(extent - extents[1][i]) < 1e-12));
			}
			const agent = new Agent(name);
			agent.moveTo(1, 2, 3);
			agent.setQuaternion(...scenes.quaternion().toArray());
			new ThreeAgentBinding(agent, scene, read).updateObject();
			assert.ok(differenceOf(cornersOf(model, agent, "y"), drawnCorners(THREE, scene)) < 1e-12);
		}
	});
}
