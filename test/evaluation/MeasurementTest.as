package evaluation
{
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    public class MeasurementTest
    {
        private static const NS_PER_MS:Number = 1e6;

        [Test]
        public function timesOneOfMany():void
        {
            var measurement:Measurement = new Measurement("ten waits", wait, 10);
            Measurement.runAll(new <Measurement>[measurement], 3);
            assertEquals(3, measurement.samples.count);
            // never less than it waits; more where the machine is busy
            assertTrue(String(measurement.nanoseconds), measurement.nanoseconds > 0.3 * NS_PER_MS && measurement.nanoseconds < 20 * NS_PER_MS);
        }

        [Test]
        public function theWarmUpDoesNotCount():void
        {
            var measurement:Measurement = new Measurement("wait", wait, 1);
            measurement.warmUp();
            measurement.sample();
            assertEquals(1, measurement.samples.count);
        }

        [Test]
        public function anOverheadIsTakenOff():void
        {
            var overhead:Measurement = new Measurement("wait", wait, 1);
            var measurement:Measurement = new Measurement("wait twice", function():void
                {
                    wait();
                    wait();
                }, 1);
            Measurement.runAll(new <Measurement>[measurement, overhead], 5);
            var whole:Number = measurement.nanoseconds;
            measurement.overhead = overhead;
            assertTrue(overhead.nanoseconds > 0);
            assertTrue(Math.abs(whole - overhead.nanoseconds - measurement.nanoseconds) < 1e-6 * whole);
        }

        // About five milliseconds.
        private static function wait():void
        {
            var end:int = getTimer() + 5;
            var now:int = end - 5;
            while (now < end)
            {
                now = getTimer();
            }
        }
    }
}
