/** Words for programs in Blockly's notation. */

export const number = (value) => ({ shadow: { type: "math_number", fields: { NUM: value } } });
export const colour = (name) => ({ block: { type: "starlogo_pick", fields: { COLOUR: name } } });
export const numbers = (from, to) => ({ block: { type: "math_random_int", inputs: { FROM: number(from), TO: number(to) } } });

/** Blocks one below the other. */
export function chain(...blocks) {
	return blocks.reduceRight((next, block) => (next ? { ...block, next: { block: next } } : block), undefined);
}

export const inside = (...blocks) => ({ block: chain(...blocks) });
export const move = (steps) => ({ type: "starlogo_forward", inputs: { STEPS: number(steps) } });
export const turn = (DIRECTION, degrees) => ({ type: "starlogo_turn", fields: { DIRECTION }, inputs: { DEGREES: degrees } });
export const paint = (WHO, COLOUR) => ({ type: "starlogo_colour", fields: { WHO }, inputs: { COLOUR } });
export const size = (value) => ({ type: "starlogo_size", inputs: { SIZE: number(value) } });
export const go = (x, y, z) => ({ type: "starlogo_go", inputs: { X: number(x), Y: number(y), Z: number(z) } });
export const up = (steps) => ({ type: "starlogo_up", inputs: { STEPS: number(steps) } });
export const heading = (value) => ({ type: "starlogo_heading", inputs: { HEADING: number(value) } });
export const scatter = { type: "starlogo_scatter" };
export const create = (count, BREED, SHAPE, ...blocks) => ({ type: "starlogo_create", fields: { BREED, SHAPE }, inputs: { COUNT: number(count), DO: inside(...blocks) } });
export const key = (KEY, MODE, BREED, ...blocks) => ({ type: "starlogo_key", fields: { KEY, MODE, BREED }, inputs: { DO: inside(...blocks) } });
export const each = (BREED, ...blocks) => ({ type: "starlogo_each", fields: { BREED }, inputs: { DO: inside(...blocks) } });
export const touch = (BREED, OTHER, ...blocks) => ({ type: "starlogo_touch_start", fields: { BREED, OTHER }, inputs: { DO: inside(...blocks) } });
export const start = (...blocks) => ({ type: "starlogo_start", inputs: { DO: inside(...blocks) } });
export const remove = (WHO) => ({ type: "starlogo_delete", fields: { WHO } });

export const program = (...scripts) => ({ blocks: { languageVersion: 0, blocks: scripts } });

/** A script that shows its first line only. */
export const folded = (script) => ({ ...script, collapsed: true });
export const field = (type, fields) => ({ block: { type, fields } });
export const along = (steps, BREED) => ({ type: "starlogo_until", fields: { HOW: "slide", BREED }, inputs: { STEPS: number(steps) } });
export const compare = (OP, A, B) => ({ block: { type: "logic_compare", fields: { OP }, inputs: { A, B } } });
export const when = (condition, ...blocks) => ({ type: "controls_if", inputs: { IF0: condition, DO0: inside(...blocks) } });
export const score = (value) => ({ type: "starlogo_score_set", inputs: { SCORE: value } });
export const end = (HOW, TEXT) => ({ type: "starlogo_end", fields: { HOW, TEXT } });
export const goal = (TEXT) => ({ type: "starlogo_goal", fields: { TEXT } });

/** One that stands still, and a ball beside it; who is touched turns red. */
export function nearMiss(shape, scale, x, y, z, ball, ...first) {
	return program(
		start(
			...first,
			create(1, "turtles", shape, size(scale), paint("me", colour("blue"))),
			create(1, "paintballs", "sphere", size(ball), go(x, y, z), paint("me", colour("yellow"))),
		),
		touch("paintballs", "turtles", paint("collidee", colour("red"))),
		{ type: "starlogo_touch_end", fields: { BREED: "paintballs", OTHER: "turtles" }, inputs: { DO: inside(paint("collidee", colour("blue"))) } },
	);
}
