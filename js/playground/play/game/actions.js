/** The actions and values of single blocks: functions that act on a world. Nothing here needs Blockly or a page. */
import { Collision } from "starlogo-collision";
import { plain, texts } from "../../shared/language.js";
import { Being } from "./being.js";
import { COLOURS } from "./colours.js";

/** An error that a student made, and its block. */
export class ProgramError extends Error {
	constructor(message, block) {
		super(message);
		this.block = block;
	}
}

/** A block's words, without its inputs. */
const wordsOf = (type) => texts.blocks[type].replaceAll(/ ?%\d/g, " …").replace(/^ … |[ :]*…$/g, "").trim();

/** The breed that a collision block names. */
export const breedOf = (field) => (field === "anyone" ? Collision.ANY_BREED : field);

/** The content of an input: the block put there, or else the shadow. */
const inputOf = (block, name) => block.inputs?.[name]?.block ?? block.inputs?.[name]?.shadow;

export function value(block, name, world, missing = 0) {
	const input = inputOf(block, name);
	if (!input) return () => missing;
	const make = VALUES[input.type];
	if (!make) throw new ProgramError(`${input.type}?`, input.id);
	return make(input, world);
}

export function number(block, name, world) {
	const get = value(block, name, world);
	return () => {
		const result = Number(get());
		if (!Number.isFinite(result)) throw new ProgramError(texts.play.notANumber(wordsOf(block.type)), block.id);
		return result;
	};
}

export function me(block, world) {
	return world.me ?? fail(texts.play.nobody(wordsOf(block.type)), block);
}

export function fail(message, block) {
	throw new ProgramError(message, block.id);
}

/** The other agent of a collision block. */
const touched = (block, world) => world.collidee ?? fail(texts.play.noCollidee(wordsOf(block.type)), block);

/** The subject of a block: me, the collidee, or a breed's name. */
function whom(block, world) {
	const who = block.fields.WHO;
	if (who === "me") return me(block, world);
	return who === "collidee" ? touched(block, world) : who;
}

/** Makes the function of a block that has inputs: of their contents, the block and the world. */
const withInputs = (read, names, use, missing) => (block, world) => {
	const gets = names.map((name) => read(block, name, world, missing));
	return () => use(gets.map((get) => get()), block, world);
};
const withNumbers = (names, use) => withInputs(number, names, use);
/** Makes the function of a block that is about an agent and has an input: of the agent, the input's content, the block's fields and the world. */
const withInput = (read, name, use, missing) => (block, world) => {
	const get = read(block, name, world, missing);
	return () => use(me(block, world), get(), block.fields, world);
};
const withNumber = (name, use) => withInput(number, name, use);
const withValue = (name, use, missing) => withInput(value, name, use, missing);
/** Makes the function of a block that needs a terrain, and that of one that raises it if hasHills. */
const onTerrain = (make, hasHills = false) => (block, world) => {
	world.needTerrain(hasHills);
	return make(block, world);
};
/** The function of a block that is about an agent alone. */
const about = (use) => (block, world) => () => use(me(block, world), block.fields, world);

export const STATEMENTS = {
	starlogo_system: (block, world) => () => world.isSystemFixed || world.useSystem(block.fields.SYSTEM),
	starlogo_hierarchical: (block, world) => () => world.setTrait("setHierarchical", whom(block, world), block.fields.ON === "on"),
	starlogo_depth: withInputs(value, ["DEPTH"], ([depth], block, world) => world.setTrait("setCollisionDepth", whom(block, world), Number(depth))),
	starlogo_collide_as: (block, world) => () => world.setTrait("collideAs", whom(block, world), block.fields.AS),
	starlogo_show: (block, world) => () => world.showStructures(whom(block, world), block.fields.ON === "on"),
	starlogo_sweep: (block, world) => () => world.sweep(whom(block, world), block.fields.ON === "on"),
	starlogo_until: withNumber("STEPS", (agent, steps, { BREED, HOW }, world) => world.moves.advance(agent, steps, breedOf(BREED), HOW)),
	starlogo_face: withValue("AGENT", (agent, other, fields, world) => world.moves.face(agent, other), null),
	starlogo_bounce: (block, world) => () => world.moves.bounce(me(block, world), touched(block, world)),
	starlogo_become: (block, world) => () => {
		for (const agent of world.subjects(whom(block, world))) world.become(agent, block.fields.BREED);
	},
	starlogo_say: withValue("TEXT", (agent, text, fields, world) => world.say(agent, textOf(text)), ""),
	starlogo_score_set: withNumbers(["SCORE"], ([score], block, world) => {
		world.score = score;
	}),
	starlogo_score_change: withNumbers(["SCORE"], ([by], block, world) => {
		world.score = (world.score ?? 0) + by;
	}),
	starlogo_goal: (block, world) => () => {
		world.goal = block.fields.TEXT;
	},
	starlogo_ground: (block, world) => () => {
		world.ground = block.fields.GROUND;
	},
	starlogo_limit: withNumbers(["SECONDS"], ([seconds], { fields: { TEXT } }, world) => {
		world.limit = { until: world.frameIn(seconds), text: TEXT };
	}),
	starlogo_sound: (block, world) => () => {
		world.sounds.push(block.fields.SOUND);
	},
	starlogo_note: withNumbers(["NOTE"], ([note], block, world) => {
		world.sounds.push(note);
	}),
	starlogo_end: (block, world) => () => {
		world.ended ??= { how: block.fields.HOW, text: block.fields.TEXT };
	},
	starlogo_forward: withNumber("STEPS", (agent, steps, fields, world) => world.moves.forward(agent, steps)),
	starlogo_turn: withNumber("DEGREES", (agent, degrees, { DIRECTION }) => {
		agent.heading += DIRECTION === "left" ? degrees : -degrees;
	}),
	starlogo_up: withNumber("STEPS", (agent, steps) => {
		agent.z += steps;
	}),
	starlogo_go: withNumbers(["X", "Y", "Z"], ([x, y, z], block, world) => me(block, world).jumpTo(x, y, z)),
	starlogo_scatter: about((agent, fields, world) => world.moves.scatter(agent)),
	starlogo_back: about((agent, fields, world) => world.moves.goBack(agent, world.collidee)),
	starlogo_mound: onTerrain(withNumbers(["WIDTH", "HEIGHT"], ([width, height], block, world) => {
		const { x, y } = me(block, world);
		world.terrain.raiseMound(x, y, width, height);
	}), true),
	starlogo_wall: onTerrain(withNumber("HEIGHT", ({ x, y }, high, fields, world) => world.terrain.raiseWall(x, y, high)), true),
	starlogo_raise: onTerrain(withNumbers(["X", "Y", "HEIGHT"], ([x, y, height], block, world) => world.edges.raiseGround(x, y, height)), true),
	starlogo_broadcast: (block, world) => () => world.broadcast(block.fields.MESSAGE),
	starlogo_own_set: withValue("VALUE", (agent, own, { NAME }, world) => world.setOwn(agent, NAME, own)),
	starlogo_own_change: withNumber("DELTA", (agent, by, { NAME }, world) => world.setOwn(agent, NAME, Number(agent.own[NAME] ?? 0) + by)),
	starlogo_own_show: (block, world) => () => world.showOwn(block.fields.NAME, block.fields.ON === "on"),
	starlogo_flat: onTerrain((block, world) => () => world.terrain.reset()),
	starlogo_solid: (block, world) => () => world.setSolid(block.fields.BREED, block.fields.ON === "on"),
	starlogo_push: (block, world) => () => world.contacts.pushAway(me(block, world), touched(block, world)),
	starlogo_walk: onTerrain(withNumber("STEPS", (agent, steps, fields, world) => world.moves.walk(agent, steps))),
	starlogo_jump: onTerrain(withNumber("HEIGHT", (agent, height, fields, world) => {
		agent.rise = world.walking.jump(agent, height, agent.rise);
	})),
	starlogo_fall: onTerrain(about((agent, fields, world) => {
		agent.rise = world.walking.fall(agent, agent.rise);
	})),
	starlogo_edge: (block, world) => {
		world.needEdges();
		return () => world.edges[`${block.fields.HOW}Edge`](me(block, world));
	},
	starlogo_stand: onTerrain(about((agent, fields, world) => {
		agent.z = world.moves.groundBelow(agent);
	})),
	starlogo_delete: (block, world) => () => {
		for (const agent of world.subjects(whom(block, world))) world.remove(agent);
	},
	starlogo_size: withNumber("SIZE", (agent, size) => {
		agent.size = size;
	}),
	starlogo_heading: withNumber("HEADING", (agent, heading) => {
		agent.heading = heading;
	}),
	starlogo_colour: withInputs(value, ["COLOUR"], ([colour], block, world) => world.paint(whom(block, world), Number(colour))),
	variables_set: withInputs(value, ["VALUE"], ([content], { fields: { VAR } }, { variables }) => {
		variables[VAR.id] = content;
	}),
	math_change: withNumbers(["DELTA"], ([by], { fields: { VAR } }, { variables }) => {
		variables[VAR.id] = Number(variables[VAR.id] ?? 0) + by;
	}),
};

/** The distance to nothing. */
const FAR = 1000000;

/** The text that an agent says. Numbers have few decimals. */
export function textOf(value) {
	if (typeof value === "number") return plain(value);
	return typeof value === "boolean" ? texts.blocks.truths[String(value).toUpperCase()] : String(value ?? "").slice(0, 80);
}

const ARITHMETIC = { ADD: (a, b) => a + b, MINUS: (a, b) => a - b, MULTIPLY: (a, b) => a * b, DIVIDE: (a, b) => a / b, POWER: (a, b) => a ** b };
const COMPARISONS = { EQ: (a, b) => a === b, NEQ: (a, b) => a !== b, LT: (a, b) => a < b, LTE: (a, b) => a <= b, GT: (a, b) => a > b, GTE: (a, b) => a >= b };

const two = (read, table) => withInputs(read, ["A", "B"], ([a, b], { fields: { OP } }) => table[OP](a, b));

const VALUES = {
	math_number: (block) => () => block.fields.NUM,
	math_arithmetic: two(number, ARITHMETIC),
	math_random_int: withNumbers(["FROM", "TO"], ([a, b], block, world) => Math.min(a, b) + Math.floor(world.random() * (Math.abs(b - a) + 1))),
	math_modulo: withNumbers(["DIVIDEND", "DIVISOR"], ([a, b]) => a % b),
	logic_compare: two(value, COMPARISONS),
	logic_operation: two(value, { AND: (a, b) => a && b, OR: (a, b) => a || b }),
	logic_negate: withInputs(value, ["BOOL"], ([holds]) => !holds, false),
	logic_boolean: (block) => () => block.fields.BOOL === "TRUE",
	variables_get: (block, world) => () => world.variables[block.fields.VAR.id] ?? 0,
	text: (block) => () => block.fields.TEXT,
	starlogo_own: about((agent, { NAME }) => agent.own[NAME] ?? 0),
	starlogo_trait: about((agent, { TRAIT }, world) => world.traitOf(agent, TRAIT)),
	starlogo_agent: (block, world) => () => whom(block, world),
	starlogo_count: withNumber("DISTANCE", (agent, distance, { BREED }, world) => world.senses.countWithin(agent, breedOf(BREED), distance)),
	starlogo_number_of: withValue("COLOUR", (agent, colour, { BREED }, world) => world.senses.countWith(agent, breedOf(BREED), "color", colour)),
	starlogo_nearest: withNumber("DISTANCE", (agent, distance, { BREED }, world) => world.senses.nearestWithin(agent, breedOf(BREED), distance)),
	starlogo_distance: withValue("AGENT", (agent, other, fields, world) => (other ? world.senses.distanceTo(agent, other) : FAR), null),
	starlogo_can_see: withValue("AGENT", (agent, other, fields, world) => other !== null && world.senses.canSee(agent, other), null),
	starlogo_side: (block, world) => () => {
		const [agent, other] = [me(block, world), touched(block, world)];
		return (block.fields.WHO === "me" ? world.contacts.sideHit(agent, other) : world.contacts.sideHit(other, agent)) === block.fields.SIDE;
	},
	starlogo_touch: (block, world) => () => {
		const [agent, other] = [me(block, world), touched(block, world)];
		return block.fields.TOUCH === "speed" ? world.moves.speedOf(agent, other) : world.contacts.touchPoint(agent, other)[block.fields.TOUCH];
	},
	starlogo_ahead: withNumber("DISTANCE", (agent, distance, { BREED }, world) => world.senses.ahead(agent, breedOf(BREED), distance)),
	starlogo_free: withNumber("DISTANCE", (agent, distance, { BREED }, world) => Math.min(FAR, world.senses.distanceAhead(agent, breedOf(BREED), distance))),
	starlogo_standing: onTerrain(about((agent, { BREED }, world) => {
		const below = world.walking.standsOn(agent);
		return below !== null && (BREED === "anyone" || below.breed === BREED);
	})),
	starlogo_floor: onTerrain(about((agent, fields, world) => {
		const below = world.walking.standsOn(agent);
		return below instanceof Being ? below : null;
	})),
	starlogo_at_edge: (block, world) => {
		world.needEdges();
		return () => {
			const edge = world.edges.edgeTouched(me(block, world));
			return edge !== null && (block.fields.EDGE === "any" || block.fields.EDGE === edge);
		};
	},
	starlogo_touching: about((agent, { BREED }, world) => world.senses.isTouching(agent, breedOf(BREED))),
	starlogo_ground_height: onTerrain(about((agent, fields, world) => world.moves.groundBelow(agent))),
	starlogo_on_ground: onTerrain(about((agent, fields, world) => world.senses.isTouching(agent, Collision.TERRAIN))),
	starlogo_key_down: (block, world) => () => world.input.isDown(block.fields.KEY),
	starlogo_mouse: (block, world) => () => world.input.mouse[block.fields.MOUSE === "down" ? "isDown" : block.fields.MOUSE],
	starlogo_score: (block, world) => () => world.score ?? 0,
	starlogo_clock: (block, world) => () => world.seconds,
	starlogo_pick: (block) => () => COLOURS[block.fields.COLOUR],
	starlogo_any_colour: (block, world) => () => Object.values(COLOURS)[Math.floor(world.random() * 6)],
	starlogo_colour_of: (block, world) => () => {
		const who = whom(block, world);
		return typeof who === "string" ? 0 : who.color;
	},
};
