/**
 * The lessons. Each has a program, and two checks of the game that the reader makes from it. Both run after every frame, with a memory for
 * each game: isDone says whether the task is done, and wrong names what is wrong with a solution, or gives null. The words are in languages/.
 */
import { CollisionBlocks } from "starlogo-collision";
import { textOf } from "../game/actions.js";
import {
	change, collision, colour, compare, create, each, folded, get, go, ground, heading, many, move, numbers, paint, program, remove, repeat, scatter, set, size, start, step, touch, trait, turn, up, walk, wall, when,
} from "./notation.js";

const touching = (world) => world.collisions.collision.statistics.collisions;
const all = (world, name) => world.agents.filter(({ breed }) => breed === name);
const total = (world, a, b) => world.totals.get([a, b].sort().join("\n")) ?? 0;
/** The way of an agent in this frame. */
const stepOf = ({ x, y, before }) => Math.hypot(x - before[0], y - before[1]);
const use = (SYSTEM) => ({ type: "starlogo_system", fields: { SYSTEM } });
const ball = (large, ...blocks) => create(1, "paintballs", "sphere", size(large), paint("me", colour("yellow")), ...blocks);
const touchEnd = (BREED, OTHER, block) => ({ type: "starlogo_touch_end", fields: { BREED, OTHER }, inputs: { DO: { block } } });

const ROOM = 4;
/** The height of the coin above a platform. */
const PLACE_OF_COIN = 3.2;
const LONG = 600;
/** The frame in which a game shows whether its program works. */
const SOON = 90;
/** The heights of the fireman's helmet and of the ball above it. */
const [HELMET, HIGH] = [6, 8.6];
/** The dragon's size, and a ball's: it fits under a wing. */
const [DRAGON, BALL] = [8, 0.8];

/** Whether there is one agent of a breed, with this size. */
const isAlone = (world, breed, large) => all(world, breed).length === 1 && all(world, breed)[0].size === large;

/** Whether the ball of the lesson about the wing has rolled under it, without a touch. */
function isPastWing(world, memory) {
	const [{ x, y, z }] = all(world, "paintballs");
	const [dragon] = all(world, "dragons");
	const isOnItsWay = y === -2.6 && z === 0.4 && dragon.x === 0 && dragon.y === 0 && dragon.z === 0;
	memory.way = isOnItsWay && touching(world) === 0 && x > -3 && x < 3 ? (memory.way ?? 0) + 1 : 0;
	return x > 2.5 && x < 3 && memory.way > 80;
}

/** Blocks that the reader must change come first, so that they are in sight. */
export const LESSONS = {
	blocks: {
		program: program(each("turtles", turn("left", numbers(-4, 4))), start(create(5, "turtles", "turtle", scatter, size(2)))),
		isDone: (world, memory) => {
			memory.places ??= all(world, "turtles").map(({ x, y }) => [x, y]);
			memory.most ??= 0;
			const ways = all(world, "turtles").map(({ x, y }, i) => (memory.places[i] ? Math.hypot(x - memory.places[i][0], y - memory.places[i][1]) : 0));
			memory.most = Math.max(memory.most, ...ways);
			return memory.places.length > 0 && ways.filter((way) => way > 2).length === memory.places.length;
		},
		wrong: (world, { most }) => {
			if (world.frame < SOON) return null;
			if (all(world, "turtles").length === 0) return "none";
			if (all(world, "turtles").some((each) => stepOf(each) > 0)) return null;
			return most > 0 ? "once" : "still";
		},
	},
	helmet: {
		isOfSystem: true,
		program: { ...program(
			each("paintballs", up(-0.04), when(compare("LT", trait("z"), { shadow: { type: "math_number", fields: { NUM: 0 } } }), go(0, 0, HIGH))),
			touch("paintballs", "firemen", go(0, 0, HIGH), change(1)),
			start(create(1, "firemen", "fireman", size(3)), ball(0.6, go(0, 0, HIGH)))), system: CollisionBlocks.UNIT_SPHERES },
		isDone: (world) => isAlone(world, "firemen", 3) && isAlone(world, "paintballs", 0.6) && world.meetings.some(({ point, names }) => point.z > HELMET && names.includes("firemen")),
		wrong: (world) => {
			if (!isAlone(world, "firemen", 3) || !isAlone(world, "paintballs", 0.6)) return "changed";
			return world.meetings.some(({ point }) => point.z < HELMET) || all(world, "paintballs")[0].z < 3 ? "through" : null;
		},
	},
	wing: {
		isOfSystem: true,
		program: program(
			each("paintballs", move(0.06)),
			touch("paintballs", "dragons", paint("collidee", colour("red"))),
			touchEnd("paintballs", "dragons", paint("collidee", colour("own"))),
			start(create(1, "dragons", "dragon", size(DRAGON)), ball(BALL, go(-6, -2.6, 0.4)))),
		isDone: (world, memory) => isAlone(world, "dragons", DRAGON) && isAlone(world, "paintballs", BALL) && isPastWing(world, memory),
		wrong: (world) => {
			if (!isAlone(world, "dragons", DRAGON) || !isAlone(world, "paintballs", BALL)) return "changed";
			return touching(world) > 0 ? "air" : null;
		},
	},
	main: {
		// must fail if all agents have trees, because the lesson is about precision where it matters
		program: program(
			start(use(CollisionBlocks.COMBINATION), create(1, "dragons", "dragon", size(DRAGON), go(-8, 0, 0)), ball(BALL, go(0, -2.6, 0.4)), ball(BALL, go(5.8, 2.6, 0.4))),
			each("dragons", move(0.06)),
			touch("dragons", "paintballs", paint("collidee", colour("red")))),
		isDone: (world, memory) => {
			const [dragon] = all(world, "dragons");
			memory.touched ||= world.meetingCount > 0;
			memory.isHonest ??= isAlone(world, "dragons", DRAGON) && dragon.x < -7 && all(world, "paintballs").filter((each) => each.size === BALL && each.z === 0.4 && Math.abs(each.y) === 2.6).length === 2;
			return memory.isHonest && !memory.touched && dragon?.hierarchical && dragon.x > 8.4 && !isBallPrecise(world) && world.collisions.systemName === CollisionBlocks.COMBINATION;
		},
		wrong: (world, { isHonest }) => {
			if (world.collisions.systemName !== CollisionBlocks.COMBINATION) return "system";
			if (isBallPrecise(world)) return "balls";
			if (!isHonest) return "changed";
			return world.meetingCount > 0 ? "box" : null;
		},
	},
	fast: {
		program: program(
			// Before and behind the wall it is outside the wall's unit sphere. After crossing the ground it returns to the same places.
			start(wall(0, 0, 4), ball(0.5, go(-10, 0, 0.5))),
			each("paintballs", move(4)),
			touch("paintballs", "walls", paint("collidee", colour("yellow")), remove("me"))),
		isDone: (world) => world.meetings.some(({ a, b }) => [a, b].some((one) => one.breed === "paintballs" && one.sweeps) && [a, b].some((one) => one.breed === "walls")),
		wrong: (world, memory) => {
			const [thrown] = all(world, "paintballs");
			if (thrown && stepOf(thrown) > 0 && stepOf(thrown) < 3) return "slow";
			if (all(world, "walls").some(({ sweeps }) => sweeps) && !thrown?.sweeps) return "walls";
			memory.isThrough ||= Boolean(thrown) && world.frame > 8;
			return memory.isThrough ? "through" : null;
		},
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
		wrong: (world, { met }) => {
			if (met === 0 || touching(world) > 0) return null;
			if ((world.score ?? 0) > met) return "frames";
			return (world.score ?? 0) < met ? "few" : null;
		},
	},
	room: {
		// the walls are low, so that the bear is seen behind them
		program: many(["place"],
			each("bears", move(0.1)),
			folded(start(
				create(1, "bears", "bear", size(1.2), heading(25)),
				set("place", 1 - ROOM),
				repeat(ROOM, wall(get("place"), ROOM, 2.1, 90), wall(get("place"), -ROOM, 2.1, 90), wall(ROOM, get("place"), 2.1), wall(-ROOM, get("place"), 2.1), step("place", 2))))),
		isDone: (world, memory) => {
			const [bear] = all(world, "bears");
			const isInside = bear && Math.abs(bear.x) < ROOM && Math.abs(bear.y) < ROOM;
			memory.wasOut ||= !isInside;
			memory.way = isInside ? (memory.way ?? 0) + stepOf(bear) : 0;
			return world.frame >= LONG && memory.way > 12 && all(world, "walls").length === 4 * ROOM;
		},
		wrong: (world, { way, wasOut }) => {
			if (all(world, "walls").length !== 4 * ROOM || all(world, "bears").length === 0) return "gone";
			if (wasOut) return "out";
			return world.frame >= LONG && way <= 12 ? "still" : null;
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
			if (near > 0 && bear.said.text === textOf(near)) memory.counts.add(near);
			return memory.counts.size >= 2;
		},
		wrong: (world, memory) => wrongWords(world, memory, memory.counts.size === 0),
	},
	see: {
		program: program(
			each("turtles", move(0.05)),
			start(create(1, "bears", "bear", size(1.4)), wall(4, 0, 5), create(1, "turtles", "turtle", size(1.6), go(8, -6, 0), heading(90)))),
		isDone: (world, memory) => {
			const [[bear], [turtle]] = [all(world, "bears"), all(world, "turtles")];
			memory.said ??= new Set();
			const isSeen = bear && turtle && world.frame > 1 ? world.senses.canSee(bear, turtle) : null;
			if (isSeen !== null && bear.said.text === textOf(isSeen)) memory.said.add(isSeen);
			return memory.said.has(true) && memory.said.has(false);
		},
		wrong: (world, memory) => wrongWords(world, memory, world.frame > LONG),
	},
	hunt: {
		program: program(
			each("bears", move(0.1)),
			touch("bears", "turtles", remove("collidee"), change(1)),
			each("turtles", move(0.03), turn("left", numbers(-4, 4))),
			// another ground than that of "near", so that their pictures differ
			start(ground("sea"), create(1, "bears", "bear", size(1.4)), create(8, "turtles", "turtle", scatter, size(1.3)))),
		isDone: (world, memory) => {
			memory.most = Math.max(memory.most ?? 0, all(world, "turtles").length);
			return memory.most >= 8 && all(world, "turtles").length === 0 && total(world, "bears", "turtles") >= 8 && world.seconds <= 30;
		},
		wrong: (world) => {
			if (all(world, "bears").length === 0) return "none";
			if (world.seconds > 30) return "late";
			// it goes straight on
			return world.frame > 3 * SOON && all(world, "bears").every(({ heading: at, before }) => at === before[3]) && all(world, "turtles").length > 5 ? "straight" : null;
		},
	},
	jump: {
		program: program(
			each("bears", walk(0.05)),
			start(
				create(1, "platforms", "platform", size(4), go(-5, 0, 1)), create(1, "platforms", "platform", size(4), go(0.6, 0, 1)),
				create(1, "coins", "coin", size(1), go(1.5, 0, PLACE_OF_COIN)), create(1, "bears", "bear", size(1.2), go(-6, 0, 3))),
			touch("bears", "coins", remove("collidee"), change(1))),
		isDone: (world, memory) => {
			memory.isHonest ??= hasCoin(world);
			const [bear] = all(world, "bears");
			if (!memory.isHonest || !bear) return false;
			memory.stood ??= new Set();
			const below = world.walking.standsOn(bear);
			if (below?.breed === "platforms") memory.stood.add(below);
			memory.hasJumped ||= bear.rise > 0;
			return memory.hasJumped && memory.stood.size === 2 && all(world, "coins").length === 0 && total(world, "bears", "coins") > 0;
		},
		wrong: (world, { isHonest }) => {
			const [bear] = all(world, "bears");
			if (!isHonest || !bear) return "changed";
			if (world.frame > 2 * SOON && bear.z === 3) return "air";
			if (bear.z > 1.9) return null;
			return world.solid.includes("platforms") ? "gap" : "through";
		},
	},
};

/** Whether the coin of the lesson about jumping, and its bear, are as they were at the beginning. */
const hasCoin = (world) => all(world, "bears").length === 1 && all(world, "coins").some(({ x, z }) => x === 1.5 && z === PLACE_OF_COIN) && all(world, "platforms").length === 2;

const isBallPrecise = (world) => all(world, "paintballs").some(({ hierarchical }) => hierarchical);

/** What is wrong with the words of the bear: there are none, somebody else speaks, or they are wrong. */
function wrongWords(world, memory, areWrong) {
	if (world.frame < SOON) return null;
	const [bear] = all(world, "bears");
	if (!bear) return "none";
	if (bear.said.text !== "") return areWrong ? "other" : null;
	return world.agents.some(({ said: { text } }) => text !== "") ? "others" : "silent";
}
