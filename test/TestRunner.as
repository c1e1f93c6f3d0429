package
{
    import flash.display.Sprite;
    import headless.Host;
    import org.flexunit.runner.FlexUnitCore;
    import org.flexunit.runner.Request;
    import support.Fixtures;
    import support.TestFilter;
    import support.TestReporter;

    /**
     * The test SWF: loads the files that the test classes ask for, runs every class of the generated list (or those
     * that the parameter <code>test</code> names), and reports to the headless runner.
     *
     * <p>A class that needs files lists their addresses in a public static <code>FIXTURES:Array</code>.</p>
     */
    public class TestRunner extends Sprite
    {
        private var _core:FlexUnitCore;
        private var _filter:TestFilter;
        private var _classes:Array;

        public function TestRunner()
        {
            _filter = new TestFilter(loaderInfo.parameters["test"]);
            _classes = _filter.classesOf(AllTests.CLASSES);
            if (_classes.length == 0)
            {
                trace("no test matches \"" + _filter.pattern + "\"");
                trace("0 passed, 1 failed, 0 skipped");
                Host.exit(1);
                return;
            }
            Fixtures.load(Fixtures.listOf(_classes), run);
        }

        private function run():void
        {
            var request:Request = Request.classes.apply(null, _classes);
            _core = new FlexUnitCore();
            _core.addListener(new TestReporter());
            _core.run(_filter.narrow(request));
        }
    }
}
