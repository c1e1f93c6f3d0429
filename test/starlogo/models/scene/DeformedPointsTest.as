package starlogo.models.scene
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.geometry.AffineTransform;
    import starlogo.models.ModelError;
    import starlogo.models.files.FileBudget;
    import starlogo.steps.finish;
    import support.assertThrows;

    public class DeformedPointsTest
    {
        private var _influences:JointInfluences;
        private var _jointMatrices:Vector.<AffineTransform>;
        private var _meshPoints:Vector.<Number>;
        private var _deformed:DeformedPoints;

        // one point that follows no joint, and one that follows the second joint three times as much as the first
        [Before]
        public function setUp():void
        {
            _influences = new JointInfluences();
            _influences.offsets.push(0, 2);
            _influences.joints.push(0, 1);
            _influences.weights.push(0.5, 1.5);
            _jointMatrices = new <AffineTransform>[movedBy(8), movedBy(16)];
            _meshPoints = new <Number>[1, 2, 3, 4, 5, 6];
            _deformed = new DeformedPoints(_meshPoints, new AffineTransform(new <Number>[-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]));
        }

        /** The weights of a point are divided by their sum. A point without weights follows the first joint. */
        [Test]
        public function aSkinMovesPointsToTheScene():void
        {
            assertTrue(_deformed.isMirror);
            skin();
            assertEquals("9,2,3,18,5,6", _deformed.points.join());
            assertEquals(new AffineTransform().rows.join(), _deformed.toScene.rows.join());
            assertFalse("as the first joint", _deformed.isMirror);
        }

        [Test]
        public function refusesAPointThatIsTooFar():void
        {
            _jointMatrices[1] = movedBy(Infinity);
            assertThrows(ModelError, /model "a", skins\[0\]: it moves points too far/, skin);
        }

        [Test]
        public function aMorphMovesSomePointsAPartOfTheWay():void
        {
            finish(_deformed.morphing(1, 0.5, new <Number>[2, 4, 6], null));
            assertEquals("1,2,3,5,7,9", _deformed.points.join());
            finish(_deformed.morphing(1, 0.5, new <Number>[2, 4, 6], new <Number>[0, 0, 2]));
            assertEquals("1,2,3,6,9,11", _deformed.points.join());
            assertEquals("1,2,3,4,5,6", _meshPoints.join());
        }

        [Test]
        public function resetPutsThePointsBack():void
        {
            skin();
            _deformed.reset(movedBy(2));
            assertEquals("1,2,3,4,5,6", _deformed.points.join());
            assertEquals(movedBy(2).rows.join(), _deformed.toScene.rows.join());
        }

        private function skin():void
        {
            finish(_deformed.skinning(_influences, _jointMatrices, new FileBudget("a", 0), "skins[0]"));
        }

        private static function movedBy(x:Number):AffineTransform
        {
            return new AffineTransform(new <Number>[1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0]);
        }
    }
}
