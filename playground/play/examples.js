/** The programs that the playground brings, in Blockly's notation. */

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

const hit = (breed) => touch("paintballs", breed, paint("collidee", { block: { type: "starlogo_colour_of", fields: { WHO: "me" } } }), remove("me"));

const paintball = program(
	start(
		create(1, "bears", "bear", paint("me", colour("brown")), size(1.4), heading(0)),
		create(10, "turtles", "turtle", scatter, paint("me", colour("green")), size(1.5)),
		create(6, "seagulls", "seagull", scatter, up(0.8), paint("me", colour("white")), size(1.8)),
		create(5, "walls", "wall", scatter, paint("me", colour("grey")), size(4)),
	),
	key("up", "held", "bears", move(0.12)),
	key("down", "held", "bears", move(-0.08)),
	key("left", "held", "bears", turn("left", number(3))),
	key("right", "held", "bears", turn("right", number(3))),
	key("space", "pressed", "bears", { type: "starlogo_hatch", fields: { BREED: "paintballs", SHAPE: "sphere" }, inputs: { DO: inside(size(0.3), up(0.5), move(0.9), paint("me", { block: { type: "starlogo_any_colour" } })) } }),
	each("paintballs", move(0.25), {
		type: "controls_if",
		inputs: { IF0: { block: { type: "logic_compare", fields: { OP: "GT" }, inputs: { A: { block: { type: "starlogo_trait", fields: { TRAIT: "age" } } }, B: number(1.5) } } }, DO0: inside(remove("me")) },
	}),
	each("turtles", move(0.02), turn("left", numbers(-4, 4))),
	each("seagulls", move(0.05), turn("right", number(1))),
	hit("turtles"),
	hit("seagulls"),
	hit("walls"),
	{ type: "starlogo_collision", fields: { BREED: "bears", OTHER: "walls" }, inputs: { DO: inside({ type: "starlogo_back" }) } },
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
