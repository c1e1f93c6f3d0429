/** The playground's blocks and its toolbox, for Blockly. */
import { Collision } from "starlogo-collision";
import { texts } from "../../shared/language.js";
import { SHAPES } from "../../shared/names.js";
import { number } from "../builtin/notation.js";

const words = texts.blocks;
const options = (table) => Object.entries(table).map(([value, text]) => [text, value]);
const dropdown = (name, list) => ({ type: "field_dropdown", name, options: list });

/** The first shape of a breed's agents. */
export const SHAPE_OF = {
	bears: "bear", turtles: "turtle", seagulls: "seagull", walls: "wall", paintballs: "sphere", people: "person", dragons: "dragon", firemen: "fireman", trees: "tree", kelp: "kelp",
	fortresses: "fortress", spaceships: "spaceship", platforms: "platform", coins: "coin", houses: "house", rocks: "rock", keys: "key", cars: "car", lifts: "platform",
};
/** The breeds in menus, also the user's own. Programs add theirs. */
export const breeds = ["bears", "turtles", "seagulls", "walls", "paintballs", "platforms", "coins", "rocks", "houses", "keys", "cars"];
/** The shapes in menus. */
export const shapes = [...SHAPES];
/** The menu's entry that asks for the name of a new breed. */
export const NEW_BREED = "new breed";

const nameOf = (table, value) => table[value] ?? value;
const breedOptions = () => breeds.map((name) => [nameOf(texts.breeds, name), name]);
const newBreed = [words.newBreed, NEW_BREED];
export const MENUS = {
	BREED: () => [...breedOptions(), newBreed],
	ANYONE: () => [...breedOptions(), [words.anyBreed, "anyone"], newBreed],
	OTHER: () => [...breedOptions(), [words.anyBreed, "anyone"], [words.theGround, Collision.TERRAIN], [words.theEdge, Collision.EDGE], newBreed],
	FLOOR: () => [[words.anything, "anyone"], [words.theGround, Collision.TERRAIN], ...breedOptions()],
	WHO: () => [[words.me, "me"], [words.collidee, "collidee"], ...breedOptions().map(([text, value]) => [words.allOf(text), value])],
	SHAPE: () => shapes.map((name) => [texts.inSentence(nameOf(texts.shapes, name)), name]),
};

/**
 * Adds the breeds and shapes that a program names to the menus.
 *
 * @param {string} field BREED, OTHER, WHO or SHAPE
 * @param {string} value
 */
export function addToMenu(field, value) {
	const list = field === "SHAPE" ? shapes : breeds;
	const isThere = (kind) => MENUS[kind]().some(([, each]) => each === value);
	if (field in MENUS && typeof value === "string" && value !== NEW_BREED && !isThere(field) && !isThere("OTHER")) list.push(value);
}

/** Adds everything that a program names to the menus. */
export function addToMenus(program) {
	JSON.stringify(program, (key, value) => {
		addToMenu(key, value);
		return value;
	});
}

/** A menu whose options may grow. `menu` gives its options when it opens. */
const menu = (name, kind = name) => ({ ...dropdown(name, MENUS[kind]()), menu: kind });
const SHAPE = menu("SHAPE");
const SYSTEM = dropdown("SYSTEM", options(texts.systems).map(([text, value]) => [texts.inSentence(text), value]));
const WHO = menu("WHO");
const ONE = dropdown("WHO", [[words.me, "me"], [words.collidee, "collidee"]]);
const ON = dropdown("ON", options(words.onOff));
const AS = dropdown("AS", options(words.structures));
const KEY = dropdown("KEY", options(words.keys));
const anyone = menu("BREED", "ANYONE");
const text = (value, name = "TEXT") => ({ type: "field_input", name, text: value });
const MESSAGE = text(words.someMessage, "MESSAGE");
const OWN = text(words.someOwn, "NAME");
const SIDE = dropdown("SIDE", options(words.sides));
const AGENT = { type: "input_value", name: "AGENT", check: "Agent" };
const COLOUR = { type: "input_value", name: "COLOUR", check: ["Colour", "Number"] };
const input = (name) => ({ type: "input_value", name, check: "Number" });

/** A block: its style, its arguments, and its shape. */
const define = (type, style, args, shape) => ({ type, style: `${style}_blocks`, message0: words[type], args0: args, inputsInline: true, ...shape });
const STATEMENT = { previousStatement: null, nextStatement: null };
const NUMBER = { output: "Number" };
const TRUTH = { output: "Boolean" };
const BODY = { message1: "%1", args1: [{ type: "input_statement", name: "DO" }] };
const HAT = BODY;
const truth = (name) => ({ type: "input_value", name, check: "Boolean" });
const VARIABLE = { type: "field_variable", name: "VAR", variable: words.variable };
/** Inputs for blocks, the second one after a word. */
const then = (first, second) => ({
	message1: "%1", args1: [{ type: "input_statement", name: first }], ...(second && { message2: words.otherwise, args2: [{ type: "input_statement", name: second }] }),
});

export const DEFINITIONS = [
	define("starlogo_start", "event", [], HAT),
	define("starlogo_each", "event", [menu("BREED")], HAT),
	define("starlogo_key", "event", [KEY, dropdown("MODE", options(words.modes)), menu("BREED")], HAT),
	define("starlogo_timer", "event", [input("SECONDS"), menu("BREED")], HAT),
	define("starlogo_click", "event", [anyone], HAT),
	define("starlogo_receive", "event", [MESSAGE, anyone], HAT),
	define("starlogo_broadcast", "event", [MESSAGE], STATEMENT),
	define("starlogo_own_set", "variable", [OWN, { type: "input_value", name: "VALUE" }], STATEMENT),
	define("starlogo_own_change", "variable", [OWN, input("DELTA")], STATEMENT),
	define("starlogo_own", "variable", [OWN], { output: null }),
	define("starlogo_own_show", "variable", [OWN, ON], STATEMENT),
	define("starlogo_collision", "collision", [menu("BREED"), menu("OTHER")], HAT),
	define("starlogo_touch_start", "collision", [menu("BREED"), menu("OTHER")], HAT),
	define("starlogo_touch_end", "collision", [menu("BREED"), menu("OTHER")], HAT),
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
	define("starlogo_stand", "movement", [], STATEMENT),
	define("starlogo_solid", "collision", [menu("BREED"), ON], STATEMENT),
	define("starlogo_push", "collision", [], STATEMENT),
	define("starlogo_side", "collision", [ONE, SIDE], TRUTH),
	define("starlogo_touch", "collision", [dropdown("TOUCH", options(words.touch))], NUMBER),
	define("starlogo_walk", "movement", [input("STEPS")], STATEMENT),
	define("starlogo_jump", "movement", [input("HEIGHT")], STATEMENT),
	define("starlogo_fall", "movement", [], STATEMENT),
	define("starlogo_edge", "movement", [dropdown("HOW", options(words.edgeWays))], STATEMENT),
	define("starlogo_at_edge", "sense", [dropdown("EDGE", options(words.edges))], TRUTH),
	define("starlogo_standing", "sense", [menu("BREED", "FLOOR")], TRUTH),
	define("starlogo_floor", "sense", [], { output: "Agent" }),
	define("starlogo_ahead", "sense", [anyone, input("DISTANCE")], { output: "Agent" }),
	define("starlogo_free", "sense", [anyone, input("DISTANCE")], NUMBER),
	define("starlogo_mound", "game", [input("HEIGHT"), input("WIDTH")], STATEMENT),
	define("starlogo_wall", "game", [input("HEIGHT")], STATEMENT),
	define("starlogo_raise", "game", [input("HEIGHT"), input("X"), input("Y")], STATEMENT),
	define("starlogo_flat", "game", [], STATEMENT),
	define("starlogo_ground_height", "sense", [], NUMBER),
	define("starlogo_on_ground", "sense", [], TRUTH),
	define("starlogo_create", "agent", [input("COUNT"), menu("BREED"), SHAPE], { ...STATEMENT, ...BODY }),
	define("starlogo_hatch", "agent", [menu("BREED"), SHAPE], { ...STATEMENT, ...BODY }),
	define("starlogo_delete", "agent", [WHO], STATEMENT),
	define("starlogo_trait", "agent", [dropdown("TRAIT", options(words.traits))], NUMBER),
	define("starlogo_ask", "agent", [AGENT], { ...STATEMENT, ...BODY }),
	define("starlogo_become", "agent", [WHO, menu("BREED")], STATEMENT),
	define("starlogo_agent", "agent", [ONE], { output: "Agent" }),
	define("starlogo_size", "look", [input("SIZE")], STATEMENT),
	define("starlogo_colour", "look", [WHO, COLOUR], STATEMENT),
	define("starlogo_say", "look", [{ type: "input_value", name: "TEXT" }], STATEMENT),
	define("starlogo_pick", "look", [dropdown("COLOUR", options(texts.colours))], { output: "Colour" }),
	define("starlogo_any_colour", "look", [], { output: "Colour" }),
	define("starlogo_colour_of", "look", [ONE], { output: "Colour" }),
	define("starlogo_sweep", "collision", [WHO, ON], STATEMENT),
	define("starlogo_bounce", "collision", [], STATEMENT),
	define("starlogo_until", "movement", [input("STEPS"), dropdown("HOW", options(words.ways)), anyone], STATEMENT),
	define("starlogo_face", "movement", [AGENT], STATEMENT),
	define("starlogo_count", "sense", [anyone, input("DISTANCE")], NUMBER),
	define("starlogo_number_of", "sense", [anyone, COLOUR], NUMBER),
	define("starlogo_nearest", "sense", [anyone, input("DISTANCE")], { output: "Agent" }),
	define("starlogo_distance", "sense", [AGENT], NUMBER),
	define("starlogo_can_see", "sense", [AGENT], TRUTH),
	define("starlogo_touching", "sense", [anyone], TRUTH),
	define("starlogo_key_down", "sense", [KEY], TRUTH),
	define("starlogo_mouse", "sense", [dropdown("MOUSE", options(words.mouse))], { output: null }),
	define("starlogo_goal", "game", [text(words.someGoal)], STATEMENT),
	define("starlogo_ground", "game", [dropdown("GROUND", options(words.grounds))], STATEMENT),
	define("starlogo_score_set", "game", [input("SCORE")], STATEMENT),
	define("starlogo_score_change", "game", [input("SCORE")], STATEMENT),
	define("starlogo_score", "game", [], NUMBER),
	define("starlogo_clock", "game", [], NUMBER),
	define("starlogo_limit", "game", [input("SECONDS"), text(words.timeOver)], STATEMENT),
	define("starlogo_sound", "look", [dropdown("SOUND", options(words.sounds))], STATEMENT),
	define("starlogo_note", "look", [input("NOTE")], STATEMENT),
	define("starlogo_end", "game", [dropdown("HOW", options(words.ends)), text(words.someEnd)], STATEMENT),
	define("starlogo_wait", "logic", [input("SECONDS")], STATEMENT),
	// blocks that Blockly has too, under its names
	define("controls_if", "logic", [truth("IF0")], { ...STATEMENT, ...then("DO0"), mutator: "branches" }),
	define("controls_ifelse", "logic", [truth("IF0")], { ...STATEMENT, ...then("DO0", "ELSE") }),
	define("controls_repeat_ext", "logic", [input("TIMES")], { ...STATEMENT, ...BODY }),
	define("controls_whileUntil", "logic", [dropdown("MODE", options(words.loopModes)), truth("BOOL")], { ...STATEMENT, ...BODY }),
	define("logic_compare", "logic", [{ type: "input_value", name: "A" }, dropdown("OP", options(words.comparisons)), { type: "input_value", name: "B" }], TRUTH),
	define("logic_operation", "logic", [truth("A"), dropdown("OP", options(words.operations)), truth("B")], TRUTH),
	define("logic_negate", "logic", [truth("BOOL")], TRUTH),
	define("logic_boolean", "logic", [dropdown("BOOL", options(words.truths))], TRUTH),
	define("math_number", "math", [{ type: "field_number", name: "NUM", value: 0 }], NUMBER),
	define("math_arithmetic", "math", [input("A"), dropdown("OP", options(words.arithmetic)), input("B")], NUMBER),
	define("math_random_int", "math", [input("FROM"), input("TO")], NUMBER),
	define("math_modulo", "math", [input("DIVIDEND"), input("DIVISOR")], NUMBER),
	define("text", "text", [text("")], { output: "String" }),
	define("variables_get", "variable", [VARIABLE], { output: null }),
	define("variables_set", "variable", [VARIABLE, { type: "input_value", name: "VALUE" }], STATEMENT),
	define("math_change", "variable", [VARIABLE, input("DELTA")], STATEMENT),
];

/** The content of an input in the toolbox: a number, “true”, a text, or a block by its type. */
function contentOf(value) {
	if (typeof value === "number") return number(value);
	if (value === true) return { shadow: { type: "logic_boolean", fields: { BOOL: "TRUE" } } };
	if (value === NEAREST) return { block: { type: value, inputs: { DISTANCE: number(10) } } };
	return value.startsWith("starlogo") ? { block: { type: value } } : { shadow: { type: "text", fields: { TEXT: value } } };
}

/** What a drawer has for variables, as Blockly makes it, with a number in “set”. */
export const variableDrawer = (items) => [...items.map((item) => (item.type === "variables_set" ? { ...item, inputs: { VALUE: number(0) } } : item)), ...OWN_BLOCKS()];

const block = (type, inputs, fields) => ({ kind: "block", type, ...(fields && { fields }), ...(inputs && { inputs: Object.fromEntries(Object.entries(inputs).map(([name, value]) => [name, contentOf(value)])) }) });
const category = (name, ...contents) => ({ kind: "category", name: words.categories[name], categorystyle: `${STYLE_OF[name] ?? name}_category`, cssconfig: { icon: `icon icon-${name}` }, contents });
/** The blocks about variables of an agent. */
const OWN_BLOCKS = () => [block("starlogo_own_set", { VALUE: 3 }), block("starlogo_own_change", { DELTA: -1 }), block("starlogo_own"), block("starlogo_own_show")];
const STYLE_OF = { events: "event", collisions: "collision", senses: "sense", agents: "agent", looks: "look", control: "logic", maths: "math", variables: "variable" };
const NEAREST = "starlogo_nearest";

export const TOOLBOX = {
	kind: "categoryToolbox",
	contents: [
		category("events", block("starlogo_start"), block("starlogo_each"), block("starlogo_key"), block("starlogo_timer", { SECONDS: 1 }), block("starlogo_click"), block("starlogo_receive"), block("starlogo_broadcast")),
		category("collisions", block("starlogo_collision"), block("starlogo_touch_start"), block("starlogo_touch_end"), block("starlogo_bounce"), block("starlogo_push"), block("starlogo_side"), block("starlogo_touch"), block("starlogo_solid", null, { BREED: "walls" }), block("starlogo_sweep"), block("starlogo_system"),
			block("starlogo_hierarchical"), block("starlogo_depth", { DEPTH: 5 }), block("starlogo_collide_as"), block("starlogo_show")),
		category("movement", block("starlogo_forward", { STEPS: 0.1 }), block("starlogo_walk", { STEPS: 0.1 }), block("starlogo_jump", { HEIGHT: 3 }), block("starlogo_fall"), block("starlogo_until", { STEPS: 0.1 }), block("starlogo_turn", { DEGREES: 5 }), block("starlogo_face", { AGENT: NEAREST }),
			block("starlogo_heading", { HEADING: 90 }), block("starlogo_up", { STEPS: 0.1 }), block("starlogo_go", { X: 0, Y: 0, Z: 0 }), block("starlogo_stand"), block("starlogo_edge"), block("starlogo_scatter"), block("starlogo_back")),
		category("senses", block("starlogo_count", { DISTANCE: 5 }), block("starlogo_number_of", { COLOUR: "starlogo_pick" }), block(NEAREST, { DISTANCE: 10 }), block("starlogo_distance", { AGENT: NEAREST }),
			block("starlogo_can_see", { AGENT: NEAREST }), block("starlogo_touching"), block("starlogo_ahead", { DISTANCE: 3 }), block("starlogo_free", { DISTANCE: 10 }), block("starlogo_standing"), block("starlogo_floor"), block("starlogo_at_edge"), block("starlogo_on_ground"), block("starlogo_ground_height"), block("starlogo_key_down"), block("starlogo_mouse")),
		category("agents", block("starlogo_create", { COUNT: 1 }, { BREED: "bears", SHAPE: "bear" }), block("starlogo_hatch", null, { BREED: "paintballs", SHAPE: "sphere" }), block("starlogo_delete"), block("starlogo_ask", { AGENT: NEAREST }), block("starlogo_become"), block("starlogo_trait"), block("starlogo_agent")),
		category("looks", block("starlogo_colour", { COLOUR: "starlogo_pick" }), block("starlogo_pick"), block("starlogo_any_colour"), block("starlogo_colour_of"), block("starlogo_size", { SIZE: 1 }), block("starlogo_say", { TEXT: words.hello }), block("starlogo_sound"), block("starlogo_note", { NOTE: 60 })),
		category("game", block("starlogo_goal"), block("starlogo_score_change", { SCORE: 1 }), block("starlogo_score_set", { SCORE: 0 }), block("starlogo_score"), block("starlogo_clock"), block("starlogo_limit", { SECONDS: 60 }), block("starlogo_ground"), block("starlogo_mound", { HEIGHT: 2, WIDTH: 6 }), block("starlogo_wall", { HEIGHT: 1 }), block("starlogo_raise", { HEIGHT: 1, X: 0, Y: 0 }), block("starlogo_flat"), block("starlogo_end")),
		category("control", block("controls_if"), block("controls_ifelse"), block("starlogo_wait", { SECONDS: 1 }), block("controls_repeat_ext", { TIMES: 4 }), block("controls_whileUntil"),
			block("logic_compare", { A: 0, B: 0 }), block("logic_operation", { A: true, B: true }), block("logic_negate", { BOOL: true }), block("logic_boolean")),
		category("maths", block("math_number"), block("math_arithmetic", { A: 1, B: 1 }), block("math_random_int", { FROM: 1, TO: 10 }), block("math_modulo", { DIVIDEND: 10, DIVISOR: 3 })),
		{ ...category("variables"), custom: "VARIABLE" },
	],
};

/** The colours of the styles. White words are readable on all of them. */
const COLOURS = { event: "#9a6200", collision: "#b3384a", movement: "#2c66c9", sense: "#0b7285", agent: "#2d7a46", look: "#7a4bb5", game: "#a8326e", logic: "#3d6a80", loop: "#3d6a80", math: "#57606e", text: "#57606e", variable: "#8a4a2c" };

export const BLOCK_STYLES = Object.fromEntries(Object.entries(COLOURS).map(([name, colour]) => [`${name}_blocks`, { colourPrimary: colour }]));
export const CATEGORY_STYLES = Object.fromEntries(Object.entries(COLOURS).map(([name, colour]) => [`${name}_category`, { colour }]));

/** The breeds that a program creates, then those that it throws, with their shapes. */
function castOf(program) {
	const cast = new Map();
	for (const type of ["starlogo_create", "starlogo_hatch"]) JSON.stringify(program, (key, value) => {
		if (value?.type === type && !cast.has(value.fields.BREED)) cast.set(value.fields.BREED, value.fields.SHAPE);
		return value;
	});
	return cast;
}

/**
 * The blocks of a drawer for a program: they name its breeds. A block about others names the second breed, or the second one with scripts.
 *
 * @param {object[]} items the drawer's blocks, which do not change
 * @param {object} program in Blockly's notation
 */
export function drawerFor(items, program) {
	const cast = castOf(program);
	const [first, ...others] = cast.keys();
	const acting = new Set(program.blocks?.blocks?.map(({ fields }) => fields?.BREED));
	const second = others.find((breed) => acting.has(breed)) ?? others[0] ?? first;
	if (first === undefined) return items;
	return items.map((item) => JSON.parse(JSON.stringify(item), (key, value) => {
		const names = DEFINITIONS.find(({ type }) => type === value?.type)?.args0.map(({ name }) => name);
		if (!names) return value;
		const fields = { ...value.fields };
		if (names.includes("BREED")) fields.BREED = OF_OTHERS.test(value.type) ? second : first;
		if (names.includes("OTHER")) fields.OTHER = second;
		if (names.includes("SHAPE")) fields.SHAPE = cast.get(fields.BREED);
		// at the start there is no “me” whose trait could be set
		if (OF_ALL.test(value.type)) fields.WHO = first;
		return { ...value, fields };
	}));
}

/** Blocks about other agents than me, and blocks that are put at a game's start for all of a breed. */
const OF_OTHERS = /^starlogo_(until|count|number_of|nearest|touching|become|hatch)$/;
const OF_ALL = /^starlogo_(hierarchical|depth|collide_as|show|sweep)$/;
