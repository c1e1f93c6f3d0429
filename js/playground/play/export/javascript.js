/**
 * Writes a program of blocks as a JavaScript module for the npm package. It plays the same game: in every frame the same agents are at the
 * same places.
 */
import { Collision, CollisionBlocks } from "starlogo-collision";
import { BUILT_IN, INSTALL } from "../../shared/names.js";
import { COLOURS } from "../game/colours.js";
import { BEING, ENGINE, HELPERS, INSIDE_EDGES, hex } from "./javascriptparts.js";
import { HALF_WIDTH } from "../game/moves.js";
import { FRAMES_A_SECOND } from "../game/world.js";

const INDENT = "\t";
const text = JSON.stringify;
const NAME = /^[a-z_$][\w$]*$/i;

/** The classes that a module may import from the package. */
const CLASSES = ["Agent", "BuiltInModel", "Collision", "CollisionBlocks", "ContactBlocks", "DetectionBlocks", "GreatLand", "Model", "Terrain", "TerrainBlocks", "TraitBlocks", "WalkBlocks", "WorldBounds"];

const RESERVED = { anyone: "Collision.ANY_BREED", [Collision.TERRAIN]: "Collision.TERRAIN", [Collision.EDGE]: "Collision.EDGE" };
const breedOf = (field) => RESERVED[field] ?? text(field);
/** Lines that a module has only if it needs them. */
const linesIf = (isNeeded, ...lines) => (isNeeded ? lines : []);

/** A member of an object, by a name that a user has written. */
const memberOf = (object, name) => (NAME.test(name) ? `${object}.${name}` : `${object}[${text(name)}]`);

/** The block in an input, or its shadow. */
const inputOf = ({ inputs }, name) => inputs?.[name]?.block ?? inputs?.[name]?.shadow;

/** Blocks whose value may be a text: their variable, or what they say. */
const MAY_BE_TEXT = new Set(["variables_get", "starlogo_own", "math_change", "starlogo_own_change", "text"]);

/**
 * A block at its place in a script: with the names of its agent and of the collidee, and the depth of nesting. `whole` has the names of the program's
 * variables, and of the function that moves forward. The block's parts are texts of JavaScript.
 */
class Writing {
	constructor(block, whole, me, collidee, depth = 0) {
		Object.assign(this, { block, whole, me, collidee, depth, fields: block.fields });
	}

	/** The value of an input as an expression. */
	value(name, missing = "0") {
		const input = inputOf(this.block, name);
		return input ? VALUES[input.type](new Writing(input, this.whole, this.me, this.collidee, this.depth)) : missing;
	}

	/** The value of an input as an expression that is a number. */
	number(name) {
		return this.#asNumber(this.value(name), inputOf(this.block, name));
	}

	/** The present value of the variable that the block changes, as a number. */
	numberOf(variable) {
		return this.#asNumber(variable, this.block);
	}

	/** A variable may hold the text of a number. */
	#asNumber(expression, { type } = {}) {
		return this.whole.keepsTexts && MAY_BE_TEXT.has(type) ? `Number(${bare(expression)})` : expression;
	}

	/** The statements of an input, in one or more lines. If they are about another agent, it has a name of its own. */
	body(name, me = null) {
		const [whose, depth] = me === null ? [this.me, this.depth] : [me, this.depth + 1];
		const lines = [];
		for (let each = this.block.inputs?.[name]?.block; each; each = each.next?.block) {
			if (each.enabled !== false && !(each.disabledReasons?.length > 0)) lines.push(STATEMENTS[each.type](new Writing(each, this.whole, whose, this.collidee, depth)));
		}
		return lines.flat().map((line) => INDENT + line);
	}

	/** Another name for an agent, at each depth. */
	named(name) {
		return this.depth > 0 ? name + (this.depth + 1) : name;
	}

	/** The line of a statement about me, the collidee or a breed. `line` is called with the agent's name. */
	whom(line) {
		return this.isOfBreed ? `for (const one of all(${this.who})) ${line("one")}` : line(this.who);
	}

	get isOfBreed() {
		return !["me", "collidee"].includes(this.fields.WHO);
	}

	/** The subject of the block: the name of an agent, or a breed. */
	get who() {
		return this.isOfBreed ? text(this.fields.WHO) : this[this.fields.WHO];
	}

	get breed() {
		return breedOf(this.fields.BREED);
	}

	get other() {
		return breedOf(this.fields.OTHER);
	}

	/** The variable of the program that the block is about. */
	get variable() {
		const { id } = this.fields.VAR;
		return memberOf("variables", this.whole.names.get(id) ?? id);
	}

	/** The variable of the agent that the block is about. */
	get own() {
		return memberOf(`${this.me}.own`, this.fields.NAME);
	}
}

/** An expression without its outer brackets. */
function bare(expression) {
	if (!expression.startsWith("(")) return expression;
	let depth = 0;
	const end = [...expression].findIndex((letter) => {
		depth += letter === "(" ? 1 : letter === ")" ? -1 : 0;
		return depth === 0;
	});
	return end === expression.length - 1 ? expression.slice(1, -1) : expression;
}

/** The head of a loop with this count, a number or an expression. */
function rounds(count, lines) {
	const isNumber = /^[\d.]+$/.test(count);
	if (isNumber && Math.floor(count) === 1) return null;
	return [isNumber ? `for (let i = 0; i < ${Math.floor(count)}; i++) {` : `for (let i = 1, rounds = ${count}; i <= rounds; i++) {`, ...lines, "}"];
}

/** Creates a new agent, and runs the block's content for it. */
function creating(it, parent) {
	const agent = it.named("agent");
	const inner = it.body("DO", agent);
	const make = `add(${text(it.fields.SHAPE)}, ${text(it.fields.BREED)}${parent ? `, ${parent}` : ""})`;
	return inner.length > 0 ? [`${INDENT}const ${agent} = ${make};`, ...inner] : [`${INDENT}${make};`];
}

const STATEMENTS = {
	starlogo_system: ({ fields }) => `useSystem(${text(fields.SYSTEM)});`,
	starlogo_hierarchical: (it) => `traits.setHierarchical(${it.who}, ${it.fields.ON === "on"});`,
	starlogo_depth: (it) => `traits.setCollisionDepth(${it.who}, ${it.number("DEPTH")});`,
	starlogo_collide_as: (it) => `traits.collideAs(${it.who}, ${text(it.fields.AS)});`,
	starlogo_show: () => "// bounding structures are shown where there is a picture",
	starlogo_sweep: (it) => {
		const isOn = it.fields.ON === "on";
		return it.isOfBreed ? `sweep(${it.who}, ${isOn});` : `${it.who}.sweeps = ${isOn};`;
	},
	starlogo_until: (it) => `advance(${it.me}, ${it.number("STEPS")}, ${it.breed}, ${text(it.fields.HOW)});`,
	starlogo_face: (it) => `face(${it.me}, ${it.value("AGENT", "null")});`,
	starlogo_bounce: ({ me, collidee }) => `bounce(${me}, ${collidee});`,
	starlogo_become: (it) => it.whom((agent) => `become(${agent}, ${text(it.fields.BREED)});`),
	starlogo_say: (it) => `${it.me}.said = String(${it.value("TEXT", "\"\"")});`,
	starlogo_score_set: (it) => `game.score = ${it.number("SCORE")};`,
	starlogo_score_change: (it) => `game.score += ${it.number("SCORE")};`,
	starlogo_goal: ({ fields }) => `game.goal = ${text(fields.TEXT)};`,
	starlogo_ground: ({ fields }) => `game.ground = ${text(fields.GROUND)};`,
	starlogo_limit: (it) => `game.limit = { until: game.frame + Math.max(1, Math.round(${it.number("SECONDS")} * ${FRAMES_A_SECOND})), text: ${text(it.fields.TEXT)} };`,
	starlogo_sound: ({ fields }) => `// here the game plays the sound ${text(fields.SOUND)}`,
	starlogo_note: (it) => `// here the game plays the note ${it.value("NOTE")}`,
	starlogo_end: ({ fields }) => `game.ended ??= { how: ${text(fields.HOW)}, text: ${text(fields.TEXT)} };`,
	starlogo_forward: (it) => `${it.whole.forward}(${it.me}, ${it.number("STEPS")});`,
	starlogo_turn: (it) => `${it.me}.heading ${it.fields.DIRECTION === "left" ? "+=" : "-="} ${it.number("DEGREES")};`,
	starlogo_up: (it) => `${it.me}.z += ${it.number("STEPS")};`,
	starlogo_go: (it) => `${it.me}.jumpTo(${["X", "Y", "Z"].map((name) => it.number(name)).join(", ")});`,
	starlogo_scatter: ({ me }) => `scatter(${me});`,
	starlogo_back: ({ me, collidee }) => `goBack(${me}, ${collidee});`,
	starlogo_mound: (it) => `terrain.raiseMound(${it.me}.x, ${it.me}.y, ${it.number("WIDTH")}, ${it.number("HEIGHT")});`,
	starlogo_wall: (it) => `terrain.raiseWall(${it.me}.x, ${it.me}.y, ${it.number("HEIGHT")});`,
	starlogo_raise: (it) => `terrain.raiseWall(${["X", "Y", "HEIGHT"].map((name) => it.number(name)).join(", ")});`,
	starlogo_broadcast: ({ fields }) => `broadcast(${text(fields.MESSAGE)});`,
	starlogo_own_set: (it) => `${it.own} = ${it.value("VALUE")};`,
	starlogo_own_change: (it) => `${it.own} = ${it.numberOf(`(${it.own} ?? 0)`)} + ${it.number("DELTA")};`,
	starlogo_own_show: ({ fields }) => `// here the game ${fields.ON === "on" ? "shows" : "hides"} the agents' variable ${text(fields.NAME)}`,
	starlogo_flat: () => "terrain.reset();",
	starlogo_solid: ({ fields }) => `walking().setSolid(${text(fields.BREED)}, ${fields.ON === "on"});`,
	starlogo_push: ({ me, collidee }) => `contacts.pushAway(${me}, ${collidee});`,
	starlogo_walk: (it) => `walk(${it.me}, ${it.number("STEPS")});`,
	starlogo_jump: (it) => `${it.me}.rise = walking().jump(${it.me}, ${it.number("HEIGHT")}, ${it.me}.rise);`,
	starlogo_fall: ({ me }) => `${me}.rise = walking().fall(${me}, ${me}.rise);`,
	starlogo_edge: ({ fields, me }) => `edges.${fields.HOW}Edge(${me});`,
	starlogo_stand: ({ me }) => `${me}.z = groundBelow(${me});`,
	starlogo_delete: (it) => it.whom((agent) => `remove(${agent});`),
	starlogo_size: (it) => `${it.me}.size = ${it.number("SIZE")};`,
	starlogo_heading: (it) => `${it.me}.heading = ${it.number("HEADING")};`,
	starlogo_colour: (it) => {
		const colour = it.number("COLOUR");
		if (!it.isOfBreed) return `${it.who}.color = ${colour};`;
		return ["{", `${INDENT}const colour = ${colour};`, `${INDENT}${it.whom((agent) => `${agent}.color = colour;`)}`, "}"];
	},
	variables_set: (it) => `${it.variable} = ${it.value("VALUE")};`,
	math_change: (it) => (it.whole.keepsTexts ? `${it.variable} = ${it.numberOf(it.variable)} + ${it.number("DELTA")};` : `${it.variable} += ${it.number("DELTA")};`),
	starlogo_create: (it) => {
		const lines = creating(it, null);
		return rounds(it.number("COUNT"), lines) ?? ["{", ...lines, "}"];
	},
	starlogo_hatch: (it) => ["{", ...creating(it, it.me), "}"],
	starlogo_ask: (it) => {
		const asked = it.named("asked");
		return ["{", `${INDENT}const ${asked} = ${it.value("AGENT", "null")};`, `${INDENT}if (${asked}) {`, ...it.body("DO", asked).map((line) => INDENT + line), `${INDENT}}`, "}"];
	},
	starlogo_wait: (it) => `yield wait(${it.number("SECONDS")}, ${it.me});`,
	controls_if: (it) => branches(it, 1 + (it.block.extraState?.elseIfCount ?? 0)),
	controls_ifelse: (it) => branches(it, 1),
	controls_repeat_ext: (it) => {
		const lines = it.body("DO");
		return rounds(it.number("TIMES"), lines) ?? ["{", ...lines, "}"];
	},
	controls_whileUntil: (it) => {
		const holds = it.value("BOOL", "false");
		return [`while (${it.fields.MODE === "UNTIL" ? `!(${bare(holds)})` : bare(holds)}) {`, ...it.body("DO"), "}"];
	},
};

function branches(it, count) {
	const lines = [];
	for (let i = 0; i < count; i++) lines.push(`${i > 0 ? "} else " : ""}if (${bare(it.value(`IF${i}`, "false"))}) {`, ...it.body(`DO${i}`));
	const otherwise = it.body("ELSE");
	return [...lines, ...(otherwise.length > 0 ? ["} else {", ...otherwise] : []), "}"];
}

const ARITHMETIC = { ADD: "+", MINUS: "-", MULTIPLY: "*", DIVIDE: "/", POWER: "**" };
const COMPARISONS = { EQ: "===", NEQ: "!==", LT: "<", LTE: "<=", GT: ">", GTE: ">=" };
const two = (table, read = (it, name) => it.value(name)) => (it) => {
	const [a, b] = ["A", "B"].map((name) => read(it, name));
	// the left side of ** must not have a sign
	return `(${it.fields.OP === "POWER" ? `(${a})` : a} ${table[it.fields.OP]} ${b})`;
};

const VALUES = {
	math_number: ({ fields }) => String(fields.NUM),
	math_arithmetic: two(ARITHMETIC, (it, name) => it.number(name)),
	math_random_int: (it) => `randomBetween(${it.number("FROM")}, ${it.number("TO")})`,
	math_modulo: (it) => `(${it.number("DIVIDEND")} % ${it.number("DIVISOR")})`,
	logic_compare: two(COMPARISONS),
	logic_operation: two({ AND: "&&", OR: "||" }, (it, name) => it.value(name, "false")),
	logic_negate: (it) => `!${it.value("BOOL", "false")}`,
	logic_boolean: ({ fields }) => String(fields.BOOL === "TRUE"),
	variables_get: (it) => it.variable,
	text: ({ fields }) => text(fields.TEXT),
	starlogo_own: (it) => `(${it.own} ?? 0)`,
	starlogo_trait: ({ fields: { TRAIT }, me }) => (TRAIT === "age" ? `((game.frame - ${me}.born) / ${FRAMES_A_SECOND})` : `${me}.${TRAIT}`),
	starlogo_agent: (it) => it.who,
	starlogo_count: (it) => `senses().countWithin(${it.me}, ${it.breed}, ${it.number("DISTANCE")})`,
	starlogo_number_of: (it) => `senses().countWith(${it.me}, ${it.breed}, "color", ${it.value("COLOUR")})`,
	starlogo_nearest: (it) => `senses().nearestWithin(${it.me}, ${it.breed}, ${it.number("DISTANCE")})`,
	starlogo_distance: (it) => `distanceTo(${it.me}, ${it.value("AGENT", "null")})`,
	starlogo_can_see: (it) => `canSee(${it.me}, ${it.value("AGENT", "null")})`,
	starlogo_side: ({ fields, me, collidee }) => `(contacts.sideHit(${fields.WHO === "me" ? `${me}, ${collidee}` : `${collidee}, ${me}`}) === ${text(fields.SIDE)})`,
	starlogo_touch: ({ fields: { TOUCH }, me, collidee }) => (TOUCH === "speed" ? `speedOf(${me}, ${collidee})` : `contacts.touchPoint(${me}, ${collidee}).${TOUCH}`),
	starlogo_ahead: (it) => `senses().ahead(${it.me}, ${it.breed}, ${it.number("DISTANCE")})`,
	starlogo_free: (it) => `Math.min(1000000, senses().distanceAhead(${it.me}, ${it.breed}, ${it.number("DISTANCE")}))`,
	starlogo_standing: ({ fields: { BREED }, me }) => (BREED === "anyone" ? `walking().isStanding(${me})` : `(walking().standsOn(${me})?.breed === ${breedOf(BREED)})`),
	starlogo_floor: ({ me }) => `floorOf(${me})`,
	starlogo_at_edge: ({ fields: { EDGE }, me }) => (EDGE === "any" ? `(edges.edgeTouched(${me}) !== null)` : `(edges.edgeTouched(${me}) === ${text(EDGE)})`),
	starlogo_touching: (it) => `senses().isTouching(${it.me}, ${it.breed})`,
	starlogo_ground_height: ({ me }) => `groundBelow(${me})`,
	starlogo_on_ground: ({ me }) => `senses().isTouching(${me}, Collision.TERRAIN)`,
	starlogo_key_down: ({ fields }) => `held.has(${text(fields.KEY)})`,
	starlogo_mouse: ({ fields: { MOUSE } }) => `mouse.${MOUSE === "down" ? "isDown" : MOUSE}`,
	starlogo_score: () => "game.score",
	starlogo_clock: () => `(game.frame / ${FRAMES_A_SECOND})`,
	starlogo_pick: ({ fields }) => `colours.${fields.COLOUR}`,
	starlogo_any_colour: () => "anyColour()",
	starlogo_colour_of: (it) => `${it.who}.color`,
};

/** The kinds of scripts for two agents. */
const PAIRS = new Set(["starlogo_collision", "starlogo_touch_start", "starlogo_touch_end"]);

/** The registration of each kind of script with the game. */
const EVENTS = {
	starlogo_start: () => "whenTheGameStarts(",
	starlogo_each: (it) => `everyFrame(${it.breed}, `,
	starlogo_key: (it) => `whileKey(${text(it.fields.KEY)}, ${text(it.fields.MODE)}, ${it.breed}, `,
	starlogo_timer: (it) => `everySeconds(() => ${it.number("SECONDS")}, ${it.breed}, `,
	starlogo_click: (it) => `whenClicked(${it.breed}, `,
	starlogo_collision: (it) => `whenColliding(${it.breed}, ${it.other}, `,
	starlogo_receive: (it) => `whenReceiving(${text(it.fields.MESSAGE)}, ${it.breed}, `,
	starlogo_touch_start: (it) => `whenTouchingStarts(${it.breed}, ${it.other}, `,
	starlogo_touch_end: (it) => `whenTouchingEnds(${it.breed}, ${it.other}, `,
};

/** The shapes that a program names, in order. */
export function shapesOf(program) {
	const found = new Set();
	JSON.stringify(program, (key, value) => {
		if (key === "SHAPE" && typeof value === "string") found.add(value);
		return value;
	});
	return [...found].sort();
}

/** Whether a program sets a variable to a text. */
function keepsTexts(program) {
	let isFound = false;
	JSON.stringify(program, (key, value) => {
		isFound ||= ["variables_set", "starlogo_own_set"].includes(value?.type) && inputOf(value, "VALUE")?.type === "text";
		return value;
	});
	return isFound;
}

/** Numbers in lines that can be read beside a program. */
const numbers = (all) => JSON.stringify(Array.from(all)).replaceAll(/(.{100}[^,]*,)/g, "$1\n\t\t");

/** A model as an expression: as its file had it, or else as it is. */
function making(name, { given, vertices, triangles }) {
	const parts = [text(name), numbers(given?.vertices ?? vertices), ...(triangles ? [numbers(given?.triangles ?? triangles)] : ["null"]), ...(given ? [] : ["Model.AS_GIVEN"])];
	return `new Model(${parts.join(", ")})`;
}

/** The function with the models that a module brings along, so that it needs no other file. */
const MODELS = (all) => `/** The models: vertices, and the vertices of triangles. */
function models() {
	return [${all.map((each) => `\n\t\t${each},`).join("")}
	];
}`;

const TEN_SECONDS = `// ten seconds of it

for (let i = 0; i < ${10 * FRAMES_A_SECOND} && !game.ended; i++) step();
console.log(\`\${agents.length} agents after \${game.frame} frames\`, game);
`;

/**
 * Writes a program as a module.
 *
 * @param {object} program in Blockly's notation
 * @param {string} title the program's title
 * @param {Map} models by their names
 * @param {string} file the file's name without its ending
 * @param {string} ending what the module does in the end: unless told it plays for ten seconds
 * @returns {string}
 */
export function javascriptOf(program, title, models, file = "game", ending = TEN_SECONDS) {
	const names = new Map((program.variables ?? []).map(({ id, name }) => [id, name]));
	const whole = { names, keepsTexts: keepsTexts(program), forward: JSON.stringify(program).includes('"starlogo_solid"') ? "forwardAlongSolid" : "forward" };
	const scripts = (program.blocks?.blocks ?? []).filter(({ type }) => type in EVENTS).map((block) => {
		const isAlone = block.type === "starlogo_start";
		const isPair = PAIRS.has(block.type) && ![Collision.TERRAIN, Collision.EDGE].includes(block.fields.OTHER);
		const it = new Writing(block, whole, isAlone ? "null" : "me", isPair ? "collidee" : "null");
		const body = it.body("DO");
		return `${EVENTS[block.type](it)}function* (${isAlone ? "" : isPair ? "me, collidee" : "me"}) {${body.length > 0 ? `\n${body.join("\n")}\n` : ""}});`;
	});
	const shapes = shapesOf(program);
	const included = shapes.filter((name) => models.has(name) && !BUILT_IN.includes(name)).map((name) => making(name, models.get(name)));
	const addModels = [...shapes.filter((name) => BUILT_IN.includes(name)).map((name) => `greatLand.addModel(BuiltInModel.${name}());`), ...linesIf(included.length > 0, "for (const model of models()) greatLand.addModel(model);")];
	const { system = CollisionBlocks.TIGHTEST_FITS } = program;
	const main = [...addModels, ...scripts].join("\n");
	const hasEdges = /\bedges\.|Collision\.EDGE/.test(main);
	const helpers = neededBy(`${main}\n${ENGINE}`, hasEdges ? INSIDE_EDGES : {});
	const has = (word) => new RegExp(`\\b${word}\\b`).test(`${main}\n${helpers.join("\n")}`);
	/** What stands in place of the marks in parts of the module. */
	const marks = {
		old: linesIf(has("areSensesOld"), "areSensesOld = true;"),
		receive: linesIf(has("(messages|received)"), "received = messages;", "messages = [];"),
		own: linesIf(has("\\.own"), "own = {}; // its variables"),
		limit: linesIf(has("game\\.limit"), "if (game.limit && game.frame >= game.limit.until) game.ended ??= { how: \"lost\", text: game.limit.text };"),
		welcome: [...linesIf(has("traits"), "traits.welcome(agent);"), ...linesIf(has("sweeping"), "agent.sweeps = sweeping[agent.breed] ?? agent.sweeps;")],
	};
	const fill = (part) => part.replaceAll(/\/\*(\w+)\*\//g, (mark, name) => marks[name].map((line) => `\n\t${line}`).join(""));
	const colours = Object.entries(COLOURS).filter(([name]) => has(`colours\\.${name}`)).map(([name, colour]) => `${name}: ${hex(colour)}`);
	const variables = [...names.values()].map((name) => `${NAME.test(name) ? name : text(name)}: 0`);
	const state = [
		"/** Who is in the game, and how it stands. */",
		"export const agents = [];",
		`export const game = { frame: 0, score: ${has("game\\.score") ? 0 : null}, goal: null, ground: "meadow",${has("game\\.limit") ? " limit: null," : ""} ended: null };`,
		...linesIf(variables.length > 0, `const variables = { ${variables.join(", ")} };`),
		...linesIf(colours.length > 0, `const colours = { ${colours.join(", ")} };`),
		...linesIf(has("HALF_WIDTH"), `const HALF_WIDTH = ${HALF_WIDTH};`),
		...linesIf(has("seed"), "let seed = 20150601;"),
		...linesIf(has("sweeping"), "/** The breeds that collide along their way, or do not. */", "const sweeping = {};"),
		...linesIf(has("mouse"), "export const mouse = { x: 0, y: 0, isDown: false };"),
		...linesIf(has("(messages|received)"), "let messages = [];", "let received = [];"),
		"const held = new Set();", "const pressed = new Set();", "let clicked = null;", "let threads = [];", "const starts = [];", "const scripts = [];",
	];
	const blocks = [
		"const collisions = new CollisionBlocks(greatLand, agents);",
		...linesIf(system !== CollisionBlocks.TIGHTEST_FITS && CollisionBlocks.systemNames.includes(system), `collisions.useCollisionSystem(${text(system)});`),
		...linesIf(has("terrain\\.") || has("(isTouching|when\\w+)\\([^,]+, Collision\\.TERRAIN") || has("walker"), `const terrain = new Terrain(${2 * HALF_WIDTH + 1}, ${2 * HALF_WIDTH + 1}, 1, ${-HALF_WIDTH}, ${-HALF_WIDTH});`, "collisions.collision.terrain = terrain;"),
		...linesIf(has("traits"), "const traits = new TraitBlocks(agents);"),
		...linesIf(has("detection") || has("walker") || hasEdges, "const detection = new DetectionBlocks(collisions);", "let areSensesOld = true;"),
		...linesIf(has("walker"), "const walker = new WalkBlocks(detection);"),
		...linesIf(has("contacts"), "const contacts = new ContactBlocks(collisions);"),
		...linesIf(hasEdges, "const edges = new TerrainBlocks(collisions, detection);", `collisions.collision.bounds = new WorldBounds(${-HALF_WIDTH}, ${-HALF_WIDTH}, -Infinity, ${HALF_WIDTH}, ${HALF_WIDTH}, Infinity);`),
		...linesIf(has("systemsOfNow"), "const systemsOfNow = new CollisionBlocks(greatLand, []);"),
	];
	const code = [main, BEING, ENGINE, ...helpers, ...blocks, included.length > 0 ? "new Model" : "", "new GreatLand"].join("\n");
	return [
		`// “${title.replaceAll(/\s+/g, " ")}”: a program of blocks as a module, with its models. It plays without a picture: node ${file}.mjs`,
		INSTALL,
		`import { ${CLASSES.filter((name) => new RegExp(`\\b${name}\\b`).test(code.replaceAll(/\/\*\*.*?\*\/|"[^"]*"/gs, ""))).join(", ")} } from "starlogo-collision";`,
		"",
		"const greatLand = new GreatLand();",
		...addModels, "",
		...state, "", fill(BEING), "", ...blocks, "",
		"// the program", "",
		scripts.join("\n\n"), "",
		"for (const script of starts) start(script, null, null);", "",
		ending,
		"// what makes it a game", "",
		[ENGINE, ...helpers].map(fill).join("\n\n"), "",
		...linesIf(included.length > 0, MODELS(included), ""),
	].join("\n");
}

/** The helpers that a text names, and the helpers that these name. */
function neededBy(code, others) {
	const helpers = { ...HELPERS, ...others };
	const found = new Set();
	const look = (part) => {
		for (const [name, helper] of Object.entries(helpers)) {
			if (found.has(name) || !new RegExp(`\\b${name}\\(`).test(part)) continue;
			found.add(name);
			look(helper);
		}
	};
	look(code);
	return Object.keys(helpers).filter((name) => found.has(name)).map((name) => helpers[name]);
}
