/** Builds the page around an example: its title, its picture, its code. It is no module, so it also runs where a page is opened as a file. */
"use strict";

/** All examples by groups, in the order of the index. A name with a capital is that of a SWF in flash/, the others are those of pages. */
const EXAMPLES = {
	"Touching": ["first-collision", "start-and-end", "separate", "bullet", "filters"],
	"Asking and moving": ["nearest-and-cone", "ray", "distance", "slide", "walk", "one-way", "camera", "falling", "hills"],
	"Models and whole games": ["exact", "models", "three-instances", "ten-thousand", "snapshot", "own-system"],
	"In Flash": ["FirstCollision", "Contacts", "Sweeps", "Questions", "OwnModel"],
};

const KEYWORDS = "as|async|await|break|case|class|const|continue|else|export|extends|false|for|from|function|get|if|implements|import|in|"
	+ "let|new|null|of|override|package|private|protected|public|return|set|static|super|this|throw|true|var|while";
const TOKENS = new RegExp(`(/\\*[^]*?\\*/|//.*)|("(?:[^"\\\\\\n]|\\\\.)*"|'(?:[^'\\\\\\n]|\\\\.)*'|\`[^\`]*\`)|\\b(${KEYWORDS})\\b|(\\b\\d[\\w.]*)`, "g");

/** Makes an element. */
function element(name, properties, ...children) {
	const made = Object.assign(document.createElement(name), properties);
	made.append(...children);
	return made;
}

/** Code as HTML, with comments, strings, keywords and numbers in colours. */
function coloured(code) {
	const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
	let html = "";
	let end = 0;
	for (const match of code.matchAll(TOKENS)) {
		const kind = ["comment", "string", "keyword", "number"].find((_, i) => match[i + 1] !== undefined);
		const [open, close] = [`<span class="${kind}">`, "</span>"];
		html += `${escaped(code.slice(end, match.index))}${open}${escaped(match[0]).replaceAll("\n", `${close}\n${open}`)}${close}`;
		end = match.index + match[0].length;
	}
	return html + escaped(code.slice(end));
}

/** Coloured code in lines, of which each goes on further to the right where it is wrapped. */
function lined(code) {
	const lines = coloured(code).split("\n").map((line) => {
		const [, tabs, spaces] = /^(\t*)( *)/.exec(line);
		return `<span class="line" style="--tabs: ${tabs.length}; --spaces: ${spaces.length}">${line}`;
	});
	return `${lines.join("\n</span>")}</span>`;
}

/** Shows code beside the picture. */
function showCode(code, file) {
	const name = file.split("/").pop();
	const listing = element("pre", { innerHTML: lined(code.trim()) });
	listing.setAttribute("aria-label", `The code of ${name}`);
	const link = element("a", { href: file, download: name, textContent: name });
	document.querySelector(".code").replaceChildren(element("p", { className: "file" }, link, ` · ${code.trim().split("\n").length} lines of code`), listing);
}

/** The name of the example that this page shows, as EXAMPLES has it. */
function nameHere() {
	const [, folder, file] = /([^/]*)\/([^/]*)$/.exec(location.pathname);
	return folder === "flash" ? location.search.slice(1).split("&")[0] : file.replace(".html", "");
}

/** Where an example's page is, from the index. */
function addressOf(name) {
	return /^[A-Z]/.test(name) ? `flash/index.html?${name}` : `${name}.html`;
}

/**
 * Builds the page from what its file says: the title and the sentence.
 *
 * @param {string} top the way to the folder of the index: "" or "../"
 */
function buildPage(top) {
	const names = Object.values(EXAMPLES).flat();
	const next = names[(names.indexOf(nameHere()) + 1) % names.length];
	const nav = element("nav", {}, element("a", { href: `${top}index.html`, textContent: "All examples" }), element("a", { href: top + addressOf(next), textContent: "Next" }));
	const picture = element("section", { className: "picture" });
	const code = element("section", { className: "code" });
	const others = Object.values(EXAMPLES).find((group) => group.includes(nameHere())).map((name) => {
		const words = name.replaceAll(/-|\B(?=[A-Z])/g, " ").toLowerCase();
		const link = element("a", { href: top + addressOf(name), title: words }, element("img", { src: `${top}pictures/${name}.webp`, alt: words, width: 96, height: 64 }));
		if (name === nameHere()) link.setAttribute("aria-current", "page");
		return link;
	});
	const sentence = document.querySelector("body > p");
	const shown = element("div", { className: "shown" }, sentence, picture, element("nav", { className: "others", ariaLabel: "Examples like this one" }, ...others));
	document.body.prepend(element("header", {}, element("h1", { textContent: document.title }), nav), element("main", {}, shown, code));
	if (location.protocol === "file:") {
		picture.append(element("p", { className: "notice", textContent: "A browser runs modules from a web server only. Run \"./antw examples\" in a clone, "
			+ "or \"python3 -m http.server\" in the folder of the release, and open the address that it prints, with /examples/ behind it." }));
	}
}

const ownScript = document.querySelector("body > script[type=module]");
if (ownScript) {
	buildPage("");
	showCode(ownScript.textContent, `${nameHere()}.html`);
}
