/** The examples and their index: examples/index.html and examples/README.md. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** The width of the pictures, in pixels. */
export const WIDTH = 480;

/** The cards of a page, between two marks. */
const CARDS = /(<!-- cards: .*-->\n)[^]*(<!-- end of cards -->)/;

/** Where the examples are. */
export const folder = fileURLToPath(new URL('../../examples', import.meta.url));

/** Whether an example is in ActionScript. */
export const isSwf = (name) => /^[A-Z]/.test(name);

/**
 * All examples by groups.
 *
 * @returns {{ group: string, examples: Example[] }[]}
 * @typedef {{ name: string, title: string, sentence: string, address: string, file: string }} Example its title and its sentence are
 *     from its own file; its address and its file are in the folder of the examples
 */
export function groups() {
	const [, list] = /const EXAMPLES = (\{[^]*?\n\});/.exec(readIn('shared/page.js'));
	const namesByGroup = JSON.parse(list.replaceAll(/,(\s*[\]}])/g, '$1'));
	const exampleOf = (name) => (isSwf(name) ? exampleInActionScript(name) : exampleInJavaScript(name));
	return Object.entries(namesByGroup).map(([group, names]) => ({ group, examples: names.map(exampleOf) }));
}

function readIn(file) {
	return readFileSync(path.join(folder, file), 'utf8');
}

function exampleInActionScript(name) {
	const file = `flash/${name}.as`;
	const [, title, comment] = /\/\*\*\s*(.*?): ([^]*?)\s*\*\//.exec(readIn(file));
	return { name, title, sentence: comment.replaceAll(/\s*\n\s*\* ?/g, ' '), address: `flash/index.html?${name}`, file };
}

function exampleInJavaScript(name) {
	const file = `${name}.html`;
	const text = readIn(file);
	const [, title] = /<title>(.*)<\/title>/.exec(text);
	const [, sentence] = /<p>([^]*?)<\/p>/.exec(text);
	return { name, title, sentence: sentence.replaceAll('\n', ' '), address: file, file };
}

/** The index's two pages as they should be: [the file, its text]. */
export function pages() {
	const all = groups();
	return new Map([
		['index.html', filled('index.html', all.map(groupInHtml).join(''))],
		['README.md', filled('README.md', `\n${all.map(groupInMarkdown).join('\n')}\n`)],
	]);
}

/** The text of a page with other cards. */
function filled(file, cards) {
	return readIn(file).replace(CARDS, (_, begin, end) => `${begin}${cards}${end}`);
}

function groupInHtml({ group, examples }) {
	return `<h2>${group}</h2>\n<ul class="cards">\n${examples.map(cardInHtml).join('')}</ul>\n`;
}

function cardInHtml({ name, title, sentence, address }) {
	const picture = `<img src="pictures/${name}.webp" alt="" width="${WIDTH}" height="${(WIDTH * 2) / 3}" loading="lazy">`;
	return `<li><a href="${address}">${picture}<strong>${title}</strong><span>${sentence}</span></a></li>\n`;
}

function groupInMarkdown({ group, examples }) {
	return `## ${group}\n\n<table>\n${examples.map(rowInMarkdown).join('')}</table>\n`;
}

function rowInMarkdown({ name, title, sentence, file }) {
	const picture = `<img src="pictures/${name}.webp" alt="${title}" width="240">`;
	const lines = sentence.replaceAll('. ', '.<br>\n');
	return `<tr><td><a href="${file}">${picture}</a></td>\n<td><a href="${file}">${title}</a><br>\n${lines}</td></tr>\n`;
}
