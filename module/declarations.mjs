/** Writes index.d.ts: TypeScript's view of the public classes, with their documentation. */

const PRIMITIVES = { Number: "number", int: "number", uint: "number", Boolean: "boolean", String: "string", void: "void", "*": "any", Object: "any", Array: "any[]", Class: "Function", Error: "Error", RegExp: "RegExp", Function: "(...args: any[]) => any" };
const HEAD = `/** What is taken wherever numbers are listed. */
export type Numbers = number[] | Float32Array | Float64Array | Int8Array | Int16Array | Int32Array | Uint8Array | Uint16Array | Uint32Array;

/** What is taken for a file's bytes. */
export type Bytes = ByteArray | ArrayBuffer | ArrayBufferView;
`;
const BY_HAND = `/** An argument is not what it has to be. */
export class ArgumentError extends Error {
    constructor(message?: string);
}

/** Bytes with a place to read and write at, as far as loading models needs them. */
export class ByteArray {
    /** @param source bytes to begin with, which are copied */
    constructor(source?: ArrayBuffer | ArrayBufferView | null);
    /** The order of a number's bytes: "bigEndian" or "littleEndian". */
    endian: string;
    /** Where the next byte is read or written. */
    position: number;
    /** How many bytes there are. */
    length: number;
    /** The bytes, copied. */
    toUint8Array(): Uint8Array;
}
`;

/**
 * The text of index.d.ts.
 *
 * @param types the signatures of what is exported, by qualified name
 */
export function writeDeclarations(types) {
	const writer = new Writer(new Map([...types.values()].map((type) => [type.name, type])));
	return [HEAD, ...[...types.values()].map((type) => writer.text(type)), BY_HAND].join("\n");
}

class Writer {
	#exported;

	constructor(exported) {
		this.#exported = exported;
	}

	text(type) {
		if (type.kind === "function") {
			return `${doc(type.doc, "")}export function ${type.name}(${this.#parameters(type)}): ${this.#type(type.result)};\n`;
		}
		const members = this.#membersOf(type).map((member) => this.#memberText(type, member));
		const bases = type.bases.filter((name) => this.#exported.has(name) || name === "Error");
		const interfaces = type.interfaces.filter((name) => this.#exported.has(name));
		const heritage = (bases.length > 0 ? ` extends ${bases.join(", ")}` : "") + (interfaces.length > 0 ? ` implements ${interfaces.join(", ")}` : "");
		return `${doc(type.doc, "")}export ${type.kind} ${type.name}${heritage} {\n${members.join("\n")}\n}\n`;
	}

	// Overrides that say nothing of their own are there through the base.
	#membersOf(type) {
		const isSeen = (member) => (member.isPublic || member.isProtected) && !member.isPrivate && !(member.isOverride && /^(@inheritDoc\s*)?$/.test(member.doc));
		return type.members.filter(isSeen);
	}

	#memberText(type, member) {
		const isStatic = member.isStatic ? "static " : "";
		const visible = member.isProtected ? "protected " : "";
		const text = doc(this.#docOf(type, member), "    ");
		const result = this.#type(member.result) + (this.#mayBeNull(member) ? " | null" : "");
		switch (member.kind) {
			case "constructor":
				return `${text}    constructor(${this.#parameters(member)});`;
			case "method":
				return `${text}    ${visible}${isStatic}${member.name}(${this.#parameters(member)}): ${result};`;
			case "get": {
				const isReadOnly = !type.members.some((other) => other.kind === "set" && other.name === member.name);
				if (type.kind === "interface") return `${text}    ${isReadOnly ? "readonly " : ""}${member.name}: ${result};`;
				return `${text}    ${visible}${isStatic}get ${member.name}(): ${result};`;
			}
			case "set":
				return `${visible}    ${isStatic}set ${member.name}(value: ${this.#parameterType(member.parameters[0])});`;
			default:
				return `${text}    ${visible}${isStatic}${member.kind === "const" ? "readonly " : ""}${member.name}: ${result};`;
		}
	}

	#mayBeNull(member) {
		if (member.kind === "const" || /^(Number|int|uint|Boolean|void|\*|Object)$/.test(member.result)) return false;
		const said = member.kind === "method" ? /@return([\s\S]*?)(?:\n@|$)/.exec(member.doc)?.[1] ?? member.doc.split("\n@")[0] : member.doc.split("\n@")[0];
		return /\bnull\b/.test(said);
	}

	#docOf(type, member) {
		if (!/@inheritDoc|@copy/.test(member.doc)) return member.doc;
		const copied = /@copy #(\w+)/.exec(member.doc)?.[1];
		if (copied) return type.members.find((other) => other.name === copied)?.doc ?? "";
		for (const name of [...type.bases, ...type.interfaces]) {
			const base = this.#exported.get(name);
			const found = base?.members.find((other) => other.name === member.name && other.kind === member.kind);
			if (found) return member.doc.replace("@inheritDoc", this.#docOf(base, found));
		}
		return member.doc.replace("@inheritDoc", "").trim();
	}

	#parameters({ parameters, doc: said }) {
		return parameters.map((parameter) => {
			if (parameter.isRest) return `...${parameter.name}: any[]`;
			const optional = parameter.value === null ? "" : "?";
			return `${parameter.name}${optional}: ${this.#parameterType(parameter, said)}`;
		}).join(", ");
	}

	#parameterType({ name, type, value }, said = "") {
		const orNull = value === "null" ? " | null" : "";
		if (/^Vector\.<(Number|int|uint)>$/.test(type) && name !== "out") return `Numbers${orNull}`;
		if (type === "ByteArray") return `Bytes${orNull}`;
		if (type === "Function") {
			const written = new RegExp(String.raw`@param ${name}\s+(?:(?!\n@)[\s\S])*?<code>(?:function)?(\([^<]*)</code>`).exec(said)?.[1];
			return written ? this.#functionType(written) : PRIMITIVES.Function;
		}
		return `${this.#type(type)}${orNull}`;
	}

	/** "(a:Agent):void" */
	#functionType(text) {
		const [, list, result] = /^\(([^)]*)\):(\S+)/.exec(text) ?? [null, "...args:any[]", "any"];
		const parameters = list.split(",").filter((word) => word.trim() !== "").map((word) => {
			const [name, type] = word.trim().split(":");
			return `${name}: ${this.#type(type)}`;
		});
		return `(${parameters.join(", ")}) => ${this.#type(result)}`;
	}

	#type(type) {
		const element = /^Vector\.<(.*)>$/.exec(type)?.[1];
		if (element) return `${this.#type(element)}[]`;
		return PRIMITIVES[type] ?? (this.#exported.has(type) || type === "ByteArray" ? type : "unknown");
	}
}

/** A documentation comment: HTML as Markdown, ASDoc's tags as TSDoc's. */
function doc(text, indent) {
	if (text === "") return "";
	const plain = text
		.replaceAll(/<listing[^>]*>/g, "```actionscript").replaceAll("</listing>", "```")
		.replaceAll(/<\/?code>/g, "`").replaceAll(/<\/p>/g, "").replaceAll(/<p>/g, "")
		.replaceAll(/<\/?(em|i)>/g, "*").replaceAll(/<\/?(strong|b)>/g, "**")
		.replaceAll(/<\/?ul>/g, "").replaceAll("<li>", "- ").replaceAll("</li>", "")
		.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&amp;", "&")
		.replaceAll(/^@return /gm, "@returns ").replaceAll(/@eventType.*$/gm, "").replaceAll("*/", "* /").trim();
	const lines = plain.split("\n");
	if (lines.length === 1) return `${indent}/** ${lines[0]} */\n`;
	return `${indent}/**\n${lines.map((line) => `${indent} * ${line}`.trimEnd()).join("\n")}\n${indent} */\n`;
}
