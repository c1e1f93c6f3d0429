package starlogo.bounding
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;

    use namespace engine;

    public class SupportAlongTest
    {
        private static const AXES:Array = [Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS];

        [Test]
        public function alongTheAxesItIsTheEndOfTheExtents():void
        {
            var structures:RandomStructures = new RandomStructures(new SeededRandom(4711));
            var extents:Vector.<Number> = new Vector.<Number>(6, true);
            for (var i:int = 0; i < 200; i++)
            {
                var structure:BoundingStructure = structures.ofKind(i % BoundingStructure.KIND_COUNT, 1, 3);
                structure.extentsInto(extents);
                for (var axis:int = 0; axis < 3; axis++)
                {
                    assertNear(structure + "", extents[2 * axis + 1], structure.supportAlong(AXES[axis]));
                }
            }
        }

        [Test]
        public function theFarthestPointIsThatFarAndInside():void
        {
            var random:SeededRandom = new SeededRandom(4712);
            var structures:RandomStructures = new RandomStructures(random);
            var point:Vector3D = new Vector3D();
            for (var i:int = 0; i < 400; i++)
            {
                var structure:BoundingStructure = structures.ofKind(i % BoundingStructure.KIND_COUNT, 1, 3);
                var direction:Vector3D = structures.direction();
                var support:Number = structure.supportAlong(direction);
                structure.farthestPoint(direction, support - 1e-9, point);
                assertNear(structure + "", support, point.dotProduct(direction));
                assertTrue(structure + "", structure.contains(point));
            }
        }

        [Test]
        public function itIsTheMiddleOfAFaceOrAnEdge():void
        {
            var along:Vector3D = Vector3D.X_AXIS;
            assertMiddle(new Box(new Vector3D(1, 2, 3), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 2, 3), along, 2, 2, 3);
            assertMiddle(new Capsule(new Vector3D(0, 1, 0), new Vector3D(0, 5, 0), 0.5), along, 0.5, 3, 0);
            assertMiddle(new Hull(new <Number>[0, 0, 0, 1, 0, 0, 1, 2, 0, 0, 2, 0]), along, 1, 1, 0);
        }

        private static function assertMiddle(structure:BoundingStructure, along:Vector3D, x:Number, y:Number, z:Number):void
        {
            var point:Vector3D = new Vector3D();
            structure.farthestPoint(along, structure.supportAlong(along) - 1e-9, point);
            assertTrue(structure + ": " + point, point.subtract(new Vector3D(x, y, z)).length < 1e-12);
        }

        private static function assertNear(what:String, expected:Number, actual:Number):void
        {
            assertTrue(what + ": " + expected + ", " + actual, Math.abs(expected - actual) < 1e-9);
        }
    }
}
