/**
 * Translates the JavaScript that Apache's ActionScript compiler writes into ES classes.
 *
 * For each file the compiler writes functions on prototypes of global names, Vectors of its own runtime, mangled private names, and types
 * in comments. Here each file becomes a class like the ActionScript class: fields set in the constructor, getters and setters, `super`,
 * plain arrays for Vectors, short names. All classes of a program are in one module scope. A class comes after the class that it extends.
 * Then come the statics that are more than a literal, each after the statics that it needs.
 *
 * unit.mjs reads the compiler's files, scopes.mjs tells what names mean there, bodies.mjs writes functions, statics.mjs the statics, and this file the
 * classes around them.
 */
import { ONLY_IN_JAVASCRIPT, RETURNS_UINT8ARRAY } from "../differences.mjs";
import { Bodies } from "./bodies.mjs";
import { Checks, isWrapped } from "./checks.mjs";
import { MemberNames } from "./members.mjs";
import { Scopes } from "./scopes.mjs";
import { isVisible } from "../signatures.mjs";
import { isConstant, staticsText } from "./statics.mjs";
import { LANGUAGE, indent, isAbstract, isBaseCall, isFieldAssignment, pathOf, plainComment } from "./syntax.mjs";
import { unitsOf } from "./unit.mjs";

// Classes of plain data, which tools show as they are.
const SHOWN_AS_THEY_ARE = new Set(["flash.geom.Vector3D", "flash.geom.Matrix3D"]);

/** All that is translated together, as a Program is in TypeScript: the compiler's files, and names from elsewhere. */
export class Program {
	#units = new Map(); // by qualified name
	#shortNames = new Map();
	#members;
	#publicClassNames = null; // of members that objects of public classes have
	#scopes;
	#bodies;
	#checks;

	/**
	 * @param files the compiler's files: { file, source }
	 * @param externals names from elsewhere: { "flash.utils.ByteArray": "ByteArray" }
	 * @param signatures the public declarations, by qualified name. Their parameters are checked, and accept more forms than in ActionScript
	 * @param isForTests whether it is for the engine's own tests, which are ActionScript: all statics are accessible, casts stay checked, methods
	 * return ByteArrays
	 */
	constructor(files, externals, signatures = new Map(), isForTests = false) {
		this.externals = externals;
		this.signatures = signatures;
		this.isForTests = isForTests;
		this.#checks = new Checks(signatures, (qname) => this.#bodies.reference(qname));
		for (const { file, source } of files) {
			for (const unit of unitsOf(file, source)) {
				const isNamespace = pathOf(unit.main.callee) === "Namespace";
				if (!isNamespace && unit.qname !== LANGUAGE && !(unit.qname in externals)) this.#units.set(unit.qname, unit);
			}
		}
		const taken = new Set(Object.values(externals));
		for (const unit of [...this.#units.values()].sort((a, b) => isOfEngine(b) - isOfEngine(a))) {
			const words = unit.qname.split(".");
			const own = unit.isInner && unit.kind !== "class" ? words.slice(-2).join("_") : unit.name;
			const name = taken.has(own) ? words.join("_") : isWrapped(signatures.get(unit.qname)) ? `${own}$` : own;
			taken.add(name).add(own);
			this.#shortNames.set(unit.qname, name);
		}
		this.#members = new MemberNames(this.#units, signatures);
		this.#scopes = new Scopes(this.#units, externals);
		this.#bodies = new Bodies(this, this.#units, this.#members, this.#scopes);
	}

	/** The qualified names of the program's definitions. */
	get names() {
		return [...this.#units.keys()];
	}

	/** The name in the text for a qualified name. */
	shortName(qname) {
		return this.#shortNames.get(qname);
	}

	/** The name under which the module exports a public declaration. */
	exportName(qname) {
		return this.shortName(qname)?.replace(/\$$/, "");
	}

	/** The tests of a class: { name, kind, args }. Inherited tests come first. */
	testsOf(qname) {
		const unit = this.#units.get(qname);
		return unit ? [...this.testsOf(unit.base), ...unit.tests] : [];
	}

	/** The text of all definitions. */
	text() {
		const written = new Set();
		const parts = [];
		const write = (unit) => {
			if (!unit || written.has(unit)) return;
			written.add(unit);
			write(this.#units.get(unit.base));
			if (unit.kind !== "variable") parts.push(this.#textOf(unit));
		};
		for (const unit of this.#units.values()) write(unit);
		return `${parts.join("\n\n")}\n\n${staticsText(this.#units, this.#scopes, this, this.#bodies)}`;
	}

	/**
	 * The names of members that only the program's own text reads, of objects whose class it knows. They may be exchanged for others. It is
	 * known after text().
	 */
	get hiddenNames() {
		const shown = [...this.signatures.values()].flatMap((type) => type.members).filter(isVisible).map((member) => member.name);
		const kept = new Set([...shown, ...this.#bodies.namesOfUnknownObjects]);
		const found = new Set();
		for (const unit of this.#units.values()) {
			const methods = unit.members.filter((member) => member.kind === "method").map((member) => this.#members.nameOf(member.name));
			for (const name of this.#memberNames(unit)) {
				// tools show the state of public classes: the names without _ or $
				const isState = this.signatures.has(unit.qname) && !/^[_$]/.test(name) && !methods.includes(name);
				(isState ? kept : found).add(name);
			}
		}
		return [...found].filter((name) => !kept.has(name));
	}

	/** Whether objects of public classes have a member of a name. A game's own class may extend these. */
	isInPublicClass(name) {
		const withBases = (unit) => (unit ? [unit, ...withBases(this.#units.get(unit.base))] : []);
		this.#publicClassNames ??= new Set([...this.signatures.keys()].flatMap((qname) => withBases(this.#units.get(qname))).flatMap((unit) => this.#memberNames(unit)));
		return this.#publicClassNames.has(name);
	}

	#memberNames(unit) {
		const known = [...unit.types.keys(), ...unit.members.map((member) => member.name)];
		return [...known.map((name) => this.#members.nameOf(name)), ...this.#checks.settings(unit.qname).map((setting) => fieldOf(setting))];
	}

	#textOf(unit) {
		try {
			return this.#scopes.within(unit, () => this.#definitionText(unit));
		} catch (error) {
			throw new Error(`${unit.file}: ${error.message}`, { cause: error });
		}
	}

	#definitionText(unit) {
		const doc = this.#docOf(unit, unit.doc);
		if (unit.kind === "interface") return this.#interfaceText(unit);
		if (unit.kind === "function") {
			return `${doc}function ${this.shortName(unit.qname)}${this.#bodies.functionText(unit.main, unit.doc)}${this.#wrapperText(unit)}`;
		}
		const text = unit.base === "Error" ? withPrivateFields(this.#classText(unit)) : this.#classText(unit);
		return `${this.#showsState(unit) ? `const ${this.shortName(unit.qname)} = /* @__PURE__ */ $shown(${text});` : doc + text}${this.#functionsText(unit)}`;
	}

	// index.d.ts has the documentation of what is exported.
	#docOf(unit, doc) {
		return this.signatures.has(unit.qname) ? "" : plainComment(doc);
	}

	// The export for a package function that the engine calls in its loops.
	#wrapperText(unit) {
		if (!isWrapped(this.signatures.get(unit.qname))) return "";
		const { parameters } = this.#bodies.enter(unit.main, unit.doc);
		this.#bodies.leave();
		const passed = unit.main.params.map((parameter) => parameter.name).join(", ");
		const lines = [...this.#checks.prologueOf(unit.qname, unit.name, "function"), `return ${this.shortName(unit.qname)}(${passed});`];
		return `\n\nfunction ${this.exportName(unit.qname)}(${parameters}) {\n${lines.map(indent).join("\n")}\n}`;
	}

	// Tools show only the public state of public classes.
	#showsState(unit) {
		const type = this.signatures.get(unit.qname);
		return type?.kind === "class" && !this.#hasShownBase(unit) && !SHOWN_AS_THEY_ARE.has(unit.qname);
	}

	// Whether a class extends a public class, or one of the platform. A base that only the engine knows shows nothing.
	#hasShownBase({ base }) {
		if (!base) return false;
		const unit = this.#units.get(base);
		return !unit || this.signatures.has(base) || this.#hasShownBase(unit);
	}

	#interfaceText(unit) {
		const names = this.#interfaceMembers(unit).map((name) => JSON.stringify(name));
		return `${this.#docOf(unit, unit.doc)}class ${this.shortName(unit.qname)} {
	static [Symbol.hasInstance](value) {
		return $hasMembers(value, [${names.join(", ")}]);
	}
}`;
	}

	#interfaceMembers(unit) {
		const bases = [...unit.source.matchAll(/^ \* @extends \{([\w.]+)\}/gm)].map((match) => this.#units.get(match[1]));
		return [...bases.flatMap((base) => (base ? this.#interfaceMembers(base) : [])), ...unit.members.map((member) => member.name)];
	}

	#classText(unit) {
		const base = unit.base ? ` extends ${this.#bodies.reference(unit.base)}` : "";
		const lines = [];
		for (const field of unit.staticValues) {
			const name = this.#members.nameOf(field.name);
			if (!this.isForTests && !this.#isVisibleStatic(unit, field.name)) continue;
			lines.push(`static get ${name}() {\n\treturn ${this.staticName(unit, field.name)};\n}`);
			if (!isConstant(field)) lines.push(`static set ${name}(value) {\n\t${this.staticName(unit, field.name)} = value;\n}`);
		}
		// Errors name classes, also if a bundler shortens the names. A field would turn V8's class into a dictionary, and V8 never finishes
		// compiling a constructor that calls super() in one: it begins again and again, with all functions that make such an object.
		if (this.signatures.has(unit.qname)) lines.push(`static get name() {\n\treturn ${JSON.stringify(unit.name)};\n}`);
		lines.push(this.#constructorText(unit));
		// $shown does this for public classes. Users never see the text of others.
		if (!unit.base && !this.#showsState(unit) && (this.isForTests || this.signatures.has(unit.qname))) lines.push(`get [Symbol.toStringTag]() {\n\treturn this.constructor.name;\n}`);
		if (this.#checks.isMarked(unit.qname)) lines.push(`get $is${unit.name}() {\n\treturn $copy;\n}`);
		for (const setting of this.#checks.settings(unit.qname)) {
			const check = this.#checks.ofSetting(unit.qname, setting).map((line) => `${indent(line)}\n`).join("");
			const field = fieldOf(setting);
			lines.push(`get ${setting.name}() {\n\treturn this.${field};\n}`, `set ${setting.name}(value) {\n${check}\tthis.${field} = value;\n}`);
		}
		for (const member of unit.members) {
			const prefix = (member.isStatic ? "static " : "") + (member.kind === "method" ? "" : `${member.kind} `);
			const name = this.#members.nameOf(member.name);
			// nothing calls these, and only the engine could extend the class
			if (!this.isForTests && !this.signatures.has(unit.qname) && isAbstract(member.node, unit.source)) continue;
			if (this.#isFunction(unit, member)) {
				if (this.isForTests) lines.push(`static get ${name}() {\n\treturn ${this.staticName(unit, member.name)};\n}`);
			} else {
				const prologue = this.#checks.prologueOf(unit.qname, member.name, member.kind);
				const text = this.#bodies.functionText(member.node, member.doc, prologue);
				const returnsBytes = !this.isForTests && RETURNS_UINT8ARRAY.has(`${unit.qname}.${member.name}`);
				lines.push(`${this.#docOf(unit, member.doc)}${prefix}${name}${returnsBytes ? asPlainBytes(text) : text}`);
			}
		}
		if (ONLY_IN_JAVASCRIPT[unit.qname]) lines.push(ONLY_IN_JAVASCRIPT[unit.qname].text);
		return `class ${this.shortName(unit.qname)}${base} {\n${indent(lines.filter((line) => line !== "").join("\n\n"))}\n}`;
	}

	// A static method that is not for users becomes a function of the module, like statics: a bundle then has it only if it calls it.
	#isFunction(unit, member) {
		return member.isStatic && member.kind === "method" && !this.#isVisibleStatic(unit, member.name);
	}

	#functionsText(unit) {
		return unit.members.filter((member) => this.#isFunction(unit, member))
			.map((member) => `\n\n${this.#docOf(unit, member.doc)}function ${this.staticName(unit, member.name)}${this.#bodies.functionText(member.node, member.doc)}`).join("");
	}

	#constructorText(unit) {
		const { parameters, body } = this.#bodies.enter(unit.main, unit.doc);
		const prologue = this.#checks.prologueOf(unit.qname, unit.name, "constructor");
		const fields = unit.fields.filter((field) => !this.#isSetAnyway(field, body));
		const settings = this.#checks.settings(unit.qname).map((setting) => setting.name);
		const nameOf = (field) => (settings.includes(field.name) ? fieldOf(field) : this.#members.nameOf(field.name));
		const initial = fields.map((field) => `this.${nameOf(field)} = ${this.#bodies.text(field.value)};`);
		let statements;
		if (unit.base) {
			const at = body.findIndex((statement) => isBaseCall(statement));
			if (at < 0) throw new Error("its constructor does not call super()");
			const { until, held } = this.#bodies.untilSuper(body.slice(0, at + 1));
			statements = [...prologue, ...until, ...initial, ...held, ...this.#bodies.statements(body.slice(at + 1))];
		} else {
			statements = [...prologue, ...initial, ...this.#bodies.statements(body)];
		}
		statements.push(...this.#checks.ofLiteral(unit.qname));
		this.#bodies.leave();
		if (statements.length === 0 && parameters === "") return "";
		return `constructor(${parameters}) {\n${statements.map(indent).join("\n")}\n}`;
	}

	// Whether the constructor sets a field at its beginning. Then the field needs no value before.
	#isSetAnyway(field, body) {
		return body.some((statement) => isFieldAssignment(statement) && statement.expression.left.property.name === field.name &&
			!/this|arguments/.test(this.#scopes.unit.source.slice(statement.expression.right.start, statement.expression.right.end)));
	}

	/** The definition of the class that declares a static which is a variable or function of the module: the named class, or one that it extends; or null. */
	ownerOf(qname, name) {
		for (let unit = this.#units.get(qname); unit; unit = this.#units.get(unit.base)) {
			const isValue = unit.staticValues.some((field) => field.name === name);
			if (isValue || unit.members.some((member) => member.name === name && this.#isFunction(unit, member))) return unit;
		}
		return null;
	}

	/**
	 * The name of a static in the module, where it is a variable. A class's own static would need a statement, and bundlers do not leave out a class with such
	 * statements.
	 */
	staticName(unit, name) {
		return `${this.shortName(unit.qname)}$${this.#members.nameOf(name)}`;
	}

	// Whether the types show it: to users, or to classes that extend this one.
	#isVisibleStatic(unit, name) {
		return Boolean(this.signatures.get(unit.qname)?.members.some((member) => member.isStatic && isVisible(member) && member.name === name));
	}
}

/** Whether a definition is the engine's own. These get their short names first. */
function isOfEngine(unit) {
	return unit.qname.startsWith("starlogo.");
}

/** The name of the field that keeps the value of a setting. */
function fieldOf({ name }) {
	return `$_${name}`;
}

/** Makes the fields of an error's class private, because Node prints all others below the message. Its getters have what users read. */
function withPrivateFields(text) {
	const names = [...new Set(text.match(/(?<=\bthis\.\$?)_\w+/g))];
	return text.replaceAll(/\bthis\.\$?_/g, "this.#").replace("{\n", () => `{\n${names.map((name) => `\t#${name.slice(1)};\n`).join("")}`);
}

/** Wraps a method that returns a ByteArray, so that it returns a Uint8Array. */
function asPlainBytes(text) {
	const [, parameters, body] = /^(\([^)]*\)) \{\n([\s\S]*)\}$/.exec(text);
	return `${parameters} {\n\treturn (() => {\n${indent(body).trimEnd()}\n\t})().toUint8Array();\n}`;
}
