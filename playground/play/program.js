/**
 * Programs: Blockly's own notation, made into lists of steps. Nothing here needs Blockly or a page.
 *
 * A script is run for an agent, "me"; in a collision block there is a "collidee" too. Both stand in `world`, as do the variables. What a run of
 * a script knows besides is a Thread, which can wait, and can be copied: so a game can be set back to an earlier frame.
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
const wordsOf = (type) => texts.blocks[type].replaceAll(/ ?%\d/g, " …").replace(/^ … |[ :]*…$/g, "").trim();

/** Counts the rounds of a frame's loops. */
export class Rounds {
	#left = MOST_ROUNDS;

	begin() {
		this.#left = MOST_ROUNDS;
	}

	take(block) {
		if (--this.#left < 0) throw new ProgramError(texts.play.endless[block.fields?.MODE ?? "TIMES"] ?? texts.play.endless.TIMES, block.id);
	}
}

/** A run of a script: where it is, and for whom. */
export class Thread {
	at = 0;
	/** Rounds that loops have left, and agents that blocks go back to. */
	stack = [];
	/** The frame in which it goes on. */
	until = 0;

	constructor(code, me, collidee) {
		Object.assign(this, { code, me, collidee });
	}

	copy() {
		return Object.assign(new Thread(this.code, this.me, this.collidee), { at: this.at, until: this.until, stack: [...this.stack] });
	}

	/** Goes on until the end, which is true, or until it waits. Errors, the engine's too, say which block they are about. */
	run(world) {
		const { steps, blocks } = this.code;
		world.me = this.me;
		world.collidee = this.collidee;
		try {
			while (this.at < steps.length) {
				if (steps[this.at++](this)) {
					this.me = world.me;
					return false;
				}
			}
			return true;
		} catch (error) {
			throw error instanceof ProgramError ? error : new ProgramError(error.message, blocks[this.at - 1].id);
		} finally {
			world.me = world.collidee = null;
		}
	}
}

/** The steps of a script, each with the block that it is of. A step that returns true waits. */
class Code {
	steps = [];
	blocks = [];

	add(block, step) {
		this.steps.push(step);
		this.blocks.push(block);
	}

	/** Steps for a chain of blocks. */
	addChain(first, world) {
		for (let block = first; block; block = block.next?.block) {
			const control = CONTROL[block.type];
			const make = STATEMENTS[block.type];
			if (!control && !make) throw new ProgramError(`${block.type}?`, block.id);
			if (block.enabled === false || block.disabledReasons?.length > 0) continue;
			if (control) control(block, world, this);
			else this.add(block, make(block, world));
		}
	}

	/** Steps for what is in an input, and after that a step back to an earlier one, if told. */
	addBody(block, name, world, back = -1) {
		this.addChain(block.inputs?.[name]?.block, world);
		if (back >= 0) this.addJump(block).to = back;
	}

	addJump(block) {
		const jump = { to: 0 };
		this.add(block, (thread) => {
			thread.at = jump.to;
		});
		return jump;
	}

	get end() {
		return this.steps.length;
	}
}

/**
 * A program's scripts.
 *
 * @param {object} state what Blockly.serialization.workspaces.save gives
 * @param {import("./world.js").World} world what they act upon
 * @returns {{event: string, fields: object, seconds: Function|null, code: Code}[]}
 */
export function compile(state, world) {
	const tops = state?.blocks?.blocks ?? [];
	return tops.filter((block) => block.type in EVENTS).map((block) => {
		const code = new Code();
		code.addBody(block, "DO", world);
		return { event: EVENTS[block.type], fields: block.fields ?? {}, seconds: block.inputs?.SECONDS ? number(block, "SECONDS", world) : null, code };
	});
}

/**
 * The keys that a program has scripts for, each with what its first block does.
 *
 * @returns {Map<string, string>}
 */
export function keysOf(state) {
	const keys = new Map();
	for (const { type, fields, inputs } of state?.blocks?.blocks ?? []) {
		const first = inputs?.DO?.block;
		if (type === "starlogo_key" && first) keys.set(fields.KEY, doing(first));
	}
	return keys;
}

/** What a block does in a word or two. */
function doing({ type, fields, inputs }) {
	if (inputs?.STEPS?.shadow?.fields.NUM < 0) return texts.blocks.back;
	const word = texts.blocks[type].split(" ")[0];
	return fields?.DIRECTION ? `${word} ${texts.blocks.directions[fields.DIRECTION]}` : word;
}

const EVENTS = {
	starlogo_start: "start", starlogo_each: "each", starlogo_key: "key", starlogo_timer: "timer", starlogo_click: "click", starlogo_collision: "collision",
	starlogo_touch_start: "touchStart", starlogo_touch_end: "touchEnd",
};

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
	starlogo_sweep: (block, world) => () => {
		for (const agent of world.subjects(whom(block, world))) agent.sweeps = block.fields.ON === "on";
	},
	starlogo_until: (block, world) => {
		const steps = number(block, "STEPS", world);
		return () => world.advance(me(block, world), steps(), breedOf(block.fields.BREED), block.fields.HOW);
	},
	starlogo_face: (block, world) => {
		const agent = value(block, "AGENT", world, null);
		return () => world.face(me(block, world), agent());
	},
	starlogo_bounce: (block, world) => () => world.bounce(me(block, world), world.collidee ?? fail(texts.play.noCollidee(wordsOf(block.type)), block)),
	starlogo_become: (block, world) => () => {
		for (const agent of world.subjects(whom(block, world))) world.become(agent, block.fields.BREED);
	},
	starlogo_say: (block, world) => {
		const text = value(block, "TEXT", world, "");
		return () => world.say(me(block, world), said(text()));
	},
	starlogo_score_set: (block, world) => {
		const score = number(block, "SCORE", world);
		return () => {
			world.score = score();
		};
	},
	starlogo_score_change: (block, world) => {
		const by = number(block, "SCORE", world);
		return () => {
			world.score = (world.score ?? 0) + by();
		};
	},
	starlogo_goal: (block, world) => () => {
		world.goal = block.fields.TEXT;
	},
	starlogo_end: (block, world) => () => {
		world.ended ??= { how: block.fields.HOW, text: block.fields.TEXT };
	},
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
	starlogo_back: (block, world) => () => world.goBack(me(block, world), world.collidee),
	starlogo_delete: (block, world) => () => {
		for (const agent of world.subjects(whom(block, world))) world.remove(agent);
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

/** Blocks that have others inside of them, or wait. */
const CONTROL = {
	starlogo_create: (block, world, code) => {
		const count = number(block, "COUNT", world);
		addRounds(block, world, code, () => Math.floor(count()), () => added(block, world, null));
	},
	starlogo_hatch: (block, world, code) => addRounds(block, world, code, () => 1, () => added(block, world, me(block, world))),
	starlogo_ask: (block, world, code) => {
		const agent = value(block, "AGENT", world, null);
		addRounds(block, world, code, () => (agent() ? 1 : 0), agent);
	},
	starlogo_wait: (block, world, code) => {
		const seconds = number(block, "SECONDS", world);
		code.add(block, (thread) => {
			thread.until = world.frameIn(seconds());
			return true;
		});
	},
	controls_if: (block, world, code) => {
		const count = 1 + (block.extraState?.elseIfCount ?? 0);
		addBranches(block, world, code, Array.from({ length: count }, (_, i) => i));
	},
	controls_ifelse: (block, world, code) => addBranches(block, world, code, [0]),
	controls_repeat_ext: (block, world, code) => {
		const times = number(block, "TIMES", world);
		addRounds(block, world, code, times);
	},
	controls_whileUntil: (block, world, code) => {
		const holds = value(block, "BOOL", world, false);
		const goal = block.fields.MODE !== "UNTIL";
		const begin = code.end;
		const jump = { to: 0 };
		code.add(block, (thread) => {
			if (Boolean(holds()) === goal) world.rounds.take(block);
			else thread.at = jump.to;
		});
		code.addBody(block, "DO", world, begin);
		jump.to = code.end;
	},
};

/** Rounds of a loop; each for the agent that `who` gives, if it is told. */
function addRounds(block, world, code, times, who = null) {
	code.add(block, ({ stack }) => {
		stack.push(world.me, times());
	});
	const begin = code.end;
	const jump = { to: 0 };
	code.add(block, (thread) => {
		const { stack } = thread;
		const last = stack.length - 1;
		if (who) world.me = stack[last - 1];
		if (stack[last] < 1) {
			stack.length = last - 1;
			thread.at = jump.to;
			return;
		}
		stack[last]--;
		world.rounds.take(block);
		if (who) world.me = who();
	});
	code.addBody(block, "DO", world, begin);
	jump.to = code.end;
}

/** The branches of a condition, and what is done otherwise. */
function addBranches(block, world, code, numbers) {
	const ends = numbers.map((i) => {
		const holds = value(block, `IF${i}`, world, false);
		const past = { to: 0 };
		code.add(block, (thread) => {
			if (!holds()) thread.at = past.to;
		});
		code.addBody(block, `DO${i}`, world);
		const end = code.addJump(block);
		past.to = code.end;
		return end;
	});
	code.addBody(block, "ELSE", world);
	for (const end of ends) end.to = code.end;
}

function added(block, world, parent) {
	return world.add(block.fields.SHAPE, block.fields.BREED, parent) ?? fail(texts.play.tooMany(world.agents.length), block);
}

/** How far nothing is. */
const FAR = 1000000;

/** What an agent says: numbers without tails. */
const said = (value) => String(typeof value === "number" ? Number(value.toFixed(2)) : value ?? "").slice(0, 80);

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
	text: (block) => () => block.fields.TEXT,
	starlogo_trait: (block, world) => () => world.traitOf(me(block, world), block.fields.TRAIT),
	starlogo_agent: (block, world) => () => whom(block, world),
	starlogo_count: (block, world) => {
		const distance = number(block, "DISTANCE", world);
		return () => world.senses.countWithin(me(block, world), breedOf(block.fields.BREED), distance());
	},
	starlogo_number_of: (block, world) => {
		const colour = value(block, "COLOUR", world);
		return () => world.senses.countWith(me(block, world), breedOf(block.fields.BREED), "color", colour());
	},
	starlogo_nearest: (block, world) => {
		const distance = number(block, "DISTANCE", world);
		return () => world.senses.nearestWithin(me(block, world), breedOf(block.fields.BREED), distance());
	},
	starlogo_distance: (block, world) => {
		const agent = value(block, "AGENT", world, null);
		return () => {
			const other = agent();
			return other ? world.senses.distanceTo(me(block, world), other) : FAR;
		};
	},
	starlogo_can_see: (block, world) => {
		const agent = value(block, "AGENT", world, null);
		return () => {
			const other = agent();
			return other !== null && world.senses.canSee(me(block, world), other);
		};
	},
	starlogo_touching: (block, world) => () => world.senses.isTouching(me(block, world), breedOf(block.fields.BREED)),
	starlogo_key_down: (block, world) => () => world.held.has(block.fields.KEY),
	starlogo_mouse: (block, world) => () => (block.fields.MOUSE === "down" ? world.mouse.isDown : world.mouse[block.fields.MOUSE]),
	starlogo_score: (block, world) => () => world.score ?? 0,
	starlogo_clock: (block, world) => () => world.seconds,
	starlogo_pick: (block) => () => COLOURS[block.fields.COLOUR],
	starlogo_any_colour: (block, world) => () => Object.values(COLOURS)[Math.floor(world.random() * 6)],
	starlogo_colour_of: (block, world) => () => {
		const who = whom(block, world);
		return typeof who === "string" ? 0 : who.color;
	},
};

/** The breed that a collision block names. */
export const breedOf = (field) => (field === "anyone" ? Collision.ANY_BREED : field);
