/**
 * Programs: Blockly's own notation, made into functions. Nothing here needs Blockly or a page.
 *
 * A script is run for an agent, "me"; in a collision block there is a "collidee" too. Both stand in `world`, as do the variables.
 */
import { Collision } from "starlogo-collision";
import { texts } from "../texts.js";
import { COLOURS } from "./colours.js";

/** How many times the loops of one frame may go round. */
const MOST_ROUNDS = 100000;

/** What a student did wrong, and where. */
export class ProgramError extends Error {
	constructor(message, block) {
		super(message);
		this.block = block;
	}
}

/** A block's words, without what is put into it. */
const wordsOf = (type) => texts.blocks.loops[type] ?? texts.blocks[type].replaceAll(/ ?%\d/g, " …").replace(/^ … |[ :]*…$/g, "").trim();

/** Counts the rounds of a frame's loops. */
export class Rounds {
	#left = MOST_ROUNDS;

	begin() {
		this.#left = MOST_ROUNDS;
	}

	take(block) {
		if (--this.#left < 0) throw new ProgramError(texts.play.endless(wordsOf(block.type)), block.id);
	}
}

/**
 * A program's scripts.
 *
 * @param {object} state what Blockly.serialization.workspaces.save gives
 * @param {import("./world.js").World} world what they act upon
 * @returns {{event: string, fields: object, seconds: Function|null, run: Function}[]}
 */
export function compile(state, world) {
	const tops = state?.blocks?.blocks ?? [];
	return tops.filter((block) => block.type in EVENTS).map((block) => ({
		event: EVENTS[block.type],
		fields: block.fields ?? {},
		seconds: block.inputs?.SECONDS ? number(block, "SECONDS", world) : null,
		run: statements(block.inputs?.DO?.block, world),
	}));
}

const EVENTS = {
	starlogo_start: "start", starlogo_each: "each", starlogo_key: "key", starlogo_timer: "timer", starlogo_collision: "collision",
	starlogo_touch_start: "touchStart", starlogo_touch_end: "touchEnd",
};

/** A chain of blocks as one function. */
function statements(block, world) {
	const steps = [];
	for (let each = block; each; each = each.next?.block) {
		const make = STATEMENTS[each.type];
		if (!make) throw new ProgramError(`${each.type}?`, each.id);
		if (each.enabled !== false) steps.push(blamed(each, make(each, world)));
	}
	if (steps.length === 1) return steps[0];
	return () => {
		for (let i = 0; i < steps.length; i++) steps[i]();
	};
}

/** A step whose errors, the engine's too, say which block they are about. */
function blamed(block, step) {
	return () => {
		try {
			step();
		} catch (error) {
			throw error instanceof ProgramError ? error : new ProgramError(error.message, block.id);
		}
	};
}

/** What is in an input: the block put there, or else the shadow. */
const inputOf = (block, name) => block.inputs?.[name]?.block ?? block.inputs?.[name]?.shadow;

function value(block, name, world, missing = 0) {
	const input = inputOf(block, name);
	if (!input) return () => missing;
	const make = VALUES[input.type];
	if (!make) throw new ProgramError(`${input.type}?`, input.id);
	return make(input, world);
}

function number(block, name, world) {
	const get = value(block, name, world);
	return () => {
		const result = Number(get());
		if (!Number.isFinite(result)) throw new ProgramError(texts.play.notANumber(wordsOf(block.type)), block.id);
		return result;
	};
}

function me(block, world) {
	return world.me ?? fail(texts.play.nobody(wordsOf(block.type)), block);
}

function fail(message, block) {
	throw new ProgramError(message, block.id);
}

/** Whom a block is about: me, the collidee, or a breed's name. */
function whom(block, world) {
	const who = block.fields.WHO;
	if (who === "me") return me(block, world);
	if (who === "collidee") return world.collidee ?? fail(texts.play.noCollidee(wordsOf(block.type)), block);
	return who;
}

const STATEMENTS = {
	starlogo_system: (block, world) => () => world.useSystem(block.fields.SYSTEM),
	starlogo_hierarchical: (block, world) => () => world.traits.setHierarchical(whom(block, world), block.fields.ON === "on"),
	starlogo_depth: (block, world) => {
		const depth = value(block, "DEPTH", world);
		return () => world.traits.setCollisionDepth(whom(block, world), Number(depth()));
	},
	starlogo_collide_as: (block, world) => () => world.traits.collideAs(whom(block, world), block.fields.AS),
	starlogo_show: (block, world) => () => world.structures.show(whom(block, world), block.fields.ON === "on"),
	starlogo_forward: (block, world) => {
		const steps = number(block, "STEPS", world);
		return () => world.forward(me(block, world), steps());
	},
	starlogo_turn: (block, world) => {
		const degrees = number(block, "DEGREES", world);
		const sign = block.fields.DIRECTION === "left" ? 1 : -1;
		return () => {
			me(block, world).heading += sign * degrees();
		};
	},
	starlogo_up: (block, world) => {
		const steps = number(block, "STEPS", world);
		return () => {
			me(block, world).z += steps();
		};
	},
	starlogo_go: (block, world) => {
		const [x, y, z] = ["X", "Y", "Z"].map((name) => number(block, name, world));
		return () => me(block, world).jumpTo(x(), y(), z());
	},
	starlogo_scatter: (block, world) => () => world.scatter(me(block, world)),
	starlogo_back: (block, world) => () => world.goBack(me(block, world)),
	starlogo_create: (block, world) => {
		const count = number(block, "COUNT", world);
		const run = statements(block.inputs?.DO?.block, world);
		return () => {
			const times = Math.floor(count());
			for (let i = 0; i < times; i++) create(block, world, run, null);
		};
	},
	starlogo_hatch: (block, world) => {
		const run = statements(block.inputs?.DO?.block, world);
		return () => create(block, world, run, me(block, world));
	},
	starlogo_delete: (block, world) => () => {
		const who = whom(block, world);
		if (typeof who === "string") world.removeBreed(who);
		else world.remove(who);
	},
	starlogo_size: (block, world) => {
		const size = number(block, "SIZE", world);
		return () => {
			me(block, world).size = size();
		};
	},
	starlogo_heading: (block, world) => {
		const heading = number(block, "HEADING", world);
		return () => {
			me(block, world).heading = heading();
		};
	},
	starlogo_colour: (block, world) => {
		const colour = value(block, "COLOUR", world);
		return () => world.paint(whom(block, world), Number(colour()));
	},
	controls_if: (block, world) => {
		const branches = [];
		for (let i = 0; i <= (block.extraState?.elseIfCount ?? 0); i++) {
			branches.push({ holds: value(block, `IF${i}`, world, false), run: statements(block.inputs?.[`DO${i}`]?.block, world) });
		}
		const otherwise = statements(block.inputs?.ELSE?.block, world);
		return () => (branches.find(({ holds }) => holds())?.run ?? otherwise)();
	},
	controls_ifelse: (block, world) => {
		const holds = value(block, "IF0", world, false);
		const [run, otherwise] = ["DO0", "ELSE"].map((name) => statements(block.inputs?.[name]?.block, world));
		return () => (holds() ? run() : otherwise());
	},
	controls_repeat_ext: (block, world) => {
		const times = number(block, "TIMES", world);
		const run = statements(block.inputs?.DO?.block, world);
		return () => {
			for (let i = times(); i >= 1; i--) {
				world.rounds.take(block);
				run();
			}
		};
	},
	controls_whileUntil: (block, world) => {
		const holds = value(block, "BOOL", world, false);
		const goal = block.fields.MODE !== "UNTIL";
		const run = statements(block.inputs?.DO?.block, world);
		return () => {
			while (Boolean(holds()) === goal) {
				world.rounds.take(block);
				run();
			}
		};
	},
	variables_set: (block, world) => {
		const get = value(block, "VALUE", world);
		return () => {
			world.variables[block.fields.VAR.id] = get();
		};
	},
	math_change: (block, world) => {
		const by = number(block, "DELTA", world);
		const { id } = block.fields.VAR;
		return () => {
			world.variables[id] = Number(world.variables[id] ?? 0) + by();
		};
	},
};

function create(block, world, run, parent) {
	const { me: before } = world;
	world.me = world.add(block.fields.SHAPE, block.fields.BREED, parent) ?? fail(texts.play.tooMany(world.agents.length), block);
	try {
		run();
	} finally {
		world.me = before;
	}
}

const ARITHMETIC = { ADD: (a, b) => a + b, MINUS: (a, b) => a - b, MULTIPLY: (a, b) => a * b, DIVIDE: (a, b) => a / b, POWER: (a, b) => a ** b };
const COMPARISONS = { EQ: (a, b) => a === b, NEQ: (a, b) => a !== b, LT: (a, b) => a < b, LTE: (a, b) => a <= b, GT: (a, b) => a > b, GTE: (a, b) => a >= b };

const two = (block, world, table, wrap = value, names = ["A", "B"]) => {
	const [a, b] = names.map((name) => wrap(block, name, world));
	const operation = table[block.fields.OP];
	return () => operation(a(), b());
};

const VALUES = {
	math_number: (block) => () => block.fields.NUM,
	math_arithmetic: (block, world) => two(block, world, ARITHMETIC, number),
	math_random_int: (block, world) => {
		const [low, high] = ["FROM", "TO"].map((name) => number(block, name, world));
		return () => {
			const from = Math.min(low(), high());
			return from + Math.floor(world.random() * (Math.abs(high() - low()) + 1));
		};
	},
	math_modulo: (block, world) => {
		const [a, b] = ["DIVIDEND", "DIVISOR"].map((name) => number(block, name, world));
		return () => a() % b();
	},
	logic_compare: (block, world) => two(block, world, COMPARISONS),
	logic_operation: (block, world) => two(block, world, { AND: (a, b) => a && b, OR: (a, b) => a || b }),
	logic_negate: (block, world) => {
		const get = value(block, "BOOL", world, false);
		return () => !get();
	},
	logic_boolean: (block) => () => block.fields.BOOL === "TRUE",
	variables_get: (block, world) => () => world.variables[block.fields.VAR.id] ?? 0,
	starlogo_trait: (block, world) => () => world.traitOf(me(block, world), block.fields.TRAIT),
	starlogo_pick: (block) => () => COLOURS[block.fields.COLOUR],
	starlogo_any_colour: (block, world) => () => Object.values(COLOURS)[Math.floor(world.random() * 6)],
	starlogo_colour_of: (block, world) => () => {
		const who = whom(block, world);
		return typeof who === "string" ? 0 : who.color;
	},
};

/** The breed that a collision block names. */
export const breedOf = (field) => (field === "anyone" ? Collision.ANY_BREED : field);
