/**
 * Prints how many bytes 10,000 questions of each kind leave to the garbage collector, as JSON. Each is asked by agents that have moved since the update,
 * and by some that are not in the list.
 *
 *   node --expose-gc --min-semi-space-size=64 --max-semi-space-size=64 test/module/questions.mjs SYSTEM MOST
 *
 * SYSTEM is one of those of games.mjs, or triangles. MOST is JSON: the bytes that a question of each kind may leave, and of all others.
 */
import { garbageOf } from "./bytes.mjs";
import { HALF_WIDTH, MODELS, SYSTEMS, engine, makeGreatLand, scatter } from "../benchmark/games.mjs";

const { Agent, AgentFilter, AgentQueries, Contact, Footing, RayHit, ShapeHit, Sphere, Terrain, Vector3D, WalkOptions } = engine;

const COUNT = 500;
const ASKED = 10000;
const GUESTS = 50;
const WARM = 20;
const PASSES = 12;

const { agents } = scatter(COUNT, MODELS, { halfWidth: HALF_WIDTH / 3 });
agents.forEach((agent, i) => {
	agent.hierarchical = i % 10 === 0;
	agent.breed = i % 2 === 0 ? "turtles" : "sheep";
});
const system = process.argv[2];
const mostOf = JSON.parse(process.argv[3]);
const isExact = system === "triangles";
const collider = new SYSTEMS[isExact ? "hierarchical" : system](makeGreatLand());
if (isExact) collider.exact = true;
const queries = new AgentQueries(collider);
queries.update(agents);
const askers = agents.slice(GUESTS);
for (let i = 0; i < GUESTS; i++) {
	const guest = new Agent(MODELS[i % MODELS.length]);
	guest.moveTo(agents[i].x, agents[i].y, 0);
	askers.push(guest);
}

// hills, for walks alone
const onHills = new AgentQueries(collider);
const terrain = new Terrain(41, 41, 1, -20, -20);
for (let i = 0; i < GUESTS; i++) terrain.raiseMound(agents[i].x, agents[i].y, 6, 0.3);
onHills.terrain = terrain;
onHills.update(agents.slice(0, GUESTS));

const filter = AgentFilter.ofBreeds("turtles", "wolves");
const out = [];
const hits = [];
const hit = new RayHit();
const contact = new Contact();
const shapeHit = new ShapeHit();
const shapeHits = [];
const options = new WalkOptions();
const footing = new Footing();
const structure = new Sphere(new Vector3D(), 2);
const [point, ahead, onA, onB] = Array.from({ length: 4 }, () => new Vector3D(1, 0, 0));

// Numbers where none is an object
const steps = Float64Array.from(askers, (_, i) => 0.1 * Math.sin(i));
const answer = new Float64Array(1);
let found = 0;

/** Puts a vector where an agent is: not with setTo, to which Numbers would be passed. */
function put(vector, agent, height) {
	vector.x = agent.x;
	vector.y = agent.y;
	vector.z = agent.z + height;
}

/** The kinds of question, each with lists or objects to write to, of an agent and another. */
const questions = {
	near: (agent) => { found += queries.near(agent, 3, null, out).length; },
	"near, filter": (agent) => { found += queries.near(agent, 3, filter, out).length; },
	countNear: (agent) => { found += queries.countNear(agent, 3); },
	"countNear, filter": (agent) => { found += queries.countNear(agent, 3, filter); },
	nearest: (agent) => { found += queries.nearest(agent) === null ? 0 : 1; },
	"nearest, filter": (agent) => { found += queries.nearest(agent, 3, filter) === null ? 0 : 1; },
	nearestOf: (agent) => { found += queries.nearestOf(agent, 5, Infinity, null, out).length; },
	inCone: (agent) => { found += queries.inCone(agent, 3, 90, null, out).length; },
	nearPoint: (agent) => {
		put(point, agent, 0.5);
		found += queries.nearPoint(point, 3, null, out).length;
	},
	countNearPoint: (agent) => {
		put(point, agent, 0.5);
		found += queries.countNearPoint(point, 3);
	},
	nearestToPoint: (agent) => {
		put(point, agent, 0.5);
		found += queries.nearestToPoint(point) === null ? 0 : 1;
	},
	touching: (agent) => { found += queries.touching(agent, null, out).length; },
	touchesAny: (agent) => { found += queries.touchesAny(agent) ? 1 : 0; },
	overlapping: (agent) => {
		put(structure.center, agent, 0);
		found += queries.overlapping(structure, null, out).length;
	},
	moved: (agent, other) => {
		found++;
		queries.moved(other);
	},
	cast: (agent) => {
		put(point, agent, 0.5);
		found += queries.cast(point, ahead, 20, null, hit) === null ? 0 : 1;
	},
	castAll: (agent) => {
		put(point, agent, 0.5);
		found += queries.castAll(point, ahead, 20, null, hits).length;
	},
	distance: (agent, other) => {
		answer[0] = queries.distance(agent, other);
		found += answer[0] > 0 ? 1 : 0;
	},
	"distance, points": (agent, other) => {
		answer[0] = queries.distance(agent, other, onA, onB);
		found += answer[0] > 0 ? 1 : 0;
	},
	moveUntilTouch: (agent, other, i) => {
		answer[0] = queries.moveUntilTouch(agent, steps[i], 0.1, 0, null, contact);
		found += answer[0] > 0 ? 1 : 0;
	},
	slide: (agent, other, i) => {
		answer[0] = queries.slide(agent, steps[i], 0.1, 0);
		found += answer[0] > 0 ? 1 : 0;
	},
	// after the motions, for the crowd hides all
	canSee: (agent, other) => { found += queries.canSee(agent, other) ? 1 : 0; },
	walk: (agent, other, i) => { found += onHills.walk(agent, steps[i], 0.1, options, footing).stands ? 1 : 0; },
	castAgent: (agent) => { found += queries.castAgent(agent, 9, 0, 0, null, shapeHit) === null ? 0 : 1; },
	castAgentAll: (agent) => { found += queries.castAgentAll(agent, 9, 0, 0, null, shapeHits).length; },
	castShape: (agent) => {
		put(structure.center, agent, 0);
		found += queries.castShape(structure, 9, 0, 0, null, shapeHit) === null ? 0 : 1;
	},
	castShapeAll: (agent) => {
		put(structure.center, agent, 0);
		found += queries.castShapeAll(structure, 9, 0, 0, null, shapeHits).length;
	},
	overlapsAgent: (agent, other) => { found += queries.overlapsAgent(agent, other.x, other.y, 0) ? 1 : 0; },
	distanceToPoint: (agent) => {
		answer[0] = queries.distanceToPoint(agent, point, onA);
		found += answer[0] > 0 ? 1 : 0;
	},
};

const turnOf = (ask) => () => {
	for (let i = 0; i < COUNT; i++) ask(askers[i], agents[(i + 1) % GUESTS], i);
};

const bytes = {};
const answers = {};
const isFew = (name) => bytes[name] < (mostOf[name] ?? mostOf.others) * ASKED;
// All kinds in turns, as in a game, until each leaves little: what one kind has made the compiler expect, another may void.
for (let pass = 0; pass < PASSES && !Object.keys(questions).every(isFew); pass++) {
	for (const [name, ask] of Object.entries(questions)) {
		// to where they were not at the update
		for (const agent of agents) agent.moveTo(agent.x + 0.01, agent.y, agent.z);
		found = 0;
		const left = garbageOf(turnOf(ask), { warm: WARM, calls: ASKED / COUNT, rounds: 1 }) * ASKED / COUNT;
		bytes[name] = Math.min(left, bytes[name] ?? Infinity);
		answers[name] = found;
	}
}
console.log(JSON.stringify({ bytes, answers }));
