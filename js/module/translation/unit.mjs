/** Reads the definitions in one of the compiler's files. */
import { parse } from "acorn";
import { caughtIn } from "./catches.mjs";
import { isWithin, keyName, lazyValue, pathOf } from "./syntax.mjs";

/**
 * The definitions in one of the compiler's files. The one that the file is named after comes first, then those that only this file sees.
 */
export function unitsOf(file, source) {
	const comments = [];
	const ast = parse(source, { ecmaVersion: 2022, preserveParens: true, onComment: comments });
	const qnames = [...source.matchAll(/^goog\.provide\('([\w.]+)'\)/gm)].map((match) => match[1]);
	const caught = caughtIn(file, source);
	return qnames.map((qname) => {
		const isOwn = (path) => path === qname || path.startsWith(`${qname}.`) && !qnames.some((other) => other.length > qname.length && isWithin(path, other));
		return new Unit({ file, source, caught, comments, qname, isOwn, isInner: qname !== qnames[0] }, ast);
	}).filter((unit) => unit.main !== null);
}

/** A class, an interface, a function of a package, or a variable of a file. */
class Unit {
	constructor({ file, source, caught, comments, qname, isOwn, isInner }, ast) {
		this.source = source;
		this.file = file;
		this.caught = caught;
		this.comments = comments;
		this.qname = qname;
		this.isOwn = isOwn;
		this.isInner = isInner; // only its file sees it
		this.name = qname.split(".").pop();
		this.mangled = isInner ? `${this.name}_` : qname.replaceAll(".", "_") + "_";
		this.kind = "function";
		this.base = null;
		this.main = null; // the constructor, the package's function, or the variable's value
		this.doc = "";
		this.types = new Map(); // of members, by mangled name
		this.statics = new Map(); // types of static members
		this.constants = new Map(); // numbers to insert for their names, because the lookup of a class's static takes time
		this.members = []; // { name, node, doc, isStatic, kind: "method" | "get" | "set" }
		this.fields = []; // { name, value }
		this.staticValues = []; // { name, value, doc }
		this.tests = [];
		for (const statement of ast.body) this.#read(statement);
		if (this.kind === "function" && this.main && this.main.type !== "FunctionExpression") this.kind = "variable";
	}

	#read(statement) {
		if (statement.type !== "ExpressionStatement") return;
		const expression = statement.expression;
		const doc = this.#docBefore(statement);
		if (expression.type === "CallExpression") {
			if (!this.isOwn(pathOf(expression.arguments[0]))) return;
			if (pathOf(expression.callee) === "goog.inherits") this.base = pathOf(expression.arguments[1]);
			else if (pathOf(expression.callee) === "Object.defineProperties") this.#readAccessors(expression);
			return;
		}
		const left = expression.type === "AssignmentExpression" ? expression.left : expression;
		const path = pathOf(left);
		if (!this.isOwn(path)) return;
		if (path === this.qname && expression.right) this.#readMain(expression.right, doc);
		else if (path.startsWith(`${this.qname}.prototype.`)) this.#readMember(path.slice(this.qname.length + 11), expression.right, doc, false);
		else if (path.startsWith(`${this.qname}.`)) this.#readMember(path.slice(this.qname.length + 1), expression.right, doc, true);
	}

	#readMain(node, doc) {
		this.main = node;
		this.doc = doc;
		if (/@constructor/.test(doc)) this.kind = "class";
		if (/@interface/.test(doc)) this.kind = "interface";
	}

	#readMember(name, value, doc, isStatic) {
		if (name === "ROYALE_REFLECTION_INFO") this.#readTests(value);
		if (name.startsWith("ROYALE_")) return;
		const types = isStatic ? this.statics : this.types;
		const [, engine = "", kind, plain] = /^(starlogo_engine__)?([gs]et)__(.*)$/.exec(name) ?? [];
		if (kind) {
			this.#readAccessor(engine + plain, kind, value, doc, isStatic);
			return;
		}
		if (value?.type === "FunctionExpression") {
			types.set(name, /@return \{(.*)\}/.exec(doc)?.[1] ?? "void");
			this.members.push({ name, node: value, doc, isStatic, kind: "method" });
			return;
		}
		types.set(name, /@type \{(.*)\}/.exec(doc)?.[1] ?? "*");
		if (value?.type === "Literal" && typeof value.value === "number" && isStatic && /@const/.test(doc)) this.constants.set(name, value.raw);
		if (value && isStatic) this.staticValues.push({ name, value, doc });
		else if (value) this.fields.push({ name, value, doc });
		else if (this.kind === "interface") this.members.push({ name, node: null, doc, isStatic, kind: "get" });
	}

	#readAccessor(name, kind, value, doc, isStatic) {
		const lazy = isStatic ? lazyValue(value) : null;
		if (lazy) this.staticValues.push({ name, value: lazy, doc: /writable: false/.test(this.source.slice(value.start, value.end)) ? "@const" : "" });
		else if (!(isStatic && this.staticValues.some((known) => known.name === name))) this.members.push({ name, node: value, doc, isStatic, kind });
	}

	// In JavaScript an accessor that has one half hides the inherited other one.
	#readAccessors(call) {
		if (pathOf(call.arguments[0]) !== `${this.qname}.prototype`) return;
		for (const property of call.arguments[1].properties) {
			this.types.set(keyName(property.key), /@type \{(.*)\}/.exec(this.#docBefore(property))?.[1] ?? "*");
			for (const half of property.value.properties) {
				const path = half.value.type === "MemberExpression" ? pathOf(half.value) : "";
				if (path !== "" && !path.startsWith(`${this.qname}.`)) throw new Error(`${keyName(property.key)} overrides one half: override the getter and the setter`);
			}
		}
	}

	// The metadata that FlexUnit reads: [{ name, kind: "Test", args: { expects: "ArgumentError" } }]
	#readTests(info) {
		const text = this.source.slice(info.start, info.end);
		if (!/metadata:/.test(text)) return;
		const methods = new Function(`return (${text})()`)().methods?.() ?? {};
		for (const [name, method] of Object.entries(methods)) {
			for (const tag of method.metadata?.() ?? []) {
				const args = Object.fromEntries((tag.args ?? []).map((arg) => [arg.key || arg.value, arg.value]));
				this.tests.push({ name: name.replace("|", ""), kind: tag.name, args });
			}
		}
	}

	#docBefore(statement) {
		const comment = this.comments.filter((each) => each.type === "Block" && each.end <= statement.start).pop();
		const isNext = comment && /^\s*$/.test(this.source.slice(comment.end, statement.start));
		return isNext ? `/*${comment.value}*/` : "";
	}
}
