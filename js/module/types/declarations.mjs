/** Writes index.d.ts: the TypeScript declarations of the public classes, with their documentation. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ONLY_IN_JAVASCRIPT, RETURNS_UINT8ARRAY } from "../differences.mjs";
import { PLATFORM_NAMES, ROOT } from "../names.mjs";
import { TAKES_LITERAL, docOf, docOfParameter, endingBooleans, isVisible, isWritten, mayHaveNull } from "../signatures.mjs";
import { settingsOf } from "../translation/checks.mjs";
import { PRIMITIVES, docComment } from "./tsdoc.mjs";

/** The types that no class of ActionScript has. */
const BY_HAND = readFileSync(join(ROOT, "js/module/types/byhand.d.ts"), "utf8");

/** TypeScript types that ActionScript's types do not express, by the names of parameters and members. */
const BY_NAME = new Map([
	["accepts", '{ accept(agent: Agent): boolean }["accept"] | null'], // a method's parameter may be a subclass of Agent
	["ANY_BREED", '"*"'],
	["EDGE", '"*edge"'],
	["TERRAIN", '"*terrain"'],
	["buffers", "Record<string, Bytes>"],
	["getQuaternion", "[x: number, y: number, z: number, w: number]"],
	["collisionOrShapes", "Collision<Breeds, GameAgent> | CollisionSystem | LevelShapes"],
	["collisionOrSystem", "Collision<Breeds, GameAgent> | CollisionSystem"],
	["edgeNames", "string[]"],
	["picture", "Picture"],
	["scaling", "Scaling"],
	["sideNames", "string[]"],
	["solidBreeds", "string[]"],
	["structureNames", "string[]"],
	["subject", "Agent | string"],
	["systemNames", "string[]"],
	["toObject", "CollisionRecord"],
	["upAxis", "UpAxis"],
]);

/** The values that a text lists: "x", "y" or "z". */
const LISTED = /"\w+"(?:, "\w+")* or "\w+"/;

/** What the documentation says of a list that belongs to the engine. */
const OF_ENGINE = /\bdo not change it\b|\bread only\b/i;

/** What the documentation says of a field that its type says is there. */
const NULL_IF_EMPTY = /\bnull only in an empty hit\b/;

/** What the documentation says of a list of agents with gaps. */
const HAS_GAPS = /\bnull among them\b/i;

/** What the documentation says of a method whose calls can be chained. */
const RETURNS_THIS = /@return this structure$/m;

/** The method that makes an object of its own class. In ActionScript an override has the type of the base's. */
const COPYING = "clone";

/** What the documentation says of a method that has another name now. */
const OLDER_NAME = /^An older name of <code>(\w+)\(\)<\/code>/;

/** What the documentation says of a handler. Its types are the two agents', which may be of different classes. */
const HANDLER = /<code>function\(collider:Agent, collidee:Agent\):void<\/code>|@param handler\s+as in onCollision\b/;

/** The type parameters of a class for a client's agents, and of one with handlers or questions, which may know a class for each breed. */
const OF_AGENTS = "<GameAgent extends Agent = Agent>";
const OF_BREEDS = "<Breeds extends Agent | { [Name in keyof Breeds]: Agent } = Agent, GameAgent extends Agent = AgentsOf<Breeds>>";

/**
 * The type parameters of methods: the agents of a list, the breeds and agents of a handler, the breeds that a filter names, what takes a point
 * and is returned, and what a question finds. A method that took breeds without type parameters of its own would make a Collision with classes for breeds unfit for
 * a plain `Collision`.
 */
const PICKING = "<GameAgent extends Agent>";
const NAMING = "Name extends BreedOf<Breeds> = BreedOf<Breeds>, OtherName extends BreedOf<Breeds> = BreedOf<Breeds>>";
const HANDLING = `<ColliderAgent extends AgentOf<Breeds, Name>, CollideeAgent extends AgentOf<Breeds, OtherName>, ${NAMING}`;
const FILTERING = "Name extends string = string, ExceptName extends string = string>";
const FILLING = "<Taker extends PointTaker | null = null>";
const findingOf = (agent) => `<FoundAgent extends ${agent} = ${agent}, ${FILTERING}`;

/** What a question finds, and its filter. */
const FOUND = "Found<FoundAgent, Breeds, Name, ExceptName>";
const FILTER_NAMES = "NamedBreed<Breeds, Name>, NamedBreed<Breeds, ExceptName>";
const filterOf = (agent, found) => `AgentFilterInit<${agent}, ${found}, ${FILTER_NAMES}>`;

/** An agent that such a question finds. */
const OR_GROUND = "OrGround<GameAgent>";

/** The classes that a class has the questions of. */
const PARTS = { AgentQueries: ["AgentPlaces", "AgentRays", "AgentMotions"] };

/**
 * The text of index.d.ts.
 *
 * @param types the signatures of the exports, by qualified name
 */
export function writeDeclarations(types) {
	const writer = new Writer(new Map([...types.values()].map((type) => [type.name, type])));
	// without the last line, every declaration here would be exported
	return [BY_HAND, ...[...types.values()].map((type) => writer.text(type)), "export {};\n"].join("\n");
}

/**
 * Whether a class has a type parameter for a client's own class of agents: its update takes them, it asks about them, it is a hit of one, or its
 * base class has a type parameter.
 */
function isGeneric(type, types) {
	const hasAgents = (member) => member.name === "update" && member.parameters[0]?.type === "Vector.<Agent>";
	const isOfHit = (member) => member.result === "Agent" && NULL_IF_EMPTY.test(member.doc);
	if (type?.kind !== "class") return false;
	return hasQuestions(type) || type.members.some((member) => hasAgents(member) || isOfHit(member))
		|| type.bases.some((name) => isGeneric(types.get(name), types));
}

/** Whether a class asks about a client's agents, or is what such a class is made of. */
function hasQuestions({ members }) {
	return members.some(({ kind, parameters: [first] }) => kind === "constructor" && /^(?:seen$|collisionOr)/.test(first?.name));
}

/** Whether a class is there to be extended, as its documentation or its constructor's says. */
function isAbstract(type) {
	const isForSubclasses = ({ kind, doc }) => kind === "constructor" && doc.startsWith("For subclasses only.");
	return /\babstract base class\b/.test(type.doc) || type.members.some(isForSubclasses);
}

/** A member's documentation with the values that only ActionScript shows in its signature: of arguments that are left out, of a switch at first. */
function withValues(docs, { kind, parameters, result, initial }) {
	if (kind === "var" && result === "Boolean" && initial && !/@default\b/.test(docs)) return `${docs}\n\n@default ${initial}`;
	return parameters.filter(({ value }) => value !== null && value !== "null").reduce((text, { name, value }) => {
		const about = docOfParameter(name, text);
		if (about === "" || /\bwithout it\b/.test(about)) return text;
		const shown = value.replace("Number.NEGATIVE_INFINITY", "-Infinity");
		return text.replace(`@param ${name} ${about}`, () => `@param ${name} ${about.replace(/\.?\s*$/, "")}. Default: ${shown}`);
	}, docs);
}

/** Whether a member overrides one whose documentation is all of its own. */
function hasInheritedDoc({ isOverride, doc }) {
	return isOverride && /^(@inheritDoc\s*)?$/.test(doc);
}

/** A word and the names after it, if there are any. */
function listText(word, names) {
	return names.length > 0 ? word + names.join(", ") : "";
}

class Writer {
	#exported;
	#agent = "Agent";

	constructor(exported) {
		this.#exported = exported;
	}

	#isGeneric(type) {
		return isGeneric(type, this.#exported);
	}

	text(type) {
		this.#agent = "Agent";
		if (type.kind === "function") {
			return `${docComment(type.doc, "")}export function ${type.name}(${this.#parameters(type)}): ${this.#type(type.result)};\n`;
		}
		const parts = (PARTS[type.name] ?? []).map((name) => this.#exported.get(name));
		const ofParts = new Set(parts.flatMap((part) => this.#memberTexts(part)));
		const members = this.#memberTexts(type).filter((text) => !ofParts.has(text));
		const interfaces = type.interfaces.filter((name) => this.#exported.has(name));
		const heritage = listText(" extends ", this.#basesOf(type)) + listText(" implements ", interfaces);
		const hasHandlers = type.members.some((member) => HANDLER.test(docOf(type, member, this.#exported)));
		const parameters = this.#isGeneric(type) ? (hasHandlers || hasQuestions(type) ? OF_BREEDS : OF_AGENTS) : "";
		if (type.events.length > 0) members.unshift(...this.#listening(type));
		if (ONLY_IN_JAVASCRIPT[type.qname]?.declaration) members.push(ONLY_IN_JAVASCRIPT[type.qname].declaration);
		const modifiers = `${PLATFORM_NAMES.has(type.name) ? "declare" : "export"} ${isAbstract(type) ? "abstract " : ""}`;
		const head = `${modifiers}${type.kind} ${type.name}${parameters}${heritage}`;
		const merged = listText(" extends ", parts.map(({ name }) => `${name}<Breeds, GameAgent>`));
		const partsText = merged && `\nexport interface ${type.name}${parameters}${merged} {}\n`;
		return `${this.#eventsText(type)}${docComment(type.doc, "")}${head} {\n${members.join("\n")}\n}\n${partsText}`;
	}

	#memberTexts(type) {
		return this.#membersOf(type).map((member) => this.#memberText(type, member));
	}

	#basesOf(type) {
		const isKnown = (name) => this.#exported.has(name) || name === "Error";
		return type.bases.filter(isKnown).map((name) => (this.#isGeneric(this.#exported.get(name)) ? `${name}<GameAgent>` : name));
	}

	#eventsText(type) {
		if (type.events.length === 0) return "";
		const lines = type.events.map(({ event, eventType }) => `\t${event}: ${this.#type(eventType)};`);
		return `/** The events of a ${type.name}, by their types. */\nexport interface ${type.name}Events {\n${lines.join("\n")}\n}\n\n`;
	}

	#listening(type) {
		const known = `<K extends keyof ${type.name}Events>(type: K, listener: (event: ${type.name}Events[K]) => void, `;
		return [
			`\taddEventListener${known}options?: boolean | ListenerOptions, priority?: number): void;`,
			`\tremoveEventListener${known}options?: boolean | ListenerOptions): void;`,
		];
	}

	// Overrides without documentation are left out, because the base has them, but for what is of another type.
	#membersOf(type) {
		// constants of a class that cannot be imported are out of reach
		const isReached = (member) => !(PLATFORM_NAMES.has(type.name) && member.isStatic);
		const isSeen = (member) => isReached(member) && isVisible(member) && !(hasInheritedDoc(member) && member.name !== COPYING);
		return type.members.filter(isSeen);
	}

	#memberText(type, member) {
		const isStatic = member.isStatic ? "static " : "";
		const visible = member.isProtected ? "protected " : "";
		this.#agent = this.#isGeneric(type) && !member.isStatic ? (this.#mayFindGround(type, member) ? OR_GROUND : "GameAgent") : "Agent";
		const docs = hasInheritedDoc(member) ? "" : docOf(type, member, this.#exported);
		const takesLiteral = member.kind === "constructor" && TAKES_LITERAL.has(type.qname);
		const text = docComment(takesLiteral ? `${docs}\n\n@param settings a literal with some of its properties` : withValues(docs, member), "\t");
		if (/^(add|remove)EventListener$/.test(member.name)) {
			const priority = member.name === "addEventListener" ? ", priority?: number" : "";
			return `${text}\t${member.name}(type: string, listener: Listener, options?: boolean | ListenerOptions${priority}): void;`;
		}
		const generic = this.#genericOf(member, docs);
		// agents from a list of a client's agents have the client's class
		if (generic === PICKING) this.#agent = "GameAgent";
		const result = this.#resultOf(type, member, docs, generic);
		switch (member.kind) {
			case "constructor":
				return `${text}\tconstructor(${takesLiteral ? `settings?: ${type.name}Init | null` : this.#parameters(member, type)});`;
			case "method":
				return `${text}\t${visible}${isStatic}${member.name}${generic}(${this.#parameters(member, type, generic)}): ${result};`;
			case "get": {
				const isReadOnly = !type.members.some((other) => other.kind === "set" && other.name === member.name);
				if (OF_ENGINE.test(docs) && result.includes("[]")) return `${text}\t${isStatic}get ${member.name}(): readonly ${result};`;
				if (type.kind === "interface") return `${text}\t${isReadOnly ? "readonly " : ""}${member.name}: ${result};`;
				return `${text}\t${visible}${isStatic}get ${member.name}(): ${result};`;
			}
			case "set": {
				const getter = type.members.find((other) => other.kind === "get" && other.name === member.name);
				const orNull = getter && this.#mayBeNull({ ...getter, doc: docOf(type, getter, this.#exported) }) ? " | null" : "";
				const union = BY_NAME.get(member.name) ?? (getter && this.#unionOf(type, getter.result, docOf(type, getter, this.#exported)));
				return `\t${visible}${isStatic}set ${member.name}(value: ${union ?? this.#parameterType(member.parameters[0]) + orNull});`;
			}
			default:
				if (member.result === "AgentPredicate") return `${text}\tget ${member.name}(): ${result};\n\tset ${member.name}(value: AgentFilterInit<GameAgent> | ${result});`;
				if (member.kind === "var" && /^Vector\.<(?!Number|u?int)/.test(member.result) && !member.isStatic) {
					// what is set may be a list that its owner does not change
					return `${text}\tget ${member.name}(): ${result};\n\tset ${member.name}(value: readonly ${result});`;
				}
				if (settingsOf(type).includes(member) && !/\bRead only\./.test(docs)) return `${text}\tget ${member.name}(): ${result};\n\tset ${member.name}(value: ${result});`;
				return `${text}\t${visible}${isStatic}${member.kind === "const" || /\bRead only\./.test(docs) ? "readonly " : ""}${member.name}: ${result};`;
		}
	}

	/** Whether a member is a question with a filter that may find the ground: only those of AgentPlaces, by any of their names, never do. */
	#mayFindGround(type, member) {
		if (member.kind !== "method" || !member.parameters.some((parameter) => /^(?:AgentFilter|WalkOptions)$/.test(parameter.type))) return false;
		const present = OLDER_NAME.exec(member.doc)?.[1];
		const { doc } = type.members.find(({ name }) => name === present) ?? member;
		return type.name !== "AgentPlaces" && !doc.includes("@copy AgentPlaces#");
	}

	/** The type parameters of a method itself. */
	#genericOf({ kind, parameters, result }, docs) {
		if (kind !== "method") return "";
		if (result === "Vector3D" && parameters.some(({ name }) => name === "out")) return FILLING;
		const hasList = parameters.some(({ name, type }) => type === "Vector.<Agent>" && name !== "out");
		if (this.#agent === "Agent") return result === "Vector.<Agent>" && hasList ? PICKING : "";
		if (HANDLER.test(docs)) return HANDLING;
		if (parameters.some(({ name }) => name === "otherBreed")) return `<${NAMING}`;
		const takes = (wanted) => parameters.some(({ type }) => type === wanted);
		if (!takes("AgentFilter") && !takes("WalkOptions")) return "";
		return /^(?:Vector\.<)?(?:Agent|RayHit|ShapeHit)>?$/.test(result) ? findingOf(this.#agent) : `<${FILTERING}`;
	}

	/** The type of what a member has or returns. */
	#resultOf(type, member, docs, generic) {
		if (RETURNS_UINT8ARRAY.has(`${type.qname}.${member.name}`)) return "OwnBytes";
		if (RETURNS_THIS.test(docs)) return "this";
		if (member.name === COPYING) return type.name;
		const known = BY_NAME.get(member.name) ?? this.#literalOf(member) ?? this.#unionOf(type, member.result, docs);
		if (known) return known;
		const orNull = this.#mayBeNull({ ...member, doc: docs }) ? " | null" : "";
		if (generic === FILLING) return `Taken<NoInfer<Taker>>${orNull}`;
		return (generic === findingOf(this.#agent) ? this.#foundType(member.result) : this.#resultType(member, docs)) + orNull;
	}

	/** What a question finds. The agents' class is not inferred from where they are stored: that would be a cast that nobody sees. */
	#foundType(type) {
		const [, list, found] = /^(Vector\.<)?(\w+)/.exec(type);
		return (found === "Agent" ? `NoInfer<${FOUND}>` : `${found}<NoInfer<${FOUND}>>`) + (list ? "[]" : "");
	}

	// "null for a mesh without a name" makes null an element
	#resultType({ kind, result }, docs) {
		// what takes a filter takes a literal too
		if (kind === "var" && result === "AgentFilter") return "AgentFilterInit";
		if (result === "Vector.<Agent>" && HAS_GAPS.test(docs)) return `(${this.#agent} | null | undefined)[]`;
		return result === "Vector.<String>" && mayHaveNull(docs) ? "(string | null)[]" : this.#type(result);
	}

	#mayBeNull(member) {
		if (member.initial === "null") return !NULL_IF_EMPTY.test(member.doc);
		if (member.kind === "const" || /^(Number|int|uint|Boolean|void|\*|Object)$/.test(member.result)) return false;
		const docs = member.kind === "method" ? /@return([\s\S]*?)(?:\n@|$)/.exec(member.doc)?.[1] ?? member.doc.split("\n@")[0] : member.doc.split("\n@")[0];
		return /(?<!\bnever )\bnull\b/i.test(docs);
	}

	// The type of a constant is its value, which identifies an event or a kind of structure.
	#literalOf(member) {
		return member.kind === "const" && member.result === "String" && /^"[\w ]+"$/.test(member.initial ?? "") ? member.initial : null;
	}

	// The values that a text lists, for example "x", "y" or "z", or the class's own constants.
	#unionOf(type, result, docs) {
		if (result !== "String") return null;
		const listed = LISTED.exec(docs)?.[0].match(/"\w+"/g);
		if (listed) return listed.join(" | ");
		const constants = type.members.filter((each) => this.#literalOf(each) && new RegExp(`\\b${each.name}\\b`).test(docs));
		return constants.length > 1 ? constants.map((each) => each.initial).join(" | ") : null;
	}

	#parameters(member, owner, generic = "") {
		const booleans = owner ? endingBooleans(owner, member) : [];
		const literal = ` | { ${booleans.map(({ name }) => `${name}?: boolean | undefined`).join("; ")} }`;
		return member.parameters.map((parameter) => {
			const { name, type, value, isRest } = parameter;
			if (isRest) return `...${name}: string[]`;
			if (generic.endsWith(NAMING) && /breed$/i.test(name)) return `${name}: ${name === "breed" ? "Name" : "OtherName"}`;
			const isFinding = generic.startsWith("<FoundAgent ");
			if (isFinding && type === "Vector.<Agent>") return `${name}?: Filled<${FOUND}> | null`;
			if (generic.endsWith(FILTERING) && type === "AgentFilter") return `${name}?: ${filterOf(this.#agent, isFinding ? "FoundAgent" : this.#agent)} | null`;
			if (generic.endsWith(FILTERING) && type === "WalkOptions") return `${name}?: WalkOptionsInit<${this.#agent}, ${FILTER_NAMES}> | null`;
			if (generic === FILLING && name === "out") return "out?: Taker";
			const text = this.#parameterType(parameter, this.#docsOf(member, parameter, owner));
			return `${name}${value === null ? "" : "?"}: ${text}${parameter === booleans[0] ? literal : ""}`;
		}).join(", ");
	}

	/** The documentation of a parameter. "as in moveTo" is replaced by the documentation of that parameter in moveTo. */
	#docsOf({ doc: text }, { name }, owner) {
		const own = docOfParameter(name, text);
		const other = /^as in (?:the )?(\w+)/.exec(own)?.[1];
		const member = owner?.members.find((each) => each.name === other || other === "constructor" && each.kind === other);
		return member ? this.#docsOf(member, { name }, owner) : own;
	}

	#parameterType(parameter, docs = "") {
		// who asks a question need not be in the list, and what it fills may have been made for any class of agents before
		const agent = this.#agent;
		const isForAny = parameter.type !== "SeenAgents" && this.#isGeneric(this.#exported.get(/^(?:Vector\.<)?(\w+)>?$/.exec(parameter.type)?.[1]));
		if (parameter.type === "Agent" || isForAny) this.#agent = "Agent";
		const text = this.#parameterText(parameter, docs);
		this.#agent = agent;
		return text;
	}

	#parameterText({ name, type, value }, docs) {
		const orNull = value === "null" || /(?<!\bnot )\bnull\b/.test(docs) ? " | null" : "";
		if (BY_NAME.has(name)) return BY_NAME.get(name) + orNull;
		const element = /^Vector\.<(.*)>$/.exec(type)?.[1];
		if (element && name !== "out" && !/^(Number|int|uint)$/.test(element)) return `readonly ${mayHaveNull(docs) ? `(${this.#type(element)} | null)` : this.#type(element)}[]${orNull}`;
		if (/^Vector\.<(Number|int|uint)>$/.test(type) && name !== "out") return `Numbers${orNull}`;
		if (type === "ByteArray") return `Bytes${orNull}`;
		if (type === "String" && LISTED.test(docs)) return LISTED.exec(docs)[0].match(/"\w+"/g).join(" | ") + orNull;
		if (/^(?:AgentFilter|WalkOptions)$/.test(type)) return `${type}Init${this.#agent === "Agent" ? "" : `<${this.#agent}>`}${orNull}`;
		if (type === "Vector3D") return `${isWritten(docs) ? "PointTaker" : "Point"}${orNull}`;
		if (type === "Function") {
			const written = /<code>(?:function)?(\([^<]*)<\/code>/.exec(docs)?.[1];
			if (!written) return PRIMITIVES.Function + orNull;
			const more = /<code>(contact:Contact)<\/code>/.exec(docs)?.[1] ?? (/third argument would be null/.test(docs) ? "contact:null" : undefined);
			// "null for none" is of what a function returns, if the function itself has to be there
			const orNone = value === null && /\bnull for none\b/.test(docs) ? " | null" : "";
			return this.#functionType(more ? written.replace(")", `, ${more})`) : written) + orNone;
		}
		return `${this.#type(type)}${orNull}`;
	}

	/** "(a:Agent):void" */
	#functionType(text) {
		const [, list, result] = /^\(([^)]*)\):(\S+)/.exec(text) ?? [null, "", "unknown"];
		const parameters = list.split(",").filter((word) => word.trim() !== "").map((word) => {
			const [name, type] = word.trim().split(":");
			const own = this.#agent === "GameAgent" ? { collider: "ColliderAgent", collidee: "CollideeAgent" }[name] : undefined;
			return `${name}: ${own ?? (type === "null" ? type : this.#type(type))}`;
		});
		return `(${parameters.join(", ")}) => ${this.#type(result)}`;
	}

	#type(type) {
		const element = /^Vector\.<(.*)>$/.exec(type)?.[1];
		if (element) return `${this.#type(element)}[]`;
		if (type === "Agent") return this.#agent;
		const isOfAgents = this.#agent !== "Agent" && this.#isGeneric(this.#exported.get(type));
		if (isOfAgents) return `${type}<${hasQuestions(this.#exported.get(type)) ? "Breeds, " : ""}${this.#agent}>`;
		return PRIMITIVES[type] ?? (this.#exported.has(type) || type === "ByteArray" ? type : "unknown");
	}
}
