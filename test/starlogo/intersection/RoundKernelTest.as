package starlogo.intersection
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.convex.RelativeMotion;

    public class RoundKernelTest
    {
        private var _motion:RelativeMotion = new RelativeMotion();

        // Each step finds half of the gap before, so the steps never come to its end.
        [Test]
        public function theTimeOfTheLastStepIsTheTimeOfImpact():void
        {
            var gaps:Halves = new Halves();
            gaps.length = 0.5;
            new RoundKernel(gaps, null).findTime(null, null, _motion);
            assertEquals("steps", 80, gaps.count);
            assertTrue("a time: " + _motion.time, _motion.time > 0.5 && _motion.time <= 1);
        }

        [Test]
        public function aTouchAfterTheLatestTimeIsNone():void
        {
            var gaps:Halves = new Halves();
            gaps.length = 2;
            new RoundKernel(gaps, null).findTime(null, null, _motion);
            assertEquals(RelativeMotion.NEVER, _motion.time);
            assertEquals("steps", 1, gaps.count);
        }
    }
}

import starlogo.bounding.BoundingStructure;
import starlogo.convex.RelativeMotion;
import starlogo.intersection.GapFinder;
import starlogo.intersection.RoundGap;

class Halves extends GapFinder
{
    public var length:Number = 0;
    public var count:int = 0;

    override public function find(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion, out:RoundGap):void
    {
        out.squaredLength = length * length;
        out.closing = count == 0 ? length : 1e3 * out.squaredLength;
        out.extent = 0;
        length /= 2;
        count++;
    }
}
