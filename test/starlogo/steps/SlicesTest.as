package starlogo.steps
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;

    public class SlicesTest
    {
        private var _log:Array = [];

        [Test]
        public function doesSomeInAStep():void
        {
            assertEquals("0-3|3-6|6-7", trail(new Slices(7, 3, note)));
            assertEquals("0-3|3-6", trail(new Slices(6, 3, note)));
            assertEquals("0-2", trail(new Slices(2, 3, note)));
        }

        [Test]
        public function noneAreOneStep():void
        {
            assertEquals("0-0", trail(new Slices(0, 3, note)));
            assertFalse(new Slices(0, 3, note).step());
        }

        [Test]
        public function doesNothingWhenNoStepIsLeft():void
        {
            for each (var count:int in [0, 2, 3])
            {
                var work:Slices = new Slices(count, 3, note);
                var before:String = trail(work);
                assertFalse(work.step());
                assertEquals(before, _log.join("|"));
            }
        }

        private function note(first:int, end:int):void
        {
            _log.push(first + "-" + end);
        }

        private function trail(work:Slices):String
        {
            _log = [];
            finish(work);
            return _log.join("|");
        }
    }
}
