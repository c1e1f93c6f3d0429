/** The playground's blocks and its toolbox, for Blockly. */
import { texts } from "../texts.js";
import { SHAPES } from "../shared/names.js";

const words = texts.blocks;
const options = (table) => Object.entries(table).map(([value, text]) => [text, value]);
const dropdown = (name, list) => ({ type: "field_dropdown", name, options: list });

const BREEDS = options(texts.breeds);
const ANYONE = [...BREEDS, [words.anyBreed, "anyone"]];
const SHAPE = dropdown("SHAPE", SHAPES.map((name) => [texts.shapes[name].toLowerCase(), name]));
const SYSTEM = dropdown("SYSTEM", options(texts.systems).map(([text, value]) => [text.toLowerCase(), value]));
const WHO = dropdown("WHO", [[words.me, "me"], [words.collidee, "collidee"], ...BREEDS.map(([text, value]) => [words.allOf(text), value])]);
const ONE = dropdown("WHO", [[words.me, "me"], [words.collidee, "collidee"]]);
const ON = dropdown("ON", options(words.onOff));
const AS = dropdown("AS", ["tightest", "sphere", "box", "capsule"].map((name) => [name, name]));
const breed = (name) => dropdown(name, name === "OTHER" ? ANYONE : BREEDS);
const input = (name) => ({ type: "input_value", name, check: "Number" });

const STYLES = { event: "event_blocks", collision: "collision_blocks", movement: "movement_blocks", agent: "agent_blocks", look: "look_blocks" };

/** A block: its style, what its words' places take, and what it is. */
const define = (type, style, args, shape) => ({ type, style: STYLES[style], message0: words[type], args0: args, inputsInline: true, ...shape });
const STATEMENT = { previousStatement: null, nextStatement: null };
const BODY = { message1: "%1", args1: [{ type: "input_statement", name: "DO" }] };
const HAT = BODY;

export const DEFINITIONS = [
	define("starlogo_start", "event", [], HAT),
	define("starlogo_each", "event", [breed("BREED")], HAT),
	define("starlogo_key", "event", [dropdown("KEY", options(words.keys)), dropdown("MODE", options(words.modes)), breed("BREED")], HAT),
	define("starlogo_timer", "event", [input("SECONDS"), breed("BREED")], HAT),
	define("starlogo_collision", "collision", [breed("BREED"), breed("OTHER")], HAT),
	define("starlogo_touch_start", "collision", [breed("BREED"), breed("OTHER")], HAT),
	define("starlogo_touch_end", "collision", [breed("BREED"), breed("OTHER")], HAT),
	define("starlogo_system", "collision", [SYSTEM], STATEMENT),
	define("starlogo_hierarchical", "collision", [WHO, ON], STATEMENT),
	define("starlogo_depth", "collision", [WHO, input("DEPTH")], STATEMENT),
	define("starlogo_collide_as", "collision", [WHO, AS], STATEMENT),
	define("starlogo_show", "collision", [WHO, ON], STATEMENT),
	define("starlogo_forward", "movement", [input("STEPS")], STATEMENT),
	define("starlogo_turn", "movement", [dropdown("DIRECTION", options(words.directions)), input("DEGREES")], STATEMENT),
	define("starlogo_up", "movement", [input("STEPS")], STATEMENT),
	define("starlogo_go", "movement", [input("X"), input("Y"), input("Z")], STATEMENT),
	define("starlogo_scatter", "movement", [], STATEMENT),
	define("starlogo_back", "movement", [], STATEMENT),
	define("starlogo_heading", "movement", [input("HEADING")], STATEMENT),
	define("starlogo_create", "agent", [input("COUNT"), breed("BREED"), SHAPE], { ...STATEMENT, ...BODY }),
	define("starlogo_hatch", "agent", [breed("BREED"), SHAPE], { ...STATEMENT, ...BODY }),
	define("starlogo_delete", "agent", [WHO], STATEMENT),
	define("starlogo_trait", "agent", [dropdown("TRAIT", options(words.traits))], { output: "Number" }),
	define("starlogo_size", "look", [input("SIZE")], STATEMENT),
	define("starlogo_colour", "look", [WHO, { type: "input_value", name: "COLOUR", check: "Colour" }], STATEMENT),
	define("starlogo_pick", "look", [dropdown("COLOUR", options(texts.colours))], { output: "Colour" }),
	define("starlogo_any_colour", "look", [], { output: "Colour" }),
	define("starlogo_colour_of", "look", [ONE], { output: "Colour" }),
];

const number = (value) => ({ shadow: { type: "math_number", fields: { NUM: value } } });
const block = (type, inputs) => ({ kind: "block", type, ...(inputs && { inputs: Object.fromEntries(Object.entries(inputs).map(([name, value]) => [name, typeof value === "number" ? number(value) : { block: { type: value } }])) }) });
const category = (name, style, ...contents) => ({ kind: "category", name: words.categories[name], categorystyle: style, contents });

export const TOOLBOX = {
	kind: "categoryToolbox",
	contents: [
		category("events", "event_category", block("starlogo_start"), block("starlogo_each"), block("starlogo_key"), block("starlogo_timer", { SECONDS: 1 })),
		category("collisions", "collision_category", block("starlogo_collision"), block("starlogo_touch_start"), block("starlogo_touch_end"), block("starlogo_system"),
			block("starlogo_hierarchical"), block("starlogo_depth", { DEPTH: 5 }), block("starlogo_collide_as"), block("starlogo_show")),
		category("movement", "movement_category", block("starlogo_forward", { STEPS: 1 }), block("starlogo_turn", { DEGREES: 15 }), block("starlogo_up", { STEPS: 1 }),
			block("starlogo_go", { X: 0, Y: 0, Z: 0 }), block("starlogo_scatter"), block("starlogo_back"), block("starlogo_heading", { HEADING: 90 })),
		category("agents", "agent_category", block("starlogo_create", { COUNT: 1 }), block("starlogo_hatch"), block("starlogo_delete"), block("starlogo_trait")),
		category("looks", "look_category", block("starlogo_colour", { COLOUR: "starlogo_pick" }), block("starlogo_pick"), block("starlogo_any_colour"), block("starlogo_colour_of"), block("starlogo_size", { SIZE: 1 })),
		category("control", "logic_category", block("controls_if"), block("controls_ifelse"), block("controls_repeat_ext", { TIMES: 4 }), block("controls_whileUntil"),
			block("logic_compare"), block("logic_operation"), block("logic_negate"), block("logic_boolean")),
		category("maths", "math_category", block("math_number"), block("math_arithmetic", { A: 1, B: 1 }), block("math_random_int", { FROM: 1, TO: 10 }), block("math_modulo", { DIVIDEND: 10, DIVISOR: 3 })),
		{ kind: "category", name: words.categories.variables, categorystyle: "variable_category", custom: "VARIABLE" },
	],
};

/** The colours of the styles: for white words on all of them. */
const COLOURS = { event: "#9a6200", collision: "#b3384a", movement: "#2c66c9", agent: "#2d7a46", look: "#7a4bb5", logic: "#3d6a80", loop: "#3d6a80", math: "#57606e", variable: "#8a4a2c" };

export const BLOCK_STYLES = Object.fromEntries(Object.entries(COLOURS).map(([name, colour]) => [`${name}_blocks`, { colourPrimary: colour }]));
export const CATEGORY_STYLES = Object.fromEntries(Object.entries(COLOURS).map(([name, colour]) => [`${name}_category`, { colour }]));
