/** What is meant by a name that is not known, or by a value of the wrong kind. */

/** What an error says about a name that is not known: the name that is probably meant. With an agent's breed the name is that of its shape. */
export function $hintOfName(name, names, breed) {
	if (names.includes(breed)) return `; is new Agent(${JSON.stringify(breed)}, ${JSON.stringify(name)}) meant? The model comes first`;
	const meant = names.find((each) => $isProbablyMisspelt(name, each));
	return meant === undefined ? "" : `; is ${JSON.stringify(meant)} meant?`;
}

/** The options of a filter. */
const $FILTER = ["breeds", "exceptBreeds", "except", "accepts"];

/** What an error says about options that are something else, that have an option of a filter, or a misspelt one. */
export function $hintOfOptions(call, value, key, names) {
	if (names.includes("filter") && $FILTER.includes(key)) return `a filter is one of them: { filter: { ${key}: ... } }; `;
	const [kind] = /^(?:Contact|RayHit|ShapeHit)$/.exec(value.constructor?.name) ?? [];
	if (kind && call.endsWith(": filter")) {
		const found = kind === "Contact" ? "contact" : "hit";
		return `a ${kind} is the argument after the filter: ${call.slice(call.indexOf(".") + 1, -8)}(..., null, ${found}); `;
	}
	return "stands" in value ? "a Footing is the argument after the options: walk(agent, dx, dy, null, footing); " : $hintOfOption(key, names);
}

/** Throws a setter's error about an option with the name of the call: the setter names only its class. */
export function $refuseSetting(where, error) {
	throw new error.constructor(`${where}.${error.message.replace(/^\w+\./, "")}`);
}

/** What an error says about an option that is not among the names of all: the nearest one. */
export function $hintOfOption(key, names) {
	const nearest = $nearestOption(key, names);
	return nearest === undefined ? "" : `the nearest is ${nearest}; `;
}

/** The option that is nearest to one that is not among the names of all; undefined if none is near. */
export function $nearestOption(key, names) {
	const word = key.toLowerCase();
	const longer = names.find((each) => word.length > 3 && each.toLowerCase().endsWith(word));
	if (longer) return longer;
	// each letter in common counts against two changes, because abbreviations are common
	const farAway = names.map((each) => $changesBetween(word, each.toLowerCase()) - 2 * $commonLetters(word, each.toLowerCase()));
	const least = Math.min(...farAway);
	return least < 1 ? names[farAway.indexOf(least)] : undefined;
}

/** Whether a breed's or a model's name may be another one, misspelled. Names that differ in numbers alone are of different breeds. */
export function $isProbablyMisspelt(name, other) {
	if (name.length < 4 || name.replace(/\d+/g, "") === other.replace(/\d+/g, "")) return false;
	// the first letter is seldom wrong: that of a reserved name is after its *
	const hasSameFirst = other.toLowerCase().replace("*", "").startsWith(name[0].toLowerCase());
	const mostChanges = Math.max(name.length, other.length) < 6 || !hasSameFirst ? 1 : 2;
	return name.toLowerCase() === other.toLowerCase() || $changesBetween(name, other) <= mostChanges;
}

/** How many letters have to be inserted, removed, replaced, or exchanged with the next (Damerau, 1964; Levenshtein, 1966). */
export function $changesBetween(name, other) {
	let earlier = [];
	let counts = [...other, ""].map((_, i) => i);
	[...name].forEach((letter, i) => {
		const before = counts;
		counts = [i + 1];
		for (let j = 0; j < other.length; j++) {
			const isExchanged = i > 0 && j > 0 && letter === other[j - 1] && name[i - 1] === other[j];
			const replaced = before[j] + (letter === other[j] ? 0 : 1);
			counts.push(Math.min(before[j + 1] + 1, counts[j] + 1, replaced, isExchanged ? earlier[j - 1] + 1 : Infinity));
		}
		earlier = before;
	});
	return counts[other.length];
}

/** How many letters two words have in common from the beginning on. */
function $commonLetters(word, other) {
	let same = 0;
	while (same < word.length && word[same] === other[same]) same++;
	return same;
}

const $HINT_OF_WALK = ". A walk has no dz: its options come after dx and dy. { fall: 0.2 } lets it fall";

const $HINT_OF_LIST = ". A list that is filled is the argument after the filter, which may be null";
const $HINT_OF_BREEDS = ". Breeds go into one: { breeds: [\"sheep\"] }";

const $HINT_OF_SAVED = ". JSON does not keep bytes: a saved game has them as text. See docs/snapshots.md in the package, \"A saved game\"";

const $HINT_OF_COPIES = ". Copies and JSON are no agents: a saved game makes them anew. See docs/snapshots.md in the package, \"A saved game\"";

const $HINT_OF_COPY = ". A copy of an agent's fields is no agent. See docs/questions.md in the package, \"How is an agent copied?\"";

/** What an error says about a value of the wrong kind: what is probably meant by it. `given` is the call, a colon, and the argument's name. */
export function $hintOfValue(value, expected, given) {
	const ofCall = $meantInCall(value, expected, given);
	if (ofCall !== "") return ofCall;
	if (typeof value === "function" && expected.startsWith("an AgentFilter")) return ". A function goes into one: { accepts: (agent) => agent.size > 1 }";
	if (typeof value === "number" && expected.startsWith("WalkOptions")) return $HINT_OF_WALK;
	if (typeof value === "string" && expected === "an array of strings") return `; is [${JSON.stringify(value)}] meant?`;
	if (typeof value !== "object" || value === null) return "";
	if (expected.startsWith("an AgentFilter") && Array.isArray(value)) return typeof value[0] === "string" ? $HINT_OF_BREEDS : $HINT_OF_LIST;
	if (expected === "an array" && "sweeps" in value) return ": all agents are in one, [level, hero]";
	if (expected.startsWith("an array") && Symbol.iterator in value) return `. ${$spreadOf(value)} is one`;
	if (typeof value.then === "function") return ": await it first";
	if (expected === "an array of Agents" && "sweeps" in value) return ": put it into one, [agent]";
	if (expected.startsWith("a Vector3D")) return Array.isArray(value) ? ". A point is an object: { x: 1, y: 2, z: 3 }" : $whatIsUndefined(value);
	if (expected.startsWith("a CollisionSystem") && "collisionSystem" in value) return ". Its collisionSystem is one";
	if (expected === "a SeenAgents" && "collisionSystem" in value) return ": new SeenAgents(collision) makes one of it";
	if (expected === "a number" && $FILTER.some((name) => name in value)) {
		return `. A filter is an argument after it${/: (?:radius|maxDistance)$/.test(given) ? ". Infinity is no limit" : ""}`;
	}
	if (expected === "a number" && "x" in value && "y" in value) {
		return value.isQuaternion ? ". It takes the numbers of a quaternion one by one: quaternion.x, quaternion.y, quaternion.z, quaternion.w"
			: ". It takes the numbers of a point one by one: point.x, point.y, point.z";
	}
	const isDrawn = value.isObject3D || value.isBufferGeometry;
	if (expected === "an Agent" && isDrawn) return ". An object of three.js has an agent: new ThreeAgentBinding(agent, object)";
	return expected === "a Model" && isDrawn ? ". modelFromObject() and levelFromObject() of starlogo-collision/three make a model of it" : "";
}

/** The hint about an argument of one call, or about one of a list. */
function $meantInCall(value, expected, given) {
	if (/^Collision\.(?:on\w+|removeHandler): (?:breed|otherBreed)$/.test(given)) return $meantByBreed(value);
	const isSome = value !== null && /object|string/.test(typeof value) && typeof value.then !== "function";
	if (given === "Collision.restore: bytes" && isSome) return $HINT_OF_SAVED;
	if (given.startsWith("Collision.restore: agents[")) return $HINT_OF_COPIES;
	if (expected === "an Agent" && (value?.$revision ?? value?.sweeps) !== undefined) return $HINT_OF_COPY;
	if (/castAll: out$/.test(given) && value?.allSurfaces !== undefined) return ". Options are the argument after it: castAll(..., null, { allSurfaces: true })";
	const [, model] = /^BuiltInModel\.(capsule|box): (?:radius|x)$/.exec(given) ?? [];
	if (model && $isWord(value)) {
		return `. The name comes last: ${model}(${model === "box" ? "4, 0.5, 3" : "0.3, 1.8"}, ${JSON.stringify(value)})`;
	}
	const [, point] = /^Agent\w+\.(near|nearest): agent$/.exec(given) ?? [];
	if (point && typeof value?.x === "number" && typeof value.y === "number") return `. For a point there is ${point === "near" ? "nearPoint" : "nearestToPoint"}()`;
	if (given.startsWith("new ") && typeof value === "number" && expected.startsWith("a Vector3D")) return ". Points come before numbers";
	const [, call] = /^Agent\w+\.(\w+): radius$/.exec(given) ?? [];
	const breeds = [value].flat();
	if (call && breeds.length > 0 && breeds.every($isWord)) {
		return `. Breeds are in a filter after it: ${call}(..., Infinity, { breeds: ${JSON.stringify(breeds)} })`;
	}
	const isNested = Array.isArray(value) && given.endsWith("]") && /^an? (?:number|integer)/.test(expected);
	return isNested ? ". All numbers are in one flat list: list.flat()" : "";
}

/** How an array is made of what can be iterated. A Map has its values beside their keys. */
function $spreadOf(value) {
	if (value instanceof Map) return "[...map.values()]";
	return value instanceof Set ? "[...set]" : "[...agents]";
}

/** Whether a value is a text, and not that of a number. */
function $isWord(value) {
	return typeof value === "string" && Number.isNaN(Number(value));
}

/** What is meant by a handler's breed that is no string. */
function $meantByBreed(value) {
	if (typeof value === "function") return ". The handler comes last: onCollisionStart(breed, otherBreed, handler)";
	if (Array.isArray(value)) return ". Each pair of breeds has a call of its own";
	return value?.sweeps === undefined ? "" : ". A handler is for all agents of a breed: hero.breed";
}

/** What a point lacks that has one of x, y and z. */
function $whatIsUndefined(point) {
	const missing = ["x", "y", "z"].filter((name) => !(name in point));
	return missing.length === 3 ? "" : `. Its ${missing.join(" and ")} ${missing.length === 1 ? "is" : "are"} undefined`;
}
