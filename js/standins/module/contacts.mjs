/** The third argument of handlers in JavaScript. There a function need not declare how many arguments it takes. */

/** Whether a handler may read a third argument. */
export function mayTakeContact(handler) {
	return handler.length >= 3 || mayTakeMore(handler);
}

/**
 * Whether a handler that declares fewer than three arguments may still read a third: by `(...all)`, a default value or `arguments`, or
 * because it is bound or a mock, whose code is not known. The contacts of such a handler are computed in every frame.
 */
function mayTakeMore(handler) {
	const text = Function.prototype.toString.call(handler);
	return /\.\.\.|=/.test(parametersOf(text)) || /^[\s*]*(?:async\b[\s*]*)?\[|\barguments\b|\[native code\]/.test(text);
}

/**
 * A function's parameters: what is between their parentheses, of which default values may have others, or the one of an arrow function without them.
 * Comments, quoted names and texts are left out.
 */
export function parametersOf(code) {
	const text = code.replaceAll(/\/\*[^]*?\*\/|\/\/.*|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'/g, "");
	const [head] = text.split("=>");
	if (!head.includes("(")) return head;
	const start = text.indexOf("(");
	let end = start;
	for (let depth = 0; end < text.length; end++) {
		if (text[end] === "(") depth++;
		else if (text[end] === ")" && --depth === 0) break;
	}
	return text.slice(start + 1, end);
}
