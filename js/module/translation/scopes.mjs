/** Tells what stands at a place in the compiler's output: which definition a path of names means, and of what type an expression is. */
import { LANGUAGE, bare, childrenOf, pathOf } from "./syntax.mjs";

/** The functions that are open at a place of a definition, with the types of their parameters and variables. */
export class Scopes {
	#unit = null;
	#units;
	#externals;
	#roots; // the first words of qualified names
	#locals = []; // for each open function, the innermost last: types by names

	/**
	 * @param units the program's definitions, by qualified name
	 * @param externals the names of what comes from elsewhere, by qualified name
	 */
	constructor(units, externals) {
		this.#units = units;
		this.#externals = externals;
		this.#roots = new Set([...units.keys(), ...Object.keys(externals), LANGUAGE, "flash", "mx", "org", "goog"].map((qname) => qname.split(".")[0]));
	}

	/** The definition at whose text work looks. */
	get unit() {
		return this.#unit;
	}

	/** Does work in a definition, and returns its result. */
	within(unit, work) {
		const outer = this.#unit;
		this.#unit = unit;
		try {
			return work();
		} finally {
			this.#unit = outer;
		}
	}

	/** Opens a function. @param doc the comment before it */
	enter(node, doc) {
		const types = new Map();
		for (const [, type, name] of this.#typesDoc(node, doc).matchAll(/@param \{([^\n]*?)=?\} (\w+)/g)) types.set(name, type);
		for (const parameter of node.params) if (!types.has(parameter.name)) types.set(parameter.name, this.#typeBefore(parameter));
		this.#collectLocals(node.body, types);
		this.#locals.push(types);
	}

	/** Closes the innermost function. */
	leave() {
		this.#locals.pop();
	}

	/** Whether a name is a parameter or a variable of a function that was entered. */
	isLocal(name) {
		return this.#locals.some((scope) => scope.has(name));
	}

	/** The definition at the beginning of a path of names, and the rest of the path: { qname, rest }; null if it begins with none. */
	resolve(path) {
		const words = path.split(".");
		if (!this.#roots.has(words[0]) || this.isLocal(words[0])) return null;
		for (let count = words.length; count > 0; count--) {
			const qname = words.slice(0, count).join(".");
			if (this.#units.has(qname) || qname in this.#externals || qname === LANGUAGE) return { qname, rest: words.slice(count) };
		}
		const count = words.findIndex((word) => /^[A-Z]/.test(word)) + 1 || words.length;
		return { qname: words.slice(0, count).join("."), rest: words.slice(count) };
	}

	/** The type of an expression, as the compiler's comments say it; "*" if it is not known. */
	typeOf(given) {
		const node = bare(given);
		switch (node.type) {
			case "ThisExpression":
				return this.#unit.qname;
			case "Identifier":
				if (node.name === "self") return this.#unit.qname;
				for (let i = this.#locals.length - 1; i >= 0; i--) if (this.#locals[i].has(node.name)) return this.#locals[i].get(node.name);
				return "*";
			case "MemberExpression": {
				const path = pathOf(node);
				const found = path === "" ? null : this.resolve(path);
				if (found && found.rest.length > 0) {
					const start = this.#units.get(found.qname)?.statics.get(found.rest[0]) ?? "*";
					return found.rest.slice(1).reduce((type, name) => this.#memberType(type, name), start);
				}
				const type = this.typeOf(node.object);
				return node.computed ? /^Array\.<(.*)>$/.exec(type)?.[1] ?? "*" : this.#memberType(type, node.property.name);
			}
			case "CallExpression": {
				if (pathOf(node.callee) === `${LANGUAGE}.as`) return pathOf(node.arguments[1]);
				return node.callee.type === "MemberExpression" ? this.typeOf(node.callee) : "*";
			}
			case "NewExpression":
				return pathOf(node.callee) || "*";
			default:
				return "*";
		}
	}

	/** The type of the elements of a Vector. Throws an error if it is not known. */
	elementOf(vector) {
		const type = this.typeOf(vector);
		const element = /^\??Array\.<(.*)>$/.exec(type)?.[1];
		if (!element) throw new Error(`the type of a vector is not known: ${this.#unit.source.slice(vector.start, vector.end)} is ${type}`);
		return element;
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
}
