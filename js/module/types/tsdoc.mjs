/** Documentation comments for JavaScript and TypeScript, made of ASDoc. */
import { PAGES } from "../pages/guide.mjs";

/** The TypeScript names of types that JavaScript has too. */
export const PRIMITIVES = {
	Number: "number", int: "number", uint: "number", Boolean: "boolean", String: "string", void: "void", "*": "unknown", Object: "unknown",
	Array: "unknown[]", Class: "Function", Error: "Error", RegExp: "RegExp", Function: "(...args: never[]) => unknown",
};

/** Sentences with these words do not concern a JavaScript developer. */
const OF_PLAYERS = /Ruffle|Adobe|Flash|Away3D|SWF|SWC|avmshell|mxmlc|ASDoc|E4X/;

/** A page of the project. */
const PAGE = /\bdocs\/([\w-]+)\.md\b/;

/** Whether a sentence concerns a JavaScript developer, who has the package's pages and no players. */
function isForJavaScript(sentence) {
	const [, page] = PAGE.exec(sentence) ?? [];
	return !OF_PLAYERS.test(sentence.replaceAll(/<\/?p>/g, "")) && (page === undefined || PAGES.includes(page));
}

/** A documentation text for JavaScript: with JavaScript's terms, and without references to the thesis. */
function forJavaScript(text) {
	const sentences = text.split(/(?<=\.)(?=\s)|(?=\n@)|(?=<p>)|(?<=<\/p>)/);
	return sentences.filter(isForJavaScript).join("").replaceAll(/(?<=\n\n) (?=\S)/g, "")
		.replaceAll(/\s*\((?:the\s+)?(?:thesis\s+)?§[^)]*\)/g, "")
		.replaceAll(/,? ?(?:in |of |as in )?(?:the )?thesis,? §[\d.]+/g, "").replaceAll(/\s*\(?§\s?[\d.]+[^\s)]*\)?/g, "")
		.replaceAll(/\bflash\.\w+\.(?=[A-Z])/g, "").replaceAll(/\.\/antw cook/g, "npx starlogo-cook")
		.replaceAll(/\bVector\.<(?:Number|int|uint)>/g, "an array of numbers").replaceAll(/\ba Vector\b/g, "an array")
		.replaceAll(/<code>(?:function)?\(([^)<]*)\):(\w+)<\/code>/g, (_, list, result) => `<code>(${list.replaceAll(/:(\w+)/g, (_, name) => `: ${nameHere(name)}`)}) => ${nameHere(result)}</code>`)
		.replaceAll(/<code>(\w+):([A-Z]\w*)<\/code>/g, (_, name, type) => `<code>${name}: ${nameHere(type)}</code>`)
		.replaceAll(/<listing[^>]*>[\s\S]*?<\/listing>/g, sampleForJavaScript);
}

/** A sample in JavaScript: without types, modifiers and the constants of events. */
function sampleForJavaScript(code) {
	return code.replaceAll(/(?<=[\w)]):(?:[A-Z][\w.]*|int|uint|void)(?:&lt;\w+&gt;)?/g, "")
		.replaceAll(/\bfor \(var /g, "for (let ").replaceAll(/\btrace\(/g, "console.log(")
		.replaceAll(/\bvar (\w+)( = [^;]*;)/g, (_, name, rest) => `${isAssignedLater(code, name) ? "let" : "const"} ${name}${rest}`)
		.replaceAll(/\bnew &lt;\w+&gt;\[/g, "[").replaceAll(/\bpublic class\b/g, "class").replaceAll(/\b(?:(?:override|public|protected|private) )+function /g, "")
		.replaceAll(/\b\w*Event\.([A-Z_]+)\b/g, (_, constant) => JSON.stringify(camelCase(constant)));
}

/** Whether a variable of a sample is assigned again after its declaration, which has a type before its "=". */
function isAssignedLater(code, name) {
	return new RegExp(`\\b${name} [-+*/]?= `).test(code);
}

/** The value of a constant that names a type of event: MODEL_LOADED is "modelLoaded". */
function camelCase(constant) {
	return constant.toLowerCase().replaceAll(/_(.)/g, (_, letter) => letter.toUpperCase());
}

/** The TypeScript name of an ActionScript type. */
function nameHere(name) {
	return PRIMITIVES[name] ?? name;
}

/** An indented comment of a documentation text: Markdown in place of HTML, and TSDoc's tags in place of ASDoc's. */
export function docComment(text, indent) {
	if (text === "") return "";
	const plain = forJavaScript(text)
		.replaceAll(/<listing[^>]*>/g, "```js").replaceAll("</listing>", "```")
		.replaceAll(/<\/?code>/g, "`").replaceAll(/<\/p>/g, "").replaceAll(/<p>/g, "")
		.replaceAll(/<\/?(em|i)>/g, "*").replaceAll(/<\/?(strong|b)>/g, "**")
		.replaceAll(/<\/?ul>/g, "").replaceAll("<li>", "- ").replaceAll("</li>", "")
		.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&amp;", "&")
		.replaceAll(/^An older name of (`\w+\(\)`)\.$/gm, "An older name.\n\n@deprecated Use $1.")
		.replaceAll(/^@return /gm, "@returns ").replaceAll(/@eventType.*$/gm, "").replaceAll("*/", "* /").trim();
	const lines = plain.split("\n");
	if (lines.length === 1) return `${indent}/** ${lines[0]} */\n`;
	return `${indent}/**\n${lines.map((line) => `${indent} * ${line}`.trimEnd()).join("\n")}\n${indent} */\n`;
}
