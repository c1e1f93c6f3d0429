/**
 * Writes a program of blocks as a JavaScript module for the npm package. It plays the same game: in every frame the same agents are at the
 * same places.
 */
import { Collision, CollisionBlocks } from "starlogo-collision";
import { BUILT_IN } from "../../shared/files/assets.js";
import { INSTALL } from "../../shared/names.js";
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
const systemOf = (program) => (CollisionBlocks.systemNames.includes(program.system) ? program.system : CollisionBlocks.TIGHTEST_FITS);

/** The content of an input: the block put there, or else the shadow. */
const inputOf = (block, name) => block.inputs?.[name]?.block ?? block.inputs?.[name]?.shadow;

/** The names at a place in a script: its agent, the collidee, and the depth of nesting. */
class Place {
	constructor(me, collidee, depth = 0) {
		Object.assign(this, { me, collidee, depth });
	}

	/** The same place, about another agent. */
	about(me) {
		return new Place(me, this.collidee, this.depth + 1);
	}
}

class Writer {
	constructor(program) {
		this.program = program;
		const code = JSON.stringify(program);
		this.forward = code.includes('"starlogo_solid"') ? "forwardAlongSolid" : "forward";
		this.names = new Map((program.variables ?? []).map(({ id, name }) => [id, name]));
	}

	variable(id) {
		const name = this.names.get(id) ?? id;
		return NAME.test(name) ? `variables.${name}` : `variables[${text(name)}]`;
	}

	/** A value as an expression. */
	value(block, name, place, missing = "0") {
		const input = inputOf(block, name);
		return input ? VALUES[input.type](input, place, this) : missing;
	}

	/** The statements of an input, in one or more lines. */
	body(block, name, place) {
		const lines = [];
		for (let each = block.inputs?.[name]?.block; each; each = each.next?.block) {
			if (each.enabled !== false && !(each.disabledReasons?.length > 0)) lines.push(...STATEMENTS[each.type](each, place, this));
		}
		return lines.map((line) => INDENT + line);
	}

	/** The lines of a statement about me, the collidee or a breed. `line` is called with the agent's name. */
	whom({ fields: { WHO } }, place, line) {
		if (WHO === "me") return [line(place.me)];
		if (WHO === "collidee") return [line(place.collidee)];
		return [`for (const one of all(${text(WHO)})) ${line("one")}`];
	}

	who({ fields: { WHO } }, place) {
		return WHO === "me" ? place.me : WHO === "collidee" ? place.collidee : text(WHO);
	}
}

/** A variable of the agent that a script is about. */
const ownOf = ({ fields: { NAME: name } }, { me }) => (NAME.test(name) ? `${me}.own.${name}` : `${me}.own[${text(name)}]`);

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
function creating(block, place, writer, parent) {
	const agent = `agent${place.depth > 0 ? place.depth + 1 : ""}`;
	const inner = writer.body(block, "DO", place.about(agent));
	const make = `add(${text(block.fields.SHAPE)}, ${text(block.fields.BREED)}${parent ? `, ${parent}` : ""})`;
	return inner.length > 0 ? [`${INDENT}const ${agent} = ${make};`, ...inner] : [`${INDENT}${make};`];
}

const STATEMENTS = {
	starlogo_system: ({ fields }) => [`useSystem(${text(fields.SYSTEM)});`],
	starlogo_hierarchical: (block, place, writer) => [`traits.setHierarchical(${writer.who(block, place)}, ${block.fields.ON === "on"});`],
	starlogo_depth: (block, place, writer) => [`traits.setCollisionDepth(${writer.who(block, place)}, ${writer.value(block, "DEPTH", place)});`],
	starlogo_collide_as: (block, place, writer) => [`traits.collideAs(${writer.who(block, place)}, ${text(block.fields.AS)});`],
	starlogo_show: () => ["// bounding structures are shown where there is a picture"],
	starlogo_sweep: (block, place, writer) => {
		const isOn = block.fields.ON === "on";
		return ["me", "collidee"].includes(block.fields.WHO) ? writer.whom(block, place, (agent) => `${agent}.sweeps = ${isOn};`) : [`sweep(${text(block.fields.WHO)}, ${isOn});`];
	},
	starlogo_until: (block, place, writer) => [`advance(${place.me}, ${writer.value(block, "STEPS", place)}, ${breedOf(block.fields.BREED)}, ${text(block.fields.HOW)});`],
	starlogo_face: (block, place, writer) => [`face(${place.me}, ${writer.value(block, "AGENT", place, "null")});`],
	starlogo_bounce: (block, { me, collidee }) => [`bounce(${me}, ${collidee});`],
	starlogo_become: (block, place, writer) => writer.whom(block, place, (agent) => `become(${agent}, ${text(block.fields.BREED)});`),
	starlogo_say: (block, place, writer) => [`${place.me}.said = String(${writer.value(block, "TEXT", place, "\"\"")});`],
	starlogo_score_set: (block, place, writer) => [`game.score = ${writer.value(block, "SCORE", place)};`],
	starlogo_score_change: (block, place, writer) => [`game.score += ${writer.value(block, "SCORE", place)};`],
	starlogo_goal: ({ fields }) => [`game.goal = ${text(fields.TEXT)};`],
	starlogo_ground: ({ fields }) => [`game.ground = ${text(fields.GROUND)};`],
	starlogo_limit: (block, place, writer) => [`game.limit = { until: game.frame + Math.max(1, Math.round(${writer.value(block, "SECONDS", place)} * ${FRAMES_A_SECOND})), text: ${text(block.fields.TEXT)} };`],
	starlogo_sound: ({ fields }) => [`// here the game plays the sound ${text(fields.SOUND)}`],
	starlogo_note: (block, place, writer) => [`// here the game plays the note ${writer.value(block, "NOTE", place)}`],
	starlogo_end: ({ fields }) => [`game.ended ??= { how: ${text(fields.HOW)}, text: ${text(fields.TEXT)} };`],
	starlogo_forward: (block, place, writer) => [`${writer.forward}(${place.me}, ${writer.value(block, "STEPS", place)});`],
	starlogo_turn: (block, place, writer) => [`${place.me}.heading ${block.fields.DIRECTION === "left" ? "+=" : "-="} ${writer.value(block, "DEGREES", place)};`],
	starlogo_up: (block, place, writer) => [`${place.me}.z += ${writer.value(block, "STEPS", place)};`],
	starlogo_go: (block, place, writer) => [`${place.me}.jumpTo(${["X", "Y", "Z"].map((name) => writer.value(block, name, place)).join(", ")});`],
	starlogo_scatter: (block, { me }) => [`scatter(${me});`],
	starlogo_back: (block, { me, collidee }) => [`goBack(${me}, ${collidee});`],
	starlogo_mound: (block, place, writer) => [`terrain.raiseMound(${place.me}.x, ${place.me}.y, ${writer.value(block, "WIDTH", place)}, ${writer.value(block, "HEIGHT", place)});`],
	starlogo_wall: (block, place, writer) => [`terrain.raiseWall(${place.me}.x, ${place.me}.y, ${writer.value(block, "HEIGHT", place)});`],
	starlogo_raise: (block, place, writer) => [`terrain.raiseWall(${["X", "Y", "HEIGHT"].map((name) => writer.value(block, name, place)).join(", ")});`],
	starlogo_broadcast: ({ fields }) => [`broadcast(${text(fields.MESSAGE)});`],
	starlogo_own_set: (block, place, writer) => [`${ownOf(block, place)} = ${writer.value(block, "VALUE", place)};`],
	starlogo_own_change: (block, place, writer) => [`${ownOf(block, place)} = (${ownOf(block, place)} ?? 0) + ${writer.value(block, "DELTA", place)};`],
	starlogo_own_show: ({ fields }) => [`// here the game ${fields.ON === "on" ? "shows" : "hides"} the agents' variable ${text(fields.NAME)}`],
	starlogo_flat: () => ["terrain.reset();"],
	starlogo_solid: ({ fields }) => [`walking().setSolid(${text(fields.BREED)}, ${fields.ON === "on"});`],
	starlogo_push: (block, { me, collidee }) => [`contacts.pushAway(${me}, ${collidee});`],
	starlogo_walk: (block, place, writer) => [`walk(${place.me}, ${writer.value(block, "STEPS", place)});`],
	starlogo_jump: (block, place, writer) => [`${place.me}.rise = walking().jump(${place.me}, ${writer.value(block, "HEIGHT", place)}, ${place.me}.rise);`],
	starlogo_fall: (block, { me }) => [`${me}.rise = walking().fall(${me}, ${me}.rise);`],
	starlogo_edge: ({ fields }, { me }) => [`edges.${fields.HOW}Edge(${me});`],
	starlogo_stand: (block, { me }) => [`${me}.z = groundBelow(${me});`],
	starlogo_delete: (block, place, writer) => writer.whom(block, place, (agent) => `remove(${agent});`),
	starlogo_size: (block, place, writer) => [`${place.me}.size = ${writer.value(block, "SIZE", place)};`],
	starlogo_heading: (block, place, writer) => [`${place.me}.heading = ${writer.value(block, "HEADING", place)};`],
	starlogo_colour: (block, place, writer) => {
		const colour = writer.value(block, "COLOUR", place);
		if (["me", "collidee"].includes(block.fields.WHO)) return writer.whom(block, place, (agent) => `${agent}.color = ${colour};`);
		return ["{", `${INDENT}const colour = ${colour};`, `${INDENT}${writer.whom(block, place, (agent) => `${agent}.color = colour;`)[0]}`, "}"];
	},
	variables_set: (block, place, writer) => [`${writer.variable(block.fields.VAR.id)} = ${writer.value(block, "VALUE", place)};`],
	math_change: (block, place, writer) => [`${writer.variable(block.fields.VAR.id)} += ${writer.value(block, "DELTA", place)};`],
	starlogo_create: (block, place, writer) => {
		const lines = creating(block, place, writer, null);
		return rounds(writer.value(block, "COUNT", place), lines) ?? ["{", ...lines, "}"];
	},
	starlogo_hatch: (block, place, writer) => ["{", ...creating(block, place, writer, place.me), "}"],
	starlogo_ask: (block, place, writer) => {
		const asked = `asked${place.depth > 0 ? place.depth + 1 : ""}`;
		return ["{", `${INDENT}const ${asked} = ${writer.value(block, "AGENT", place, "null")};`, `${INDENT}if (${asked}) {`, ...writer.body(block, "DO", place.about(asked)).map((line) => INDENT + line), `${INDENT}}`, "}"];
	},
	starlogo_wait: (block, place, writer) => [`yield wait(${writer.value(block, "SECONDS", place)}, ${place.me});`],
	controls_if: (block, place, writer) => branches(block, place, writer, 1 + (block.extraState?.elseIfCount ?? 0)),
	controls_ifelse: (block, place, writer) => branches(block, place, writer, 1),
	controls_repeat_ext: (block, place, writer) => {
		const lines = writer.body(block, "DO", place);
		return rounds(writer.value(block, "TIMES", place), lines) ?? ["{", ...lines, "}"];
	},
	controls_whileUntil: (block, place, writer) => {
		const holds = writer.value(block, "BOOL", place, "false");
		return [`while (${block.fields.MODE === "UNTIL" ? `!(${bare(holds)})` : bare(holds)}) {`, ...writer.body(block, "DO", place), "}"];
	},
};

function branches(block, place, writer, count) {
	const lines = [];
	for (let i = 0; i < count; i++) lines.push(`${i > 0 ? "} else " : ""}if (${bare(writer.value(block, `IF${i}`, place, "false"))}) {`, ...writer.body(block, `DO${i}`, place));
	const otherwise = writer.body(block, "ELSE", place);
	return [...lines, ...(otherwise.length > 0 ? ["} else {", ...otherwise] : []), "}"];
}

const ARITHMETIC = { ADD: "+", MINUS: "-", MULTIPLY: "*", DIVIDE: "/", POWER: "**" };
const COMPARISONS = { EQ: "===", NEQ: "!==", LT: "<", LTE: "<=", GT: ">", GTE: ">=" };
const two = (table, names = ["A", "B"], missing = "0") => (block, place, writer) => {
	const [a, b] = names.map((name) => writer.value(block, name, place, missing));
	// the left side of ** must not have a sign
	return `(${block.fields.OP === "POWER" ? `(${a})` : a} ${table[block.fields.OP]} ${b})`;
};

const VALUES = {
	math_number: ({ fields }) => String(fields.NUM),
	math_arithmetic: two(ARITHMETIC),
	math_random_int: (block, place, writer) => `randomBetween(${writer.value(block, "FROM", place)}, ${writer.value(block, "TO", place)})`,
	math_modulo: (block, place, writer) => `(${writer.value(block, "DIVIDEND", place)} % ${writer.value(block, "DIVISOR", place)})`,
	logic_compare: two(COMPARISONS),
	logic_operation: two({ AND: "&&", OR: "||" }, ["A", "B"], "false"),
	logic_negate: (block, place, writer) => `!${writer.value(block, "BOOL", place, "false")}`,
	logic_boolean: ({ fields }) => String(fields.BOOL === "TRUE"),
	variables_get: (block, place, writer) => writer.variable(block.fields.VAR.id),
	text: ({ fields }) => text(fields.TEXT),
	starlogo_own: (block, place) => `(${ownOf(block, place)} ?? 0)`,
	starlogo_trait: ({ fields: { TRAIT } }, { me }) => (TRAIT === "age" ? `((game.frame - ${me}.born) / ${FRAMES_A_SECOND})` : `${me}.${TRAIT}`),
	starlogo_agent: (block, place, writer) => writer.who(block, place),
	starlogo_count: (block, place, writer) => `senses().countWithin(${place.me}, ${breedOf(block.fields.BREED)}, ${writer.value(block, "DISTANCE", place)})`,
	starlogo_number_of: (block, place, writer) => `senses().countWith(${place.me}, ${breedOf(block.fields.BREED)}, "color", ${writer.value(block, "COLOUR", place)})`,
	starlogo_nearest: (block, place, writer) => `senses().nearestWithin(${place.me}, ${breedOf(block.fields.BREED)}, ${writer.value(block, "DISTANCE", place)})`,
	starlogo_distance: (block, place, writer) => `distanceTo(${place.me}, ${writer.value(block, "AGENT", place, "null")})`,
	starlogo_can_see: (block, place, writer) => `canSee(${place.me}, ${writer.value(block, "AGENT", place, "null")})`,
	starlogo_side: ({ fields }, { me, collidee }) => `(contacts.sideHit(${fields.WHO === "me" ? `${me}, ${collidee}` : `${collidee}, ${me}`}) === ${text(fields.SIDE)})`,
	starlogo_touch: ({ fields: { TOUCH } }, { me, collidee }) => (TOUCH === "speed" ? `speedOf(${me}, ${collidee})` : `contacts.touchPoint(${me}, ${collidee}).${TOUCH}`),
	starlogo_ahead: (block, place, writer) => `senses().ahead(${place.me}, ${breedOf(block.fields.BREED)}, ${writer.value(block, "DISTANCE", place)})`,
	starlogo_free: (block, place, writer) => `Math.min(1000000, senses().distanceAhead(${place.me}, ${breedOf(block.fields.BREED)}, ${writer.value(block, "DISTANCE", place)}))`,
	starlogo_standing: ({ fields: { BREED } }, { me }) => (BREED === "anyone" ? `walking().isStanding(${me})` : `(walking().standsOn(${me})?.breed === ${breedOf(BREED)})`),
	starlogo_floor: (block, { me }) => `floorOf(${me})`,
	starlogo_at_edge: ({ fields: { EDGE } }, { me }) => (EDGE === "any" ? `(edges.edgeTouched(${me}) !== null)` : `(edges.edgeTouched(${me}) === ${text(EDGE)})`),
	starlogo_touching: (block, place) => `senses().isTouching(${place.me}, ${breedOf(block.fields.BREED)})`,
	starlogo_ground_height: (block, { me }) => `groundBelow(${me})`,
	starlogo_on_ground: (block, { me }) => `senses().isTouching(${me}, Collision.TERRAIN)`,
	starlogo_key_down: ({ fields }) => `held.has(${text(fields.KEY)})`,
	starlogo_mouse: ({ fields: { MOUSE } }) => `mouse.${MOUSE === "down" ? "isDown" : MOUSE}`,
	starlogo_score: () => "game.score",
	starlogo_clock: () => `(game.frame / ${FRAMES_A_SECOND})`,
	starlogo_pick: ({ fields }) => `colours.${fields.COLOUR}`,
	starlogo_any_colour: () => "anyColour()",
	starlogo_colour_of: (block, place, writer) => `${writer.who(block, place)}.color`,
};

/** The registration of each kind of script with the game. */
const EVENTS = {
	starlogo_start: () => "whenTheGameStarts(",
	starlogo_each: ({ fields }) => `everyFrame(${breedOf(fields.BREED)}, `,
	starlogo_key: ({ fields }) => `whileKey(${text(fields.KEY)}, ${text(fields.MODE)}, ${breedOf(fields.BREED)}, `,
	starlogo_timer: ({ fields }, seconds) => `everySeconds(() => ${seconds}, ${breedOf(fields.BREED)}, `,
	starlogo_click: ({ fields }) => `whenClicked(${breedOf(fields.BREED)}, `,
	starlogo_collision: ({ fields }) => `whenColliding(${breedOf(fields.BREED)}, ${breedOf(fields.OTHER)}, `,
	starlogo_receive: ({ fields }) => `whenReceiving(${text(fields.MESSAGE)}, ${breedOf(fields.BREED)}, `,
	starlogo_touch_start: ({ fields }) => `whenTouchingStarts(${breedOf(fields.BREED)}, ${breedOf(fields.OTHER)}, `,
	starlogo_touch_end: ({ fields }) => `whenTouchingEnds(${breedOf(fields.BREED)}, ${breedOf(fields.OTHER)}, `,
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
	const writer = new Writer(program);
	const scripts = (program.blocks?.blocks ?? []).filter(({ type }) => type in EVENTS).map((block) => {
		const isAlone = block.type === "starlogo_start";
		const isPair = block.type in { starlogo_collision: 1, starlogo_touch_start: 1, starlogo_touch_end: 1 } && ![Collision.TERRAIN, Collision.EDGE].includes(block.fields.OTHER);
		const place = new Place(isAlone ? "null" : "me", isPair ? "collidee" : "null");
		const seconds = block.inputs?.SECONDS ? writer.value(block, "SECONDS", new Place("null", "null")) : "";
		return `${EVENTS[block.type](block, seconds)}function* (${isAlone ? "" : isPair ? "me, collidee" : "me"}) {\n${writer.body(block, "DO", place).join("\n")}\n});`;
	}).map((lines) => lines.replace("{\n\n}", "{}"));
	const shapes = shapesOf(program);
	const brought = shapes.filter((name) => models.has(name) && !BUILT_IN.includes(name)).map((name) => making(name, models.get(name)));
	const addModels = [...shapes.filter((name) => BUILT_IN.includes(name)).map((name) => `greatLand.addModel(BuiltInModel.${name}());`), ...(brought.length > 0 ? ["for (const model of models()) greatLand.addModel(model);"] : [])];
	const system = systemOf(program);
	const main = [...addModels, ...scripts].join("\n");
	const hasEdges = /\bedges\.|Collision\.EDGE/.test(main);
	const helpers = neededBy(`${main}\n${ENGINE}`, hasEdges ? INSIDE_EDGES : {});
	const has = (word) => new RegExp(`\\b${word}\\b`).test(`${main}\n${helpers.join("\n")}`);
	const fill = (part) => part.replaceAll("/*old*/", has("areSensesOld") ? "\n\tareSensesOld = true;" : "").replaceAll("/*receive*/", has("(messages|received)") ? "\n\treceived = messages;\n\tmessages = [];" : "").replaceAll("/*own*/", has("\\.own") ? "\n\town = {}; // its variables" : "").replaceAll("/*limit*/", has("game\\.limit") ? "\n\tif (game.limit && game.frame >= game.limit.until) game.ended ??= { how: \"lost\", text: game.limit.text };" : "").replaceAll("/*welcome*/", `${has("traits") ? "\n\ttraits.welcome(agent);" : ""}${has("sweeping") ? "\n\tagent.sweeps = sweeping[agent.breed] ?? agent.sweeps;" : ""}`);
	const colours = Object.entries(COLOURS).filter(([name]) => has(`colours\\.${name}`)).map(([name, colour]) => `${name}: ${hex(colour)}`);
	const variables = [...writer.names.values()].map((name) => `${NAME.test(name) ? name : text(name)}: 0`);
	const state = [
		"/** Who is in the game, and how it stands. */",
		"export const agents = [];",
		`export const game = { frame: 0, score: ${has("game\\.score") ? 0 : null}, goal: null, ground: "meadow",${has("game\\.limit") ? " limit: null," : ""} ended: null };`,
		...(variables.length > 0 ? [`const variables = { ${variables.join(", ")} };`] : []),
		...(colours.length > 0 ? [`const colours = { ${colours.join(", ")} };`] : []),
		...(has("HALF_WIDTH") ? [`const HALF_WIDTH = ${HALF_WIDTH};`] : []),
		...(has("seed") ? ["let seed = 20150601;"] : []),
		...(has("sweeping") ? ["/** The breeds that collide along their way, or do not. */", "const sweeping = {};"] : []),
		...(has("mouse") ? ["export const mouse = { x: 0, y: 0, isDown: false };"] : []),
		...(has("(messages|received)") ? ["let messages = [];", "let received = [];"] : []),
		"const held = new Set();", "const pressed = new Set();", "let clicked = null;", "let threads = [];", "const starts = [];", "const scripts = [];",
	];
	const blocks = [
		"const collisions = new CollisionBlocks(greatLand, agents);",
		...(system === CollisionBlocks.TIGHTEST_FITS ? [] : [`collisions.useCollisionSystem(${text(system)});`]),
		...(has("terrain\\.") || has("(isTouching|when\\w+)\\([^,]+, Collision\\.TERRAIN") || has("walker") ? [`const terrain = new Terrain(${2 * HALF_WIDTH + 1}, ${2 * HALF_WIDTH + 1}, 1, ${-HALF_WIDTH}, ${-HALF_WIDTH});`, "collisions.collision.terrain = terrain;"] : []),
		...(has("traits") ? ["const traits = new TraitBlocks(agents);"] : []),
		...(has("detection") || has("walker") || hasEdges ? ["const detection = new DetectionBlocks(collisions);", "let areSensesOld = true;"] : []),
		...(has("walker") ? ["const walker = new WalkBlocks(detection);"] : []),
		...(has("contacts") ? ["const contacts = new ContactBlocks(collisions);"] : []),
		...(hasEdges ? ["const edges = new TerrainBlocks(collisions, detection);", `collisions.collision.bounds = new WorldBounds(${-HALF_WIDTH}, ${-HALF_WIDTH}, -Infinity, ${HALF_WIDTH}, ${HALF_WIDTH}, Infinity);`] : []),
		...(has("systemsOfNow") ? ["const systemsOfNow = new CollisionBlocks(greatLand, []);"] : []),
	];
	const whole = [main, BEING, ENGINE, ...helpers, ...blocks, brought.length > 0 ? "new Model" : "", "new GreatLand"].join("\n");
	return [
		`// “${title.replaceAll(/\s+/g, " ")}”: a program of blocks as a module, with its models. It plays without a picture: node ${file}.mjs`,
		INSTALL,
		`import { ${CLASSES.filter((name) => new RegExp(`\\b${name}\\b`).test(whole.replaceAll(/\/\*\*.*?\*\/|"[^"]*"/gs, ""))).join(", ")} } from "starlogo-collision";`,
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
		...(brought.length > 0 ? [MODELS(brought), ""] : []),
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
