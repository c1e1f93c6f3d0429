package starlogo.convex
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;

    public class ConservativeAdvancementTest
    {
        private var _step:ConservativeAdvancement = new ConservativeAdvancement();
        private var _motion:RelativeMotion = new RelativeMotion(0);

        [Before]
        public function beginApart():void
        {
            _step.separation = 0.5;
            _step.speed = 1;
        }

        // Each step finds half of the gap before, so the steps never come to its end.
        [Test]
        public function theTimeOfTheLastStepIsTheTimeOfImpact():void
        {
            var steps:int = 1;
            while (_step.advance(_motion))
            {
                _step.separation /= 2;
                _step.speed = 1e3 * _step.separation;
                steps++;
            }
            assertEquals("steps", 80, steps);
            assertTrue("a time: " + _motion.time, _motion.time > 0.5 && _motion.time <= 1);
        }

        [Test]
        public function aTouchAfterTheLatestTimeIsNone():void
        {
            _motion.latestTime = 0.4;
            assertFalse(_step.advance(_motion));
            assertEquals(RelativeMotion.NEVER, _motion.time);
        }

        [Test]
        public function roundingHidesNoTouchAtTheLatestTime():void
        {
            _motion.latestTime = 0.5 - 2e-16;
            assertTrue("the step to 0.5 is later than that", _motion.latestTime < 0.5);
            assertTrue(_step.advance(_motion));
            assertEquals(_motion.latestTime, _motion.time);
        }

        [Test]
        public function shapesThatDoNotCloseNeverTouch():void
        {
            _step.speed = 0;
            assertFalse(_step.advance(_motion));
            assertEquals(RelativeMotion.NEVER, _motion.time);
        }

        [Test]
        public function aTouchAtTheStartIsAtTimeZero():void
        {
            _step.isTouching = true;
            assertFalse(_step.advance(_motion));
            assertEquals(0, _motion.time);
        }

        [Test]
        public function aTouchAcrossTheMarginsLeadsOnceMoreToTheSurface():void
        {
            touchAcrossMargins();
            assertEquals(0.5 + 1e-9, _motion.time);
            assertFalse(_step.advance(_motion));
            assertEquals("it still touches", 0.5 + 1e-9, _motion.time);
        }

        [Test]
        public function aTouchAcrossTheMarginsCountsIfTheNextStepLeadsOutOfIt():void
        {
            touchAcrossMargins();
            _step.isTouching = false;
            assertFalse(_step.advance(_motion));
            assertEquals(0.5, _motion.time);
        }

        [Test]
        public function aTouchAcrossTheMarginsCountsIfTheNextStepIsTooLate():void
        {
            _motion.latestTime = 0.5;
            assertTrue(_step.advance(_motion));
            _step.isTouching = true;
            _step.separation = 1e-9;
            assertFalse(_step.advance(_motion));
            assertEquals(0.5, _motion.time);
        }

        // The second step touches, with a gap left.
        private function touchAcrossMargins():void
        {
            assertTrue(_step.advance(_motion));
            assertEquals(0.5, _motion.time);
            _step.isTouching = true;
            _step.separation = 1e-9;
            assertTrue(_step.advance(_motion));
        }
    }
}
