/**
 * The samples of the documentation: the fences of README.md, js/module/README.md and docs/, and the listings of the ASDoc. The build makes
 * test classes of those in ActionScript, and samples.test.mjs runs those in JavaScript, so that what a page shows is what is tested.
 *
 * The samples of a page follow one another in one function. One that is a whole class is a file of its own. What a page names and does
 * not show is in its prelude: docs/away3d.md has Away3dPage.as, js/module/README.md has module-readme.mjs, beside this file.
 */
import { existsSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';
import { codeOf, definitionIn, read, root, sourcesBelow } from '../structure/sources.mjs';

/** What a sample's fence must not be called: it would not be run. Others (a command, a tree, a table of fields) are no programs. */
const OTHER_NAMES = /^(?:as3?|javascript|mjs|typescript)$/i;

/** The file of tests that runs samples in JavaScript: those of the pages that the environment's OF names, or all. */
export const SAMPLES_IN_JAVASCRIPT = 'test/docs/samples.test.mjs';

/** Where a sample takes names from that it does not import itself: as an editor would, from the engine and from these. */
const FLASH = ['flash.display.Sprite', 'flash.display.Stage', 'flash.events.ErrorEvent', 'flash.events.Event', 'flash.geom.Matrix3D',
	'flash.geom.Vector3D', 'flash.utils.ByteArray'];

/**
 * The fences of a page.
 *
 * @param {string} markdown the page
 * @returns {{language: string, line: number, text: string}[]} line is the first of the text, from 1
 */
export function fencesIn(markdown) {
	const fences = [];
	let open = null;
	markdown.split('\n').forEach((line, index) => {
		const [, indent, language] = /^( *)```(.*)$/.exec(line) ?? [];
		if (language === undefined) {
			open?.lines.push(line.slice(open.indent));
		} else if (open) {
			fences.push({ language: open.language, line: open.line, text: open.lines.join('\n') });
			open = null;
		} else {
			open = { language: language.trim(), indent: indent.length, line: index + 2, lines: [] };
		}
	});
	if (open) {
		throw new Error(`a fence is not closed: line ${open.line - 1}`);
	}
	return fences;
}

/** The listings in the ASDoc of a source, as fences. */
export function listingsIn(source) {
	return [...source.matchAll(/<listing[^>]*>\n([^]*?)<\/listing>/g)].map((match) => ({
		language: 'actionscript',
		line: source.slice(0, match.index).split('\n').length + 1,
		text: match[1].split('\n').map((line) => line.replace(/^ *\* ?/, '')).join('\n').trimEnd()
			.replaceAll('&lt;', '<').replaceAll('&gt;', '>').replaceAll('&amp;', '&'),
	}));
}

/** Every page with samples: its path, its name (docs/es-module.md is es-module), and its fences. */
export function pages() {
	const guide = readdirSync(path.join(root, 'docs')).filter((file) => file.endsWith('.md')).map((file) => `docs/${file}`);
	const written = ['README.md', 'js/module/README.md', ...guide].map((file) => ({ file, slug: slugOf(file), fences: fencesIn(read(file)) }));
	const sources = sourcesBelow('src').map((file) => ({ file, slug: path.basename(file, '.as'), fences: listingsIn(read(file)) }));
	for (const { file, fences } of written) {
		for (const { language, line } of fences) {
			if (OTHER_NAMES.test(language)) {
				throw new Error(`${file}:${line}: the fence of a sample is called actionscript, js or ts, not ${language}`);
			}
		}
	}
	return [...written, ...sources].filter(({ fences }) => fences.some(({ language }) => ['actionscript', 'js'].includes(language)));
}

const slugOf = (file) => file.replace(/^(?:docs\/(?!README)|js\/)|\.md$/g, '').replace('/', '-').toLowerCase();
const classOf = (slug) => slug.replace(/(?:^|-)(\w)/g, (_, letter) => letter.toUpperCase());

/** The class of tests that the samples in ActionScript of a page become. */
export const classOfSamples = (file) => `docs.${classOf(slugOf(file))}SamplesTest`;

/** Where a page's prelude is, if it has one: its name and an ending. */
export function preludeOf(name, ending) {
	const file = `test/docs/${name}${ending}`;
	return existsSync(path.join(root, file)) ? file : null;
}

/** The names that a program declares at its outermost level. */
const namesIn = (text, keyword) => [...text.matchAll(new RegExp(`^${keyword} (\\w+)`, 'gm'))].map(([, name]) => name);

const IMPORT = /^import \{(.*)\} from "(.*)";$/gm;
/** The line before each sample in what is made of it: the page, and the sample's line there. */
const PLACE = /^(?:\/\/ | +_place = ")([\w./-]+):(\d+)(?:";)?$/;

const escaped = (text) => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');
/** A place in a file that is made of samples, as compilers and Node name it. */
const MADE = new RegExp(`(?:${[pathToFileURL(root).href, root].map(escaped).join('|')})?(bin/generated/docs(?:-js)?/[\\w./-]+\\.(?:as|mjs))(?:\\((\\d+)\\)|:(\\d+))`, 'g');
const isWhole = (text) => /^(?:import .*\n|\s)*(?:package|public (?:final )?class)\b/.test(text);

/**
 * What the samples in ActionScript become: files to be compiled with the engine and FlexUnit.
 *
 * @param {{file: string, slug: string, fences: object[]}[]} pages as pages() gives them
 * @returns {Map<string, string>} text by path
 */
export function testClasses(pages) {
	const files = new Map();
	const samples = pages.map((page) => ({ ...page, fences: page.fences.filter(({ language }) => language === 'actionscript') }))
		.filter(({ fences }) => fences.length > 0);
	const whole = samples.flatMap(({ file, fences }) => fences.filter(({ text }) => isWhole(text)).map((fence) => ({ file, ...fence })));
	const classes = whole.map(({ text }) => definedIn(text));
	const add = (name, from, text) => {
		const at = `${name.replaceAll('.', '/')}.as`;
		if (files.has(at)) {
			throw new Error(`${from}: another sample defines ${name} too`);
		}
		files.set(at, text);
	};
	for (const { file, line, text } of whole) {
		const placed = `// ${file}:${line}\n${text}\n`;
		add(definedIn(text), `${file}:${line}`, /^package\b/m.test(text) ? placed : packaged(placed));
	}
	for (const page of samples) {
		add(`docs.${classOf(page.slug)}SamplesTest`, page.file, testClass(page, classes));
	}
	return files;
}

/** The qualified name of the class that a text is. */
function definedIn(text) {
	const [, name] = /\bclass (\w+)/.exec(text);
	const inPackage = /^package ([\w.]*)/m.exec(text)?.[1];
	return inPackage === undefined ? `docs.${name}` : inPackage === '' ? name : `${inPackage}.${name}`;
}

function packaged(text) {
	return `package docs\n{\n${importLines(text, [])}\n${text}\n}`;
}

/** Imports of what a text names: its own, then the engine's classes and the other samples'. */
function importLines(text, classes) {
	const own = [...text.matchAll(/^import ([\w.]+);$/gm)].map(([, name]) => name);
	const words = new Set(codeOf(text).match(/\b[A-Za-z]\w*/g));
	// what a text imports, or a sample shows, hides a class of the engine with the same name
	const simple = (name) => name.split('.').pop();
	const taken = new Set([...own, ...classes].map(simple));
	const engine = sourcesBelow('src/starlogo').map(definitionIn).filter((name) => !taken.has(simple(name)));
	const known = [...engine, ...FLASH, ...classes].filter((name) => words.has(simple(name)));
	return [...new Set([...own, ...known])].filter((name) => name.includes('.')).sort().map((name) => `    import ${name};`).join('\n');
}

function testClass({ file, slug, fences }, classes) {
	const name = classOf(slug);
	const statements = fences.filter(({ text }) => !isWhole(text))
		.map(({ line, text }) => `                _place = "${file}:${line}";\n${text.replace(/^import .*$/gm, '')}`).join('\n\n');
	const shown = namesIn(statements, 'var').map((each) => `${each}: ${each}`).join(', ');
	const prelude = preludeOf(name, 'Page.as') ? `${name}Page` : 'Page';
	return `package docs
{
${importLines(fences.map(({ text }) => text).join('\n'), classes)}

    /** What ${file} shows, as it stands there; generated by the build. */
    public class ${name}SamplesTest extends ${prelude}
    {
        public static const FIXTURES:Array = ${prelude}.FIXTURES;

        private var _place:String;

        [Test(async)]
        public function samples():void
        {
            try
            {
${statements}
            }
            catch (thrown:Error)
            {
                thrown.message = "in the sample at " + _place + ": " + thrown.message;
                throw thrown;
            }
            check({ ${shown} });
        }
    }
}
`;
}

/**
 * What the samples in JavaScript of a page become: a module that exports what they declare.
 *
 * @param {{file: string, slug: string, fences: object[]}} page one of pages()
 * @returns {string}
 */
export function moduleOf({ file, slug, fences }) {
	const text = fences.filter(({ language }) => language === 'js').map((fence) => `// ${file}:${fence.line}\n${fence.text}`).join('\n\n');
	const imported = new Map();
	// a later sample may import a name again
	const once = text.replace(IMPORT, (_, names, from) => {
		const known = imported.get(from) ?? new Set();
		const added = names.split(',').map((name) => name.trim()).filter((name) => !known.has(name));
		imported.set(from, new Set([...known, ...added]));
		return added.length > 0 ? `import { ${added.join(', ')} } from "${from}";` : '';
	});
	const prelude = preludeOf(slug, '.mjs');
	const given = prelude ? namesIn(read(prelude), 'export const').filter((name) => text.includes(name)).join(', ') : '';
	const first = prelude ? `import { ${given} } from "${pathToFileURL(path.join(root, prelude)).href}";\n\n` : '';
	return `${first}${once}\n\nexport { ${namesIn(text, '(?:const|let|function|class)').join(', ')} };\n`;
}

/**
 * What a compiler or Node says, with the page and the line there in place of those of files that are made of samples.
 *
 * @param {string} said text that names files as "a/File.as(3)" or "a/file.mjs:3"
 */
export function withPagesNamed(said) {
	return said.replace(MADE, (place, file, inBrackets, behind) => {
		const number = Number(inBrackets ?? behind);
		const above = existsSync(path.join(root, file)) ? read(file).split('\n').slice(0, number) : [];
		const at = above.findLastIndex((line) => PLACE.test(line));
		if (at < 0) return place;
		const [, page, first] = PLACE.exec(above[at]);
		return `${page}:${Number(first) + number - at - 2}`;
	});
}

/**
 * The classes of the engine and of Flash that a page's samples in ActionScript name and have not imported, as "docs/a.md:12: a.b.C". A
 * reader copies the samples in their order. Samples that are whole classes have packages of their own.
 */
export function missingImports({ file, fences }) {
	const simple = (name) => name.split('.').pop();
	const known = [...sourcesBelow('src/starlogo').map(definitionIn), ...FLASH].filter((name) => name.includes('.'));
	const imported = new Set();
	return fences.filter(({ language, text }) => language === 'actionscript' && !isWhole(text)).flatMap(({ line, text }) => {
		for (const [, name] of text.matchAll(/^import ([\w.]+);$/gm)) imported.add(simple(name));
		const words = new Set(codeOf(text.replace(/^import .*$/gm, '')).match(/\b[A-Z]\w*/g));
		const missing = known.filter((name) => words.has(simple(name)) && !imported.has(simple(name)));
		missing.forEach((name) => imported.add(simple(name)));
		return missing.map((name) => `${file}:${line}: ${name}`);
	});
}
