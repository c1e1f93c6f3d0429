/** Random calls of a game. */
import { BREEDS } from "./kinds/handlers.mjs";
import { MORE, SHAPES, THIN, TRAITS } from "./game.mjs";
import { engine, numbersOf, toolsOf } from "./tools.mjs";

const { Agent } = engine;

/** How many calls a game has. */
export const CALLS = 120;

/** The calls of the game with this seed: of all kinds, or of these alone. */
export function gameOf(seed, kinds = null) {
	const random = numbersOf(seed);
	return Array.from({ length: CALLS }, () => randomCall(random, kinds));
}

function randomCall(random, kinds) {
	const tools = toolsOf(random);
	const { between, integer, pick } = tools;
	const place = () => (random() < 0.3 ? pick([-1, 0, 0.5, 1]) : between(-2.5, 2.5));
	const value = {
		shape: () => pick(random() < 0.2 ? Object.keys(THIN) : SHAPES), breed: () => pick(BREEDS), size: () => pick([1, 1, 0.5, between(0.1, 2.5)]),
		heading: () => pick([0, 45, 90, between(0, 360)]), pitch: () => pick([0, 30, 90]), roll: () => pick([0, 180, 77]),
		sweeps: () => random() < 0.3, hierarchical: () => random() < 0.5, traversalDepth: () => integer(7),
		collideAs: () => pick([Agent.TIGHTEST, Agent.TIGHTEST, Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.HULL]),
	};
	const calls = {
		add: () => [place(), place(), place() / 2, value.size()],
		tiles: () => [integer(3) - 2, integer(3) - 2, integer(3) - 1, pick([1, 1, 0.1, 3]), integer(512)],
		walk: () => [integer(99), integer(5) - 2, integer(5) - 2, integer(3) - 1, integer(5) / 4 - 0.5, integer(5) / 4 - 0.5, pick([0, 0, -0.25, -0.1, 0.25]), random() < 0.6],
		leave: () => [integer(99)],
		move: () => [integer(99), place(), place(), place() / 2, random() < 0.1],
		trait: () => {
			const name = pick(TRAITS);
			return [integer(99), name, value[name]()];
		},
		model: () => [pick(SHAPES.slice(3)), 1 + integer(1e6), random() < 0.5, true, pick([engine.BoundingStructure.BOX, engine.BoundingStructure.SPHERE, engine.BoundingStructure.CAPSULE])],
		forget: () => [pick(SHAPES.slice(3))],
		system: () => [integer(4), random() < 0.4, 1 + integer(8)],
		frame: () => [],
		check: () => [],
		ask: () => [integer(99), integer(99), between(0, 4), between(0, 360)],
		go: () => [integer(99), place(), place(), place() / 2, random() < 0.4],
		wrong: () => [integer(99)],
	};
	const often = ["add", "add", "add", "move", "move", "move", "trait", "trait", "trait", "frame", "frame", "check", "ask", "ask", "go", "walk", "walk", "file"];
	const more = ["ground", "stand", "stand", "stand", "stroll", "rest", "inside", "watch", "watch", "watchFrame", "watchOnce", "watchOnce", "watchGround", "edges", "beside"];
	const part = random();
	const name = kinds ? pick(kinds) : part < 0.4 ? pick(often) : part < 0.75 ? pick(more) : pick([...Object.keys(calls), ...Object.keys(MORE)]);
	return [name, ...(name in MORE ? MORE[name].random(tools) : calls[name]())];
}
