/**
 * Writes the statements that check arguments of the module's public members. They refuse the values that ActionScript's types refuse.
 * JavaScript has no types, so without checks a string could be stored in place of a number. The functions that they call are in
 * ../../standins/module/checks.mjs.
 *
 * Numbers, strings, Booleans and functions are checked by small functions, which take little of a bundle and which V8 inlines. Where an
 * error names the object too, as for agents, they are checked in place. null is accepted if the documentation mentions it. The engine
 * itself then throws the error, if it is one, as it does for numbers that are not finite.
 */
import { TAKES_LITERAL, docOf, docOfParameter, endingBooleans, isWritten, mayHaveNull } from "../signatures.mjs";
import { warningsOf, warningsOfMember } from "./warnings.mjs";

/** Classes that are recognised by a mark of their own. Naming them would bring all the classes that they use into every bundle. By qualified names. */
const MARKED = new Set(["starlogo.GreatLand", "starlogo.libraries.FitStore", "starlogo.terrain.Terrain", "starlogo.terrain.WorldBounds"]);

/** Classes whose fields are written by the engine's own loops, or by the engine alone. They are not checked. By simple names. */
const UNCHECKED_CLASS_NAMES = new Set([
	"BoundingStructure", "Box", "Capsule", "CastHit", "CollisionStatistics", "Contact", "Cylinder", "ErrorEvent", "Footing", "HierarchyNode",
	"Matrix3D", "Placement", "ProgressEvent", "RayHit", "ShapeHit", "Sphere", "TextEvent", "Vector3D",
]);

/** Classes whose methods would take a number that is not finite, as fields would. All others refuse it themselves, or have an answer for it. By simple names. */
const FINITE_CHECKED_CLASS_NAMES = new Set(["FrameTimes", "Placement"]);

/** Functions that the engine calls in its loops. The module exports a checked function around them. */
export const isWrapped = (type) => type?.kind === "function";

/** The public fields of a class that only its users write. The module has a getter and a setter of each. */
export function settingsOf(type) {
	if (type?.kind !== "class" || UNCHECKED_CLASS_NAMES.has(type.name)) return [];
	return type.members.filter((member) => member.kind === "var" && member.isPublic && !member.isPrivate && !member.isStatic);
}

/** The checks of a program's public members. */
export class Checks {
	#signatures;
	#reference;
	#byName;

	/**
	 * @param signatures the signatures of the public declarations, by qualified name
	 * @param reference gives the name of a class in the text, for its qualified name
	 */
	constructor(signatures, reference) {
		this.#signatures = signatures;
		this.#reference = reference;
		this.#byName = new Map([...signatures.values()].map((type) => [type.name, type]));
	}

	/** The statements at the beginning of a member: its checks, and then its warnings, which take the arguments to be as they have to be. */
	prologueOf(qname, name, kind) {
		const type = this.#signatures.get(qname);
		const isPublic = (each) => each.isPublic && !each.isPrivate;
		const member = kind === "function" ? type : type?.members.find((each) => each.name === name && each.kind === kind && isPublic(each));
		const parameters = member?.parameters ?? [];
		const checks = parameters.flatMap((parameter) => this.#check(type, member, parameter));
		return [...switchesOf(type, member), ...checks, ...checkOfInner(type, member), ...warningsOf(qname, name, kind, parameters)];
	}

	/** The public fields of a class that only its users write: { name, type }. */
	settings(qname) {
		return settingsOf(this.#signatures.get(qname));
	}

	/** The statements that check a new value of such a field. */
	ofSetting(qname, field) {
		const member = { ...field, kind: "set", parameters: [], isField: true };
		const value = { name: "value", type: field.result, value: field.initial, isRest: false };
		return [...this.#check(this.#signatures.get(qname), member, value), ...warningsOfMember(qname, field.name)];
	}

	/** The statements at the end of a constructor, which may take its settings as a literal. */
	ofLiteral(qname) {
		const { name } = this.#signatures.get(qname) ?? {};
		if (!TAKES_LITERAL.has(qname)) return [];
		return [`if (arguments[0] != null) $options(null, "new ${name}: settings", arguments[0], this, ${JSON.stringify(expectedText(name))});`];
	}

	/** Whether a class is recognised by its mark. */
	isMarked(qname) {
		return MARKED.has(qname);
	}

	#check(type, given, parameter) {
		const { name } = parameter;
		// a setter's documentation stands at its getter
		const getter = given.kind === "set" ? type.members.find((each) => each.kind === "get" && each.name === given.name) : null;
		const member = { ...given, doc: `${docOf(type, given, this.#byName)}\n${getter ? docOf(type, getter, this.#byName) : ""}` };
		const isNullable = mayBeNull(parameter, member, type);
		const { receiver, qualifiedName, inline } = this.#placeOf(type, member, name);
		const refuse = (expected) => `$refuse(${receiver}, ${name}, ${expected});`;
		const unlessNull = isNullable && !/^(Number|u?int|Boolean)$/.test(parameter.type) ? `${name} != null && ` : "";
		const vector = /^Vector\.<(.*)>$/.exec(parameter.type)?.[1];
		// options as for the platform's own listeners, not only for Flash's class
		if (name === "useCapture") return [...optionsOf(member), `if (typeof ${name} !== "boolean") ${refuse('"true, false or options"')}`];
		if (name === "buffers") return [`${name} = $bytesByName(${receiver}, ${name});`];
		if (parameter.isRest || parameter.type === "*" || parameter.type === "Object") return [];
		if (vector) {
			const hasNulls = mayHaveNull(docOfParameter(name, member.doc));
			return this.#vectorCheck(parameter, vector, isNullable, receiver, hasNulls, member.kind === "set");
		}
		const simple = this.#simpleCheck(parameter, member, type);
		if (simple) {
			const [helper, test, expected] = simple;
			if (inline) return [`if (${unlessNull}${test}) ${refuse(JSON.stringify(expected))}`];
			return [`${unlessNull === "" ? "" : `if (${name} != null) `}${helper}(${qualifiedName}, ${name});`];
		}
		switch (parameter.type) {
			case "ByteArray":
				return [`${name} = $bytes(${receiver}, ${name}, ${isNullable});`];
			case "Vector3D": {
				// what the engine writes into stays what it is
				const isRead = !isWritten(docOfParameter(name, member.doc)) && !type.qname.startsWith("flash.");
				return [`${isNullable ? `if (${name} != null) ` : ""}${isRead ? `${name} = ` : ""}$point(${receiver}, ${name});`];
			}
			case "AgentPredicate": {
				const filter = this.#reference("starlogo.queries.AgentFilter");
				const read = `$options(${receiver}, ${name}, new ${filter}(), ${JSON.stringify(expectedText("AgentFilter"))})`;
				return [`if (${name} != null && !${this.#typeTest(parameter.type, name)}) ${name} = ${read};`];
			}
			case "AgentFilter":
			case "WalkOptions": {
				const options = this.#reference(`starlogo.queries.${parameter.type}`);
				return [
					`if (${name} instanceof ${options}) $warnOfUnknownProperties(${name});`,
					`else if (${name} != null) ${name} = $options(${receiver}, ${name}, new ${options}(), ${JSON.stringify(expectedText(parameter.type))});`,
					...parameter.type === "WalkOptions" ? [`$warnOfUnits(${name});`] : [],
				];
			}
			default: {
				const test = this.#typeTest(parameter.type, name);
				return test ? [`if (${unlessNull}!${test}) ${refuse(JSON.stringify(expectedText(parameter.type)))}`] : [];
			}
		}
	}

	/**
	 * What an error says about where an argument was passed, as text of the module: the receiver, if its text identifies it, with the argument's name;
	 * and the name with that of the member, which is a constant unless the check has to be written in place.
	 */
	#placeOf(type, member, name) {
		const isStatic = member.isStatic || member.kind === "function";
		// a trace of a model, a Collision or a terrain says more than an error needs;
		// in a constructor there is no this before super(), and nothing in it that toString() could read
		const hasText = !/^flash\.|\.(Model|Collision|Terrain)$/.test(type.qname) && type.members.some((each) => each.name === "toString");
		const isNamed = hasText && !isStatic && member.kind !== "constructor";
		const path = member.kind === "constructor" ? `new ${type.name}` : member.kind === "function" ? type.name : `${type.name}.${member.name}`;
		const what = member.kind === "set" ? member.name : name;
		// the game knows a setting as that of the class that it made, which may extend this one
		const isExtended = member.kind === "set" && !isStatic && [...this.#byName.values()].some((each) => each.bases.includes(type.name));
		const qualifiedName = isExtended ? `\`\${this.constructor.name}.${member.name}\`` : `"${member.kind === "set" ? path : `${path}: ${name}`}"`;
		return { receiver: isNamed ? `this, "${what}"` : `null, ${qualifiedName}`, qualifiedName, inline: isNamed || isExtended };
	}

	// The function of the stand-ins for a type, the same check in place, and what is required. Agents get the check in place, because they are
	// checked and moved in loops.
	#simpleCheck({ name, type: declared }, member, type) {
		const isNoNumber = `typeof ${name} !== "number"`;
		const isFinite = member.isField || FINITE_CHECKED_CLASS_NAMES.has(type.name);
		const number = isFinite ? ["$aFiniteNumber", `${isNoNumber} || ${name} - ${name} !== 0`] : ["$aNumber", isNoNumber];
		const offset = ["$aUint", `${isNoNumber} || ${name} !== (${name} & 0x7fffffff)`, "a whole number, 0 or more"];
		return {
			Number: [...number, member.name === "color" ? "0xRRGGBB, a number" : "a number"],
			int: name === "offset" ? offset : ["$anInt", `${isNoNumber} || ${name} !== (${name} | 0)`, "a whole number"],
			uint: ["$aUint", `${isNoNumber} || ${name} !== ${name} >>> 0`, "a whole number"],
			Boolean: ["$aBoolean", `typeof ${name} !== "boolean"`, "true or false"],
			String: ["$aString", `typeof ${name} !== "string"`, "a string"],
			Function: ["$aFunction", `typeof ${name} !== "function"`, "a function"],
		}[declared];
	}

	#typeTest(typeName, name) {
		const type = this.#byName.get(typeName);
		if (!type) return null;
		return MARKED.has(type.qname) ? `$isMarked(${name}, "$is${type.name}")` : `(${name} instanceof ${this.#reference(type.qname)})`;
	}

	#vectorCheck({ name }, element, isNullable, receiver, hasNulls, isSetting) {
		const unlessNull = isNullable ? `if (${name} != null) ` : "";
		// The engine checks the agents of a frame when it first meets them. That is once, as long as a list stays the same.
		if (name === "out" || element === "Agent" && !isSetting) return [`${unlessNull}$checkList(${receiver}, ${name});`];
		if (/^(Number|int|uint)$/.test(element)) return [`${name} = $numbers(${receiver}, ${name}, "${element}", ${isNullable});`];
		const checked = (expected, test) => [`${unlessNull}$checkList(${receiver}, ${name}, "${expected}", (each) => ${test});`];
		if (element === "String") return checked("a string", `${hasNulls ? "each === null || " : ""}typeof each === "string"`);
		const test = this.#typeTest(element, "each");
		// nobody among agents does no harm: a shot may have no shooter
		const orNobody = element === "Agent" ? "each == null || " : "";
		return checked(expectedText(element), `${orNobody}${test}`);
	}
}

/** The check of an argument that only the engine's own classes pass. */
function checkOfInner({ name: owner } = {}, { inner = null, parameters } = {}) {
	if (inner === null) return [];
	const { name, type } = inner;
	return [`if (${name} != null && !(${name} instanceof ${type})) $refuse(null, "new ${owner}: argument ${parameters.length + 1}", ${name}, "left out");`];
}

// The names are quoted, because users write them: they are never shortened.
function switchesOf(type, member) {
	const booleans = endingBooleans(type, member);
	if (booleans.length === 0) return [];
	const [{ name: first }] = booleans;
	const taken = booleans.map(({ name }) => `"${name}": ${name}`).join(", ");
	const initial = booleans.map(({ name, value }) => `"${name}": ${value}`).join(", ");
	const read = `$options(null, "${type.name}.${member.name}: options", ${first}, { ${initial} }, "true, false or options")`;
	return [`if ($isObject(${first})) ({ ${taken} } = ${read});`];
}

function optionsOf({ name }) {
	const asListener = "if ($isObject(useCapture)) return $listen(this, type, listener, useCapture, priority);";
	if (name === "addEventListener") return ["$warnOfEvent(this, type);", asListener];
	return name === "removeEventListener" ? ["if ($isObject(useCapture)) useCapture = false;"] : [];
}

/** Where a literal is likely to be passed, the text says how such an object is made. */
function expectedText(name) {
	if (name === "AgentFilter") return 'an AgentFilter, or a literal such as { breeds: ["sheep"] }';
	if (name === "WalkOptions") return "WalkOptions, or a literal such as { stepHeight: 0.3 }";
	if (name === "BoundingStructure") return "this package's Sphere, Capsule, Box or Hull";
	if (name === "ModelReceiver") return "a GreatLand, or another ModelReceiver";
	if (name === "WorldBounds") return "a WorldBounds, for example new WorldBounds(-50, -50, 0, 50, 50, 50)";
	if (name === "CollisionSystem") return "a CollisionSystem, for example new TightestFitCollider(greatLand)";
	return `${/^[AEIOU]/.test(name) ? "an" : "a"} ${name}`;
}

/** Whether a parameter may be null: the documentation of the parameter, or of a property, says so. */
function mayBeNull(parameter, member, type) {
	if (parameter.value === "null") return true;
	// Flash's own error for a null listener, or a null type of event, has only a number
	if (type.qname.startsWith("flash.") && (parameter.type === "Function" || parameter.name === "type")) return false;
	// what blocks say is for students, and models' own classes pass nothing but the name to their base
	const isAnswered = /^(?:flash|starlogo\.blocks)\./.test(type.qname) || member.inner || /^Vector\.<(?:Number|u?int)>$/.test(parameter.type);
	if (isAnswered) return /\bnull\b/.test(member.doc) || /^(?:Agent|ByteArray|Function|Model|String)$/.test(parameter.type);
	return /\bnull\b/.test(member.kind === "set" ? member.doc : docOfParameter(parameter.name, member.doc));
}
