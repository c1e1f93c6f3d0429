/** Writes the bodies of functions: the compiler's statements and expressions, with what is special in them in JavaScript's own words. */
import { parseExpressionAt } from "acorn";
import { LANGUAGE, bare, childrenOf, forEach, gap, indent, isFieldAssignment, parameterDefault, pathOf, superCall, vectorType } from "./syntax.mjs";

// V8 holds the two names' values as objects. If a Number may be one of them, it makes an object for the Number too.
const WITHOUT_NAMES = new Map([["Infinity", "(1 / 0 /* Infinity */)"], ["NaN", "(0 / 0 /* NaN */)"]]);

// Statics that only tests set. Elsewhere they are false, and code that they switch on is left out.
const SWITCHES = new Set(["flash.geom.Matrix3D.isSingle"]);

const BUILT_IN = new Set(["Array", "Boolean", "Function", "Number", "Object", "String", "Error", "RangeError", "TypeError"]);

/** The writer of a program's bodies. Functions of the language stand-in, such as $values, have names that no ActionScript name begins like. */
export class Bodies {
	/** The names of members of objects whose class is not known. */
	namesOfUnknownObjects = new Set();
	#program;
	#units;
	#members;
	#scopes;
	#beforeSuper = null; // until super() is called: the constants that fields are kept in, by the fields' names
	#target = null; // what is assigned to

	/**
	 * @param program has the names of definitions and statics
	 * @param units its definitions, by qualified name
	 * @param members the names of members
	 * @param scopes what names mean at the place that is written
	 */
	constructor(program, units, members, scopes) {
		this.#program = program;
		this.#units = units;
		this.#members = members;
		this.#scopes = scopes;
	}

	/**
	 * The text of a function from its parameters on.
	 *
	 * @param doc the comment before it
	 * @param prologue statements that come first
	 */
	functionText(node, doc, prologue = []) {
		const { parameters, body } = this.enter(node, doc);
		const statements = [...prologue, ...this.statements(body)];
		this.leave();
		const lines = statements.map(indent);
		return lines.length === 0 ? `(${parameters}) {\n}` : `(${parameters}) {\n${lines.join("\n")}\n}`;
	}

	/** Enters a function: leave() ends it. Returns the text of its parameters with their defaults, and the other statements of its body. */
	enter(node, doc) {
		this.#scopes.enter(node, doc);
		const defaults = new Map();
		const body = node.body.body.filter((statement) => {
			const found = parameterDefault(statement);
			if (found && node.params.some((parameter) => parameter.name === found.name)) {
				defaults.set(found.name, this.text(found.value));
				return false;
			}
			return statement.type !== "EmptyStatement";
		});
		const parameters = node.params.map(({ name }) => (defaults.has(name) ? `${name} = ${defaults.get(name)}` : name)).join(", ");
		return { parameters, body };
	}

	/** Leaves the function that was entered last. */
	leave() {
		this.#scopes.leave();
	}

	/**
	 * The texts of a constructor's first statements, the last of which is super(). They may set fields before there is a this: these are constants until
	 * then. Returns the statements up to super(), and those after it: they set the fields, and the variable in which functions inside find this.
	 */
	untilSuper(statements) {
		const isSelf = (text) => text === "var self = this;";
		this.#beforeSuper = new Map();
		const texts = statements.map((statement) => this.text(statement));
		const held = [...this.#beforeSuper].map(([name, local]) => `this.${name} = ${local};`);
		this.#beforeSuper = null;
		return { until: texts.filter((text) => !isSelf(text)), held: [...texts.filter(isSelf), ...held] };
	}

	/** The texts of statements. The compiler's three statements for a "for each" become one. */
	statements(body) {
		const lines = [];
		for (let i = 0; i < body.length; i++) {
			const each = forEach(body[i], body[i + 1]);
			if (each) {
				lines.push(`for (${each.isDeclared ? "var " : ""}${this.text(each.variable)} of $values(${this.text(each.over)})) ${this.text(each.body)}`);
				i++;
			} else if (body[i].type !== "EmptyStatement" && !this.#isSwitchedOff(body[i])) {
				lines.push(this.text(body[i]));
			}
		}
		return lines;
	}

	#isSwitchedOff(statement) {
		return !this.#program.isForTests && statement.type === "IfStatement" && SWITCHES.has(pathOf(statement.test));
	}

	/** The text of an expression or a statement. */
	text(node) {
		const special = Bodies.#WRITERS[node.type]?.(this, node) ?? null;
		if (special !== null) return special;
		const source = this.#scopes.unit.source;
		let text = "";
		let at = node.start;
		for (const child of childrenOf(node)) {
			text += gap(source.slice(at, child.start)) + this.text(child);
			at = child.end;
		}
		return text + gap(source.slice(at, node.end));
	}

	/** Writes the nodes that are special, by their types. A writer returns null for a node that is as the compiler has it. */
	static #WRITERS = {
		Literal: (bodies, node) => bodies.#scopes.unit.source.slice(node.start, node.end),
		BlockStatement: (bodies, node) => bodies.#blockText(node),
		FunctionExpression: (bodies, node) => `function${bodies.functionText(node, "")}`,
		FunctionDeclaration: (bodies, node) => `function ${node.id.name}${bodies.functionText(node, "")}`,
		SwitchCase: (bodies, node) => bodies.#caseText(node),
		CatchClause: (bodies, node) => bodies.#catchText(node),
		Identifier: (bodies, node) => bodies.#identifierText(node),
		Property: (bodies, node) => (node.shorthand ? null : bodies.#propertyText(node)),
		MemberExpression: (bodies, node) => bodies.#memberText(node),
		NewExpression: (bodies, node) => bodies.#newText(node),
		CallExpression: (bodies, node) => bodies.#callText(node),
		ExpressionStatement: (bodies, node) => bodies.#earlyFieldText(node),
		AssignmentExpression: (bodies, node) => bodies.#assignmentText(node),
	};

	#caseText(node) {
		const label = node.test ? `case ${this.text(node.test)}` : "default";
		return `${label}:\n${this.statements(node.consequent).map(indent).join("\n")}`;
	}

	#propertyText({ key, value }) {
		return `${this.#scopes.unit.source.slice(key.start, key.end)}: ${this.text(value)}`;
	}

	#blockText(node) {
		// the compiler puts the body of a "for each" into a block of its own
		const body = node.body.length === 1 && node.body[0].type === "BlockStatement" ? node.body[0].body : node.body;
		const lines = this.statements(body).map(indent);
		return lines.length === 0 ? "{\n}" : `{\n${lines.join("\n")}\n}`;
	}

	// Errors of other classes are thrown again.
	#catchText(node) {
		const { name, type } = this.#scopes.unit.caught[this.#scopes.unit.source.slice(0, node.start).split(/\bcatch \(\w/).length - 1];
		return type && `catch (${name}) {\n\tif (!(${name} instanceof ${this.reference(type)})) throw ${name};${this.text(node.body).slice(1)}`;
	}

	#identifierText(node) {
		if (node.name === "undefined" || this.#scopes.isLocal(node.name)) return node.name;
		const known = this.#program.shortName(node.name) ?? this.#program.externals[node.name];
		return known ? this.reference(node.name) : WITHOUT_NAMES.get(node.name) ?? node.name;
	}

	/** The name in the text for a qualified name. */
	reference(qname) {
		const own = this.#program.shortName(qname);
		if (own) {
			if (this.#scopes.isLocal(own)) throw new Error(`the local variable ${own} hides ${qname}`);
			return own;
		}
		const external = this.#program.externals[qname];
		if (external) return external;
		if (BUILT_IN.has(qname)) return qname;
		return `$missing(${JSON.stringify(qname)})`;
	}

	#memberText(node) {
		const path = pathOf(node);
		const found = path === "" ? null : this.#scopes.resolve(path);
		if (found && found.qname !== LANGUAGE) {
			if (found.rest[0] === "superClass_") throw new Error(`unexpected ${path}`);
			const constant = found.rest.length === 1 ? this.#units.get(found.qname)?.constants.get(found.rest[0]) : undefined;
			if (constant !== undefined) return `${constant} /* ${this.#program.shortName(found.qname)}.${found.rest[0]} */`;
			const owner = found.rest.length > 0 ? this.#program.ownerOf(found.qname, found.rest[0]) : null;
			if (owner) return [this.#program.staticName(owner, found.rest[0]), ...found.rest.slice(1).map((name) => this.#members.nameOf(name))].join(".");
			return [this.reference(found.qname), ...found.rest.map((name) => this.#members.nameOf(name))].join(".");
		}
		const target = this.text(node.object);
		if (!node.computed) {
			const name = this.#members.nameOf(node.property.name);
			if (/^(?:\*|\??Object)/.test(this.#scopes.typeOf(node.object))) this.namesOfUnknownObjects.add(name);
			if (this.#beforeSuper && node.object.type === "ThisExpression") throw new Error(`this.${name} is read before super()`);
			return `${target}.${name}`;
		}
		if (this.#scopes.typeOf(node.object) === "flash.utils.ByteArray") return `${target}.byteAt(${this.text(node.property)})`;
		if (this.#scopes.typeOf(node.object) === "flash.utils.Dictionary") return `${target}.get(${this.text(node.property)})`;
		if (this.#isMethodTaken(node)) return `$memberOrClosure(${target}, ${this.text(node.property)})`;
		return `${target}[${this.text(node.property)}]`;
	}

	// Whether a computed name reads a member of an object of a known class. Methods are then read as closures.
	#isMethodTaken(node) {
		return node !== this.#target && this.#units.get(this.#scopes.typeOf(node.object))?.kind === "class";
	}

	#assignmentText(node) {
		const left = node.left;
		this.#target = left;
		const rest = this.#restOfLogicalAssignment(node);
		if (rest) return `${this.text(left)} = ${this.text(left)} ${rest.operator} (${rest.text})`;
		if (left.type !== "MemberExpression") return null;
		const isLength = left.property.name === "length" && left.object.type === "MemberExpression" && left.object.computed &&
			pathOf(left.object.property).startsWith(`${LANGUAGE}.`);
		if (isLength) {
			const vector = left.object.object;
			const right = this.text(node.right).replace(/^\((.*)\) >>> 0$/, "$1");
			const length = node.operator === "=" ? right : `${this.text(vector)}.length ${node.operator.slice(0, -1)} ${right}`;
			if (length === "0") return `${this.text(vector)}.length = 0`;
			return `$resize(${this.text(vector)}, ${length}, ${zeroOf(this.#scopes.elementOf(vector))})`;
		}
		if (left.computed && this.#scopes.typeOf(left.object) === "flash.utils.Dictionary") {
			return `${this.text(left.object)}.set(${this.text(left.property)}, ${this.text(node.right)})`;
		}
		if (left.computed && this.#scopes.typeOf(left.object) === "flash.utils.ByteArray") {
			if (node.operator !== "=") {
				const at = this.text(left.property);
				return `${this.text(left.object)}.setByte(${at}, ${this.text(left.object)}.byteAt(${at}) ${node.operator.slice(0, -1)} ${this.text(node.right)})`;
			}
			return `${this.text(left.object)}.setByte(${this.text(left.property)}, ${this.text(node.right)})`;
		}
		return null;
	}

	// The compiler writes "a ||= b ? c : d" as "a = a || b ? c : d", which has another meaning.
	#restOfLogicalAssignment(node) {
		const source = this.#scopes.unit.source;
		const target = source.slice(node.left.start, node.left.end);
		const value = source.slice(node.right.start, node.right.end);
		const operator = [" || ", " && "].find((each) => value.startsWith(target + each));
		if (node.operator !== "=" || !operator) return null;
		const inner = parseExpressionAt(value, target.length + operator.length, { ecmaVersion: 2022, preserveParens: true });
		const { type, operator: written, left } = node.right;
		const isAsWritten = type === "LogicalExpression" && written === operator.trim() && source.slice(left.start, left.end) === target;
		if (isAsWritten) return null;
		const withThisValue = Object.create(this.#scopes.unit, { source: { value } });
		return { operator: operator.trim(), text: this.#scopes.within(withThisValue, () => this.text(inner)) };
	}

	#earlyFieldText(node) {
		if (!this.#beforeSuper || !isFieldAssignment(node)) return null;
		const name = this.#members.nameOf(node.expression.left.property.name);
		const local = name.replace(/^[_$]+/, "");
		this.#beforeSuper.set(name, local);
		return `const ${local} = ${this.text(node.expression.right)};`;
	}

	#newText(node) {
		const type = vectorType(node.callee);
		if (type === null) return null;
		if (node.arguments.length === 0) return "[]";
		if (type === "Number") return `$doubles(${this.text(node.arguments[0])})`;
		return `$vector(${this.text(node.arguments[0])}, ${zeroOf(type)})`;
	}

	#callText(node) {
		const path = pathOf(node.callee);
		const args = node.arguments;
		const base = superCall(node, this.#scopes.unit.qname);
		if (base) {
			const list = base.arguments.map((each) => this.text(each)).join(", ");
			return base.name === "constructor" ? `super(${list})` : `super.${this.#members.nameOf(base.name)}(${list})`;
		}
		if (node.callee.property?.name === "sort" && args.length === 1 && args[0].type !== "FunctionExpression") {
			return `$sort(${this.text(node.callee.object)}, ${this.text(args[0])})`;
		}
		const vector = node.callee.type === "MemberExpression" ? vectorType(node.callee.object) : null;
		if (vector !== null) {
			if (bare(args[0]).type === "ArrayExpression") return this.text(args[0]);
			return `Array.from(${this.text(args[0])})`;
		}
		if (!path.startsWith(`${LANGUAGE}.`)) return null;
		const helper = path.slice(LANGUAGE.length + 1);
		const first = args.length > 0 ? this.text(args[0]) : "";
		switch (helper) {
			case "_int":
				return `(${first} | 0)`;
			case "trace":
				return `console.log(${args.map((each) => this.text(each)).join(", ")})`;
			case "closure":
				return `$bound(${this.text(args[1])}, ${JSON.stringify(this.#members.nameOf(args[2].value))})`;
			case "is":
			case "as": {
				const type = this.text(args[1]);
				const isClass = this.#units.get(pathOf(args[1]))?.kind === "class" || ["Error", "RangeError", "TypeError"].includes(type);
				const isCast = helper === "as" && args[2]?.value === true;
				if (isClass && helper === "is") return `(${first} instanceof ${type})`;
				// a cast to an engine class that the compiler has already checked
				if (isClass && isCast && !this.#program.isForTests) return first;
				const otherwise = isCast ? `$cast(${first}, ${type})` : "null";
				if (isClass && /^[\w$.]+$/.test(first)) return `(${first} instanceof ${type} ? ${first} : ${otherwise})`;
				return `$${isCast ? "cast" : helper}(${first}, ${type})`;
			}
			case "string":
			case "sort":
			case "sortOn":
				return `$${helper}(${args.map((each) => this.text(each)).join(", ")})`;
			default:
				throw new Error(`${path} is not known: write it another way, for example int(x) for uint(x), or translate it here, in js/module/translation/bodies.mjs`);
		}
	}
}

/** The text of the first value of a variable of a type. */
function zeroOf(type) {
	if (/^(Number|int|uint|number)$/.test(type)) return "0";
	return /^[Bb]oolean$/.test(type) ? "false" : "null";
}
