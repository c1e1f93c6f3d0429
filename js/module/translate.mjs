/**
 * Translates the JavaScript that Apache's ActionScript compiler writes into ES classes.
 *
 * For each file the compiler writes functions on prototypes of global names, Vectors of its own runtime, mangled private names, and types
 * in comments. Here each file becomes a class like the ActionScript class: fields set in the constructor, getters and setters, `super`,
 * plain arrays for Vectors, short names. All classes of a program are in one module scope. A class comes after the class that it extends.
 * Then come the statics that are more than a literal, each after the statics that it needs.
 */
import { parseExpressionAt } from "acorn";
import { ADDED, PLAIN_BYTES } from "./added.mjs";
import { Checks, isWrapped } from "./checks.mjs";
import { MemberNames } from "./members.mjs";
import { isShown } from "./signatures.mjs";
import { LANGUAGE, bare, childrenOf, docOf, forEach, gap, indent, isBaseCall, isFieldAssignment, parameterDefault, pathOf, superCall, vectorType } from "./syntax.mjs";
import { unitsOf } from "./unit.mjs";

// V8 holds the two names' values as objects. If a Number may be one of them, it makes an object for the Number too.
const WITHOUT_NAMES = new Map([["Infinity", "(1 / 0 /* Infinity */)"], ["NaN", "(0 / 0 /* NaN */)"]]);

// Statics that only tests set. Elsewhere they are false, and code that they switch on is left out.
const SWITCHES = new Set(["flash.geom.Matrix3D.isSingle"]);

// Classes of plain data, which tools show as they are.
const SHOWN_AS_THEY_ARE = new Set(["flash.geom.Vector3D", "flash.geom.Matrix3D"]);
const BUILT_IN = new Set(["Array", "Boolean", "Function", "Number", "Object", "String", "Error", "RangeError", "TypeError"]);

/** A program made of the compiler's files, and of names from elsewhere. */
export class Program {
	#units = new Map(); // by qualified name
	#roots = new Set();
	#shortNames = new Map();
	#members;
	#unit;
	#scopes = [];
	#beforeSuper = null;
	#target = null; // the definition that is assigned to
	#open = new Set(); // names of members of objects whose class is not known
	#checks;

	/**
	 * @param files the compiler's files: { file, source }
	 * @param externals names from elsewhere: { "flash.utils.ByteArray": "ByteArray" }
	 * @param signatures the public declarations, by qualified name. Their parameters are checked, and accept more forms than in ActionScript
	 * @param hasAllStatics whether the statics of all classes are accessible from outside, not only those of public classes
	 */
	constructor(files, externals, signatures = new Map(), hasAllStatics = false) {
		this.externals = externals;
		this.signatures = signatures;
		this.hasAllStatics = hasAllStatics;
		this.#checks = new Checks(signatures, (qname) => this.#reference(qname));
		for (const { file, source } of files) {
			for (const unit of unitsOf(file, source)) {
				const isNamespace = pathOf(unit.main.callee) === "Namespace";
				if (!isNamespace && unit.qname !== LANGUAGE && !(unit.qname in externals)) this.#units.set(unit.qname, unit);
			}
		}
		for (const qname of [...this.#units.keys(), ...Object.keys(externals), LANGUAGE]) this.#roots.add(qname.split(".")[0]);
		for (const root of ["flash", "mx", "org", "goog"]) this.#roots.add(root);
		const taken = new Set(Object.values(externals));
		for (const unit of [...this.#units.values()].sort((a, b) => rank(a) - rank(b))) {
			const words = unit.qname.split(".");
			const own = unit.isInner && unit.kind !== "class" ? words.slice(-2).join("_") : unit.name;
			const name = taken.has(own) ? words.join("_") : isWrapped(signatures.get(unit.qname)) ? `${own}$` : own;
			taken.add(name).add(own);
			this.#shortNames.set(unit.qname, name);
		}
		this.#members = new MemberNames(this.#units, signatures);
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
		return `${parts.join("\n\n")}\n\n${this.#staticsText()}`;
	}

	/**
	 * The names of members that only the program's own text reads, of objects whose class it knows. They may be exchanged for others. It is
	 * known after text().
	 */
	get hiddenNames() {
		const shown = [...this.signatures.values()].flatMap((type) => type.members).filter(isShown).map((member) => member.name);
		const kept = new Set([...shown, ...this.#open]);
		const found = new Set();
		for (const unit of this.#units.values()) {
			const methods = unit.members.filter((member) => member.kind === "method").map((member) => member.name);
			for (const known of new Set([...unit.types.keys(), ...unit.members.map((member) => member.name)])) {
				const name = this.#members.nameOf(known);
				// tools show the state of public classes: the names without _ or $
				const isState = this.signatures.has(unit.qname) && !/^[_$]/.test(name) && !methods.includes(known);
				(isState ? kept : found).add(name);
			}
			for (const setting of this.#checks.settings(unit.qname)) found.add(`_${setting.name}`);
		}
		return [...found].filter((name) => !kept.has(name));
	}

	#textOf(unit) {
		this.#unit = unit;
		try {
			const doc = this.#docOf(unit, unit.doc);
			if (unit.kind === "interface") return this.#interfaceText(unit);
			if (unit.kind === "function") return `${doc}function ${this.shortName(unit.qname)}${this.#functionText(unit.main, unit.doc)}${this.#wrapperText(unit)}`;
			const text = this.#classText(unit);
			return `${this.#isShown(unit) ? `const ${this.shortName(unit.qname)} = /* @__PURE__ */ ${this.#helper("shown")}(${text});` : doc + text}${this.#functionsText(unit)}`;
		} catch (error) {
			throw new Error(`${unit.file}: ${error.message}`, { cause: error });
		}
	}

	// index.d.ts has the documentation of what is exported.
	#docOf(unit, doc) {
		return this.signatures.has(unit.qname) ? "" : docOf(doc);
	}

	// The export for a package function that the engine calls in its loops.
	#wrapperText(unit) {
		if (!isWrapped(this.signatures.get(unit.qname))) return "";
		const { parameters } = this.#opened(unit.main, unit.doc);
		this.#scopes.pop();
		const passed = unit.main.params.map((parameter) => parameter.name).join(", ");
		const lines = [...this.#checks.of(unit.qname, unit.name, "function"), `return ${this.shortName(unit.qname)}(${passed});`];
		return `\n\nfunction ${this.exportName(unit.qname)}(${parameters}) {\n${lines.map(indent).join("\n")}\n}`;
	}

	// Tools show only the public state of public classes.
	#isShown(unit) {
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
		return ${this.#helper("hasMembers")}(value, [${names.join(", ")}]);
	}
}`;
	}

	#interfaceMembers(unit) {
		const bases = [...unit.source.matchAll(/^ \* @extends \{([\w.]+)\}/gm)].map((match) => this.#units.get(match[1]));
		return [...bases.flatMap((base) => (base ? this.#interfaceMembers(base) : [])), ...unit.members.map((member) => member.name)];
	}

	#classText(unit) {
		const base = unit.base ? ` extends ${this.#reference(unit.base)}` : "";
		const lines = [];
		for (const field of unit.staticValues) {
			const name = this.#members.nameOf(field.name);
			if (!this.#isSeen(unit, field.name)) continue;
			lines.push(`static get ${name}() {\n\treturn ${this.#staticName(unit, field.name)};\n}`);
			if (!isConstant(field)) lines.push(`static set ${name}(value) {\n\t${this.#staticName(unit, field.name)} = value;\n}`);
		}
		// Errors name classes, also if a bundler shortens the names. A field would turn V8's class into a dictionary, and V8 never finishes
		// compiling a constructor that calls super() in one: it begins again and again, with all functions that make such an object.
		if (this.signatures.has(unit.qname)) lines.push(`static get name() {\n\treturn ${JSON.stringify(unit.name)};\n}`);
		lines.push(this.#constructorText(unit));
		// $shown does this for public classes. Users never see the text of others.
		if (!unit.base && !this.#isShown(unit) && (this.hasAllStatics || this.signatures.has(unit.qname))) lines.push(`get [Symbol.toStringTag]() {\n\treturn this.constructor.name;\n}`);
		if (this.#checks.isMarked(unit.qname)) lines.push(`get $is${unit.name}() {\n\treturn $copy;\n}`);
		for (const setting of this.#checks.settings(unit.qname)) {
			const check = this.#checks.ofSetting(unit.qname, setting).map((line) => `${indent(line)}\n`).join("");
			lines.push(`get ${setting.name}() {\n\treturn this._${setting.name};\n}`, `set ${setting.name}(value) {\n${check}\tthis._${setting.name} = value;\n}`);
		}
		for (const member of unit.members) {
			const prefix = (member.isStatic ? "static " : "") + (member.kind === "method" ? "" : `${member.kind} `);
			const name = this.#members.nameOf(member.name);
			if (this.#isLoose(unit, member)) {
				if (this.hasAllStatics) lines.push(`static get ${name}() {\n\treturn ${this.#staticName(unit, member.name)};\n}`);
			} else if (member.node === null) {
				lines.push(member.kind === "get" ? `get ${name}() {\n\treturn super.${name};\n}` : `set ${name}(value) {\n\tsuper.${name} = value;\n}`);
			} else {
				const taken = this.#checks.of(unit.qname, member.name, member.kind);
				// hasAllStatics is for tests, which are ActionScript and expect ByteArrays
				const text = this.#functionText(member.node, member.doc, taken);
				lines.push(`${this.#docOf(unit, member.doc)}${prefix}${name}${!this.hasAllStatics && PLAIN_BYTES.has(`${unit.qname}.${member.name}`) ? asPlainBytes(text) : text}`);
			}
		}
		if (ADDED[unit.qname]) lines.push(ADDED[unit.qname].text);
		return `class ${this.shortName(unit.qname)}${base} {\n${indent(lines.filter((line) => line !== "").join("\n\n"))}\n}`;
	}

	// A static method that is not for users becomes a function of the module, like statics: a bundle then has it only if it calls it.
	#isLoose(unit, member) {
		return member.isStatic && member.kind === "method" && !this.#isShownStatic(unit, member.name);
	}

	#functionsText(unit) {
		return unit.members.filter((member) => this.#isLoose(unit, member))
			.map((member) => `\n\n${this.#docOf(unit, member.doc)}function ${this.#staticName(unit, member.name)}${this.#functionText(member.node, member.doc)}`).join("");
	}

	#constructorText(unit) {
		const { parameters, body } = this.#opened(unit.main, unit.doc);
		const taken = this.#checks.of(unit.qname, unit.name, "constructor");
		const fields = unit.fields.filter((field) => !this.#isSetAnyway(field, body));
		const settings = this.#checks.settings(unit.qname).map((setting) => setting.name);
		const nameOf = (field) => (settings.includes(field.name) ? `_${field.name}` : this.#members.nameOf(field.name));
		const initial = fields.map((field) => `this.${nameOf(field)} = ${this.#text(field.value)};`);
		let statements;
		if (unit.base) {
			const at = body.findIndex((statement) => isBaseCall(statement));
			if (at < 0) throw new Error("its constructor does not call super()");
			this.#beforeSuper = new Map();
			const early = body.slice(0, at).map((statement) => this.#text(statement));
			const call = this.#text(body[at]);
			const held = [...this.#beforeSuper].map(([name, local]) => `this.${name} = ${local};`);
			this.#beforeSuper = null;
			statements = [...taken, ...early, call, ...initial, ...held, ...this.#statements(body.slice(at + 1))];
		} else {
			statements = [...taken, ...initial, ...this.#statements(body)];
		}
		this.#scopes.pop();
		if (statements.length === 0 && parameters === "") return "";
		return `constructor(${parameters}) {\n${statements.map(indent).join("\n")}\n}`;
	}

	// Whether the constructor sets a field at its beginning. Then the field needs no value before.
	#isSetAnyway(field, body) {
		return body.some((statement) => isFieldAssignment(statement) && statement.expression.left.property.name === field.name &&
			!/this|arguments/.test(this.#unit.source.slice(statement.expression.right.start, statement.expression.right.end)));
	}

	#functionText(node, doc, taken = []) {
		const { parameters, body } = this.#opened(node, doc);
		const statements = [...taken, ...this.#statements(body)];
		this.#scopes.pop();
		const lines = statements.map(indent);
		return lines.length === 0 ? `(${parameters}) {\n}` : `(${parameters}) {\n${lines.join("\n")}\n}`;
	}

	// Enters a function. Returns its parameters with their defaults, and the rest of its body.
	#opened(node, doc) {
		const scope = new Map();
		for (const match of this.#typesDoc(node, doc).matchAll(/@param \{([^\n]*?)=?\} (\w+)/g)) scope.set(match[2], match[1]);
		for (const parameter of node.params) if (!scope.has(parameter.name)) scope.set(parameter.name, this.#typeBefore(parameter));
		this.#collectLocals(node.body, scope);
		this.#scopes.push(scope);
		const defaults = new Map();
		const body = node.body.body.filter((statement) => {
			const found = parameterDefault(statement);
			if (found && node.params.some((parameter) => parameter.name === found.name)) {
				defaults.set(found.name, this.#text(found.value));
				return false;
			}
			return statement.type !== "EmptyStatement";
		});
		const parameters = node.params.map(({ name }) => (defaults.has(name) ? `${name} = ${defaults.get(name)}` : name)).join(", ");
		return { parameters, body };
	}

	// The compiler writes no types for a method that has its documentation from its base.
	#typesDoc(node, doc) {
		const name = this.#unit.members.find((member) => member.node === node)?.name;
		for (let base = this.#units.get(this.#unit.base); name && base && !/@param \{/.test(doc); base = this.#units.get(base.base)) {
			doc = base.members.find((member) => member.name === name)?.doc ?? doc;
		}
		return doc;
	}

	#collectLocals(node, scope) {
		if (!node || typeof node.type !== "string") return;
		if (node.type === "FunctionExpression" || node.type === "FunctionDeclaration" && node.id) {
			if (node.type === "FunctionDeclaration") scope.set(node.id.name, "Function");
			return;
		}
		if (node.type === "VariableDeclarator") {
			let type = this.#typeBefore(node.id);
			const each = node.init?.type === "MemberExpression" && /^foreachiter\d+$/.test(node.init.property.name ?? "");
			if (each && type === "*") type = "*each";
			scope.set(node.id.name, type);
		}
		if (node.type === "CatchClause" && node.param) scope.set(node.param.name, "Error");
		for (const child of childrenOf(node)) this.#collectLocals(child, scope);
	}

	#typeBefore(node) {
		return /\/\*\*? (?:@type )?\{?([^*{}]*?)=?\}? ?\*\/ *$/.exec(this.#unit.source.slice(Math.max(0, node.start - 200), node.start))?.[1].trim() ?? "*";
	}

	#isLocal(name) {
		return this.#scopes.some((scope) => scope.has(name));
	}

	// Statements. The compiler's three statements for a "for each" become one.
	#statements(body) {
		const lines = [];
		for (let i = 0; i < body.length; i++) {
			const each = forEach(body[i], body[i + 1]);
			if (each) {
				lines.push(`for (${each.isDeclared ? "var " : ""}${this.#text(each.variable)} of ${this.#helper("values")}(${this.#text(each.over)})) ${this.#text(each.body)}`);
				i++;
			} else if (body[i].type !== "EmptyStatement" && !this.#isSwitchedOff(body[i])) {
				lines.push(this.#text(body[i]));
			}
		}
		return lines;
	}

	#isSwitchedOff(statement) {
		return !this.hasAllStatics && statement.type === "IfStatement" && SWITCHES.has(pathOf(statement.test));
	}

	#text(node) {
		const special = this.#special(node);
		if (special !== null) return special;
		const source = this.#unit.source;
		let text = "";
		let at = node.start;
		for (const child of childrenOf(node)) {
			text += gap(source.slice(at, child.start)) + this.#text(child);
			at = child.end;
		}
		return text + gap(source.slice(at, node.end));
	}

	#special(node) {
		switch (node.type) {
			case "Literal":
				return this.#unit.source.slice(node.start, node.end);
			case "BlockStatement":
				return this.#blockText(node);
			case "FunctionExpression":
				return `function${this.#functionText(node, "")}`;
			case "FunctionDeclaration":
				return `function ${node.id.name}${this.#functionText(node, "")}`;
			case "SwitchCase":
				return `${node.test ? `case ${this.#text(node.test)}` : "default"}:\n${this.#statements(node.consequent).map(indent).join("\n")}`;
			case "CatchClause":
				return this.#catchText(node);
			case "Identifier":
				return this.#identifierText(node);
			case "Property":
				return node.shorthand ? null : `${node.computed ? `[${this.#text(node.key)}]` : this.#unit.source.slice(node.key.start, node.key.end)}: ${this.#text(node.value)}`;
			case "MemberExpression":
				return this.#memberText(node);
			case "NewExpression":
				return this.#newText(node);
			case "CallExpression":
				return this.#callText(node);
			case "ExpressionStatement":
				return this.#earlyFieldText(node);
			case "AssignmentExpression":
				return this.#assignmentText(node);
			default:
				return null;
		}
	}

	#blockText(node) {
		// the compiler puts the body of a "for each" into a block of its own
		const body = node.body.length === 1 && node.body[0].type === "BlockStatement" ? node.body[0].body : node.body;
		const lines = this.#statements(body).map(indent);
		return lines.length === 0 ? "{\n}" : `{\n${lines.join("\n")}\n}`;
	}

	// Errors of other classes are thrown again.
	#catchText(node) {
		const { name, type } = this.#unit.caught[this.#unit.source.slice(0, node.start).split(/\bcatch \(\w/).length - 1];
		return type && `catch (${name}) {\n\tif (!(${name} instanceof ${this.#reference(type)})) throw ${name};${this.#text(node.body).slice(1)}`;
	}

	#identifierText(node) {
		if (node.name === "undefined" || this.#isLocal(node.name)) return node.name;
		const known = this.#shortNames.get(node.name) ?? this.externals[node.name];
		return known ? this.#reference(node.name) : WITHOUT_NAMES.get(node.name) ?? node.name;
	}

	#reference(qname) {
		const own = this.#shortNames.get(qname);
		if (own) {
			if (this.#isLocal(own)) throw new Error(`the local variable ${own} hides ${qname}`);
			return own;
		}
		const external = this.externals[qname];
		if (external) return external;
		if (BUILT_IN.has(qname)) return qname;
		return `${this.#helper("missing")}(${JSON.stringify(qname)})`;
	}

	// A function of the language stand-in. No ActionScript name begins like its name.
	#helper(name) {
		return `$${name}`;
	}

	// The definition at the beginning of a path of names, and the rest of the path.
	#resolve(path) {
		const words = path.split(".");
		if (!this.#roots.has(words[0]) || this.#isLocal(words[0])) return null;
		for (let count = words.length; count > 0; count--) {
			const qname = words.slice(0, count).join(".");
			if (this.#units.has(qname) || qname in this.externals || qname === LANGUAGE) return { qname, rest: words.slice(count) };
		}
		const count = words.findIndex((word) => /^[A-Z]/.test(word)) + 1 || words.length;
		return { qname: words.slice(0, count).join("."), rest: words.slice(count) };
	}

	#memberText(node) {
		const path = pathOf(node);
		const found = path === "" ? null : this.#resolve(path);
		if (found && found.qname !== LANGUAGE) {
			if (found.rest[0] === "superClass_") throw new Error(`unexpected ${path}`);
			const constant = found.rest.length === 1 ? this.#units.get(found.qname)?.constants.get(found.rest[0]) : undefined;
			if (constant !== undefined) return `${constant} /* ${this.shortName(found.qname)}.${found.rest[0]} */`;
			const owner = found.rest.length > 0 ? this.#ownerOf(found.qname, found.rest[0]) : null;
			if (owner) return [this.#staticName(owner, found.rest[0]), ...found.rest.slice(1).map((name) => this.#members.nameOf(name))].join(".");
			return [this.#reference(found.qname), ...found.rest.map((name) => this.#members.nameOf(name))].join(".");
		}
		const target = this.#text(node.object);
		if (!node.computed) {
			const name = this.#members.nameOf(node.property.name);
			if (/^(?:\*|\??Object)/.test(this.#typeOf(node.object))) this.#open.add(name);
			if (this.#beforeSuper && node.object.type === "ThisExpression") {
				if (!this.#beforeSuper.has(name)) throw new Error(`this.${name} is read before super()`);
				return this.#beforeSuper.get(name);
			}
			return `${target}.${name}`;
		}
		if (pathOf(node.property).startsWith(`${LANGUAGE}.`)) return target;
		if (this.#typeOf(node.object) === "flash.utils.ByteArray") return `${target}.byteAt(${this.#text(node.property)})`;
		if (this.#typeOf(node.object) === "flash.utils.Dictionary") return `${target}.get(${this.#text(node.property)})`;
		if (this.#isMethodTaken(node)) return `${this.#helper("taken")}(${target}, ${this.#text(node.property)})`;
		return `${target}[${this.#text(node.property)}]`;
	}

	// The class that declares a static that is a variable or function of the module: the named class, or one that it extends.
	#ownerOf(qname, name) {
		for (let unit = this.#units.get(qname); unit; unit = this.#units.get(unit.base)) {
			if (unit.staticValues.some((field) => field.name === name) || unit.members.some((member) => member.name === name && this.#isLoose(unit, member))) return unit;
		}
		return null;
	}

	// Statics become variables of the module. A class's own statics would need statements, and bundlers do not leave out a class with such
	// statements.
	#staticName(unit, name) {
		return `${this.shortName(unit.qname)}$${this.#members.nameOf(name)}`;
	}

	#isSeen(unit, name) {
		return this.hasAllStatics || this.#isShownStatic(unit, name);
	}

	// Whether the types show it: to users, or to classes that extend this one.
	#isShownStatic(unit, name) {
		return Boolean(this.signatures.get(unit.qname)?.members.some((member) => member.isStatic && isShown(member) && member.name === name));
	}

	// Whether a computed name reads a member of an object of a known class. Methods are then read as closures.
	#isMethodTaken(node) {
		return node !== this.#target && this.#units.get(this.#typeOf(node.object))?.kind === "class";
	}

	#assignmentText(node) {
		const left = node.left;
		this.#target = left;
		const rest = this.#restOfLogicalAssignment(node);
		if (rest) return `${this.#text(left)} = ${this.#text(left)} ${rest.operator} (${rest.text})`;
		if (left.type !== "MemberExpression") return null;
		const isLength = left.property.name === "length" && left.object.type === "MemberExpression" && left.object.computed &&
			pathOf(left.object.property).startsWith(`${LANGUAGE}.`);
		if (isLength) {
			const vector = left.object.object;
			const right = this.#text(node.right).replace(/^\((.*)\) >>> 0$/, "$1");
			const length = node.operator === "=" ? right : `${this.#text(vector)}.length ${node.operator.slice(0, -1)} ${right}`;
			if (length === "0") return `${this.#text(vector)}.length = 0`;
			return `${this.#helper("resize")}(${this.#text(vector)}, ${length}, ${this.#zeroOf(this.#elementOf(this.#typeOf(vector), vector))})`;
		}
		if (left.computed && this.#typeOf(left.object) === "flash.utils.Dictionary") {
			return `${this.#text(left.object)}.set(${this.#text(left.property)}, ${this.#text(node.right)})`;
		}
		if (left.computed && this.#typeOf(left.object) === "flash.utils.ByteArray") {
			if (node.operator !== "=") {
				const at = this.#text(left.property);
				return `${this.#text(left.object)}.setByte(${at}, ${this.#text(left.object)}.byteAt(${at}) ${node.operator.slice(0, -1)} ${this.#text(node.right)})`;
			}
			return `${this.#text(left.object)}.setByte(${this.#text(left.property)}, ${this.#text(node.right)})`;
		}
		return null;
	}

	// The compiler writes "a ||= b ? c : d" as "a = a || b ? c : d", which has another meaning.
	#restOfLogicalAssignment(node) {
		const source = this.#unit.source;
		const target = source.slice(node.left.start, node.left.end);
		const value = source.slice(node.right.start, node.right.end);
		const operator = [" || ", " && "].find((each) => value.startsWith(target + each));
		if (node.operator !== "=" || !operator) return null;
		const inner = parseExpressionAt(value, target.length + operator.length, { ecmaVersion: 2022, preserveParens: true });
		const isAsWritten = node.right.type === "LogicalExpression" && node.right.operator === operator.trim() && source.slice(node.right.left.start, node.right.left.end) === target;
		if (isAsWritten) return null;
		const unit = this.#unit;
		this.#unit = Object.create(unit, { source: { value } });
		const text = this.#text(inner);
		this.#unit = unit;
		return { operator: operator.trim(), text };
	}

	#earlyFieldText(node) {
		if (!this.#beforeSuper || !isFieldAssignment(node)) return null;
		const name = this.#members.nameOf(node.expression.left.property.name);
		const local = name.replace(/^[_$]+/, "");
		const value = this.#text(node.expression.right);
		const isParameter = this.#isLocal(local);
		this.#beforeSuper.set(name, isParameter ? `${local}$` : local);
		return `const ${isParameter ? `${local}$` : local} = ${value};`;
	}

	#newText(node) {
		const type = vectorType(node.callee);
		if (type === null) return null;
		if (node.arguments.length === 0) return "[]";
		if (type === "Number") return `${this.#helper("doubles")}(${this.#text(node.arguments[0])})`;
		return `${this.#helper("vector")}(${this.#text(node.arguments[0])}, ${this.#zeroOf(type)})`;
	}

	#callText(node) {
		const path = pathOf(node.callee);
		const args = node.arguments;
		const base = superCall(node, this.#unit.qname);
		if (base) {
			const list = base.arguments.map((each) => this.#text(each)).join(", ");
			if (base.isGetter) return `super.${this.#members.nameOf(base.name)}`;
			return base.name === "constructor" ? `super(${list})` : `super.${this.#members.nameOf(base.name)}(${list})`;
		}
		if (node.callee.property?.name === "sort" && args.length === 1 && args[0].type !== "FunctionExpression") {
			return `${this.#helper("sort")}(${this.#text(node.callee.object)}, ${this.#text(args[0])})`;
		}
		const vector = node.callee.type === "MemberExpression" ? vectorType(node.callee.object) : null;
		if (vector !== null) {
			if (bare(args[0]).type === "ArrayExpression") return this.#text(args[0]);
			return `Array.from(${this.#text(args[0])})`;
		}
		if (!path.startsWith(`${LANGUAGE}.`)) return null;
		const helper = path.slice(LANGUAGE.length + 1);
		const first = args.length > 0 ? this.#text(args[0]) : "";
		switch (helper) {
			case "_int":
				return `(${first} | 0)`;
			case "trace":
				return `console.log(${args.map((each) => this.#text(each)).join(", ")})`;
			case "closure":
				return `${this.#helper("bound")}(${this.#text(args[1])}, ${JSON.stringify(this.#members.nameOf(args[2].value))})`;
			case "is":
			case "as": {
				const type = this.#text(args[1]);
				const isClass = this.#units.get(pathOf(args[1]))?.kind === "class" || ["Error", "RangeError", "TypeError"].includes(type);
				const isCast = helper === "as" && args[2]?.value === true;
				if (isClass && helper === "is") return `(${first} instanceof ${type})`;
				// a cast to an engine class that the compiler has already checked
				if (isClass && isCast && !this.hasAllStatics) return first;
				const otherwise = isCast ? `${this.#helper("cast")}(${first}, ${type})` : "null";
				if (isClass && /^[\w$.]+$/.test(first)) return `(${first} instanceof ${type} ? ${first} : ${otherwise})`;
				return `${this.#helper(isCast ? "cast" : helper)}(${first}, ${type})`;
			}
			case "string":
			case "sort":
			case "sortOn":
				return `${this.#helper(helper)}(${args.map((each) => this.#text(each)).join(", ")})`;
			default:
				throw new Error(`${path} is not known`);
		}
	}

	#zeroOf(type) {
		if (/^(Number|int|uint|number)$/.test(type)) return "0";
		return /^[Bb]oolean$/.test(type) ? "false" : "null";
	}

	#elementOf(type, node) {
		const element = /^\??Array\.<(.*)>$/.exec(type)?.[1];
		if (!element) throw new Error(`the type of a vector is not known: ${this.#unit.source.slice(node.start, node.end)} is ${type}`);
		return element;
	}

	/** A type in the compiler's comments; "*" if it is not known. */
	#typeOf(given) {
		const node = bare(given);
		switch (node.type) {
			case "ThisExpression":
				return this.#unit.qname;
			case "Identifier":
				if (node.name === "self") return this.#unit.qname;
				for (let i = this.#scopes.length - 1; i >= 0; i--) if (this.#scopes[i].has(node.name)) return this.#scopes[i].get(node.name);
				return "*";
			case "MemberExpression": {
				const path = pathOf(node);
				const found = path === "" ? null : this.#resolve(path);
				if (found && found.rest.length > 0) {
					const start = this.#units.get(found.qname)?.statics.get(found.rest[0]) ?? "*";
					return found.rest.slice(1).reduce((type, name) => this.#memberType(type, name), start);
				}
				const type = this.#typeOf(node.object);
				return node.computed ? /^Array\.<(.*)>$/.exec(type)?.[1] ?? "*" : this.#memberType(type, node.property.name);
			}
			case "CallExpression": {
				if (pathOf(node.callee) === `${LANGUAGE}.as`) return pathOf(node.arguments[1]);
				return node.callee.type === "MemberExpression" ? this.#typeOf(node.callee) : "*";
			}
			case "NewExpression":
				return pathOf(node.callee) || "*";
			default:
				return "*";
		}
	}

	#memberType(type, name) {
		for (let unit = this.#unitOf(type); unit; unit = this.#units.get(unit.base)) {
			if (unit.types.has(name)) return unit.types.get(name);
		}
		return "*";
	}

	// In the compiler's comments the class of a Vector's elements has no package.
	#unitOf(type) {
		return this.#units.get(type) ?? [...this.#units.values()].find((unit) => unit.name === type);
	}

	#staticsText() {
		const lines = [];
		const done = new Set();
		const visit = (unit, seen) => {
			if (!unit || done.has(unit) || seen.has(unit)) return;
			seen.add(unit);
			const texts = unit.staticValues.map((field) => {
				this.#unit = unit;
				for (const needed of this.#needed(field.value, unit)) visit(needed, seen);
				this.#unit = unit;
				return `${isConstant(field) ? "const" : "let"} ${this.#staticName(unit, field.name)} = ${this.#pure(field.value)};`;
			});
			if (unit.kind === "variable") {
				for (const needed of this.#needed(unit.main, unit)) visit(needed, seen);
				this.#unit = unit;
				texts.push(`let ${this.shortName(unit.qname)} = ${this.#pure(unit.main)};`);
			}
			done.add(unit);
			lines.push(...texts);
		};
		for (const unit of this.#units.values()) visit(unit, new Set());
		return lines.join("\n") + "\n";
	}

	// The text of an initial value, marked so that a bundler may leave it out.
	#pure(node) {
		const text = this.#text(node);
		return mayRun(node) ? `/* @__PURE__ */ (() => (${text}))()` : text;
	}

	// The definitions that run when an expression does: those that it names, and those that their constructors and its static methods name.
	#needed(node, unit, found = new Set(), methods = new Set()) {
		this.#unit = unit;
		const path = node.type === "MemberExpression" ? pathOf(node) : "";
		const resolved = path === "" ? null : this.#resolve(path);
		const known = this.#units.get(resolved?.qname);
		if (known) {
			const method = known.members.find((member) => member.isStatic && member.kind === "method" && member.name === resolved.rest[0]);
			if (method && !methods.has(method)) {
				methods.add(method);
				this.#needed(method.node.body, known, found, methods);
			}
			if (!found.has(known)) {
				found.add(known);
				if (known.main) this.#needed(known.main.body, known, found, methods);
			}
			this.#unit = unit;
			return found;
		}
		for (const child of childrenOf(node)) this.#needed(child, unit, found, methods);
		return found;
	}
}

function isConstant(field) {
	return /@const/.test(field.doc ?? "");
}

// Whether a bundler has to suppose that computing a value has effects. An operator may call a function of its operands.
function mayRun(node) {
	return /^(?:New|Call|Object|Binary)Expression$/.test(node.type) || childrenOf(node).some(mayRun);
}

function rank(unit) {
	return unit.qname.startsWith("starlogo.") ? 0 : 1;
}

/** Wraps a method that returns a ByteArray, so that it returns a Uint8Array. */
function asPlainBytes(text) {
	const [, parameters, body] = /^(\([^)]*\)) \{\n([\s\S]*)\}$/.exec(text);
	return `${parameters} {\n\treturn (() => {\n${indent(body).trimEnd()}\n\t})().toUint8Array();\n}`;
}
