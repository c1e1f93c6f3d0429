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
            for each (var nothing:String in [null, ""])
            {
                assertEquals(3, new TestFilter(nothing).classesOf(CLASSES).length);
                assertEquals(6, narrowed(nothing));
            }
        }

        [Test]
        public function aClassIsPickedByItsWholeName():void
        {
            assertEquals([TestFilterTest, TestStage].join(), new TestFilter("support.TestStage,support.TestFilterTest").classesOf(CLASSES).join());
            assertEquals(6, narrowed("support.TestFilterTest"));
            assertEquals("another package", 0, new TestFilter("TestFilterTest").classesOf(CLASSES).length);
            assertEquals("a part of its name", 0, new TestFilter("support.TestFilter").classesOf(CLASSES).length);
        }

        [Test]
        public function aTestIsPickedByItsWholeName():void
        {
            assertEquals(1, narrowed("support.TestFilterTest.nothingTakesAll"));
            assertEquals(2, narrowed("support.TestFilterTest.nothingTakesAll,support.TestStage,support.TestFilterTest.aTestIsPickedByItsWholeName"));
            assertEquals(TestFilterTest, new TestFilter("support.TestFilterTest.nothingTakesAll").classesOf(CLASSES).join());
        }

        [Test]
        public function whatRunsElsewhereIsLeftOut():void
        {
            var all:TestFilter = new TestFilter("", "support.Effort,support.TestFilterTest.nothingTakesAll");
            assertEquals([TestFilterTest, TestStage].join(), all.classesOf(CLASSES).join());
            assertEquals(5, all.narrow(Request.classes(TestFilterTest)).iRunner.description.testCount);
            assertTrue(all.leavesOut);
            assertFalse(new TestFilter("").leavesOut);
        }

        [Test]
        public function whatIsPickedRunsHereToo():void
        {
            var named:TestFilter = new TestFilter("support.TestFilterTest", "support.TestFilterTest.nothingTakesAll");
            assertFalse(named.leavesOut);
            assertEquals(6, named.narrow(Request.classes(TestFilterTest)).iRunner.description.testCount);
        }

        [Test]
        public function partsHaveEachClassOnce():void
        {
            assertEquals([TestFilterTest, TestStage].join(), new TestFilter("", "", "1/2").classesOf(CLASSES).join());
            assertEquals([Effort].join(), new TestFilter("", "", "2/2").classesOf(CLASSES).join());
            assertEquals("of those that run here", TestStage, new TestFilter("", "support.Effort", "2/2").classesOf(CLASSES).join());
        }

        private static function narrowed(picked:String):int
        {
            return new TestFilter(picked).narrow(Request.classes(TestFilterTest)).iRunner.description.testCount;
        }
    }
}
