/** Recognises, in acorn's trees, the patterns that Apache's compiler writes for ActionScript. */

/** The compiler's run-time library. Its names appear in the compiler's output. Nothing of it is used. */
export const LANGUAGE = "org.apache.royale.utils.Language";

/** An expression without the parentheses around it. */
export function bare(node) {
	return node.type === "ParenthesizedExpression" ? bare(node.expression) : node;
}

/** The path of a chain like a.b.c, otherwise "". */
export function pathOf(given) {
	const node = given && bare(given);
	if (!node) return "";
	if (node.type === "Identifier") return node.name;
	if (node.type !== "MemberExpression" || node.computed) return "";
	const start = pathOf(node.object);
	return start === "" ? "" : `${start}.${node.property.name}`;
}

export function keyName(key) {
	return key.type === "Literal" ? String(key.value) : key.name;
}

export function childrenOf(node) {
	const children = [];
	for (const key in node) {
		const value = node[key];
		if (Array.isArray(value)) children.push(...value.filter((each) => each && typeof each.type === "string"));
		else if (value && typeof value.type === "string") children.push(value);
	}
	return children.sort((a, b) => a.start - b.start);
}

// The text between two parts of an expression: operators and the compiler's comments.
export function gap(text) {
	return text.includes("/*") ? text.replace(/\/\*[\s\S]*?\*\/ ?/g, "") : text;
}

/** The value of a static that is computed on first access: `get__X = function() { var value = ...; ... }`. */
export function lazyValue(node) {
	const first = node?.type === "FunctionExpression" ? node.body.body[0] : null;
	const isLazy = first?.type === "VariableDeclaration" && first.declarations[0].id.name === "value" &&
		node.body.body[1]?.expression?.callee && pathOf(node.body.body[1].expression.callee) === "Object.defineProperties";
	return isLazy ? first.declarations[0].init : null;
}

/** The element type of `Language.synthVector('T')`, otherwise null. */
export function vectorType(given) {
	const node = bare(given);
	return node.type === "CallExpression" && pathOf(node.callee) === `${LANGUAGE}.synthVector` ? node.arguments[0].value : null;
}

/** `p = typeof p !== 'undefined' ? p : value`. */
export function parameterDefault(statement) {
	const expression = statement.type === "ExpressionStatement" ? statement.expression : null;
	if (expression?.type !== "AssignmentExpression" || expression.right.type !== "ConditionalExpression") return null;
	const test = expression.right.test;
	const isDefault = test.type === "BinaryExpression" && test.left.type === "UnaryExpression" && test.left.operator === "typeof" &&
		test.left.argument.name === expression.left.name && test.right.value === "undefined";
	return isDefault ? { name: expression.left.name, value: expression.right.alternate } : null;
}

export function isFieldAssignment(statement) {
	const expression = statement.type === "ExpressionStatement" ? statement.expression : null;
	return expression?.type === "AssignmentExpression" && expression.operator === "=" && expression.left.type === "MemberExpression" &&
		expression.left.object.type === "ThisExpression" && !expression.left.computed;
}

export function isBaseCall(statement) {
	const call = statement.type === "ExpressionStatement" ? statement.expression : null;
	return call?.type === "CallExpression" && call.callee.property?.name === "base" && call.arguments[1]?.value === "constructor";
}

/** Whether all that a method does is to say that a class has to implement it. */
export function isAbstract(method, source) {
	return / does not implement \w+"\);\s*\}$/.test(source.slice(method.start, method.end)) && method.body.body.length === 1;
}

/** `X.base(this, 'name', ...)`, or `X.superClass_.name.apply(this, [...])`. */
export function superCall(node, qname) {
	const path = pathOf(node.callee);
	if (path === `${qname}.base`) return { name: node.arguments[1].value, arguments: node.arguments.slice(2) };
	const match = /\.superClass_\.(?!get__)(\w+)\.apply$/.exec(path);
	return match && { name: match[1], arguments: node.arguments[1]?.elements ?? [] };
}

/** The compiler's statements for "for each (var x in list)". */
export function forEach(first, second) {
	const declared = first?.type === "VariableDeclaration" ? first.declarations[0] : null;
	if (!/^foreachiter\d+_target$/.test(declared?.id.name ?? "")) return null;
	if (second?.type !== "ForInStatement") throw new Error("a \"for each\" is not as expected");
	const [variable, ...rest] = second.body.body;
	const isDeclared = variable.type === "VariableDeclaration";
	const body = { type: "BlockStatement", body: rest, start: second.body.start, end: second.body.end };
	return { variable: isDeclared ? variable.declarations[0].id : variable.expression.left, isDeclared, over: declared.init, body };
}

/** A comment without the parts that only describe types to the compiler. */
export function plainComment(comment) {
	const lines = comment.replace(/^\/\*+/, "").replace(/\*\/$/, "").split("\n")
		.map((line) => line.replace(/^\s*\*? ?/, "").trimEnd())
		.filter((line) => !/^@(inheritDoc|param|return|type|constructor|extends|implements|private|package|protected|nocollapse|const|export|interface|override|final|see starlogo\.engine)\b/.test(line))
		.map((line) => line.replace(/^@as(param|return)/, "@$1"));
	while (lines.length > 0 && lines[0] === "") lines.shift();
	while (lines.length > 0 && lines.at(-1) === "") lines.pop();
	if (lines.length === 0) return "";
	if (lines.length === 1) return `/** ${lines[0]} */\n`;
	return `/**\n${lines.map((line) => ` * ${line}`.trimEnd()).join("\n")}\n */\n`;
}

export const indent = (text) => text.replaceAll(/^(?=.)/gm, "\t");

/** Whether a path of names begins with another. */
export function isWithin(path, qname) {
	return path === qname || path.startsWith(`${qname}.`);
}
