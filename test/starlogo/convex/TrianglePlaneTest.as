package starlogo.convex
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import support.Complaints;

    use namespace engine;

    /** Which triangles are flat, and what a flat triangle's plane says. */
    public class TrianglePlaneTest
    {
        private var _random:SeededRandom = new SeededRandom(7144);
        private var _wrong:Complaints = new Complaints();
        private var _plane:TrianglePlane = new TrianglePlane();
        private var _shape:ConvexShape = new ConvexShape();
        private var _motion:RelativeMotion = new RelativeMotion(0);

        [Test]
        public function aNeedleIsFlatWhicheverCornerComesFirst():void
        {
            for (var i:int = 0; i < 300; i++)
            {
                var size:Number = _random.logBetween(1e-6, 1e6);
                var height:Number = i % 2 == 0 ? 0.8e-12 : 1.2e-12;
                // from an end of the longest edge to its middle
                var foot:Number = _random.between(0.001, 0.5);
                var corners:Vector.<Number> = new <Number>[0, 0, 0, size, 0, 0, foot * size, height * size, 0];
                for (var first:int = 0; first < 3; first++)
                {
                    _plane.setTriangle(corners, 0);
                    _wrong.addIf(_plane.isFlat != (i % 2 == 0), "flat", "height " + height + ", foot " + foot + ", corner " + first);
                    corners = corners.slice(3).concat(corners.slice(0, 3));
                }
            }
            _wrong.assertNone();
        }

        [Test]
        public function aFlatTriangleHasNoPlane():void
        {
            new Sphere(new Vector3D(3, 4, 5), 0.1).setShape(_shape);
            _motion.x = 1;
            for each (var corners:Vector.<Number> in [
                        new <Number>[0, 0, 0, 0, 0, 0, 0, 0, 0],
                        new <Number>[1, 2, 3, 1, 2, 3, 1, 2, 3],
                        new <Number>[0, 0, 0, 1, 1, 1, 1, 1, 1],
                        new <Number>[0, 0, 0, 1, 1, 1, 0, 0, 0],
                        new <Number>[0, 0, 0, 2, 0, 0, 1, 0, 0],
                        new <Number>[0, 0, 0, 2, 0, 0, 1, 1e-12, 0],
                        new <Number>[0, 0, 0, 1e60, 0, 0, 1e59, 0, 0]])
            {
                _plane.setTriangle(new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], 0);
                _plane.setTriangle(corners, 0);
                assertTrue("is flat: " + corners, _plane.isFlat);
                assertEquals("normal: " + corners, 0, _plane.normal.length);
                assertTrue("offset: " + corners, isNaN(_plane.offset));
                assertEquals("the quick test says nothing: " + corners, 0, _plane.timeOfEntry(_shape, _motion));
            }
        }

        [Test]
        public function theSizeOfATriangleDoesNotMakeItFlat():void
        {
            for each (var size:Number in [1e-70, 1e-6, 1, 1e9, 1e60])
            {
                _plane.setTriangle(new <Number>[0, 0, size, size, 0, size, 0, size, size], 0);
                assertFalse("size " + size, _plane.isFlat);
                assertEquals("0,0,1", [_plane.normal.x, _plane.normal.y, _plane.normal.z].join());
                assertEquals(size, _plane.offset);
            }
        }

        /** A sphere of radius 1 above a triangle in the plane z = 2. */
        [Test]
        public function aShapeEntersThePlane():void
        {
            _plane.setTriangle(new <Number>[0, 0, 2, 1, 0, 2, 0, 1, 2], 0);
            assertEntry(2, 8, -8, 0.5, "from above");
            assertEntry(2, -4, 8, 0.5, "from below");
            assertEntry(2, 3, -8, 0, "near it");
            assertEntry(2, 1, 0, 0, "near it, still");
            assertEntry(2, 8, 0, RelativeMotion.NEVER, "beside it");
            assertEntry(2, 8, 8, RelativeMotion.NEVER, "away, upwards");
            assertEntry(2, -4, -8, RelativeMotion.NEVER, "away, downwards");
            assertEntry(2, 8, -2, 2, "after the motion");
        }

        private function assertEntry(margin:Number, z:Number, motionZ:Number, expected:Number, message:String):void
        {
            new Sphere(new Vector3D(0, 0, z), 1).setShape(_shape);
            _motion.z = motionZ;
            _plane.cullDistance = margin;
            assertEquals(message, expected, _plane.timeOfEntry(_shape, _motion));
        }
    }
}
