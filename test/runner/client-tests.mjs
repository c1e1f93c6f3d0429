#!/usr/bin/env node
/**
 * Writes the document class of a client's own tests: ClientTests.as, which runs every class whose name ends with Test.
 *
 *   node test/runner/client-tests.mjs OUT FOLDER,FOLDER [NAME]
 *
 * With NAME only what it chooses of these, as -Dtest does for ./antw test: classes, or tests of them.
 */
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { refuse } from '../../build/refuse.mjs';
import { choose, testsBefore } from './chosen.mjs';
import { isForTheGame, problemsIn } from './client-problems.mjs';
import { testsIn } from './test-classes.mjs';

const [out, folders, name = ''] = process.argv.slice(2);

if (!folders) refuse('OUT and FOLDER must be given');
const missing = folders.split(',').filter((folder) => !existsSync(folder));
if (missing.length > 0) refuse(`-Dsources: there is no folder ${missing.map((folder) => path.resolve(folder)).join(', ')}`);
const ownFolder = folders.split(',').find((folder) => existsSync(path.join(folder, 'starlogo/collision/Collision.as')));
if (ownFolder) refuse(`-Dsources: ${path.resolve(ownFolder)} has the engine's own sources. Folders that do not begin with "/" count from the clone`);
const files = new Map(folders.split(',').flatMap((folder) => {
	const own = readdirSync(folder, { recursive: true }).filter((file) => file.endsWith('Test.as'));
	return own.map((file) => [file.slice(0, -3).split(path.sep).join('.'), path.join(folder, file)]);
}));
const texts = new Map([...files].sort().map(([each, file]) => [each, readFileSync(file, 'utf8')]));
for (const [each, text] of texts) {
	if (!isForTheGame(text)) continue;
	console.error(`${files.get(each)}: has no [Test], so it is left out`);
	texts.delete(each);
}
const all = [...texts.keys()];
const chosen = name === '' ? new Map(all.map((each) => [each, null])) : choose(name, texts, new Map()).tests;
const classes = all.filter((each) => chosen.has(each));
if (classes.length === 0) {
	const near = testsBefore(name, texts);
	refuse(all.length === 0 ? `no file below ${folders} ends with Test.as`
		: `no class and no test matches -Dtest=${name}; there are ${(near.length > 0 ? near : all).join(', ')}`);
}

/**
 * Where the functions of a class begin, and the class, as lines of ActionScript: the player's stack traces have no lines. What runs before or after all tests
 * of the class is also found as "game.MeetTest [BeforeClass]".
 */
function placesIn(name) {
	const text = texts.get(name);
	const placeAt = (index) => `${files.get(name)}:${text.slice(0, index).split('\n').length}`;
	const own = [...text.matchAll(/\bfunction\s+(\w+)/g)].map(({ 1: called, index }) => [`${name}.${called}`, placeAt(index)]);
	const around = ['BeforeClass', 'AfterClass'].map((tag) => [`${name} [${tag}]`, aroundIn(text, tag).map(({ index }) => placeAt(index)).join(' or ')]);
	return [[name, placeAt(text.search(/^[^*/\n]*\bclass\b/m))], ...own, ...around].filter(([, place]) => place).map(asPair);
}

/** The functions of a class's text that run before or after all its tests, by their tag: their names, and where they begin. */
function aroundIn(text, tag) {
	const found = text.matchAll(new RegExp(`\\[${tag}\\b[^\\]]*\\]\\s*(?:\\[[^\\]]*\\]\\s*)*(?:\\w+\\s+)*function\\s+(\\w+)`, 'g'));
	return [...found].map(({ 0: all, 1: called, index }) => ({ called, index: index + all.search(/\bfunction\s+\w+$/) }));
}

/** By its name, the tag of each function that runs before or after all tests of a class. */
function tagsIn(name) {
	return ['BeforeClass', 'AfterClass'].flatMap((tag) => aroundIn(texts.get(name), tag).map(({ called }) => asPair([`${name}.${called}`, `[${tag}]`])));
}

function asPair([key, value]) {
	return `            "${key}": "${value.replaceAll('\\', '/')}"`;
}

const problems = classes.flatMap((each) => problemsIn(texts.get(each)).map((problem) => ({ file: files.get(each), ...problem })));
for (const { file, line, said, isError } of problems) console.error(`${file}:${line}: ${isError ? 'error' : 'warning'}: ${said}`);
// antw says such a line last
if (problems.some(({ isError }) => isError)) refuse('FAILED client-test: no test has run, because of the errors above');
// not every runner of FlexUnit's can leave out tests, so it is asked only where some are
const picked = classes.flatMap((each) => chosen.get(each)?.map((test) => `${each}.${test}`) ?? [each]);
// a class that does not load has those that its text names
const known = classes.map((each) => [each, (chosen.get(each) ?? testsIn(texts.get(each))).map((test) => `${each}.${test}`)]);
const isWhole = picked.length === classes.length && picked.every((each) => chosen.has(each));
mkdirSync(out, { recursive: true });
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
            sWithout = (loaderInfo.parameters["without"] || "").split(",");
            var reporter:ClientTestsReporter = new ClientTestsReporter();
            var found:Array = [];
            reporter.begin();
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
            _core.run(${isWhole} && sWithout.join() == "" ? request : request.filterWith(new DynamicFilter(isPicked, describe)));
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
        private static const PLACES:Object = {
${classes.flatMap(placesIn).join(',\n')}
        };

        // of the functions that run before and after all tests of a class
        private static const TAGS:Object = {
${classes.flatMap(tagsIn).join(',\n')}
        };

        // the tests that the text of a class has
        private static const KNOWN:Object = {
${known.map(([each, tests]) => `            "${each}": [${tests.map((test) => `"${test}"`).join(', ')}]`).join(',\n')}
        };

        private var _count:int = 0;
        private var _begun:int = 0;
        private var _class:String = "";
        // tests of this class that have not begun
        private var _left:int = 0;
        private var _notLoaded:Array = [];

        /** Tells the tests that there are, as far as the texts of the classes say. */
        public function begin():void
        {
            for each (var tests:Array in KNOWN)
            {
                tellTests(tests);
            }
        }

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
                _notLoaded.push(name);
                fail(place, error.message, error);
            }
        }

        override public function testRunStarted(description:IDescription):void
        {
            _count = 0;
            trace("  @tests");
            for each (var name:String in _notLoaded)
            {
                tellTests(KNOWN[name]);
            }
            for each (var each:IDescription in description.children)
            {
                tellTests(testsOf(each));
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
            tellBegun("", description);
        }

        override public function testIgnored(description:IDescription):void
        {
            tellBegun("ignored: ", description);
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
            Host.exit(result.successful && result.runCount > 0 && _notLoaded.length == 0 ? 0 : 1);
        }

        private function tellBegun(kind:String, description:IDescription):void
        {
            _begun++;
            _left--;
            var name:String = nameOf(description);
            trace("  " + _begun + "/" + _count + " " + kind + placed(name, name));
        }

        private function tellTests(names:Array):void
        {
            for each (var name:String in names)
            {
                _count++;
                trace("  @test " + placed(name, name));
            }
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
