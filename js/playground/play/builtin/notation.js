/** Functions for programs in Blockly's notation. */

export const number = (value) => ({ shadow: { type: "math_number", fields: { NUM: value } } });
export const colour = (name) => ({ block: { type: "starlogo_pick", fields: { COLOUR: name } } });
export const numbers = (from, to) => ({ block: { type: "math_random_int", inputs: { FROM: number(from), TO: number(to) } } });

/** Blocks one below the other. */
export function chain(...blocks) {
	return blocks.reduceRight((next, block) => (next ? { ...block, next: { block: next } } : block), undefined);
}

export const inside = (...blocks) => ({ block: chain(...blocks) });
/** The content of an input: a number, or a block. */
const input = (value) => (typeof value === "number" ? number(value) : value);
export const move = (steps) => ({ type: "starlogo_forward", inputs: { STEPS: input(steps) } });
export const turn = (DIRECTION, degrees) => ({ type: "starlogo_turn", fields: { DIRECTION }, inputs: { DEGREES: degrees } });
export const paint = (WHO, COLOUR) => ({ type: "starlogo_colour", fields: { WHO }, inputs: { COLOUR } });
export const size = (value) => ({ type: "starlogo_size", inputs: { SIZE: number(value) } });
export const go = (x, y, z) => ({ type: "starlogo_go", inputs: { X: input(x), Y: input(y), Z: input(z) } });
export const up = (steps) => ({ type: "starlogo_up", inputs: { STEPS: number(steps) } });
export const mound = (high, wide) => ({ type: "starlogo_mound", inputs: { HEIGHT: input(high), WIDTH: input(wide) } });
export const stand = { type: "starlogo_stand" };
export const heading = (value) => ({ type: "starlogo_heading", inputs: { HEADING: input(value) } });
export const scatter = { type: "starlogo_scatter" };
export const create = (count, BREED, SHAPE, ...blocks) => ({ type: "starlogo_create", fields: { BREED, SHAPE }, inputs: { COUNT: number(count), DO: inside(...blocks) } });
export const key = (KEY, MODE, BREED, ...blocks) => ({ type: "starlogo_key", fields: { KEY, MODE, BREED }, inputs: { DO: inside(...blocks) } });
export const each = (BREED, ...blocks) => ({ type: "starlogo_each", fields: { BREED }, inputs: { DO: inside(...blocks) } });
export const touch = (BREED, OTHER, ...blocks) => ({ type: "starlogo_touch_start", fields: { BREED, OTHER }, inputs: { DO: inside(...blocks) } });
export const start = (...blocks) => ({ type: "starlogo_start", inputs: { DO: inside(...blocks) } });
export const walk = (steps) => ({ type: "starlogo_walk", inputs: { STEPS: number(steps) } });
export const jump = (high) => ({ type: "starlogo_jump", inputs: { HEIGHT: number(high) } });
export const fall = { type: "starlogo_fall" };
export const solid = (BREED) => ({ type: "starlogo_solid", fields: { BREED, ON: "on" } });
export const standing = (BREED) => field("starlogo_standing", { BREED });
export const side = (WHO, SIDE) => field("starlogo_side", { WHO, SIDE });
export const either = (condition, first, second) => ({ type: "controls_ifelse", inputs: { IF0: condition, DO0: inside(...first), ELSE: inside(...second) } });
export const remove = (WHO) => ({ type: "starlogo_delete", fields: { WHO } });

export const program = (...scripts) => ({ blocks: { languageVersion: 0, blocks: scripts } });

/** Scripts, with the names of their variables. */
export const many = (names, ...scripts) => ({ ...program(...scripts), variables: names.map((name) => ({ name, id: name })) });

/** A script of which only the first line is shown. */
export const folded = (script) => ({ ...script, collapsed: true });
export const field = (type, fields) => ({ block: { type, fields } });
export const alongside = (steps, BREED) => ({ type: "starlogo_until", fields: { HOW: "slide", BREED }, inputs: { STEPS: steps } });
export const along = (steps, BREED) => alongside(number(steps), BREED);
export const compare = (OP, A, B) => ({ block: { type: "logic_compare", fields: { OP }, inputs: { A, B } } });
export const when = (condition, ...blocks) => ({ type: "controls_if", inputs: { IF0: condition, DO0: inside(...blocks) } });
export const score = (value) => ({ type: "starlogo_score_set", inputs: { SCORE: value } });
export const end = (HOW, TEXT) => ({ type: "starlogo_end", fields: { HOW, TEXT } });
export const limit = (seconds, TEXT) => ({ type: "starlogo_limit", fields: { TEXT }, inputs: { SECONDS: number(seconds) } });
export const sound = (SOUND) => ({ type: "starlogo_sound", fields: { SOUND } });
export const goal = (TEXT) => ({ type: "starlogo_goal", fields: { TEXT } });

export const collision = (BREED, OTHER, ...blocks) => ({ type: "starlogo_collision", fields: { BREED, OTHER }, inputs: { DO: inside(...blocks) } });
export const bounce = { type: "starlogo_bounce" };
export const change = (by) => ({ type: "starlogo_score_change", inputs: { SCORE: number(by) } });
export const hatch = (BREED, SHAPE, ...blocks) => ({ type: "starlogo_hatch", fields: { BREED, SHAPE }, inputs: { DO: inside(...blocks) } });
export const timer = (seconds, BREED, ...blocks) => ({ type: "starlogo_timer", fields: { BREED }, inputs: { SECONDS: number(seconds), DO: inside(...blocks) } });
export const repeat = (times, ...blocks) => ({ type: "controls_repeat_ext", inputs: { TIMES: number(times), DO: inside(...blocks) } });
export const say = (text) => ({ type: "starlogo_say", inputs: { TEXT: { shadow: { type: "text", fields: { TEXT: text } } } } });
export const sweep = (WHO) => ({ type: "starlogo_sweep", fields: { WHO, ON: "on" } });
export const ground = (GROUND) => ({ type: "starlogo_ground", fields: { GROUND } });
export const aim = (AGENT) => ({ type: "starlogo_face", inputs: { AGENT } });
export const nearest = (BREED, distance) => ({ block: { type: "starlogo_nearest", fields: { BREED }, inputs: { DISTANCE: number(distance) } } });
export const count = (BREED, distance) => ({ block: { type: "starlogo_count", fields: { BREED }, inputs: { DISTANCE: number(distance) } } });
export const trait = (TRAIT) => field("starlogo_trait", { TRAIT });
export const math = (OP, A, B) => ({ block: { type: "math_arithmetic", fields: { OP }, inputs: { A, B } } });
export const get = (name) => field("variables_get", { VAR: { id: name } });
export const set = (name, value) => ({ type: "variables_set", fields: { VAR: { id: name } }, inputs: { VALUE: number(value) } });
export const step = (name, by) => ({ type: "math_change", fields: { VAR: { id: name } }, inputs: { DELTA: number(by) } });

/** A wall along y, or turned. */
export const wall = (x, y, length, turned = 0) => create(1, "walls", "wall", size(length), heading(turned), go(x, y, 0));

/** An agent that stands still, and a ball beside it. Agents that touch turn red. */
export function nearMiss(breed, shape, scale, x, y, z, ball) {
	return program(
		start(
			create(1, breed, shape, size(scale), paint("me", colour("blue"))),
			create(1, "paintballs", "sphere", size(ball), go(x, y, z), paint("me", colour("yellow"))),
		),
		touch("paintballs", breed, paint("collidee", colour("red"))),
		{ type: "starlogo_touch_end", fields: { BREED: "paintballs", OTHER: breed }, inputs: { DO: inside(paint("collidee", colour("blue"))) } },
	);
}
