/** Tests of the lists that docs/adding*.md gives to who adds something: what is there already stands everywhere in them. */
import assert from 'node:assert/strict';
import { existsSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { assertNone, codeOf, definitionIn, differences, filesBelow, read, root, sourcesBelow } from './sources.mjs';

const simpleName = (file) => definitionIn(file).split('.').pop();

/** The files that a page's table lists, below a heading. */
function filesOf(page, heading) {
	const section = read(page).split(`\n## ${heading}\n`)[1].split('\n## ')[0];
	const files = [...section.matchAll(/^\| `([\w./-]+)` \|/gm)].map(([, file]) => file);
	for (const file of files) assert.ok(existsSync(path.join(root, file)), `${page} lists ${file}, which is not there`);
	assert.ok(files.length >= 3, page);
	return files;
}

/** The classes below a folder that can be made, and extend one of some classes. */
function classesOf(folder, bases) {
	const extended = new RegExp(`\\bpublic (?:final )?class (\\w+) extends (?:${bases.join('|')})\\b`);
	return sourcesBelow(folder).filter((file) => extended.test(codeOf(read(file)))).map(simpleName).filter((name) => !bases.includes(name));
}

/** What stands in no file that a list names, as "file: name". */
function missing(names, files, known) {
	const isIn = (file, name) => new RegExp(`\\b${name}\\b`).test(read(file));
	return files.flatMap((file) => names.filter((name) => !isIn(file, name)).map((name) => `${file}: ${name}`)).filter((each) => !known.includes(each));
}

/** Asserts that no file lacks a name. */
function assertNoneMissing(left) {
	const names = [...new Set(left.map((each) => each.split(': ')[1]))];
	const said = names.map((name) => {
		const files = left.filter((each) => each.endsWith(`: ${name}`)).map((each) => each.split(': ')[0]);
		return `${files.length} file${files.length === 1 ? ' lacks' : 's lack'} ${name}: ${files.join(', ')}`;
	});
	assertNone(said);
}

test('what a file lacks is said in one line', () => {
	assert.throws(() => assertNoneMissing(['a.md: OwnFitter', 'b.md: OwnFitter', 'a.md: Other']), /^AssertionError.*: 2 files lack OwnFitter: a\.md, b\.md; 1 file lacks Other: a\.md$/m);
	assertNoneMissing([]);
});

test('every fitter stands in the files of docs/adding-a-fitter.md, "A fitter in the engine"', () => {
	const fitters = classesOf('src/starlogo/fitting', ['Fitter']);
	assert.ok(fitters.includes('HullFitter') && fitters.includes('CapsuleFitter') && fitters.length > 9);
	// HullFitterTest compares hulls, ReferenceFitsTest the smallest capsules
	const known = ['test/starlogo/fitting/ReferenceFitsTest.as: HullFitter', 'test/starlogo/libraries/FittersOfModelsTest.as: HullFitter', 'test/starlogo/libraries/FittersOfModelsTest.as: MinimalCapsuleFitter'];
	assertNoneMissing(missing(fitters, filesOf('docs/adding-a-fitter.md', 'A fitter in the engine'), known));
});

test('every structure stands in the files of docs/adding-a-structure.md, "A structure of the engine"', () => {
	const structures = classesOf('src/starlogo/bounding', ['BoundingStructure']);
	for (const known of ['Box', 'Capsule', 'Cylinder', 'Hull', 'Sphere']) assert.ok(structures.includes(known), known);
	assertNoneMissing(missing(structures, filesOf('docs/adding-a-structure.md', 'A structure of the engine'), []));
});

/** The older names of questions, with the present ones. */
function olderNames(source) {
	const older = [...source.matchAll(/An older name of <code>(\w+)\(\)<\/code>\. \*\/\s+public function (\w+)/g)].map(([, name, before]) => [before, name]);
	assert.ok(older.length > 1);
	return older;
}

test('the engine calls no question by an older name', () => {
	const older = olderNames(read('src/starlogo/queries/AgentQueries.as')).map(([before]) => before);
	const calls = new RegExp(`\\b_?queries\\.(?:${older.join('|')})\\(`);
	assertNone(sourcesBelow('src/starlogo').filter((file) => calls.test(codeOf(read(file)))));
});

/** The questions of AgentQueries, and what each takes, as text. */
function questionsOf(source) {
	const others = ['AgentQueries', 'update', 'refresh', 'moved', ...olderNames(source).map(([before]) => before)];
	const methods = [...codeOf(source).matchAll(/^ {8}public function (\w+)\(([^)]*)\)/gm)].map(([, name, taken]) => ({ name, taken }));
	const questions = methods.filter(({ name }) => !others.includes(name));
	assert.ok(questions.length > 20);
	return questions;
}

test('the changelog has every question, and InWorldTest those that need a number, a point or a structure', () => {
	const questions = questionsOf(read('src/starlogo/queries/AgentQueries.as'));
	// the first release had these
	const known = ['countNear', 'nearPoint', 'countNearPoint', 'nearestToPoint'].map((name) => `CHANGELOG.md: ${name}`);
	// docs/adding.md, "A question", says what stands in these files
	assertNoneMissing(missing(questions.map(({ name }) => name), ['CHANGELOG.md'], known));
	const needsNumbers = ({ taken }) => taken.split(',').some((each) => /:(?:Number|Vector3D|BoundingStructure)\s*$/.test(each));
	const numeric = questions.filter(needsNumbers).map(({ name }) => name);
	assert.ok(numeric.includes('walk') && numeric.includes('overlapping') && numeric.includes('inCone'));
	assertNoneMissing(missing(numeric, ['test/starlogo/queries/InWorldTest.as'], []));
});

test('every question stands in the files of docs/adding.md, "A question"', () => {
	const source = read('src/starlogo/queries/AgentQueries.as');
	const older = olderNames(source);
	const questions = questionsOf(source).map(({ name }) => name);
	// it asks only the agent's own shape
	const known = ['test/module/questions.mjs: touchesEdge'];
	const isAsked = (each) => older.some(([before, name]) => each.endsWith(`: ${name}`) && new RegExp(`\\b${before}\\b`).test(read(each.split(':')[0])));
	const left = missing(questions, filesOf('docs/adding.md', 'A question'), known).filter((each) => !isAsked(each));
	assertNoneMissing(left);
});

/** The readers of the formats: a ModelReader, or a scene, which is one. */
function readersOf() {
	const isReader = /\bclass \w+Reader extends ModelReader\b|\bclass \w+ extends Scene\b/;
	const readers = sourcesBelow('src/starlogo/models').filter((file) => isReader.test(codeOf(read(file)))).map(simpleName);
	for (const known of ['ColladaScene', 'CookedReader', 'GltfScene', 'ObjReader', 'StlReader']) assert.ok(readers.includes(known), known);
	return readers;
}

test('every format has a model that passes what its reader builds to Model', () => {
	const models = sourcesBelow('src/starlogo').filter((file) => /\bclass \w+ extends Model\b/.test(codeOf(read(file))));
	const built = models.filter((file) => read(file).includes('.build()'));
	const wanted = readersOf().map((reader) => reader.replace(/(Reader|Scene)$/, 'Model'));
	assertNone(differences('the list of models that call build()', built.map(simpleName), [...wanted, 'Away3dModel']));
	assertNone(built.filter((file) => !/\bsuper\(name, null, null, null, .*\.build\(\)\);/.test(read(file))).map((file) => `${file} passes more to Model, or less`));
});

test('every format that test/growth/FileRows.as reads has a hostile file, but cooked ones', () => {
	const formats = [...read('test/growth/FileRows.as').matchAll(/\bcase "([\w-]+)":/g)].map(([, format]) => format);
	assert.ok(formats.includes('STL') && formats.includes('glTF'));
	const made = filesBelow('test/soak', '.as').filter((file) => /\/Hostile\w+\.as$/.test(file) && !file.endsWith('Test.as')).map(read).join('\n');
	// CookedLoadingTest damages cooked files
	assertNone(formats.filter((format) => format !== 'cooked' && !new RegExp(`"${format}(?:: |")`).test(made)).map((format) => `test/soak/HostileFiles.as makes no file of ${format}`));
});

test('every format stands in the files of docs/adding.md, "A format"', () => {
	const readers = readersOf();
	// CookedLoadingTest damages cooked files
	const known = ['test/starlogo/models/ModelMutationsTest.as: CookedReader', 'test/fuzz/kinds/files.mjs: CookedReader'];
	const isThere = (each) => {
		const [file, reader] = each.split(': ');
		return new RegExp(`\\b${reader.replace(/(Reader|Scene)$/, 'Model')}\\b`).test(read(file));
	};
	assertNoneMissing(missing(readers, filesOf('docs/adding.md', 'A format'), known).filter((each) => !isThere(each)));
});

test('every block of the playground stands in the files of docs/adding.md, "A block"', () => {
	const source = read('js/playground/play/blocks/blocks.js');
	const blocks = [...source.matchAll(/^\tdefine\("(\w+)"/gm)].map(([, type]) => type);
	assert.ok(blocks.length > 90 && blocks.includes('starlogo_walk') && blocks.includes('controls_if'));
	// the test's own functions write these two
	const known = ['test/playground/world.test.mjs: starlogo_forward', 'test/playground/world.test.mjs: starlogo_create'];
	const program = read('js/playground/play/game/program.js');
	const hasMeaning = (each) => each.startsWith('js/playground/play/game/actions.js: ') && new RegExp(`\\b${each.split(': ')[1]}\\b`).test(program);
	assertNoneMissing(missing(blocks, filesOf('docs/adding.md', 'A block'), known).filter((each) => !hasMeaning(each)));
	// Blockly adds these two to the drawer of variables
	const isInDrawer = (type) => source.split(`"${type}"`).length > 2 || ['variables_get', 'math_change'].includes(type);
	assertNone(blocks.filter((type) => !isInDrawer(type)).map((type) => `no drawer of TOOLBOX has ${type}`));
});

test('every block of the engine is called by its class\'s own test and in random games', () => {
	// what is read, drawn or forgotten beside the blocks, and scripts of touches, which the same table has
	const known = ['moved', 'lines', 'linesOf', 'showNone', 'forgetScripts', 'forgetBreeds', 'whenTouchingStarts', 'whenTouchingEnds'].map((name) => `test/module/blocks.test.mjs: ${name}`);
	const classes = sourcesBelow('src/starlogo/blocks').filter((file) => file.endsWith('Blocks.as'));
	assert.ok(classes.length > 6);
	const left = classes.flatMap((file) => {
		const methods = [...codeOf(read(file)).matchAll(/^ {8}public function (\w+)\(/gm)].map(([, name]) => name).filter((name) => name !== simpleName(file));
		assert.ok(methods.length > 1, file);
		return missing(methods, [file.replace('src/', 'test/').replace('.as', 'Test.as'), 'test/module/blocks.test.mjs'], known);
	});
	assertNoneMissing(left);
});

test('every build file but those of the fetched libraries stands in the table of docs/adding.md', () => {
	const files = readdirSync(path.join(root, 'build')).filter((file) => file.endsWith('.xml') && file !== 'ivy.xml').map((file) => `build/${file}`);
	assertNone(differences('docs/adding.md', filesOf('docs/adding.md', 'Which file of the build does what'), ['build.xml', ...files]));
});

test('members of the namespace engine are @private in documented classes, as ./antw asdoc demands', () => {
	const hidden = /\/\*\*(?:(?!\*\/)[^])*@private(?:(?!\*\/)[^])*\*\/\s*$/;
	const members = sourcesBelow('src/starlogo').flatMap((file) => {
		const text = read(file);
		const type = text.search(/^ {4}public /m);
		if (type < 0 || hidden.test(text.slice(0, type).replace(/\[[^\n]*\]\s*$/, ''))) return [];
		return [...text.matchAll(/^ {8}(?:(?:override|final|static) )*engine .*/gm)].map(({ index, 0: line }) => ({ isHidden: hidden.test(text.slice(0, index)), place: `${file}: ${line.trim()}` }));
	});
	assert.ok(members.length > 50, `${members.length}`);
	assertNone(members.filter(({ isHidden }) => !isHidden).map(({ place }) => place));
});
