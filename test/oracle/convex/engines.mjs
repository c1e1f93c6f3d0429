/**
 * What is checked: the same four questions to different parts of the compiled engine. Bodies are those of bodies.mjs.
 *
 * - kinds: the bodies that it takes
 * - mayGraze: motions run along what they touch, and leave it
 * - asMade(body): what the engine makes of it exactly, because rounding moves a hull's corners. Optional
 * - shapeOf(body): the engine's shape
 * - areTouching(a, b), closest(a, b), timeOf(a, b, start, way), contact(a, b): the answers for two shapes, a the one that moves
 */
import { KINDS, body } from "./bodies.mjs";

/** The structures' own tests, distances, sweeps and contacts. */
export class Kernels {
	name = "kernels";
	kinds = ["sphere", "capsule", "box"];

	/** @param engine the compiled classes, those inside too */
	constructor(engine) {
		this.engine = engine;
		this.motion = new engine.RelativeMotion();
		this.result = new engine.ClosestPoints();
		this.touch = new engine.ContactPoint();
	}

	shapeOf(each) {
		return structureOf(this.engine, each);
	}

	areTouching(a, b) {
		return this.engine.intersects$(a, b);
	}

	closest(a, b) {
		this.engine.StructurePairs.findClosest(a, b, this.result);
		return pointsOf(this.result);
	}

	timeOf(a, b, start, way) {
		setMotion(this.motion, start, way);
		this.engine.StructurePairs.findTimeOfImpact(a, b, this.motion);
		return this.motion.time;
	}

	contact(a, b) {
		this.engine.StructurePairs.findContact(a, b, new this.engine.RelativeMotion(0), this.touch);
		return contactOf(this.touch);
	}
}

/** The package convex: all kinds. */
export class Core {
	name = "core";
	kinds = KINDS;

	constructor(engine) {
		this.engine = engine;
		this.hulls = new WeakMap();
		this.pair = new engine.ConvexKernel();
		this.motion = new engine.RelativeMotion();
		this.result = new engine.ClosestPoints();
		this.touch = new engine.ContactPoint();
	}

	asMade(each) {
		if (each.kind !== "hull") return each;
		const hull = structureOf(this.engine, each);
		const made = body("hull", [hull.center.x, hull.center.y, hull.center.z, ...hull.$relativeCorners]);
		if (made.points.length !== each.points.length) throw new Error(`a hull lost corners: ${each.numbers}`);
		this.hulls.set(made, hull);
		return made;
	}

	shapeOf(each) {
		const { ConvexShape } = this.engine;
		const shape = new ConvexShape();
		if (each.kind === "triangle") shape.setTriangle([...each.numbers], 0);
		else if (each.kind === "hull") this.hulls.get(each).$setShape(shape);
		else structureOf(this.engine, each).$setShape(shape);
		return shape;
	}

	areTouching(a, b) {
		return this.pair.areTouching(a, b);
	}

	closest(a, b) {
		this.pair.findClosest(a, b, this.result);
		return pointsOf(this.result);
	}

	timeOf(a, b, start, way) {
		setMotion(this.motion, start, way);
		this.pair.findTimeOfImpact(a, b, this.motion);
		return this.motion.time;
	}

	contact(a, b) {
		this.pair.findContact(a, b, new this.engine.RelativeMotion(0), this.touch);
		return contactOf(this.touch);
	}
}

function setMotion(motion, start, way) {
	[motion.startX, motion.startY, motion.startZ] = start;
	[motion.x, motion.y, motion.z] = way;
	motion.time = 0;
	motion.latestTime = 1;
}

/** What a game asks: agents whose structures are given, and models of one triangle that the triangles decide about. */
export class Game {
	name = "game";
	mayGraze = true;
	kinds = ["sphere", "capsule", "box", "triangle"];

	constructor(engine) {
		const { AgentQueries, CombinationCollider, Fitter, GreatLand, ShapeHit } = engine;
		const game = this;
		this.engine = engine;
		this.land = new GreatLand();
		this.land.boundingStructures.fitters = [new class extends Fitter {
			findStructure() {
				return game.structure;
			}
		}()];
		this.collider = Object.assign(new CombinationCollider(this.land), { exact: true });
		this.queries = new AgentQueries(this.collider);
		this.hit = new ShapeHit();
		this.count = 0;
	}

	shapeOf(each) {
		const { Agent, Model } = this.engine;
		// two models at a time
		const name = `shape ${this.count++ % 2}`;
		const isTriangle = each.kind === "triangle";
		this.land.loadHierarchies = isTriangle;
		this.land.loadTightestFit = !isTriangle;
		if (!isTriangle) this.structure = structureOf(this.engine, each);
		const points = isTriangle ? each.numbers : each.numbers.slice(0, 3);
		this.land.removeModel(name);
		this.land.addModel(new Model(name, [...points], isTriangle ? [0, 1, 2] : null, Model.AS_GIVEN));
		return Object.assign(new Agent(name, "shapes"), { hierarchical: isTriangle });
	}

	areTouching(a, b) {
		return this.collider.areColliding(a, b);
	}

	closest(a, b) {
		const [pointA, pointB] = [new this.engine.Vector3D(), new this.engine.Vector3D()];
		const distance = this.queries.distance(a, b, pointA, pointB);
		return { distance, a: [pointA.x, pointA.y, pointA.z], b: [pointB.x, pointB.y, pointB.z] };
	}

	timeOf(a, b, start, way) {
		a.jumpTo(...start);
		this.queries.update([a, b]);
		const hit = this.queries.castAgent(a, ...way, null, this.hit);
		a.jumpTo(0, 0, 0);
		return hit === null ? Infinity : hit.time;
	}

	contact(a, b) {
		const { point, normal, depth } = this.collider.contactOf(a, b);
		return { point: [point.x, point.y, point.z], normal: [normal.x, normal.y, normal.z], depth };
	}
}

const pointsOf = ({ distance, a, b }) => ({ distance, a: [a.x, a.y, a.z], b: [b.x, b.y, b.z] });
const contactOf = ({ x, y, z, normalX, normalY, normalZ, depth }) => ({ point: [x, y, z], normal: [normalX, normalY, normalZ], depth });

function structureOf({ Box, Capsule, Hull, Sphere, Vector3D }, { kind, numbers }) {
	const vector = (i) => new Vector3D(...numbers.slice(i, i + 3));
	switch (kind) {
	case "sphere":
		return new Sphere(vector(0), numbers[3]);
	case "capsule":
		return new Capsule(vector(0), vector(3), numbers[6]);
	case "hull": {
		const hull = new Hull(numbers.slice(3));
		hull.translate(vector(0));
		return hull;
	}
	default:
		return new Box(vector(0), vector(3), vector(6), vector(9), numbers[12], numbers[13], numbers[14]);
	}
}

export const ENGINES = { core: Core, game: Game, kernels: Kernels };
