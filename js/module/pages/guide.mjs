/** The pages of the guide that the package has in its folder docs: without ActionScript, and with links that lead somewhere in the package. */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "../names.mjs";

/** The pages. build/module.xml lists them too. */
export const PAGES = ["choosing", "loading", "motion", "poses", "queries", "questions", "snapshots", "terrain", "three", "whole-game"];

/** Sections and paragraphs that are for others: for ActionScript, about examples that the package has not. */
const FOR_OTHERS = [
	/^### Reading ActionScript\n[^]*?(?=^## )/m, /^## ActionScript\n[^]*?(?=^## )/m, /^- \*\*The guide's sample is in ActionScript\.\*\*.*\n(?:  .*\n)*/m,
	/^Examples?: [^]*?\n\n/gm, /^Each sample is in ActionScript and in JavaScript\. /m, /^!\[.*\n\n?/gm, /^\| \[ActionScript\].*\n/m, / \[The page of measurements\]\(.*?\) says what each costs\./, / \[Limits\]\(limits\.md\) says how large\n[^.]*\./, /\n\[How a question runs\].*\n/,
];

/** A sentence about players and their language, to the end of its line or to the next sentence. */
const OF_PLAYERS = /(?<=^|[.:?!] )(?=[A-Z])(?:(?!\.\s)[^|])*?\b(?:ActionScript|Flash|AIR|SharedObject)\b(?:(?!\.\s)[^|])*\.(?: |(?=\n))/gm;

/** Writes README.md and the pages into the folder of the package. */
export function writePages(out) {
	mkdirSync(join(out, "docs"));
	writeFileSync(join(out, "README.md"), readFileSync(join(ROOT, "js/module/README.md"), "utf8").replaceAll("](../../docs/", "](docs/"));
	for (const name of PAGES) writeFileSync(join(out, "docs", `${name}.md`), pageForJavaScript(readFileSync(join(ROOT, `docs/${name}.md`), "utf8")));
}

/** A page of the guide without ActionScript. Each of its samples has one in JavaScript behind it. */
function pageForJavaScript(page) {
	const isInside = (to) => to.startsWith("#") || to.startsWith("../js/module/") || PAGES.includes(to.replace(/\.md\b.*/, ""));
	return FOR_OTHERS.reduce((text, pattern) => text.replace(pattern, ""), page)
		.replaceAll(/^```actionscript\n[^]*?^```\n\n(?=```js\n)/gm, "").replaceAll(OF_PLAYERS, "")
		.replaceAll(/ \(\[[^\]]*\]\(([^)]*)\)\)/g, (link, to) => (isInside(to) ? link : ""))
		.replaceAll(/\[([^\]]*)\]\(([^)]*)\)/g, (_, text, to) => (isInside(to) ? `[${text}](${to.replace("js/module/", "")})` : text));
}
