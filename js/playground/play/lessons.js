/**
 * The lessons. Each has a program, and a check of the game that the reader makes from it. The check runs after every frame, and has a
 * memory for each game. The words are in languages/.
 */
import { CollisionBlocks } from "starlogo-collision";
import { said } from "./actions.js";
import { change, collision, colour, create, each, go, heading, move, nearMiss, numbers, paint, program, remove, scatter, size, start, touch, turn } from "./notation.js";

const touching = (world) => world.collisions.collision.statistics.collisions;
const all = (world, name) => world.agents.filter(({ breed }) => breed === name);
const total = (world, a, b) => world.totals.get([a, b].sort().join("\n")) ?? 0;
/** Whether all agents are still at the lesson's places, with the same sizes. */
const isUntouched = (world, ...places) => places.every(([breed, x, y, z, large]) => all(world, breed).some((agent) => agent.x === x && agent.y === y && agent.z === z && agent.size === large));
const use = (SYSTEM) => ({ type: "starlogo_system", fields: { SYSTEM } });
const wall = (x, y, large, turned = 0) => create(1, "walls", "wall", size(large), heading(turned), go(x, y, 0));
const ball = (...blocks) => create(1, "paintballs", "sphere", size(0.5), paint("me", colour("yellow")), ...blocks);

const ROOM = 4;
const LONG = 600;

/** Blocks that the reader must change come first, so that they are in sight. */
export const LESSONS = {
	blocks: {
		program: program(each("turtles", turn("left", numbers(-4, 4))), start(create(5, "turtles", "turtle", scatter, size(2)))),
		isDone: (world, memory) => {
			memory.places ??= all(world, "turtles").map(({ x, y }) => [x, y]);
			return memory.places.length > 0 && all(world, "turtles").filter(({ x, y }, i) => memory.places[i] && Math.hypot(x - memory.places[i][0], y - memory.places[i][1]) > 2).length === memory.places.length;
		},
	},
	helmet: {
		program: { ...nearMiss("firemen", "fireman", 3, 0, 0, 6.6, 0.6), system: CollisionBlocks.UNIT_SPHERES },
		isDone: (world) => isUntouched(world, ["firemen", 0, 0, 0, 3], ["paintballs", 0, 0, 6.6, 0.6]) && touching(world) === 1,
	},
	wing: {
		program: nearMiss("dragons", "dragon", 8, 0.8, -2.6, 0.4, 0.8),
		isDone: (world) => world.frame > 1 && isUntouched(world, ["dragons", 0, 0, 0, 8], ["paintballs", 0.8, -2.6, 0.4, 0.8]) && touching(world) === 0,
	},
	main: {
		// must fail if all agents have trees, because the lesson is about precision where it matters
		program: program(
			start(use(CollisionBlocks.COMBINATION), create(1, "dragons", "dragon", size(8)), create(1, "paintballs", "sphere", size(0.8), go(0.8, -2.6, 0.4), paint("me", colour("yellow")))),
			touch("paintballs", "dragons", paint("collidee", colour("red")))),
		isDone: (world) => world.frame > 1 && world.collisions.systemName === CollisionBlocks.COMBINATION && isUntouched(world, ["dragons", 0, 0, 0, 8], ["paintballs", 0.8, -2.6, 0.4, 0.8])
			&& all(world, "dragons")[0].hierarchical && touching(world) === 0,
	},
	fast: {
		program: program(
			// Before and behind the wall it is outside the wall's unit sphere. After crossing the ground it returns to the same places.
			start(wall(0, 0, 4), ball(go(-10, 0, 0.5))),
			each("paintballs", move(4)),
			touch("paintballs", "walls", paint("collidee", colour("yellow")), remove("me"))),
		isDone: (world) => world.events.some(({ a, b }) => [a, b].some((one) => one.breed === "paintballs" && one.sweeps) && [a, b].some((one) => one.breed === "walls")),
	},
	starts: {
		program: program(
			collision("turtles", "walls", change(1)),
			each("turtles", move(0.1)),
			start(wall(-6, 0, 5), wall(0, 0, 5), wall(6, 0, 5), create(1, "turtles", "turtle", size(1.5), go(-10, 0, 0)))),
		isDone: (world, memory) => {
			memory.met = Math.max(memory.met ?? 0, total(world, "turtles", "walls"));
			return memory.met >= 3 && world.score === memory.met && touching(world) === 0;
		},
	},
	room: {
		program: program(
			each("bears", move(0.1)),
			start(wall(ROOM, 0, 2 * ROOM + 0.5), wall(-ROOM, 0, 2 * ROOM + 0.5), wall(0, ROOM, 2 * ROOM + 0.5, 90), wall(0, -ROOM, 2 * ROOM + 0.5, 90), create(1, "bears", "bear", size(1.2), heading(25)))),
		isDone: (world, memory) => {
			const [bear] = all(world, "bears");
			const isInside = bear && Math.abs(bear.x) < ROOM && Math.abs(bear.y) < ROOM;
			memory.way = isInside ? (memory.way ?? 0) + Math.hypot(bear.x - bear.before[0], bear.y - bear.before[1]) : 0;
			return world.frame >= LONG && memory.way > 12 && all(world, "walls").length === 4;
		},
	},
	near: {
		program: program(
			each("turtles", move(0.05), turn("left", numbers(-4, 4))),
			start(create(1, "bears", "bear", size(1.4)), create(12, "turtles", "turtle", scatter, size(1.3)))),
		isDone: (world, memory) => {
			const [bear] = all(world, "bears");
			const near = bear ? all(world, "turtles").filter(({ x, y, z }) => Math.hypot(x - bear.x, y - bear.y, z - bear.z) <= 5).length : 0;
			memory.counts ??= new Set();
			if (near > 0 && bear.said.text === said(near)) memory.counts.add(near);
			return memory.counts.size >= 2;
		},
	},
	see: {
		program: program(
			each("turtles", move(0.05)),
			start(create(1, "bears", "bear", size(1.4)), wall(4, 0, 5), create(1, "turtles", "turtle", size(1.6), go(8, -6, 0), heading(90)))),
		isDone: (world, memory) => {
			const [[bear], [turtle]] = [all(world, "bears"), all(world, "turtles")];
			memory.said ??= new Set();
			const isSeen = bear && turtle && world.frame > 1 ? world.senses.canSee(bear, turtle) : null;
			if (isSeen !== null && bear.said.text === said(isSeen)) memory.said.add(isSeen);
			return memory.said.has(true) && memory.said.has(false);
		},
	},
	hunt: {
		program: program(
			each("bears", move(0.1)),
			touch("bears", "turtles", remove("collidee"), change(1)),
			each("turtles", move(0.03), turn("left", numbers(-4, 4))),
			start(create(1, "bears", "bear", size(1.4)), create(8, "turtles", "turtle", scatter, size(1.3)))),
		isDone: (world, memory) => {
			memory.most = Math.max(memory.most ?? 0, all(world, "turtles").length);
			return memory.most >= 8 && all(world, "turtles").length === 0 && total(world, "bears", "turtles") >= 8 && world.seconds <= 30;
		},
	},
};
