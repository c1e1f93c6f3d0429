/** Writes the statics that are more than a literal: variables of the module, each after those that it needs. */
import { childrenOf, pathOf } from "./syntax.mjs";

/**
 * The text of the statics of all definitions.
 *
 * @param units the program's definitions, by qualified name
 * @param scopes what names mean
 * @param program has the names of definitions and statics
 * @param bodies writes the values
 */
export function staticsText(units, scopes, program, bodies) {
	const lines = [];
	const done = new Set();
	const valueIn = (unit, node) => scopes.within(unit, () => pure(node, bodies.text(node)));
	const visit = (unit, seen) => {
		if (!unit || done.has(unit) || seen.has(unit)) return;
		seen.add(unit);
		const visitNeeded = (node) => {
			for (const needed of neededFor(node, units, scopes)) visit(needed, seen);
		};
		const texts = unit.staticValues.map((field) => {
			visitNeeded(field.value);
			return `${isConstant(field) ? "const" : "let"} ${program.staticName(unit, field.name)} = ${valueIn(unit, field.value)};`;
		});
		if (unit.kind === "variable") {
			visitNeeded(unit.main);
			texts.push(`let ${program.shortName(unit.qname)} = ${valueIn(unit, unit.main)};`);
		}
		done.add(unit);
		lines.push(...texts);
	};
	for (const unit of units.values()) visit(unit, new Set());
	return `${lines.join("\n")}\n`;
}

/** Whether a static never gets another value. */
export function isConstant(field) {
	return /@const/.test(field.doc ?? "");
}

/** An initial value, marked so that a bundler may leave it out. */
function pure(node, text) {
	return mayRun(node) ? `/* @__PURE__ */ (() => (${text}))()` : text;
}

// Whether a bundler has to suppose that computing a value has effects. An operator may call a function of its operands.
function mayRun(node) {
	return /^(?:New|Call|Object|Binary)Expression$/.test(node.type) || childrenOf(node).some(mayRun);
}

/** The definitions that run when an expression does: those that it names, and those that their constructors and its static methods name. */
function neededFor(node, units, scopes, found = new Set(), methods = new Set()) {
	const path = node.type === "MemberExpression" ? pathOf(node) : "";
	const resolved = path === "" ? null : scopes.resolve(path);
	const known = units.get(resolved?.qname);
	if (!known) {
		for (const child of childrenOf(node)) neededFor(child, units, scopes, found, methods);
		return found;
	}
	const method = known.members.find((member) => member.isStatic && member.kind === "method" && member.name === resolved.rest[0]);
	if (method && !methods.has(method)) {
		methods.add(method);
		neededFor(method.node.body, units, scopes, found, methods);
	}
	if (!found.has(known)) {
		found.add(known);
		if (known.main) neededFor(known.main.body, units, scopes, found, methods);
	}
	return found;
}
