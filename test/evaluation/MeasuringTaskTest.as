package evaluation
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class MeasuringTaskTest
    {
        private static const REPETITIONS:int = 5;
        private static const MOST:int = 15;

        private var _results:Results;
        private var _task:WaitingTask;

        [Before]
        public function makeTask():void
        {
            _results = new Results();
            _task = new WaitingTask(new Settings({repetitions: String(REPETITIONS)}), _results);
        }

        [Test]
        public function onlyWhatIsNoisyIsRepeated():void
        {
            play(10);
            assertEquals(MOST, _task.changing.samples.count);
            assertEquals(MOST, _task.base.samples.count);
            assertEquals(REPETITIONS, _task.steady.samples.count);
            assertTrue(_task.isNoisy);
            assertTrue(entryOf("changing").refused != null);
        }

        [Test]
        public function whatWasNoisyIsMeasuredOnceMore():void
        {
            play(10);
            var steady:Number = entryOf("steady").value;
            _task.repeatNoisy();
            assertEquals(0, _task.changing.samples.count);
            play(1);
            var again:Object = entryOf("changing");
            assertEquals(REPETITIONS, again.samples);
            assertTrue(again.refused == null && again.value != null && again.multiple != null);
            assertEquals("what was steady stays", steady, entryOf("steady").value);
            assertEquals(REPETITIONS, _task.steady.samples.count);
            assertEquals(2, JSON.parse(_results.toText()).entries.length);
        }

        [Test]
        public function aQueueEndsWithTheNoisyOnesOnceMore():void
        {
            var quiet:WaitingTask = new WaitingTask(new Settings({repetitions: "1"}), new Results());
            var queue:TaskQueue = new TaskQueue(new <Task>[_task, quiet]);
            var steps:int = 0;
            var concluded:int = 0;
            var last:Task = queue.current;
            while (!queue.work())
            {
                _task.ms = lengthAt(steps++, 10);
                if (queue.current !== last && last === _task)
                {
                    concluded++;
                }
                last = queue.current;
            }
            assertTrue(queue.current === _task);
            assertEquals(1, concluded);
        }

        private function play(longest:int):void
        {
            var steps:int = 0;
            while (!_task.work())
            {
                _task.ms = lengthAt(steps++, longest);
            }
        }

        // now short, now long, in rounds of two and of three measurements
        private static function lengthAt(step:int, longest:int):int
        {
            return int(step / 2) % 2 == 0 ? 1 : longest;
        }

        private function entryOf(variant:String):Object
        {
            for each (var entry:Object in JSON.parse(_results.toText()).entries)
            {
                if (entry.variant == variant)
                {
                    return entry;
                }
            }
            return null;
        }
    }
}
