/**
 * A level as one mesh, in this engine and in others, each as its documentation says that it is fastest: z is up, and a level is what `prepare`
 * gives of a model's numbers, ready for its first ray. Each has `ray`, and where it can `sphere`, `capsule` and `walker`;
 * the first can say where there is room for the capsule. Each keeps the shapes that it casts, so the times do not include making them.
 * Box3D is among them if the variable BOX3D names the folder of its WebAssembly.
 */
import { readFileSync } from "node:fs";
import { engine } from "./games.mjs";
import { RAPIER, b3, box3dWorldOf, crashcat } from "./peers.mjs";
import { makeBvh } from "./rays.mjs";

const { Agent, AgentQueries, Capsule, CombinationCollider, Footing, GltfModel, GreatLand, Model, RayHit, ShapeHit, Sphere, Vector3D, WalkOptions } = engine;

/** The capsule that walks: it is a person's size. */
const RADIUS = 0.3;
const HEIGHT = 1.8;
const STEP = 0.3;
const SLOPE = 50;
const FALL = 0.2;

/** Half the length between the centres of the ends of a capsule that is cast. */
const CORE = HEIGHT / 2 - RADIUS;
const radians = (degrees) => (degrees * Math.PI) / 180;

/** The example's level: { vertices, triangles }, a unit a patch. */
export function readLevel() {
	const { vertices, triangles } = GltfModel.fromBytes("level", readFileSync(new URL("../../examples/level/level.glb", import.meta.url)), null, Model.AS_GIVEN);
	return { vertices, triangles };
}

/** The surface of the capsule that walks, its lowest point at the origin. */
function capsuleModel() {
	const [sides, rings] = [16, 8];
	const vertices = [];
	const triangles = [];
	for (let ring = 0; ring <= 2 * rings + 1; ring++) {
		const angle = (Math.PI / 2) * ((ring <= rings ? ring : ring - 1) / rings - 1);
		const [radius, height] = [RADIUS * Math.cos(angle), RADIUS * Math.sin(angle) + (ring <= rings ? RADIUS : HEIGHT - RADIUS)];
		for (let side = 0; side < sides; side++) {
			const around = (2 * Math.PI * side) / sides;
			vertices.push(radius * Math.cos(around), radius * Math.sin(around), height);
			const [here, next] = [ring * sides + side, ring * sides + ((side + 1) % sides)];
			if (ring > 0) triangles.push(here - sides, next - sides, next, here - sides, next, here);
		}
	}
	return new Model("walker", vertices, triangles, Model.AS_GIVEN);
}

/** This engine: the level is one hierarchical agent, and triangles decide. */
function inEngine({ vertices, triangles }) {
	const land = new GreatLand();
	land.loadTightestFit = false;
	land.addModel(new Model("level", vertices, triangles, Model.AS_GIVEN));
	const collider = Object.assign(new CombinationCollider(land), { exact: true });
	const queries = new AgentQueries(collider);
	const agents = [Object.assign(new Agent("level", "levels"), { hierarchical: true })];
	queries.update(agents);
	const [origin, direction, hit, shapeHit] = [new Vector3D(), new Vector3D(), new RayHit(), new ShapeHit()];
	const place = ([x, y, z]) => {
		origin.setTo(x, y, z);
		return origin;
	};
	const [ball, pill] = [new Sphere(new Vector3D(), 0), new Capsule(new Vector3D(), new Vector3D(), RADIUS)];
	const ballAt = ([x, y, z], radius) => {
		ball.center.setTo(x, y, z);
		ball.radius = radius;
		return ball;
	};
	const standing = ([x, y, z]) => {
		pill.start.setTo(x, y, z - CORE);
		pill.end.setTo(x, y, z + CORE);
		return pill;
	};
	return {
		ray: (from, to, reach) => {
			place(from);
			direction.setTo(...to);
			return queries.cast(origin, direction, reach, null, hit)?.distance ?? Infinity;
		},
		sphere: (from, radius, way) => queries.castShape(ballAt(from, radius), way[0], way[1], way[2], null, shapeHit)?.time ?? 1,
		capsule: (from, way) => queries.castShape(standing(from), way[0], way[1], way[2], null, shapeHit)?.time ?? 1,
		isFree: (from) => queries.overlapping(standing(from)).length === 0,
		walker: (from) => {
			if (!land.hasModel("walker")) {
				land.loadTightestFit = true;
				land.addModel(capsuleModel());
			}
			const walker = new Agent("walker", "walkers");
			walker.moveTo(...from);
			agents.push(walker);
			queries.update(agents);
			const options = Object.assign(new WalkOptions(), { stepHeight: STEP, snap: STEP, slopeDegrees: SLOPE, fall: FALL });
			const footing = new Footing();
			return {
				walk: (dx, dy) => queries.walk(walker, dx, dy, options, footing),
				get place() { return [walker.x, walker.y, walker.z]; },
			};
		},
	};
}

/** three-mesh-bvh with its default settings: it knows rays. */
function inBvh(mesh) {
	const { three, bvh } = makeBvh(mesh);
	const ray = new three.Ray();
	return {
		ray: (from, to, reach) => {
			ray.origin.set(...from);
			ray.direction.set(...to);
			return bvh.raycastFirst(ray, three.DoubleSide, 0, reach)?.distance ?? Infinity;
		},
	};
}

function inRapier({ vertices, triangles }) {
	const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
	world.createCollider(RAPIER.ColliderDesc.trimesh(new Float32Array(vertices), new Uint32Array(triangles)));
	world.step();
	const ray = new RAPIER.Ray({ x: 0, y: 0, z: 0 }, { x: 0, y: 0, z: 1 });
	const vector = ([x, y, z]) => ({ x, y, z });
	const upright = { x: 0, y: 0, z: 0, w: 1 };
	const balls = new Map();
	const ballOf = (radius) => balls.get(radius) ?? balls.set(radius, new RAPIER.Ball(radius)).get(radius);
	// Rapier's capsules stand along y
	const stood = { x: Math.SQRT1_2, y: 0, z: 0, w: Math.SQRT1_2 };
	const pill = new RAPIER.Capsule(CORE, RADIUS);
	return {
		ray: (from, to, reach) => {
			ray.origin = vector(from);
			ray.dir = vector(to);
			return world.castRay(ray, reach, true)?.timeOfImpact ?? Infinity;
		},
		sphere: (from, radius, way) => world.castShape(vector(from), upright, vector(way), ballOf(radius), 0, 1, true)?.time_of_impact ?? 1,
		capsule: (from, way) => world.castShape(vector(from), stood, vector(way), pill, 0, 1, true)?.time_of_impact ?? 1,
		walker: (from) => {
			const controller = world.createCharacterController(0.01);
			controller.setUp({ x: 0, y: 0, z: 1 });
			controller.enableAutostep(STEP, 0.1, false);
			controller.enableSnapToGround(STEP);
			controller.setMaxSlopeClimbAngle(radians(SLOPE));
			controller.setSlideEnabled(true);
			const body = world.createRigidBody(RAPIER.RigidBodyDesc.kinematicPositionBased());
			const capsule = RAPIER.ColliderDesc.capsule(CORE, RADIUS).setRotation(stood);
			const collider = world.createCollider(capsule, body);
			const at = vector([from[0], from[1], from[2] + HEIGHT / 2]);
			const settle = () => {
				body.setTranslation(at, true);
				collider.setTranslation(at);
			};
			settle();
			return {
				walk: (dx, dy) => {
					controller.computeColliderMovement(collider, { x: dx, y: dy, z: controller.computedGrounded() ? -0.01 : -FALL }, RAPIER.QueryFilterFlags.EXCLUDE_KINEMATIC);
					const { x, y, z } = controller.computedMovement();
					at.x += x;
					at.y += y;
					at.z += z;
					settle();
				},
				get place() { return [at.x, at.y, at.z - HEIGHT / 2]; },
			};
		},
	};
}

function inCrashcat({ vertices, triangles }) {
	const settings = crashcat.createWorldSettings();
	const layer = crashcat.addObjectLayer(settings, crashcat.addBroadphaseLayer(settings));
	crashcat.enableCollision(settings, layer, layer);
	const world = crashcat.createWorld(settings);
	const shape = crashcat.triangleMesh.create({ positions: [...vertices], indices: [...triangles] });
	crashcat.rigidBody.create(world, { shape, motionType: crashcat.MotionType.STATIC, objectLayer: layer, position: [0, 0, 0] });
	const filter = crashcat.filter.forWorld(world);
	const rays = crashcat.createClosestCastRayCollector();
	const shapes = crashcat.createClosestCastShapeCollector();
	const raySettings = { ...crashcat.createDefaultCastRaySettings(), collideWithBackfaces: true };
	const shapeSettings = { ...crashcat.createDefaultCastShapeSettings(), collideWithBackfaces: true };
	const [upright, one] = [[0, 0, 0, 1], [1, 1, 1]];
	const balls = new Map();
	const ballOf = (radius) => balls.get(radius) ?? balls.set(radius, crashcat.sphere.create({ radius })).get(radius);
	// its capsules stand along y
	const stood = [Math.SQRT1_2, 0, 0, Math.SQRT1_2];
	const pill = crashcat.capsule.create({ radius: RADIUS, halfHeightOfCylinder: CORE });
	const cast = (shape, from, turn, way) => {
		shapes.reset();
		crashcat.castShape(world, shapes, shapeSettings, shape, from, turn, one, way, filter);
		return shapes.hit.status === crashcat.CastShapeStatus.COLLIDING ? shapes.hit.fraction : 1;
	};
	return {
		ray: (from, to, reach) => {
			rays.reset();
			crashcat.castRay(world, rays, raySettings, from, to, reach, filter);
			return rays.hit.status === crashcat.CastRayStatus.COLLIDING ? rays.hit.fraction * reach : Infinity;
		},
		sphere: (from, radius, way) => cast(ballOf(radius), from, upright, way),
		capsule: (from, way) => cast(pill, from, stood, way),
		walker: (from) => {
			const { kcc } = crashcat;
			const character = kcc.create({ shape: pill, up: [0, 0, 1], maxSlopeAngle: radians(SLOPE) }, [from[0], from[1], from[2] + HEIGHT / 2], stood);
			const options = { ...kcc.createDefaultUpdateSettings(), stickToFloorStepDown: [0, 0, -STEP], walkStairsStepUp: [0, 0, STEP] };
			const [seconds, gravity] = [1 / 60, [0, 0, -9.81]];
			return {
				walk: (dx, dy) => {
					const falls = character.ground.state === kcc.GroundState.ON_GROUND ? 0 : -FALL / seconds;
					character.linearVelocity[0] = dx / seconds;
					character.linearVelocity[1] = dy / seconds;
					character.linearVelocity[2] = falls;
					kcc.update(world, character, seconds, gravity, options, undefined, filter);
				},
				get place() { return [character.position[0], character.position[1], character.position[2] - HEIGHT / 2]; },
			};
		},
	};
}

const POINT = [0, 0, 0];
const SEGMENT = [0, 0, -CORE, 0, 0, CORE];

/** Box3D's casts end at a slop before the touch, as crashcat's casts of capsules do: a few of them differ in the third digit. */
function inBox3d(level) {
	const world = box3dWorldOf(level);
	const filter = b3.b3DefaultQueryFilter();
	const vector = ([x, y, z]) => ({ x, y, z });
	let nearest = 1;
	const keep = (shape, point, normal, fraction) => {
		nearest = fraction < nearest ? fraction : nearest;
		return fraction;
	};
	const cast = (points, radius, from, way) => {
		nearest = 1;
		b3.b3World_CastShape(world, vector(from), points, radius, vector(way), filter, keep);
		return nearest;
	};
	return {
		ray: (from, to, reach) => {
			const hit = b3.b3World_CastRayClosest(world, vector(from), vector(to.map((value) => reach * value)), filter);
			return hit.hit ? hit.fraction * reach : Infinity;
		},
		sphere: (from, radius, way) => cast(POINT, radius, from, way),
		capsule: (from, way) => cast(SEGMENT, RADIUS, from, way),
	};
}

/** How each prepares a level, by its name. */
export const ENGINES = { engine: inEngine, "three-mesh-bvh": inBvh, Rapier: inRapier, crashcat: inCrashcat, ...(b3 ? { Box3D: inBox3d } : {}) };
