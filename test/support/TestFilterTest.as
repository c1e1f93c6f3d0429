package support
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.runner.Request;

    public class TestFilterTest
    {
        private static const CLASSES:Array = [TestFilterTest, Effort, TestStage];

        [Test]
        public function nothingTakesAll():void
        {
            assertEquals(3, new TestFilter(null).classesOf(CLASSES).length);
            assertEquals(3, new TestFilter("").classesOf(CLASSES).length);
            assertTrue(picks(""));
        }

        [Test]
        public function aPartOfAClassNameTakesTheClass():void
        {
            assertEquals([TestFilterTest, TestStage].join(), new TestFilter("Test").classesOf(CLASSES).join());
            assertEquals(0, new TestFilter("test").classesOf(CLASSES).length);
            assertEquals("a package is no class", 0, new TestFilter("support").classesOf(CLASSES).length);
        }

        [Test]
        public function aPartOfATestsNameTakesTheTest():void
        {
            assertTrue(picks("Filter.nothing"));
            assertTrue(picks("TestFilterTest#TakesAll"));
            assertTrue(picks(".nothing"));
            assertFalse("no test", picks("Filter.noSuchTest"));
            assertFalse("a method that is no test", picks("Filter.picks"));
            assertEquals(1, narrowed("Filter.nothingTakesAll"));
            assertEquals(2, narrowed("Filter.aPartOf"));
            assertEquals(4, narrowed("Filter"));
        }

        [Test]
        public function whatRunsElsewhereIsLeftOutUnlessItIsNamed():void
        {
            var elsewhere:String = "support.Effort,support.TestFilterTest.nothingTakesAll";
            var all:TestFilter = new TestFilter("", elsewhere);
            assertEquals([TestFilterTest, TestStage].join(), all.classesOf(CLASSES).join());
            var here:int = new TestFilter("").narrow(Request.classes(TestFilterTest)).iRunner.description.testCount;
            assertEquals(here - 1, all.narrow(Request.classes(TestFilterTest)).iRunner.description.testCount);
            assertTrue(all.leavesOut);
            var named:TestFilter = new TestFilter("TestFilterTest", elsewhere);
            assertFalse(named.leavesOut);
            assertEquals(here, named.narrow(Request.classes(TestFilterTest)).iRunner.description.testCount);
        }

        private static function picks(pattern:String):Boolean
        {
            return new TestFilter(pattern).doesPick(Request.classes(TestFilterTest));
        }

        private static function narrowed(pattern:String):int
        {
            return new TestFilter(pattern).narrow(Request.classes(TestFilterTest)).iRunner.description.testCount;
        }
    }
}
