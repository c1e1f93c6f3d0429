#!/usr/bin/env node
/**
 * Writes the document class of a client's own tests: ClientTests.as, which runs every class whose name ends with Test; and tests.txt, the
 * tests that the texts of these classes name.
 *
 *   node test/runner/client-tests.mjs OUT FOLDER,FOLDER [NAME]
 *
 * With NAME only what it chooses of these, as -Dtest does for ./antw test: classes, or tests of them.
 */
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { refuse } from '../../build/refuse.mjs';
import { choose, testsBefore } from './chosen.mjs';
import { functionsIn, hasTests, isForTheGame, lineAt, problemsIn } from './client-problems.mjs';

const [out, folders, name = ''] = process.argv.slice(2);

if (!folders) refuse('OUT and FOLDER must be given');
const ownFolder = folders.split(',').find((folder) => existsSync(path.join(folder, 'starlogo/collision/Collision.as')));
if (ownFolder) refuse(`-Dsources: ${path.resolve(ownFolder)} has the engine's own sources. Folders that do not begin with "/" count from the clone`);
const files = new Map(folders.split(',').flatMap((folder) => {
	const own = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith('.as'));
	return own.map((file) => [file.slice(0, -3).split(path.sep).join('.'), path.join(folder, file)]);
}));
const sources = new Map([...files].sort().map(([each, file]) => [each, readFileSync(file, 'utf8')]));
const bases = new Map([...sources].map(([each, text]) => [each, baseOf(each, text)]));
const texts = new Map([...sources].filter(([each]) => each.endsWith('Test')));
for (const [each, text] of sources) {
	if (texts.has(each) && isForTheGame(text)) {
		console.error(`${files.get(each)}: has no [Test], so it is left out`);
		texts.delete(each);
	} else if (!each.endsWith('Test') && hasTests(text) && ![...bases.values()].includes(each)) {
		console.error(`${files.get(each)}: warning: has [Test], but its name does not end with Test, so it is left out`);
	}
}
const all = [...texts.keys()];
const chosen = name === '' ? new Map(all.map((each) => [each, null])) : choose(name, texts, new Map()).tests;
const classes = all.filter((each) => chosen.has(each));
if (classes.length === 0) {
	const near = testsBefore(name, texts);
	refuse(all.length === 0 ? `no file below ${folders} ends with Test.as`
		: `no class and no test matches -Dtest=${name}; there are ${(near.length > 0 ? near : all).join(', ')}`);
}

const misplaced = classes.find((each) => (packageOf(texts.get(each)) ?? folderOf(each)) !== folderOf(each));
if (misplaced) refuse(`-Dsources: ${problemOfPlace(files.get(misplaced), packageOf(texts.get(misplaced)))}`);

const functions = new Map(classes.map((each) => [each, functionsOf(each)]));

/** The package that a file says it is in; undefined if it says none. */
function packageOf(text) {
	return /^[^*/\n]*\bpackage\b[ \t]*([\w.]*)/m.exec(text)?.[1];
}

/** The package of a class by its file's folders. */
function folderOf(name) {
	return name.replace(/\.?\w+$/, '');
}

/** What is wrong with a file of a package that is not its folder's. */
function problemOfPlace(file, itsPackage) {
	const folder = path.resolve(path.dirname(file));
	const end = itsPackage === '' ? '' : path.sep + itsPackage.replaceAll('.', path.sep);
	const found = `${file} is of the package "${itsPackage}"`;
	return folder.endsWith(end) ? `${found}. Name the folder in which packages begin: ${folder.slice(0, folder.length - end.length)}`
		: `${found}, so it belongs into a folder ${itsPackage.replaceAll('.', '/')}`;
}

/** The class among the sources that a class extends, by its qualified name. */
function baseOf(name, text) {
	const [, base] = /^[^*/\n]*\bclass\s+\w+\s+extends\s+([\w.]+)/m.exec(text) ?? [];
	const isMeant = (each) => each === base || each === name.replace(/\w+$/, base)
		|| each.endsWith(`.${base}`) && [each, each.replace(/\w+$/, '*')].some((imported) => text.includes(`import ${imported}`));
	return [...sources.keys()].find((each) => each !== name && isMeant(each));
}

/** The functions of a class and of those that it extends, with their files. */
function functionsOf(name) {
	const own = functionsIn(sources.get(name)).map((one) => ({ ...one, file: files.get(name) }));
	const inherited = bases.get(name) === undefined ? [] : functionsOf(bases.get(name));
	return [...own, ...inherited.filter((one) => !own.some((other) => other.name === one.name))];
}

/** The tag of a function that runs before or after all tests of its class. */
const tagOf = ({ metadata }) => /\[(?:Before|After)Class\b/.exec(metadata)?.[0].concat(']');

/**
 * Where a class begins, and its functions, with the reason of one that is ignored: the player's stack traces have no lines. What runs before or after all its tests is also found
 * as "game.MeetTest [BeforeClass]".
 */
function placesIn(name) {
	const text = texts.get(name);
	const own = functions.get(name);
	const placeAt = ({ file, line }) => `${file}:${line}`.replaceAll('\\', '/');
	const around = [...new Set(own.map(tagOf).filter(Boolean))]
		.map((tag) => [`${name} ${tag}`, own.filter((one) => tagOf(one) === tag).map(placeAt).join(' or ')]);
	const begin = { file: files.get(name), line: lineAt(text, text.search(/^[^*/\n]*\bclass\b/m)) };
	return [[name, placeAt(begin)], ...own.map((one) => [`${name}.${one.name}`, [placeAt(one), one.reason].filter(Boolean).join(', ')]), ...around];
}

const problems = classes.flatMap((each) => problemsIn(texts.get(each)).map((problem) => ({ file: files.get(each), ...problem })));
for (const { file, line, said, isError } of problems) console.error(`${file}:${line}: ${isError ? 'error' : 'warning'}: ${said}`);
// antw says such a line last
if (problems.some(({ isError }) => isError)) refuse('FAILED client-test: no test has run, because of the errors above');
// not every runner of FlexUnit's can leave out tests, so it is asked only where some are
const picked = classes.flatMap((each) => chosen.get(each)?.map((test) => `${each}.${test}`) ?? [each]);
const isWhole = classes.every((each) => !chosen.get(each));
const places = new Map(classes.flatMap(placesIn));
const tags = [...functions].flatMap(([each, own]) => own.map((one) => [`${each}.${one.name}`, tagOf(one)]));
const asObject = (entries) => JSON.stringify(Object.fromEntries(entries), null, 4).replaceAll('\n', '\n        ');
const known = [...functions].flatMap(([each, own]) => own
	.filter((one) => /\[Test\b/.test(one.metadata) && (chosen.get(each)?.includes(one.name) ?? true)).map((one) => `${each}.${one.name}`));
mkdirSync(out, { recursive: true });
writeFileSync(path.join(out, 'tests.txt'), known.map((test) => `${test} (${places.get(test)})\n`).join(''));
writeFileSync(path.join(out, 'ClientTests.as'), `package
{
    import flash.display.Sprite;
    import headless.Host;
    import org.flexunit.internals.builders.AllDefaultPossibilitiesBuilder;
    import org.flexunit.runner.FlexUnitCore;
    import org.flexunit.runner.IDescription;
    import org.flexunit.runner.Request;
    import org.flexunit.runner.manipulation.filters.DynamicFilter;
${classes.map((each) => `    import ${each};`).join('\n')}

    /** Runs the client's tests; generated by the build. */
    public class ClientTests extends Sprite
    {
        private static const CLASSES:Array = ["${classes.join('", "')}"];
        private static const PICKED:Array = ["${picked.join('", "')}"];

        // tests and classes that ran, or hung, in a player before this one
        private static var sWithout:Array;

        private var _core:FlexUnitCore = new FlexUnitCore();

        public function ClientTests()
        {
            var without:String = loaderInfo.parameters["without"] || "";
            sWithout = without.split(",");
            var reporter:ClientTestsReporter = new ClientTestsReporter();
            var found:Array = [];
            for each (var name:String in CLASSES)
            {
                if (sWithout.indexOf(name) < 0)
                {
                    reporter.load(name, found);
                }
            }
            if (found.length == 0)
            {
                Host.exit(1);
                return;
            }
            _core.addListener(reporter);
            var request:Request = Request.runner(new ClientTestsSuite(new AllDefaultPossibilitiesBuilder(true), found, reporter));
            _core.run(${isWhole} && without == "" ? request : request.filterWith(new DynamicFilter(isPicked, describe)));
        }

        // So that the compiler takes these classes, of which only the names are used.
        public static function get linked():Array
        {
            return [${classes.join(', ')}];
        }

        public static function isPicked(description:IDescription):Boolean
        {
            var name:String = description.displayName.replace("::", ".");
            return description.isTest ? sWithout.indexOf(name) < 0 && (PICKED.indexOf(name) >= 0 || PICKED.indexOf(name.slice(0, name.lastIndexOf("."))) >= 0)
                : description.children.some(function(child:IDescription, index:int, all:Array):Boolean
                    {
                        return isPicked(child);
                    });
        }

        private static function describe(description:IDescription):String
        {
            return "what -Dtest names, and has not run";
        }
    }
}
`);
writeFileSync(path.join(out, 'ClientTestsSuite.as'), `package
{
    import org.flexunit.runner.IRunner;
    import org.flexunit.runner.notification.IRunNotifier;
    import org.flexunit.runners.Suite;
    import org.flexunit.token.AsyncTestToken;

    /** All classes of the client's tests, by name. Tells when a class begins, which listeners do not hear; generated by the build. */
    public class ClientTestsSuite extends Suite
    {
        private var _reporter:ClientTestsReporter;

        public function ClientTestsSuite(builder:Object, classes:Array, reporter:ClientTestsReporter)
        {
            super(builder, classes);
            _reporter = reporter;
            sort(new ByName());
        }

        override protected function runChild(child:*, notifier:IRunNotifier, childRunnerToken:AsyncTestToken):void
        {
            _reporter.classStarted(IRunner(child).description);
            super.runChild(child, notifier, childRunnerToken);
        }
    }
}

import org.flexunit.runner.IDescription;
import org.flexunit.runner.manipulation.OrderArgumentSorter;

/** Sorts tests and classes by their order, then by name. */
class ByName extends OrderArgumentSorter
{
    override public function compare(one:IDescription, other:IDescription):int
    {
        return super.compare(one, other) || (one.displayName < other.displayName ? -1 : int(one.displayName > other.displayName));
    }
}
`);
writeFileSync(path.join(out, 'ClientTestsReporter.as'), `package
{
    import flash.display.Sprite;
    import flash.events.Event;
    import flash.utils.getDefinitionByName;
    import headless.Host;
    import org.flexunit.runner.IDescription;
    import org.flexunit.runner.Result;
    import org.flexunit.runner.notification.Failure;
    import org.flexunit.runner.notification.RunListener;

    /** Tells client-tests-run.mjs which tests there are, what runs and what failed, and ends the run; generated by the build. */
    public class ClientTestsReporter extends RunListener
    {
        // file and line of each class and function
        private static const PLACES:Object = ${asObject(places)};

        // of the functions that run before and after all tests of a class
        private static const TAGS:Object = ${asObject(tags)};

        // frames after the last test
        private static const LAST_FRAMES:int = 5;

        private var _frames:Sprite = new Sprite();
        private var _class:String = "";
        // tests of this class that have not begun
        private var _left:int = 0;

        /** Loads a class, and puts it into a list; a static initialiser that throws fails it. */
        public function load(name:String, found:Array):void
        {
            var place:String = placed(name + ", static initialiser", name);
            trace("  @now " + place);
            try
            {
                found.push(getDefinitionByName(name));
            }
            catch (error:Error)
            {
                fail(place, error.message, error);
            }
        }

        override public function testRunStarted(description:IDescription):void
        {
            trace("  @tests");
            for each (var name:String in testsOf(description))
            {
                trace("  @test " + placed(name, name));
            }
        }

        /** Notes that a class begins: what is before all its tests runs next. */
        public function classStarted(description:IDescription):void
        {
            _class = nameOf(description);
            _left = testsOf(description).length;
            trace("  @now " + placed(_class + " [BeforeClass]", _class + " [BeforeClass]"));
        }

        override public function testStarted(description:IDescription):void
        {
            tellBegun("begin", description);
        }

        override public function testIgnored(description:IDescription):void
        {
            tellBegun("ignore", description);
            testFinished(description);
        }

        override public function testFinished(description:IDescription):void
        {
            var name:String = _class + (_left > 0 ? ", between its tests" : " [AfterClass]");
            trace("  @now " + placed(name, name));
        }

        override public function testFailure(failure:Failure):void
        {
            var name:String = nameOf(failure.description);
            var error:Error = failure.exception;
            var stack:String = error == null ? null : error.getStackTrace();
            fail(failure.description.isTest ? placed(name, name) : placeIn(name, stack), failure.message, error);
        }

        override public function testRunFinished(result:Result):void
        {
            trace("  @now the frames after the last test");
            var left:int = LAST_FRAMES;
            // a timer or a listener that the last test has left may throw
            _frames.addEventListener(Event.ENTER_FRAME, function(event:Event):void
                {
                    left--;
                    if (left == 0)
                    {
                        Host.exit(result.successful && result.runCount > 0 ? 0 : 1);
                    }
                });
        }

        private function tellBegun(tag:String, description:IDescription):void
        {
            _left--;
            var name:String = nameOf(description);
            trace("  @" + tag + " " + placed(name, name));
        }

        private static function fail(what:String, why:String, error:Error):void
        {
            trace("FAILED " + what + ": " + why);
            var stack:String = error == null ? null : error.getStackTrace();
            for each (var call:String in stack == null ? [] : stack.split("\\n"))
            {
                // without the message
                if (/^\\s*at ./.test(call))
                {
                    trace(call);
                }
            }
        }

        // of what failed before or after all tests of a class: it is in the calls
        private static function placeIn(className:String, stack:String):String
        {
            for each (var call:String in stack == null ? [] : stack.split("\\n"))
            {
                var found:Array = /^\\s*at ([^$\\/]+)\\$\\/(\\w+)\\(/.exec(call);
                var name:String = found == null ? "" : found[1].split("::").join(".") + "." + found[2];
                if (name in TAGS)
                {
                    return placed(className + " " + TAGS[name], name);
                }
            }
            return placed(className, className);
        }

        private static function testsOf(description:IDescription):Array
        {
            if (description.isTest)
            {
                return ClientTests.isPicked(description) ? [nameOf(description)] : [];
            }
            var names:Array = [];
            for each (var child:IDescription in description.children)
            {
                names.push.apply(null, testsOf(child));
            }
            return names;
        }

        private static function nameOf(description:IDescription):String
        {
            return description.displayName.split("::").join(".");
        }

        // with its file and line
        private static function placed(what:String, key:String):String
        {
            return what + (key in PLACES ? " (" + PLACES[key] + ")" : "");
        }
    }
}
`);
console.log(`${classes.length} test class${classes.length === 1 ? '' : 'es'}`);
