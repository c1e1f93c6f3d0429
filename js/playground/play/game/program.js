/**
 * Programs: compiles Blockly's own notation to lists of steps. Nothing here needs Blockly or a page.
 *
 * A script runs for an agent, "me". In a collision block there is a "collidee" too. `world` has both, and the variables. All other data of
 * a running script is in a Thread. A Thread can wait and can be copied, so a game can go back to an earlier frame.
 */
import { texts } from "../../shared/language.js";
import { ProgramError, STATEMENTS, fail, me, number, value } from "./actions.js";

/** The most rounds of all loops in one frame. */
const MOST_ROUNDS = 100000;

/** Counts the rounds of loops in a frame. */
export class Rounds {
	#left = MOST_ROUNDS;

	begin() {
		this.#left = MOST_ROUNDS;
	}

	count(block) {
		if (--this.#left < 0) throw new ProgramError(texts.play.endless[block.fields?.MODE ?? "TIMES"] ?? texts.play.endless.TIMES, block.id);
	}
}

/** A running script: its place, and its agent. */
export class Thread {
	at = 0;
	/** The remaining rounds of loops, and the agents that blocks go back to. */
	stack = [];
	/** The frame in which it goes on. */
	until = 0;

	constructor(code, me, collidee) {
		Object.assign(this, { code, me, collidee });
	}

	copy() {
		return Object.assign(new Thread(this.code, this.me, this.collidee), { at: this.at, until: this.until, stack: [...this.stack] });
	}

	/** Runs until the end, and returns true, or until it waits. Errors, also the engine's, get the block in which they happened. */
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

/** The steps of a script, with the block of each. A step that returns true waits. */
class Code {
	steps = [];
	blocks = [];

	add(block, step) {
		this.steps.push(step);
		this.blocks.push(block);
	}

	/** Adds the steps of a chain of blocks. */
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

	/** Adds the steps of an input, and then, if `back` is given, a step back to that one. */
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
 * @param {object} state the result of Blockly.serialization.workspaces.save
 * @param {import("./world.js").World} world the scripts act on it
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
 * The keys for which a program has scripts, with the effect of each script's first block.
 *
 * @returns {Map<string, string>}
 */
export function keysOf(state) {
	const keys = new Map();
	for (const { type, fields, inputs } of state?.blocks?.blocks ?? []) {
		const first = inputs?.DO?.block;
		if (type === "starlogo_key" && first) keys.set(fields.KEY, doing(first, fields.KEY));
	}
	return keys;
}

/** The breeds that keys turn. A player who looks over the shoulder of such an agent sees where it goes. */
export function breedsThatKeysTurn(state) {
	const tops = state?.blocks?.blocks ?? [];
	return [...new Set(tops.filter((block) => block.type === "starlogo_key" && has(block, "starlogo_turn")).map(({ fields }) => fields.BREED))];
}

/** Whether a block contains a block of a type, or is followed by one. */
function has(block, type) {
	if (!block) return false;
	return block.type === type || Object.values(block.inputs ?? {}).some((input) => has(input.block, type)) || has(block.next?.block, type);
}

/** Blocks that only prepare something, or contain what is done. */
const PREPARING = /^(starlogo_(heading|go|ask)|controls_\w+|variables_set|math_change|starlogo_own_\w+)$/;

/** The first block of a chain that does more than to prepare something, or the first one in it; null if there is none. */
function acting(first) {
	for (let block = first; block; block = block.next?.block) {
		if (!PREPARING.test(block.type)) return block;
		const inner = Object.entries(block.inputs ?? {}).filter(([name]) => /^(DO|ELSE)/.test(name)).map(([, input]) => acting(input.block)).find(Boolean);
		if (inner) return inner;
	}
	return null;
}

/** The effect of a key in a word or two, by its first block. If that block only prepares something, an arrow's direction, or what follows. */
function doing(first, key) {
	if (PREPARING.test(first.type) && key in texts.play.keyWays) return texts.play.keyWays[key];
	const block = acting(first);
	if (!block) return texts.blocks.keys[key];
	const { type, fields, inputs } = block;
	if (inputs?.STEPS?.shadow?.fields.NUM < 0) return texts.blocks.back;
	const word = texts.blocks[type].split(" ").find((each) => !each.startsWith("%"));
	return fields?.DIRECTION ? `${word} ${texts.blocks.directions[fields.DIRECTION]}` : word;
}

const EVENTS = {
	starlogo_start: "start", starlogo_each: "each", starlogo_key: "key", starlogo_timer: "timer", starlogo_click: "click", starlogo_collision: "collision",
	starlogo_touch_start: "touchStart", starlogo_touch_end: "touchEnd", starlogo_receive: "receive",
};

/** Blocks that contain other blocks, or wait. */
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
			if (Boolean(holds()) === goal) world.rounds.count(block);
			else thread.at = jump.to;
		});
		code.addBody(block, "DO", world, begin);
		jump.to = code.end;
	},
};

/** Adds the rounds of a loop. If `who` is given, each round is for the agent that it returns. */
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
		world.rounds.count(block);
		if (who) world.me = who();
	});
	code.addBody(block, "DO", world, begin);
	jump.to = code.end;
}

/** Adds the branches of a condition, and of the other case. */
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
	const agent = world.add(block.fields.SHAPE, block.fields.BREED, parent) ?? fail(texts.play.tooMany(world.agents.length), block);
	agent.maker = block.id;
	return agent;
}
