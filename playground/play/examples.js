/** The programs that the playground brings, in Blockly's notation. */

import { texts } from "../texts.js";

const number = (value) => ({ shadow: { type: "math_number", fields: { NUM: value } } });
const colour = (name) => ({ block: { type: "starlogo_pick", fields: { COLOUR: name } } });
const numbers = (from, to) => ({ block: { type: "math_random_int", inputs: { FROM: number(from), TO: number(to) } } });

/** Blocks one below the other. */
function chain(...blocks) {
	return blocks.reduceRight((next, block) => (next ? { ...block, next: { block: next } } : block), undefined);
}

const inside = (...blocks) => ({ block: chain(...blocks) });
const move = (steps) => ({ type: "starlogo_forward", inputs: { STEPS: number(steps) } });
const turn = (DIRECTION, degrees) => ({ type: "starlogo_turn", fields: { DIRECTION }, inputs: { DEGREES: degrees } });
const paint = (WHO, COLOUR) => ({ type: "starlogo_colour", fields: { WHO }, inputs: { COLOUR } });
const size = (value) => ({ type: "starlogo_size", inputs: { SIZE: number(value) } });
const go = (x, y, z) => ({ type: "starlogo_go", inputs: { X: number(x), Y: number(y), Z: number(z) } });
const up = (steps) => ({ type: "starlogo_up", inputs: { STEPS: number(steps) } });
const heading = (value) => ({ type: "starlogo_heading", inputs: { HEADING: number(value) } });
const scatter = { type: "starlogo_scatter" };
const create = (count, BREED, SHAPE, ...blocks) => ({ type: "starlogo_create", fields: { BREED, SHAPE }, inputs: { COUNT: number(count), DO: inside(...blocks) } });
const key = (KEY, MODE, BREED, ...blocks) => ({ type: "starlogo_key", fields: { KEY, MODE, BREED }, inputs: { DO: inside(...blocks) } });
const each = (BREED, ...blocks) => ({ type: "starlogo_each", fields: { BREED }, inputs: { DO: inside(...blocks) } });
const touch = (BREED, OTHER, ...blocks) => ({ type: "starlogo_touch_start", fields: { BREED, OTHER }, inputs: { DO: inside(...blocks) } });
const start = (...blocks) => ({ type: "starlogo_start", inputs: { DO: inside(...blocks) } });
const remove = (WHO) => ({ type: "starlogo_delete", fields: { WHO } });

const program = (...scripts) => ({ blocks: { languageVersion: 0, blocks: scripts } });

/** A script that shows its first line only. */
const folded = (script) => ({ ...script, collapsed: true });
const field = (type, fields) => ({ block: { type, fields } });
const along = (steps, BREED) => ({ type: "starlogo_until", fields: { HOW: "slide", BREED }, inputs: { STEPS: number(steps) } });
const compare = (OP, A, B) => ({ block: { type: "logic_compare", fields: { OP }, inputs: { A, B } } });
const when = (condition, ...blocks) => ({ type: "controls_if", inputs: { IF0: condition, DO0: inside(...blocks) } });
const score = (value) => ({ type: "starlogo_score_set", inputs: { SCORE: value } });
const end = (HOW, TEXT) => ({ type: "starlogo_end", fields: { HOW, TEXT } });
const goal = (TEXT) => ({ type: "starlogo_goal", fields: { TEXT } });

const splash = [paint("collidee", { block: { type: "starlogo_colour_of", fields: { WHO: "me" } } }), remove("me")];
const TURTLES = 10;
const unpainted = { block: { type: "starlogo_number_of", fields: { BREED: "turtles" }, inputs: { COLOUR: colour("own") } } };
const words = texts.programs;

const paintball = program(
	key("space", "pressed", "bears", { type: "starlogo_hatch", fields: { BREED: "paintballs", SHAPE: "sphere" }, inputs: { DO: inside(paint("me", { block: { type: "starlogo_any_colour" } }), size(0.4), up(0.8), move(1)) } }),
	touch("paintballs", "turtles", ...splash),
	each("bears",
		score({ block: { type: "math_arithmetic", fields: { OP: "MINUS" }, inputs: { A: number(TURTLES), B: unpainted } } }),
		when(compare("EQ", unpainted, number(0)), end("won", words.allPainted))),
	each("turtles", move(0.02), turn("left", numbers(-4, 4))),
	folded(start(
		goal(words.paintball),
		create(1, "bears", "bear", size(1.4), heading(0)),
		create(TURTLES, "turtles", "turtle", scatter, size(1.6)),
		create(6, "seagulls", "seagull", scatter, up(1.6), size(1.8)),
		create(5, "walls", "wall", scatter, size(4)),
	)),
	folded(key("up", "held", "bears", along(0.12, "walls"))),
	folded(key("down", "held", "bears", along(-0.08, "walls"))),
	folded(key("left", "held", "bears", turn("left", number(3)))),
	folded(key("right", "held", "bears", turn("right", number(3)))),
	folded(each("paintballs", move(0.25), when(compare("GT", field("starlogo_trait", { TRAIT: "age" }), number(1.5)), remove("me")))),
	folded(each("seagulls", move(0.05), turn("right", number(1)))),
	folded(touch("paintballs", "seagulls", ...splash)),
	folded(touch("paintballs", "walls", ...splash)),
	folded({ type: "starlogo_collision", fields: { BREED: "turtles", OTHER: "walls" }, inputs: { DO: inside({ type: "starlogo_bounce" }) } }),
);

/** One that stands still, and a ball beside it; who is touched turns red. */
function nearMiss(shape, scale, x, y, z, ball) {
	return program(
		start(
			create(1, "turtles", shape, size(scale), paint("me", colour("blue"))),
			create(1, "paintballs", "sphere", size(ball), go(x, y, z), paint("me", colour("yellow"))),
		),
		touch("paintballs", "turtles", paint("collidee", colour("red"))),
		{ type: "starlogo_touch_end", fields: { BREED: "paintballs", OTHER: "turtles" }, inputs: { DO: inside(paint("collidee", colour("blue"))) } },
	);
}

export const EXAMPLES = {
	paintball,
	// all of the helmet is above the unit sphere
	helmet: nearMiss("fireman", 3, 0, 0, 6.6, 0.6),
	// in the box around the dragon, and nowhere near its body
	wing: nearMiss("dragon", 8, 0.8, -2.6, 0.4, 0.8),
	// in the unit sphere of the wall, and a good way from it
	wall: nearMiss("wall", 6, 1.5, 0, 1.5, 0.6),
};
