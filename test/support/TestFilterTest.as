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
            assertEquals(3, narrowed("Filter"));
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
