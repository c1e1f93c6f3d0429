package support
{
    import flash.utils.Dictionary;
    import flash.utils.getTimer;
    import headless.Host;
    import org.flexunit.runner.IDescription;
    import org.flexunit.runner.Result;
    import org.flexunit.runner.notification.Failure;
    import org.flexunit.runner.notification.RunListener;

    /**
     * Prints each failed test with its message and stack, a line of progress every few seconds, the counts last, and
     * hands the runner a JUnit report.
     */
    public class TestReporter extends RunListener
    {
        private static const PROGRESS_MS:int = 5000;

        // What the names of the reports end with.
        private var _ending:String;
        private var _total:int;
        private var _finished:int = 0;
        private var _failed:int = 0;
        private var _skipped:int = 0;
        private var _start:int;
        private var _testStart:int;
        private var _lastProgress:int;
        private var _failures:Dictionary = new Dictionary();
        private var _skippedTests:Dictionary = new Dictionary();
        private var _suites:XML = <testsuites/>;

        /** @param part the part of the classes that is run, for example "2/3"; nothing for all */
        public function TestReporter(part:String = null)
        {
            _ending = part ? "-" + part.split("/")[0] : "";
        }

        override public function testRunStarted(description:IDescription):void
        {
            _total = description.testCount;
            _start = _lastProgress = getTimer();
            trace("running " + _total + " tests");
        }

        override public function testStarted(description:IDescription):void
        {
            _testStart = getTimer();
            if (_testStart - _lastProgress >= PROGRESS_MS)
            {
                _lastProgress = _testStart;
                trace("  " + _finished + " of " + _total + " done, now " + readableName(description));
            }
        }

        override public function testFailure(failure:Failure):void
        {
            var name:String = failure.description.displayName;
            trace("FAILED " + readableName(failure.description) + ": " + failure.message);
            trace("  " + stackOf(failure).split("\n").join("\n  "));
            if (_failures[name] == null)
            {
                _failed++;
                _failures[name] = failure;
            }
            if (!failure.description.isTest)
            {
                record(failure.description, 0);
            }
        }

        override public function testFinished(description:IDescription):void
        {
            if (_skippedTests[description.displayName])
            {
                return; // FlexUnit ignores a test whose assumption fails, then ends it as well
            }
            _finished++;
            record(description, getTimer() - _testStart);
        }

        override public function testIgnored(description:IDescription):void
        {
            _finished++;
            _skipped++;
            _skippedTests[description.displayName] = true;
            trace("skipped " + readableName(description));
            record(description, 0).appendChild(<skipped/>);
        }

        override public function testRunFinished(result:Result):void
        {
            var passed:int = Math.max(0, _finished - _skipped - countFailedTests());
            if (_finished == 0 && _failed == 0)
            {
                _failed = 1;
                trace("FAILED: no test was run");
            }
            var counts:String = passed + " passed, " + _failed + " failed, " + _skipped + " skipped";
            _suites.@tests = _finished;
            _suites.@failures = _failed;
            _suites.@skipped = _skipped;
            _suites.@time = seconds(getTimer() - _start);
            Host.writeFile("test-reports/TEST-flexunit" + _ending + ".xml", '<?xml version="1.0" encoding="UTF-8"?>\n' + _suites.toXMLString() + "\n");
            Host.writeFile("test-reports/summary" + _ending + ".txt", counts + "\n");
            trace("ran in " + seconds(getTimer() - _start) + " s");
            trace(counts);
            Host.exit(_failed == 0 ? 0 : 1);
        }

        private function countFailedTests():int
        {
            var count:int = 0;
            for each (var failure:Failure in _failures)
            {
                if (failure.description.isTest)
                {
                    count++;
                }
            }
            return count;
        }

        /** Adds a test's result to the report, in its class's suite. */
        private function record(description:IDescription, ms:int):XML
        {
            var className:String = classNameOf(description);
            var suite:XML = suiteOf(className);
            var test:XML = <testcase classname={className} name={methodOf(description)} time={seconds(ms)}/>;
            var failure:Failure = _failures[description.displayName];
            if (failure != null)
            {
                test.appendChild(<failure message={failure.message}>{stackOf(failure)}</failure>);
            }
            suite.appendChild(test);
            suite.@tests = suite.testcase.length();
            suite.@failures = suite.testcase.failure.length();
            return test;
        }

        private function suiteOf(className:String):XML
        {
            var found:XMLList = _suites.testsuite.(@name == className);
            if (found.length() > 0)
            {
                return found[0];
            }
            var suite:XML = <testsuite name={className}/>;
            _suites.appendChild(suite);
            return suite;
        }

        private static function stackOf(failure:Failure):String
        {
            return failure.stackTrace || "(no stack)";
        }

        // FlexUnit's display name is package::Class.method
        private static function classNameOf(description:IDescription):String
        {
            var name:String = description.displayName;
            return (description.isTest ? name.slice(0, name.lastIndexOf(".")) : name).replace("::", ".");
        }

        private static function methodOf(description:IDescription):String
        {
            return description.isTest ? description.displayName.split(".").pop() : "(class)";
        }

        private static function readableName(description:IDescription):String
        {
            return classNameOf(description).split(".").pop() + "." + methodOf(description);
        }

        private static function seconds(ms:int):String
        {
            return (ms / 1000).toFixed(3);
        }
    }
}
