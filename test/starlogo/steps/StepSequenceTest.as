package starlogo.steps
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import support.assertThrows;

    public class StepSequenceTest
    {
        private var _log:Array = [];
        private var _left:int = 3;

        [Test]
        public function doesItsPartsInOrder():void
        {
            var inner:StepSequence = new StepSequence().call(note("b")).call(note("c"));
            var work:StepSequence = new StepSequence().call(note("a")).add(inner).repeat(countDown).call(note("d"));
            assertEquals("a|b|c|2|1|0|d.", trail(work));
        }

        [Test]
        public function makesWorkWhenItsTurnHasCome():void
        {
            var work:StepSequence = new StepSequence().call(note("a")).begin(makeTwo).call(note("b"));
            assertEquals("a|made|one|two|b.", trail(work));
        }

        [Test]
        public function partsMayAddOthers():void
        {
            var work:StepSequence = new StepSequence();
            work.call(function():void
                {
                    _log.push("a");
                    work.call(note("b"));
                });
            assertEquals("a|b.", trail(work));
        }

        [Test]
        public function nothingIsDoneAtOnce():void
        {
            assertFalse(new StepSequence().step());
            assertFalse(new StepSequence().add(new StepSequence()).step());
            new StepSequence().call(note("a")).begin(makeTwo).repeat(countDown);
            assertEquals(0, _log.length);
        }

        [Test]
        public function rowsOfThingsAreDoneInSlices():void
        {
            var work:StepSequence = new StepSequence().slices(5, 2, noteSlice).call(note("a"));
            assertEquals("0-2|2-4|4-5|a.", trail(work));
            assertEquals("0-2|2-4.", trail(new StepSequence().slices(4, 2, noteSlice)));
            assertEquals("0-2.", trail(new StepSequence().slices(2, 3, noteSlice)));
            assertEquals("0-0.", trail(new StepSequence().slices(0, 3, noteSlice)));
        }

        [Test]
        public function makesTheWorkOnEachThingWhenTheOneBeforeIsDone():void
        {
            var work:StepSequence = new StepSequence().beginEach(3, function(index:int):Steps
                {
                    _log.push("make " + index);
                    return new StepSequence().call(note("one")).call(note("two"));
                }).call(note("end"));
            assertEquals("make 0|one|two,make 1|one|two,make 2|one|two|end.", trail(work));
            assertEquals("|end.", trail(new StepSequence().beginEach(0, makeTwo).call(note("end"))));
        }

        [Test]
        public function makesSomeThingsInAStepThatHaveNoWorkOfTheirOwn():void
        {
            var work:StepSequence = new StepSequence().beginEach(5, function(index:int):Steps
                {
                    _log.push("make " + index);
                    return index == 1 ? new StepSequence().call(note("one")).call(note("two")) : null;
                }, 2).call(note("end"));
            assertEquals("make 0,make 1|one|two,make 2,make 3|make 4|end.", trail(work));
        }

        [Test]
        public function doesNothingWhenNoStepIsLeft():void
        {
            for each (var count:int in [0, 2, 3])
            {
                var work:StepSequence = new StepSequence().slices(count, 3, noteSlice);
                finish(work);
                _log = [];
                assertFalse(work.step());
                assertEquals(0, _log.length);
            }
        }

        [Test]
        public function anErrorComesOut():void
        {
            var work:StepSequence = new StepSequence().call(note("a")).call(function():void
                {
                    throw new ArgumentError("broken");
                });
            assertTrue(work.step());
            assertThrows(ArgumentError, /broken/, work.step);
        }

        [Test]
        public function aStepThatThrowsIsDoneAgain():void
        {
            var work:StepSequence = new StepSequence().slices(3, 1, function(first:int, end:int):void
                {
                    noteSlice(first, end);
                    if (first == 1)
                    {
                        throw new ArgumentError("broken");
                    }
                });
            assertTrue(work.step());
            assertThrows(ArgumentError, /broken/, work.step);
            assertThrows(ArgumentError, /broken/, work.step);
            assertEquals("0-1,1-2,1-2", _log.join());

            work = new StepSequence().beginEach(2, function(index:int):Steps
                {
                    throw new ArgumentError("work " + index);
                });
            assertThrows(ArgumentError, /work 0/, work.step);
            assertThrows(ArgumentError, /work 0/, work.step);
        }

        [Test]
        public function finishDoesAllThatIsLeft():void
        {
            var work:StepSequence = new StepSequence().call(note("a")).repeat(countDown).begin(makeTwo);
            work.step();
            finish(work);
            assertEquals("a,2,1,0,made,one,two", _log.join());
        }

        private function countDown():Boolean
        {
            _log.push(--_left);
            return _left > 0;
        }

        private function noteSlice(first:int, end:int):void
        {
            _log.push(first + "-" + end);
        }

        private function makeTwo():Steps
        {
            _log.push("made");
            return new StepSequence().call(note("one")).call(note("two"));
        }

        private function note(what:String):Function
        {
            return function():void
            {
                _log.push(what);
            };
        }

        /** What was done, a bar between steps and a dot after the last one. */
        private function trail(work:Steps):String
        {
            var steps:Array = [];
            var hasMore:Boolean = true;
            while (hasMore)
            {
                _log = [];
                hasMore = work.step();
                steps.push(_log.join());
            }
            return steps.join("|") + ".";
        }
    }
}
