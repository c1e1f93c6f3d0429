/**
 * The other engines that the benchmark measures, each asked in the fastest way that its documentation has: a world of agents that are unit
 * spheres, or in Rapier and crashcat unit cubes that stand on the ground, with what brings it up to date (`prepare`), what finds the pairs (`run`) and how many it found (`count`).
 * Box3D is among them if the variable BOX3D names the folder of its WebAssembly.
 */
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const tools = createRequire(new URL("../../js/module/package.json", import.meta.url));
const load = (name) => import(pathToFileURL(tools.resolve(name)));

const rapier = await load("@dimforge/rapier3d-compat");
const RAPIER = rapier.default ?? rapier;
const cannon = await load("cannon-es");
const { default: KDBush } = await load("kdbush");
// its package.json names no entry for require
const crashcat = await import(new URL("../../js/module/node_modules/crashcat/dist/index.js", import.meta.url));

const { BOX3D } = process.env;
const b3 = BOX3D ? await (await import(pathToFileURL(join(BOX3D, "box3d.mjs")))).default() : null;

await RAPIER.init();
crashcat.registerAll();

export { KDBush, RAPIER, b3, crashcat };

/** kdbush, built anew in every frame: it is flat, and its points do not move. */
export function askKdbush(agents) {
	let near = 0;
	const run = () => {
		const tree = new KDBush(agents.length, 64, Float64Array);
		for (const agent of agents) tree.add(agent.x, agent.y);
		tree.finish();
		near = 0;
		for (const agent of agents) near += tree.within(agent.x, agent.y, 1).length - 1;
	};
	return { run, count: () => near / 2 };
}

const isCube = ({ shape }) => shape === "cube";

/** An agent's turn about the axis that points up, as a quaternion. */
const turnOf = ({ heading }) => [0, 0, Math.sin(heading * Math.PI / 360), Math.cos(heading * Math.PI / 360)];

/** Rapier: sensors on kinematic bodies, so nothing is pushed. Its step finds what touched before it, so one more finds the last frame's pairs. */
export function askRapier(agents) {
	const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
	const handles = agents.map((agent) => {
		const [x, y, z, w] = turnOf(agent);
		const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased().setTranslation(agent.x, agent.y, 0.5).setRotation({ x, y, z, w }));
		const types = RAPIER.ActiveCollisionTypes.ALL;
		const shape = isCube(agent) ? RAPIER.ColliderDesc.cuboid(0.5, 0.5, 0.5) : RAPIER.ColliderDesc.ball(0.5);
		return { body, collider: world.createCollider(shape.setSensor(true).setActiveCollisionTypes(types), body) };
	});
	let touching = 0;
	const prepare = () => agents.forEach((agent, i) => handles[i].body.setNextKinematicTranslation({ x: agent.x, y: agent.y, z: 0.5 }));
	const run = () => {
		world.step();
		touching = 0;
		for (const { collider } of handles) world.intersectionPairsWith(collider, () => touching++);
	};
	const count = () => {
		run();
		return touching / 2;
	};
	return { prepare, run, count, free: () => world.free() };
}

/** cannon-es: its broad phase and its contacts, without its solver. It counts pairs in 31 bits, and so has no room for 100,000 bodies. */
export function askCannon(agents) {
	const space = new cannon.World();
	space.broadphase = new cannon.SAPBroadphase(space);
	const bodies = agents.map((agent) => {
		const body = new cannon.Body({ mass: 1, shape: new cannon.Sphere(0.5), collisionResponse: false });
		body.position.set(agent.x, agent.y, 0.5);
		space.addBody(body);
		return body;
	});
	const prepare = () => {
		agents.forEach((agent, i) => {
			bodies[i].position.set(agent.x, agent.y, 0.5);
			bodies[i].aabbNeedsUpdate = true;
		});
		// as its step does: otherwise it looks for pairs in the order of places that are no more
		space.broadphase.dirty = true;
	};
	let contacts = [];
	const run = () => {
		const first = [];
		const second = [];
		contacts = [];
		space.broadphase.collisionPairs(space, first, second);
		space.narrowphase.getContacts(first, second, space, contacts, [], [], []);
	};
	return { prepare, run, count: () => contacts.length };
}

/** crashcat: sensors on kinematic bodies. A step of no time finds the contacts and solves nothing. */
export function askCrashcat(agents) {
	const settings = crashcat.createWorldSettings();
	const layer = crashcat.addObjectLayer(settings, crashcat.addBroadphaseLayer(settings));
	crashcat.enableCollision(settings, layer, layer);
	const world = crashcat.createWorld(settings);
	const [sphere, cube] = [crashcat.sphere.create({ radius: 0.5 }), crashcat.box.create({ halfExtents: [0.5, 0.5, 0.5], convexRadius: 0 })];
	const bodies = agents.map((agent) => crashcat.rigidBody.create(world, {
		shape: isCube(agent) ? cube : sphere, motionType: crashcat.MotionType.KINEMATIC, objectLayer: layer, position: [agent.x, agent.y, 0.5],
		quaternion: turnOf(agent), sensor: true,
	}));
	let touching = 0;
	const listener = { onContactAdded: () => touching++, onContactPersisted: () => touching++ };
	const place = [0, 0, 0.5];
	const prepare = () => agents.forEach((agent, i) => {
		[place[0], place[1]] = [agent.x, agent.y];
		crashcat.rigidBody.setPosition(world, bodies[i], place, false);
	});
	const run = () => {
		touching = 0;
		crashcat.updateWorld(world, listener, 0);
	};
	return { prepare, run, count: () => touching };
}

/** Box3D counts shapes as touching up to this distance (its B3_OVERLAP_SLOP): they are made smaller by half of it, so that the pairs are the same. */
const BOX3D_SLOP = 0.0005;

/**
 * Box3D: sensors on kinematic bodies, whose step reports the touches that begin and end. These are added up, which is less than to ask each
 * sensor for all that touch it. Bodies are put to their places before: if they got there by velocities, its step would take longer.
 */
export function askBox3d(agents) {
	const still = { x: 0, y: 0, z: 0 };
	const world = b3.b3CreateWorld({ ...b3.b3DefaultWorldDef(), gravity: still, enableSleep: false, enableContinuous: false });
	const rotations = agents.map((agent) => {
		const [x, y, z, s] = turnOf(agent);
		return { v: { x, y, z }, s };
	});
	const half = 0.5 - BOX3D_SLOP / 2;
	const settings = { ...b3.b3DefaultShapeDef(), isSensor: true, enableSensorEvents: true };
	const kinematic = { ...b3.b3DefaultBodyDef(), type: b3.b3BodyType.b3_kinematicBody };
	const bodies = agents.map((agent, i) => {
		const body = b3.b3CreateBody(world, { ...kinematic, position: { x: agent.x, y: agent.y, z: 0.5 }, rotation: rotations[i] });
		if (isCube(agent)) b3.b3CreateBoxShape(body, settings, half, half, half);
		else b3.b3CreateSphereShape(body, settings, { center: still, radius: half });
		return body;
	});
	const place = { x: 0, y: 0, z: 0.5 };
	const prepare = () => agents.forEach((agent, i) => {
		[place.x, place.y] = [agent.x, agent.y];
		b3.b3Body_SetTransform(bodies[i], place, rotations[i]);
	});
	const events = b3.createEventsBuffer();
	let touching = 0;
	const run = () => {
		b3.b3World_Step(world, 1 / 60, 1);
		b3.getEvents(events, world);
		// each of two sensors reports the other
		touching += b3.getNumSensorBeginEvents(events) - b3.getNumSensorEndEvents(events);
	};
	const free = () => {
		b3.destroyEventsBuffer(events);
		b3.b3DestroyWorld(world);
	};
	return { prepare, run, count: () => touching / 2, free };
}

/** Two copies of a mesh in Rapier: whether they intersect with the second at a place and turned by a quaternion. */
export function makeRapierMeshes(model) {
	const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
	const [first, second] = [0, 1].map(() => {
		const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased());
		const mesh = RAPIER.ColliderDesc.trimesh(new Float32Array(model.vertices), new Uint32Array(model.triangles));
		return { body, collider: world.createCollider(mesh.setSensor(true).setActiveCollisionTypes(RAPIER.ActiveCollisionTypes.ALL), body) };
	});
	return ({ x, y, z }, [i, j, k, w]) => {
		second.body.setTranslation({ x, y, z });
		second.body.setRotation({ x: i, y: j, z: k, w });
		world.step();
		return world.intersectionPair(first.collider, second.collider);
	};
}

/** A mesh in crashcat: the distance to the first hit of a ray, or Infinity. */
export function makeCrashcatMesh(model) {
	const shape = crashcat.triangleMesh.create({ positions: [...model.vertices], indices: [...model.triangles] });
	const collector = crashcat.createClosestCastRayCollector();
	const settings = { ...crashcat.createDefaultCastRaySettings(), collideWithBackfaces: true };
	const { EMPTY_SUB_SHAPE_ID: NONE } = crashcat;
	return (origin, direction, length) => {
		collector.reset();
		crashcat.castRayVsShape(collector, settings, origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, length,
			shape, NONE, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1);
		return collector.hit.status === crashcat.CastRayStatus.COLLIDING ? collector.hit.fraction * length : Infinity;
	};
}

/** A world of Box3D with a mesh alone. */
export function box3dWorldOf({ vertices, triangles }) {
	const world = b3.b3CreateWorld(b3.b3DefaultWorldDef());
	const mesh = b3.b3CreateMesh(new Float32Array(vertices), new Uint32Array(triangles));
	b3.b3CreateMeshShape(b3.b3CreateBody(world, b3.b3DefaultBodyDef()), b3.b3DefaultShapeDef(), mesh, { x: 1, y: 1, z: 1 });
	return world;
}

/** A mesh alone in a world of Box3D: the distance to the first hit of a ray, or Infinity. Its triangles are hit from the front alone. */
export function makeBox3dMesh(model) {
	const world = box3dWorldOf(model);
	const filter = b3.b3DefaultQueryFilter();
	const way = { x: 0, y: 0, z: 0 };
	return (origin, direction, length) => {
		[way.x, way.y, way.z] = [direction.x * length, direction.y * length, direction.z * length];
		const hit = b3.b3World_CastRayClosest(world, origin, way, filter);
		return hit.hit ? hit.fraction * length : Infinity;
	};
}
