package starlogo.models.animation
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.geometry.AffineTransform;

    public class JointInfluencesTest
    {
        private var _influences:JointInfluences;
        private var _jointMatrices:Vector.<AffineTransform>;

        // one point that follows no joint, and one that follows the second joint three times as much as the first
        [Before]
        public function setUp():void
        {
            _influences = new JointInfluences();
            _influences.offsets.push(0, 2);
            _influences.joints.push(0, 1);
            _influences.weights.push(0.5, 1.5);
            _jointMatrices = new <AffineTransform>[movedBy(8), movedBy(16)];
        }

        [Test]
        public function weightsAreDividedByTheirSum():void
        {
            var points:Vector.<Number> = new <Number>[1, 2, 3, 4, 5, 6];
            assertTrue(_influences.skinPoints(points, _jointMatrices, 1, 2));
            assertEquals("1,2,3,18,5,6", points.join());
        }

        [Test]
        public function aPointWithoutWeightsFollowsTheFirstJoint():void
        {
            var points:Vector.<Number> = new <Number>[1, 2, 3, 4, 5, 6];
            assertTrue(_influences.skinPoints(points, _jointMatrices, 0, 2));
            assertEquals("9,2,3,18,5,6", points.join());
        }

        [Test]
        public function saysWhetherAPointIsTooFar():void
        {
            _jointMatrices[1] = movedBy(Infinity);
            assertTrue(_influences.skinPoints(new <Number>[1, 2, 3, 4, 5, 6], _jointMatrices, 0, 1));
            assertFalse(_influences.skinPoints(new <Number>[1, 2, 3, 4, 5, 6], _jointMatrices, 0, 2));
        }

        private static function movedBy(x:Number):AffineTransform
        {
            return new AffineTransform(new <Number>[1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0]);
        }
    }
}
