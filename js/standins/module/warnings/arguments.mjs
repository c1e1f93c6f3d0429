/** Arguments that a call takes, and does nothing with, or not what is probably meant. */
import { $aFiniteNumber, $refuse } from "../checks.mjs";
import { ArgumentError } from "../language.mjs";
import { $hintOfName } from "./spelling.mjs";
import { $functionKind, $warn } from "./warn.mjs";

/** How many arguments a constructor takes, and which others it gets: by their number. */
const $NUMBERS_TAKEN = [["no arguments", "those that it got"], ["1 argument", "the others"], ["2 arguments", "the others"]];

/** The events that objects of the engine's own classes send. */
const $EVENTS = { ModelLoader: ["modelLoaded", "error", "progress", "complete", "cancel"] };

/**
 * Warns of arguments that a constructor does not take: `new CombinationCollider(greatLand, { exact: true })`, `new GreatLand({
 * loadHulls: true })`.
 */
export function $warnOfMore(name, given, taken) {
	if (given.length <= taken) return;
	const [setting] = given[taken] instanceof Object ? Object.keys(given[taken]) : [];
	const such = setting === undefined ? "" : ` such as ${setting}`;
	const [number, others] = $NUMBERS_TAKEN[taken];
	$warn(`new ${name} takes ${number}, and does nothing with ${others}: settings${such} are set after it`);
}

/** Warns of what is given to an update beside the list, probably the time. */
export function $warnOfTime(name, given) {
	if (given.length <= 1) return;
	$warn(`${name} takes the list alone: the engine knows no time and moves nothing. `
		+ "Move an agent by its speed, multiplied by the time since the last frame");
}

/** Refuses what is no agent in a list, and names the call: the engine says only where in the list it is. */
export function $refuseNoAgent(call, agents) {
	for (let i = 0; i < agents.length; i++) {
		if (!(agents[i] instanceof Agent)) $refuse(null, `${call}: agents[${i}]`, agents[i], "an Agent");
	}
}

/** Refuses a number of a question that is negative or NaN, as the engine does, and names the call: the engine's own error names the argument alone. */
export function $refuseNegative(name, value) {
	requireNotNegative(name, value);
}

/** Refuses a ray's origin or direction, and names the call. Texts are made for what is wrong alone, because games cast many rays. */
export function $refuseNoRay(call, origin, direction) {
	if (!$isFinitePoint(origin)) for (const name of ["x", "y", "z"]) $aFiniteNumber(`${call}: origin.${name}`, origin[name]);
	const { x, y, z } = direction;
	if (x === 0 && y === 0 && z === 0) throw new ArgumentError(`${call}: direction must not be 0: (0, 0, 0) leads nowhere`);
	if (!$isFinitePoint(direction)) throw new ArgumentError(`${call}: direction must be finite, not (${x}, ${y}, ${z})`);
}

function $isFinitePoint({ x, y, z }) {
	return x - x === 0 && y - y === 0 && z - z === 0;
}

/**
 * Warns of a listener for events that an object never sends: `loader.addEventListener("load", ...)`. Only of the engine's own classes,
 * because a game's may send other events.
 */
export function $warnOfEvent(object, type) {
	const types = $EVENTS[Object.getPrototypeOf(object)?.constructor.name];
	if (types && !types.includes(type)) $warn(`a ModelLoader sends no event ${JSON.stringify(type)}; it sends ${types.join(", ")}`);
}

/** Warns of a function for `accepts` that says nothing, or later. */
export function $warnOfAccepts(accepts) {
	if (typeof accepts !== "function") return;
	const text = Function.prototype.toString.call(accepts);
	const hasBlock = /^(?:function\b|\w+\s*\(|[^=]*=>\s*\{)/.test(text);
	if (/^Async|^Generator/.test($functionKind(accepts))) {
		$warn("accepts is an async function or a generator, whose result counts as true for every agent: it has to answer at once");
	} else if (hasBlock && !/\breturn\b|\bthrow\b|\[native code\]/.test(text)) {
		$warn("accepts returns nothing, so no agent counts: it returns true for those that do");
	}
}

/** Says nothing: in JavaScript a function takes any number of arguments. */
export function $warnOfNoParameters() {
}

/** Warns of a length that is given to a built-in model that is one unit wide. */
export function $warnOfLength(name, given) {
	if (given.length > 0) $warn(`BuiltInModel.${name}() takes no arguments: it is one unit wide, and agent.size is its width in patches`);
}

/** Warns of a built-in model that takes the place of another one, because both have the same name. */
export function $warnOfReplaced(receiver, model) {
	if (!$isBuiltIn(model)) return;
	const { name } = model;
	// a LevelShapes has its models in its choice
	const before = receiver.$choice ? receiver.$choice.$modelOf(name) : receiver.modelOf(name);
	if (!before || before.vertices.join() === model.vertices.join()) return;
	const remedy = name === "box" || name === "capsule" ? `BuiltInModel.${name}() takes a name last` : "give one of them another name";
	$warn(`a ${name} of other lengths takes the place of the first, because both are called ${JSON.stringify(name)}: ${remedy}`);
}

/** Warns of a model's name that is not known, if a model is called nearly the same. Its model may still come, so it is no error. */
export function $warnOfModelName(greatLand, name) {
	if (typeof name !== "string") return;
	const names = greatLand.modelNames;
	if (names.includes(name) || greatLand.isLoading(name)) return;
	const hint = $hintOfName(name, names);
	if (hint !== "") $warn(`there is no model ${JSON.stringify(name)}, so modelOf() is null${hint}`);
}

/** Whether an object is a BuiltInModel itself, and none of a game's subclass. */
function $isBuiltIn(model) {
	return Object.getPrototypeOf(model ?? {})?.constructor?.name === "BuiltInModel";
}
