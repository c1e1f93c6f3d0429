/** The examples and their index: examples/index.html and examples/README.md. */
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

/** The width of the pictures, in pixels. */
export const WIDTH = 480;
const CARDS = /(<!-- cards: .*-->\n)[^]*(<!-- end of cards -->)/;

/** Where the examples are. */
export const folder = fileURLToPath(new URL('../../examples', import.meta.url));

/** Whether an example is in ActionScript. */
export const isSwf = (name) => /^[A-Z]/.test(name);

/** All examples by groups: the name of each with its title and its sentence, which its own file has. */
export function groups() {
	const [, list] = /const EXAMPLES = (\{[^]*?\n\});/.exec(readFileSync(path.join(folder, 'shared/page.js'), 'utf8'));
	const all = JSON.parse(list.replaceAll(/,(\s*[\]}])/g, '$1'));
	return Object.entries(all).map(([group, names]) => ({ group, examples: names.map((name) => ({ name, ...saidOf(name) })) }));
}

function saidOf(name) {
	if (isSwf(name)) {
		const [, title, sentence] = /\/\*\*\s*(.*?): ([^]*?)\s*\*\//.exec(readFileSync(path.join(folder, `flash/${name}.as`), 'utf8'));
		return { title, sentence: sentence.replaceAll(/\s*\n\s*\* ?/g, ' '), address: `flash/index.html?${name}`, file: `flash/${name}.as` };
	}
	const text = readFileSync(path.join(folder, `${name}.html`), 'utf8');
	return { title: /<title>(.*)<\/title>/.exec(text)[1], sentence: /<p>([^]*?)<\/p>/.exec(text)[1].replaceAll('\n', ' '), address: `${name}.html`, file: `${name}.html` };
}

/** The index's two pages as they should be. */
export function pages() {
	const all = groups();
	const html = all.map(({ group, examples }) => `<h2>${group}</h2>\n<ul class="cards">\n${examples.map(({ name, title, sentence, address }) =>
		`<li><a href="${address}"><img src="pictures/${name}.webp" alt="" width="${WIDTH}" height="${(WIDTH * 2) / 3}" loading="lazy"><strong>${title}</strong><span>${sentence}</span></a></li>\n`).join('')}</ul>\n`);
	const markdown = all.map(({ group, examples }) => `## ${group}\n\n<table>\n${examples.map(({ name, title, sentence, file }) =>
		`<tr><td><a href="${file}"><img src="pictures/${name}.webp" alt="${title}" width="240"></a></td>\n<td><a href="${file}">${title}</a><br>\n${sentence.replaceAll('. ', '.<br>\n')}</td></tr>\n`).join('')}</table>\n`);
	const filled = (file, cards) => readFileSync(path.join(folder, file), 'utf8').replace(CARDS, (_, begin, end) => `${begin}${cards}${end}`);
	return new Map([['index.html', filled('index.html', html.join(''))], ['README.md', filled('README.md', `\n${markdown.join('\n')}\n`)]]);
}
