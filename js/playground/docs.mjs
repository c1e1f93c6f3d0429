/** Writes the project's documentation and examples as pages beside the playground, which links to them. */
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { Marked, Renderer } from "marked";
import { groups, isSwf } from "../../build/examples/list.mjs";

/** Pages outside of docs/, with their names among the pages. */
const OTHERS = { "README.md": "project", "CONTRIBUTING.md": "contributing", "js/module/README.md": "package" };
/** The examples that are whole clients, with the files that the page lists of each. */
const CLIENTS = { page: ["page.js"], three: ["page.js"], level: ["game.js", "page.js", "looks.js"], client: ["Client.as", "Pictures.as"] };

/**
 * Writes the pages.
 *
 * @param {string} root the project's folder
 * @param {string} out the output folder
 */
export function writeDocs(root, out) {
	const pages = new Map(readdirSync(path.join(root, "docs")).filter((file) => file.endsWith(".md")).map((file) => [`docs/${file}`, file === "README.md" ? "index" : file.slice(0, -".md".length)]));
	for (const [file, name] of Object.entries(OTHERS)) pages.set(file, name);
	for (const name of ["", ...Object.keys(CLIENTS)]) pages.set(path.posix.join("examples", name, "README.md"), "examples");
	const singles = groups().flatMap(({ examples }) => examples).map((each) => ({ ...each, title: isSwf(each.name) ? `${each.title}, in ActionScript` : each.title }));
	for (const { file, title } of singles) pages.set(`examples/${file}`, `examples#${placeOf(title)}`);
	mkdirSync(out, { recursive: true });
	const read = (file) => readFileSync(path.join(root, file), "utf8");
	const write = (name, sources) => writeFileSync(path.join(out, `${name}.html`), page(sources.map(([file, text]) => htmlOf(file, text, { root, out, pages })).join("\n")));
	for (const [file, name] of pages) if (!file.startsWith("examples/")) write(name, [[file, read(file)]]);
	const listing = (file) => `\n\n\`${path.basename(file)}\`\n\n~~~~\n${read(`examples/${file}`).trim()}\n~~~~\n`;
	write("examples", [
		...Object.entries(CLIENTS).map(([name, files]) => [`examples/${name}/README.md`, read(`examples/${name}/README.md`) + files.map((file) => listing(`${name}/${file}`)).join("")]),
		["examples/README.md", `# Single things\n${singles.map(({ title, sentence, file }) => `\n## ${title}\n\n${sentence}${listing(file)}`).join("")}`],
	]);
}

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll("\"", "&quot;");

/** The id of a heading, as links name it. */
const placeOf = (text) => text.toLowerCase().replaceAll(/[^\p{L}\p{N} _-]/gu, "").replaceAll(" ", "-");

/** A Markdown text as HTML. Links lead to the other pages, pictures are copied, and a link to something missing becomes text. */
function htmlOf(file, text, { root, out, pages }) {
	const marked = new Marked({ renderer: {
		heading({ tokens, depth, text: words }) {
			return `<h${depth} id="${placeOf(words)}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
		},
		link({ href, tokens }) {
			const words = this.parser.parseInline(tokens);
			if (/^(https?:|#)/.test(href)) return `<a href="${escaped(href)}">${words}</a>`;
			const [to, place] = href.split("#");
			const [name, itsPlace = place] = pages.get(path.posix.join(path.posix.dirname(file), to))?.split("#") ?? [];
			return name ? `<a href="${name}.html${itsPlace ? `#${itsPlace}` : ""}">${words}</a>` : words;
		},
		image({ href, text: words }) {
			const from = path.join(root, path.dirname(file), href);
			if (/^https?:/.test(href) || !existsSync(from)) return "";
			cpSync(from, path.join(out, path.basename(href)));
			return `<img src="${path.basename(href)}" alt="${escaped(words)}" loading="lazy">`;
		},
		// keys can reach elements that scroll
		code({ text: words }) {
			return `<pre tabindex="0"><code>${escaped(words)}</code></pre>\n`;
		},
		table(token) {
			return `<div class="table" tabindex="0">${Renderer.prototype.table.call(this, token)}</div>`;
		},
	} });
	return marked.parse(text);
}

const page = (content) => `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'self'">
<title>${/<h1[^>]*>(.*?)<\/h1>/.exec(content)?.[1].replaceAll(/<[^>]+>/g, "") ?? "Documentation"}</title>
<link rel="icon" href="../icon.svg">
<link rel="stylesheet" href="../style.css">
</head>
<body class="docs">
<header class="bar"><nav aria-label="Pages"><a href="../index.html">Playground</a><a href="index.html">Documentation</a><a href="package.html">npm package</a><a href="examples.html">Examples</a></nav></header>
<main class="teach"><section class="sheet">
${content}
</section></main>
</body>
</html>
`;
