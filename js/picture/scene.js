/** The game of the moving picture, and how each collision system sees it. */
import {
	Agent, BinCollider, BuiltInModel, ColladaModel, Collision, GreatLand, HierarchicalCollider, ObjModel, Sphere, TightestFitCollider, Vector3D, Wireframes,
} from "starlogo-collision";
import * as three from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

const [WIDTH, HEIGHT] = [624, 330];
const FRAMES = 15;
const DEPTH = 5;
const FINER = 2;
const QUALITY = 0.42;
const [FREE, TOUCHING] = [0x1c6fd0, 0xe02b2b];

const FILES = { bear: "bear.obj", tree: "tree.obj", fortress: "fortress.obj", spaceship: "spaceship.obj", dragon: "dragon.dae", seagull: "seagull.dae",
	person: "person.dae", fireman: "fireman.dae" };
const COLORS = { bear: 0x9c6b3f, tree: 0x5f9e58, fortress: 0xb9ad97, spaceship: 0x9aa7b8, dragon: 0x7f8fa8, seagull: 0xf4f4f4, person: 0xd6a06b,
	fireman: 0xc9584a, sphere: 0xf2b632 };

const ALL = 2 * Math.PI;

/** The agents: shape, size, and where each is at a moment from 0 to 1; at 1 it is where it was at 0. */
const CAST = [
	["fortress", 8, () => [-5.6, 4.5, 0, 20]],
	["tree", 2.4, () => [4.6, 4.8, 0, 0]],
	["tree", 1.8, () => [6.8, 1.2, 0, 90]],
	["dragon", 7.5, (t) => [3.4 * Math.cos(ALL * t), 2.2 * Math.sin(ALL * t) + 0.5, 1.9 + 0.5 * Math.sin(2 * ALL * t), 90 + 360 * t]],
	["bear", 1.5, (t) => [1.6 * Math.cos(-ALL * t) + 0.6, 1.6 * Math.sin(-ALL * t) - 1.4, 0, -90 - 360 * t]],
	["person", 0.8, (t) => [-3.2 + 1.6 * Math.sin(ALL * t), -1.2 + 0.5 * Math.cos(ALL * t), 0, -360 * t]],
	["person", 0.8, (t) => [-3 + 0.9 * Math.sin(ALL * t + 2), -1.4 + 0.9 * Math.cos(ALL * t + 2), 0, -360 * t - 115]],
	["fireman", 0.85, (t) => [4 + 1.1 * Math.cos(ALL * t + 1), -2 + 1.4 * Math.sin(ALL * t + 1), 0, 147 + 360 * t]],
	["seagull", 2.2, (t) => [-1 + 4.4 * Math.cos(ALL * t + 2.4), 1.5 + 2.6 * Math.sin(ALL * t + 2.4), 3.4, 228 + 360 * t]],
	["seagull", 2.2, (t) => [1 + 4.2 * Math.cos(-ALL * t + 0.7), 1 + 2.8 * Math.sin(-ALL * t + 0.7), 3.1, -50 - 360 * t]],
	["spaceship", 2.6, (t) => [-5.4 + 1.2 * Math.sin(ALL * t), -0.2 + 3 * Math.cos(ALL * t), 2.2 + 0.3 * Math.sin(ALL * t), -360 * t - 10]],
	...[0, 1, 2].map((i) => ["sphere", 0.55, (t) => {
		const flight = (2 * t + i / 3) % 1;
		return [-4.5 + 10.5 * flight, -3.2 + 1.4 * i + 1.2 * flight, 0.4 + 5.2 * flight * (1 - flight), 0];
	}]),
];

async function load(name, file) {
	const text = await (await fetch(`/assets/${file}`)).text();
	return file.endsWith(".obj") ? new ObjModel(name, text) : new ColladaModel(name, text);
}

function meshOf(model) {
	const geometry = new three.BufferGeometry();
	geometry.setAttribute("position", new three.Float32BufferAttribute(model.vertices, 3));
	geometry.setIndex(new three.Uint32BufferAttribute(model.triangles, 1));
	return geometry.toNonIndexed();
}

function linesOf(numbers, width) {
	const geometry = new LineSegmentsGeometry().setPositions(numbers);
	const material = new LineMaterial({ color: FREE, linewidth: width * FINER });
	material.resolution.set(WIDTH * FINER, HEIGHT * FINER);
	return new LineSegments2(geometry, material);
}

/** What each system tests of a model, as lines in the model's space; of the BinCollider, around its place. */
function systemsOf(greatLand, models) {
	const exactly = new HierarchicalCollider(greatLand);
	exactly.exact = true;
	const unit = Wireframes.ofStructure(new Sphere(new Vector3D(0, 0, 0.5), 0.5));
	const trees = new HierarchicalCollider(greatLand);
	trees.maxDepth = DEPTH;
	return [
		["BinCollider", "a sphere around each agent", new BinCollider(), () => unit, 1.2],
		["TightestFitCollider", "the tightest sphere, box or capsule", new TightestFitCollider(greatLand),
			(name) => Wireframes.ofStructure(greatLand.boundingStructures.tightestFit(name)), 1.6],
		["HierarchicalCollider", `a tree of boxes, ${DEPTH} levels deep`, trees, (name) => Wireframes.ofLevel(greatLand.hierarchies.root(name), DEPTH), 1],
		["HierarchicalCollider, exact", "the triangles themselves", exactly, (name) => Wireframes.ofTriangles(models[name].vertices, models[name].triangles), 0.45],
	];
}

function makeWorld() {
	const world = new three.Scene();
	world.background = new three.Color(0xeef3f8);
	const ground = new three.Mesh(new three.PlaneGeometry(60, 60), new three.MeshLambertMaterial({ color: 0xcfe3c4 }));
	const sun = new three.DirectionalLight(0xffffff, 1.8);
	sun.position.set(-6, -9, 12);
	world.add(ground, sun, new three.AmbientLight(0xffffff, 1.5));
	return world;
}

function write(context, name, what, touching) {
	context.fillStyle = "rgba(255, 255, 255, 0.86)";
	context.fillRect(0, 0, WIDTH, 48);
	context.fillStyle = "#16212e";
	context.font = "600 19px sans-serif";
	context.fillText(name, 14, 22);
	context.font = "15px sans-serif";
	context.fillText(what, 14, 42);
	context.textAlign = "right";
	context.font = "600 19px sans-serif";
	context.fillStyle = "#e02b2b";
	context.fillText(`${touching} collisions`, WIDTH - 14, 32);
	context.textAlign = "left";
}

/** Each frame in turn, as a data URL. */
export async function* frames() {
	const models = { sphere: BuiltInModel.sphere() };
	for (const [name, file] of Object.entries(FILES)) models[name] = await load(name, file);
	const greatLand = new GreatLand();
	for (const model of Object.values(models)) greatLand.addModel(model);

	const renderer = new three.WebGLRenderer({ antialias: true });
	renderer.setSize(WIDTH * FINER, HEIGHT * FINER, false);
	const camera = new three.PerspectiveCamera(28, WIDTH / HEIGHT, 0.1, 100);
	camera.up.set(0, 0, 1);
	camera.position.set(0.2, -17.5, 7);
	camera.lookAt(0.2, 0.2, 1.75);
	const world = makeWorld();
	const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
	const context = canvas.getContext("2d", { alpha: false });
	context.imageSmoothingQuality = "high";

	const geometries = Object.fromEntries(Object.entries(models).map(([name, model]) => [name, meshOf(model)]));
	const parts = CAST.map(([shape, size, placeAt]) => {
		const agent = Object.assign(new Agent(shape), { size });
		const material = new three.MeshLambertMaterial({ color: COLORS[shape], flatShading: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
		const mesh = new three.Mesh(geometries[shape], material);
		mesh.matrixAutoUpdate = false;
		world.add(mesh);
		return { agent, mesh, placeAt };
	});
	const agents = parts.map(({ agent }) => agent);
	const systems = systemsOf(greatLand, models);
	const collision = new Collision(systems[0][2]);
	const met = new Set();
	collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, (collider) => met.add(collider));

	for (const [index, [name, what, system, draw, width]] of systems.entries()) {
		collision.collisionSystem = system;
		const shown = parts.map(({ agent, mesh, placeAt }) => {
			const lines = linesOf(draw(agent.shape), width);
			lines.matrixAutoUpdate = false;
			world.add(lines);
			return { agent, mesh, placeAt, lines };
		});
		for (let frame = 0; frame < FRAMES; frame++) {
			const moment = (index * FRAMES + frame) / (systems.length * FRAMES);
			for (const { agent, mesh, placeAt, lines } of shown) {
				const [x, y, z, heading] = placeAt(moment);
				agent.moveTo(x, y, z);
				agent.heading = heading;
				mesh.matrix.fromArray(agent.transform.rawData);
				lines.matrix.copy(mesh.matrix);
			}
			met.clear();
			collision.update(agents);
			for (const { agent, lines } of shown) lines.material.color.set(met.has(agent) ? TOUCHING : FREE);
			renderer.render(world, camera);
			context.drawImage(renderer.domElement, 0, 0, WIDTH, HEIGHT);
			write(context, name, what, collision.statistics.collisions);
			yield canvas.toDataURL("image/webp", QUALITY);
		}
		for (const { lines } of shown) world.remove(lines);
	}
}
