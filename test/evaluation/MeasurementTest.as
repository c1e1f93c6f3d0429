package evaluation
{
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class MeasurementTest
    {
        private static const NS_PER_MS:Number = 1e6;

        // Milliseconds.
        private static const WAIT:int = 5;

        // What the clock of the tests shows. It runs only while something waits.
        private var _now:Number = 0;

        [Before]
        public function setUp():void
        {
            _now = 0;
        }

        [Test]
        public function timesOneOfMany():void
        {
            var measurement:Measurement = new Measurement("ten waits", wait, 10, now);
            Measurement.runAll(new <Measurement>[measurement], 3);
            assertEquals(3, measurement.samples.count);
            assertEquals(WAIT / 10 * NS_PER_MS, measurement.nanoseconds);
        }

        [Test]
        public function theWarmUpDoesNotCount():void
        {
            var measurement:Measurement = new Measurement("wait", wait, 1, now);
            measurement.warmUp();
            measurement.sample();
            assertEquals(1, measurement.samples.count);
        }

        [Test]
        public function anOverheadIsTakenOff():void
        {
            var overhead:Measurement = new Measurement("wait", wait, 1, now);
            var measurement:Measurement = new Measurement("wait three times", function():void
                {
                    wait();
                    wait();
                    wait();
                }, 1, now);
            Measurement.runAll(new <Measurement>[measurement, overhead], 5);
            assertEquals(3 * WAIT * NS_PER_MS, measurement.nanoseconds);
            measurement.overhead = overhead;
            assertEquals(2 * WAIT * NS_PER_MS, measurement.nanoseconds);
        }

        [Test]
        public function theHostsClockRuns():void
        {
            var measurement:Measurement = new Measurement("wait", waitReally, 1);
            measurement.warmUp();
            measurement.sample();
            assertTrue(String(measurement.nanoseconds), measurement.nanoseconds > 0);
        }

        private function wait():void
        {
            _now += WAIT;
        }

        private function now():Number
        {
            return _now;
        }

        private static function waitReally():void
        {
            var end:int = getTimer() + WAIT;
            var time:int = end - WAIT;
            while (time < end)
            {
                time = getTimer();
            }
        }
    }
}
