package
{
    import flash.display.Sprite;
    import org.flexunit.runner.FlexUnitCore;
    import org.flexunit.runner.Request;
    import support.Effort;
    import support.Fixtures;
    import support.Garbage;
    import support.TestFilter;
    import support.TestReporter;
    import support.TestStage;

    /**
     * The test SWF: loads the files that the test classes ask for, runs every class of the generated list (or those
     * that the parameters <code>test</code> and <code>part</code> pick), and reports to the headless runner. Those that the parameter
     * <code>elsewhere</code> lists are left out. With the parameter <code>full</code> long tests try more.
     *
     * <p>A class that needs files lists their addresses in a public static <code>FIXTURES:Array</code>.</p>
     */
    public class TestRunner extends Sprite
    {
        private var _core:FlexUnitCore;
        private var _request:Request;

        public function TestRunner()
        {
            TestStage.stage = stage;
            Effort.isFull = loaderInfo.parameters["full"] == "true";
            Garbage.isCounted = loaderInfo.parameters["collects"] == "false";
            Garbage.isCollected = loaderInfo.parameters["player"] == "avmshell" && !Garbage.isCounted;
            Effort.isInterpreted = loaderInfo.parameters["player"] == "ruffle" && !Effort.isFull;
            var filter:TestFilter = new TestFilter(loaderInfo.parameters["test"], loaderInfo.parameters["elsewhere"], loaderInfo.parameters["part"]);
            var classes:Array = filter.classesOf(AllTests.CLASSES);
            _request = Request.classes.apply(null, classes);
            _request = filter.narrow(_request);
            if (filter.leavesOut)
            {
                trace("Node alone runs what test/runner/in-node.txt lists");
            }
            Fixtures.load(Fixtures.listOf(classes), run);
        }

        private function run():void
        {
            _core = new FlexUnitCore();
            _core.addListener(new TestReporter(loaderInfo.parameters["part"]));
            _core.run(_request);
        }
    }
}
