/** The page's languages: each has all words, the page has no others, and one is loaded. */
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { isChromium } from '../../build/headless/browsers.mjs';
import { begin, newPage, open, ready, root } from './browser.mjs';
import { parts } from './parts.mjs';

const folder = path.join(root, 'js/playground/languages');
const wordsIn = async (file) => (await import(pathToFileURL(path.join(folder, file)).href)).texts;
/** All words of a language: every view's, and the parts that load later. */
async function wordsOf(file) {
	const words = { ...await wordsIn(file) };
	for (const part of ['class', 'game', 'lab']) {
		for (const [key, value] of Object.entries(await wordsIn(`${part}/${file}`))) words[key] = { ...words[key], ...value };
	}
	return words;
}
const languages = Object.fromEntries(await Promise.all(readdirSync(folder).filter((file) => file.endsWith('.js')).map(async (file) => [path.parse(file).name, await wordsOf(file)])));
const { en, ...others } = languages;
const German = { locale: 'de-AT', viewport: { width: 1366, height: 768 } };

let site;
before(async () => {
	site = await begin();
});
after(() => site.close());

/** All words of a language, by their keys. */
function flat(words, name = '') {
	if (words === null || typeof words !== 'object') return [[name, words]];
	return Object.entries(words).flatMap(([key, each]) => flat(each, name ? `${name}.${key}` : key));
}

test('each breed and each shape of the page\'s programs has a name in every language', () => {
	const programs = [...Object.values(parts.GAMES), ...Object.values(parts.EXAMPLES), ...Object.values(parts.LESSONS).map(({ program }) => program)];
	const found = { breeds: new Set(Object.keys(parts.SHAPE_OF)), shapes: new Set(Object.values(parts.SHAPE_OF)) };
	JSON.stringify(programs, (key, value) => {
		if (key === 'BREED' && !/^anyone$|^\*/.test(value)) found.breeds.add(value);
		if (key === 'SHAPE') found.shapes.add(value);
		return value;
	});
	assert.ok(found.breeds.size > 20 && found.shapes.size > 10);
	for (const [code, words] of Object.entries(languages)) for (const [kind, names] of Object.entries(found)) assert.deepEqual([...names].filter((name) => !(name in words[kind])), [], `${code}: ${kind}`);
});

/** Names of keys, systems and the like, and words that languages share. */
const SHARED = /^(numbers|traits\.[xyz]|inspect\.(ups|time)|blocks\.(traits\.[xyz]|mouse\.[xy]|comparisons|arithmetic|keys\.[wasd]|logic_|math_number|math_arithmetic|variables_get|starlogo_agent|starlogo_pick)|play\.keysOf|blockly\.|compare\.(system|ms)$|questions\.other|play\.(another|speeds|after|panel\.tests)|gallery\.name|page\.api|views\.level|handing\.name|colours\.orange)/;
const isOfSigns = (text) => !/\p{L}/u.test(text.replaceAll(/%\d/g, ''));

for (const [code, words] of Object.entries(others)) {
	test(`${code} has the keys of English, of the same kinds, and says nothing in English`, () => {
		const [here, there] = [new Map(flat(words)), new Map(flat(en))];
		assert.deepEqual([...here.keys()].sort(), [...there.keys()].sort());
		for (const [key, text] of here) {
			const english = there.get(key);
			assert.equal(typeof text, typeof english, key);
			if (typeof text === 'string') {
				assert.equal(text === english && !isOfSigns(text) && !SHARED.test(key), false, `${key} is not translated: ${text}`);
				assert.deepEqual(text.match(/%\d/g)?.sort(), english.match(/%\d/g)?.sort(), `${key} has the places of English`);
			} else if (key !== 'inSentence') {
				assert.ok(text.length <= english.length, key);
				// each thing that is told has its place in the sentence
				const told = english.toString().match(/^\(?([^)=]*)\)?\s*=>/)[1].split(',').map((each) => each.trim()).filter(Boolean).map((_, i) => 7001 + i);
				const [own, their] = [text, english].map((each) => String(each(...told.map(String))));
				for (const number of told) assert.equal(own.includes(number), their.includes(number), `${key}: ${own}`);
			}
		}
		assert.equal(words.code, code);
	});
}

test('of one thing, one is said', () => {
	for (const [words, one, many] of [[en, /\b1 (box|vertex|triangle|level|frame|pair)\b/g, /\b1 (boxes|vertices|\w+s)\b/], [others.de, /\b1 (Quader|Ecke|Dreieck|Ebene|Bild|Paar)\b/g, /\b1 (\w+en|Dreiecke|Bilder|Paare)\b/]]) {
		const said = [words.inspect.levelNote(1, 1, '7'), words.inspect.vertices('x', 1, 1), words.play.differences(1), words.compare.gameNote(2, 1), words.compare.differenceNote(2, 1, 'x')].join(' ');
		assert.equal(said.match(one).length, 7, said);
		assert.doesNotMatch(said, many);
	}
});

test('a browser in German gets German, all of it and nothing of English; a choice by hand is kept', async () => {
	const { page, said, leave } = await open(site, 'play/paintball', German);
	const files = async () => (await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name))).filter((name) => name.endsWith('.js'))
		.map((name) => readFileSync(path.join(root, 'bin/playground', new URL(name).pathname.replace('/any/where/', '')), 'utf8'));
	const count = (all, words) => all.filter((text) => text.includes(words)).length;
	const isIn = async ([mine, other]) => {
		const all = await files();
		assert.equal(count(all, mine.page.name), 1);
		assert.equal(count(all, other.page.name), 0, 'one language is loaded');
	};
	await isIn([others.de, en]);
	assert.equal(await page.getAttribute('html', 'lang'), 'de');
	assert.equal(await page.textContent('h1'), others.de.page.name);
	assert.match(await page.title(), /Spielen/);
	assert.ok(await page.getByRole('button', { name: 'Start', exact: true }).isVisible());
	// Blockly's own words, in the menu of a block
	await page.evaluate(() => {
		const [block] = globalThis.playground.editor.workspace.getTopBlocks(true);
		block.showContextMenu(new PointerEvent('contextmenu', { clientX: 400, clientY: 300 }));
	});
	const menu = await page.locator('.blocklyMenuItem').allTextContents();
	assert.ok(menu.some((text) => /löschen/i.test(text)), menu.join());
	assert.ok(!menu.some((text) => /collapse|duplicate|copy|paste|move|Baustein/i.test(text)), menu.join());
	await page.keyboard.press('Escape');
	// a number with a comma
	const number = await page.evaluate(() => {
		const { workspace } = globalThis.playground.editor;
		const field = workspace.getAllBlocks().find(({ type }) => type === 'math_number').getField('NUM');
		field.setValue('0,5');
		return [field.getValue(), field.getText()];
	});
	assert.deepEqual(number, [0.5, '0,5']);
	await page.getByLabel('Sprache').selectOption('en');
	await page.waitForFunction(() => document.documentElement.lang === 'en');
	await ready(page, 'play');
	await isIn([en, others.de]);
	await page.reload();
	await ready(page, 'play');
	assert.equal(await page.getAttribute('html', 'lang'), 'en', 'it is kept');
	assert.deepEqual(said, []);
	await leave();
});

test('where nothing is kept, the choice of a language is in the address', async () => {
	const { page } = await newPage(site, { locale: 'en-US' });
	await page.addInitScript(() => {
		Storage.prototype.setItem = () => {
			throw new Error('refused');
		};
	});
	await page.goto(`${site.url}#inspect`);
	await ready(page, 'inspect');
	await page.getByLabel('Language').selectOption('de');
	await page.waitForFunction(() => document.documentElement.lang === 'de');
	await ready(page, 'inspect');
	assert.match(page.url(), /\?language=de#inspect$/);
	assert.match(await page.textContent('.facts'), /Einfache Kugel/);
	assert.match(await page.textContent('.facts td'), /^\d+,\d+$/);
	await page.context().close();
});

test('what Blockly says is in the language, too', async () => {
	const parts = path.join(root, 'bin/playground/parts');
	const messages = {};
	for (const file of readdirSync(parts)) {
		const [, code] = /^(en|de)-.*\.js$/.exec(file) ?? [];
		const content = code && (await import(pathToFileURL(path.join(parts, file)).href)).default;
		if (content) messages[code] = content;
	}
	const same = Object.keys(messages.en).filter((key) => messages.de[key] === messages.en[key] && /\p{L}/u.test(messages.en[key]) && !/HUE$/.test(key));
	assert.ok(Object.keys(messages.en).length > 30);
	assert.deepEqual(same.filter((key) => !(key in others.de.blockly) && !/^(UNNAMED_KEY|DIALOG_OK)$/.test(key)), []);
});

/** Puts marks around every word of a language: what is on the page without them is not from there. */
function marked() {
	const mark = (text) => text.split(/(%\d)/).map((part) => (/\p{L}/u.test(part) && !/^%\d$/.test(part) ? part.replace(/^(\s*)(.*?)(\s*)$/su, '$1⟦$2⟧$3') : part)).join('');
	const all = (words, key) => {
		if (words === 'en' || key === 'numbers' || key === 'keyName') return words;
		if (typeof words === 'string') return mark(words);
		if (typeof words === 'function') return (...told) => all(words(...told));
		if (Array.isArray(words)) return words.map((each) => all(each));
		return Object.fromEntries(Object.entries(words).map(([name, each]) => [name, all(each, name)]));
	};
	return all;
}

/** What is on the page that the language does not have. */
function unmarked() {
	const rest = (text) => {
		let [depth, left] = [0, ''];
		for (const letter of text) {
			if (letter === '⟦') depth++;
			else if (letter === '⟧' && depth > 0) depth--;
			// the first words of it stand elsewhere: Blockly puts what all of a menu begin with before it
			else if (letter === '⟧') left = '';
			else if (depth === 0) left += letter;
		}
		return left;
	};
	const found = new Set();
	const look = (text) => {
		if (/\p{L}{2}|\p{L}/u.test(rest(text))) found.add(text.trim().slice(0, 80));
	};
	const isApart = (element) => element.closest('script, style, noscript, code, .language, h1 img, option[value^="own-"], .address');
	const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
	while (walker.nextNode()) if (!isApart(walker.currentNode.parentElement)) look(walker.currentNode.data);
	for (const element of document.body.querySelectorAll('[aria-label], [title], [alt], [placeholder]')) {
		if (isApart(element) || element.closest('.blocks svg, .blocklyToolbox')) continue;
		for (const name of ['aria-label', 'title', 'alt', 'placeholder']) look(element.getAttribute(name) ?? '');
	}
	look(document.title);
	return [...found];
}

test('no word of the page is anywhere but in its language', { skip: isChromium ? false : 'one browser is enough' }, async () => {
	const { page } = await newPage(site, { locale: 'en-US', viewport: { width: 1366, height: 768 } });
	await page.route(/\/parts\/en-[^/]*\.js$/, (route) => {
		const { pathname } = new URL(route.request().url());
		const text = readFileSync(path.join(root, 'bin/playground/parts', path.basename(pathname)), 'utf8');
		const body = text.replace(/export\s*\{\s*(\w+) as texts\s*\};?/, (_, name) => `const marked=(${marked})()(${name});export{marked as texts};`);
		return route.fulfill({ contentType: 'text/javascript', body });
	});
	const press = (name) => page.getByRole('button', { name: `⟦${name}⟧`, exact: true }).first().click();
	await page.goto(`${site.url}#play/paintball`);
	await ready(page, 'play');
	assert.match(await page.textContent('h1'), /⟦/, 'words are marked');
	assert.deepEqual(await page.evaluate(unmarked), [], 'Play');
	await page.evaluate(async () => {
		const view = globalThis.playground;
		view.scene.isEngineShown = true;
		await view.putBeside('exact');
	});
	await press(en.play.step);
	await page.locator('.cast button').first().click();
	assert.deepEqual(await page.evaluate(unmarked), [], 'Play, two systems');
	await page.goto(`${site.url}#inspect`);
	await ready(page, 'inspect');
	assert.deepEqual(await page.evaluate(unmarked), [], 'Inspect');
	await page.locator('input[value=questions]').check();
	await page.waitForFunction(() => /⟦.*⟦.*\d/.test(document.querySelector('.answers .meeting dd')?.textContent));
	assert.deepEqual(await page.evaluate(unmarked), [], 'Inspect, questions');
	await page.goto(`${site.url}#compare`);
	await ready(page, 'compare');
	assert.deepEqual(await page.evaluate(unmarked), [], 'Compare');
	for (const view of ['measure', 'level', 'teach', 'teach/helmet', 'teach/class', 'teach/in-class']) {
		await page.goto(`${site.url}#${view}`);
		await ready(page, view.split('/')[0]);
		assert.deepEqual(await page.evaluate(unmarked), [], view);
	}
	await page.context().close();
});
