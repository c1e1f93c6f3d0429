package evaluation
{
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    public class ResultsTest
    {
        private static const NS_PER_MS:Number = 1e6;

        private var _results:Results;
        private var _waits:int = 1;

        [Before]
        public function make():void
        {
            _results = new Results();
        }

        [Test]
        public function keepsNumbersInOrder():void
        {
            _results.addNumber("volumes", "bear", "naive sphere", 6.4, "patches^3", 6.441);
            _results.addNumber("volumes", "kelp", "naive sphere", 0.5, "patches^3");
            var entries:Array = JSON.parse(_results.toText()).entries;
            assertEquals("bear,kelp", [entries[0].subject, entries[1].subject].join());
            assertEquals(6.441, entries[0].thesis);
            assertFalse("the thesis has none", "thesis" in entries[1]);
            assertTrue(JSON.parse(_results.toText()).player.length > 0);
        }

        [Test]
        public function aCheckThatFailsIsCounted():void
        {
            var right:Object = _results.addNumber("crowds", "10 bears", "BinCollider", 1, "ms");
            var wrong:Object = _results.addNumber("crowds", "20 bears", "BinCollider", 2, "ms");
            right.agrees = true;
            assertEquals(0, _results.failures);
            wrong.agrees = false;
            assertEquals(1, _results.failures);
        }

        [Test]
        public function aTimeIsInMillisecondsAndInMultiplesOfTheBase():void
        {
            var base:Measurement = new Measurement("wait", wait, 1);
            var measurement:Measurement = new Measurement("wait twice", waitTwice, 1);
            Measurement.runAll(new <Measurement>[measurement, base], 5);
            var entry:Object = _results.addTime("tests", "boxBox", "engine", measurement, base, 0.1);
            assertEquals(measurement.samples.low / NS_PER_MS, entry.low);
            assertEquals(measurement.samples.high / NS_PER_MS, entry.high);
            assertEquals(5, entry.samples);
            assertEquals(measurement.multiplesOf(base).low, entry.multipleLow);
            assertEquals(measurement.multiplesOf(base).high, entry.multipleHigh);
            assertEquals(0.1, entry.thesis);
            // where the machine is too busy it is refused, as below
            assertEquals(entry.refused ? null : measurement.nanoseconds / NS_PER_MS, entry.value);
            var isKnown:Boolean = !entry.refused && measurement.multiplesOf(base).isSteady;
            assertEquals(isKnown ? measurement.timesAsLongAs(base) : null, entry.multiple);
        }

        [Test]
        public function aMultipleIsRefusedByItsOwnRange():void
        {
            var base:Measurement = clocked("base", [1, 3, 1, 3, 1]);
            var steady:Measurement = clocked("steady", [2, 2, 2, 2, 2]);
            var entry:Object = _results.addTime("tests", "boxBox", "engine", steady, base);
            assertEquals(2, entry.value);
            assertTrue("from 0.67 to 2", entry.multiple === null && entry.refused == null && entry.multipleHigh == 2);
            var noisy:Measurement = clocked("noisy", [1, 9, 1, 9, 1]);
            _results.addTime("tests", "boxBox", "engine", noisy, clocked("base", [1, 1, 1, 1, 1]));
            assertEquals("times that say nothing replace none", 2, entry.value);
            _results.addTime("tests", "boxBox", "engine", clocked("again", [3, 3, 3, 3, 3]), clocked("base", [1, 1, 1, 1, 1]));
            assertEquals("both were measured again", "3,3", [entry.value, entry.multiple].join());
            assertEquals("the base is 1, however noisy", 1, base.multiplesOf(base).high);
        }

        // A measurement whose samples have these milliseconds.
        private static function clocked(name:String, ms:Array):Measurement
        {
            var now:Number = 0;
            var next:int = -1;
            var measurement:Measurement = new Measurement(name, function():void
                {
                    now += next < 0 ? 20 : ms[next];
                }, 1, function():Number
                {
                    return now;
                });
            measurement.warmUp();
            for (next = 0; next < ms.length; next++)
            {
                measurement.sample();
            }
            return measurement;
        }

        [Test]
        public function aTimeThatVariesTooMuchIsRefused():void
        {
            var base:Measurement = new Measurement("wait", wait, 1);
            var measurement:Measurement = new Measurement("now long, now short", waitOften, 1);
            base.warmUp();
            measurement.warmUp();
            // so many that a pause of the machine in some of the short ones does not make all alike
            for (var i:int = 0; i < 16; i++)
            {
                _waits = i % 2 == 0 ? 1 : 10;
                measurement.sample();
                base.sample();
            }
            var entry:Object = _results.addTime("tests", "boxBox", "engine", measurement, base);
            assertTrue(entry.refused, /^±\d+ %, noisy$/.test(entry.refused));
            assertTrue(entry.value === null && entry.multiple === null);
            assertTrue("its range is told", entry.high > entry.low);
        }

        private function waitOften():void
        {
            for (var i:int = 0; i < _waits; i++)
            {
                wait();
            }
        }

        private static function waitTwice():void
        {
            wait();
            wait();
        }

        // About three milliseconds.
        private static function wait():void
        {
            var end:int = getTimer() + 3;
            var now:int = 0;
            while (now < end)
            {
                now = getTimer();
            }
        }
    }
}
