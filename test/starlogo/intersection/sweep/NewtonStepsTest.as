package starlogo.intersection.sweep
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.distance.RoundGap;

    public class NewtonStepsTest
    {
        private var _steps:NewtonSteps = new NewtonSteps();
        private var _gap:RoundGap = new RoundGap();
        private var _way:RelativeMotion = new RelativeMotion();

        // Each step finds half of the gap before, so the steps never come to its end.
        [Test]
        public function theTimeOfTheLastStepIsTheTimeOfImpact():void
        {
            _gap.size = 1e-300;
            _gap.x = 0.5;
            _way.x = -1;
            assertTrue(_steps.begin(_way, _way, _gap));
            _way.rounding = 0;
            var count:int = 1;
            do
            {
                _gap.x /= 2;
                _way.x = -_gap.x * 1e3;
                count++;
            }
            while (_steps.next(_way, _gap));
            assertEquals("steps", 80, count);
            assertTrue("a time: " + _way.time, _way.time > 0.5 && _way.time <= 1);
        }

        [Test]
        public function aTouchAfterTheLatestTimeIsNone():void
        {
            _gap.size = 1;
            _gap.x = 2;
            _way.x = -1;
            assertFalse(_steps.begin(_way, _way, _gap));
            assertEquals(RelativeMotion.NEVER, _way.time);
        }
    }
}
