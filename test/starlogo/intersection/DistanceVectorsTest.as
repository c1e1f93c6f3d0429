package starlogo.intersection
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.distance.findClosest;
    import support.PairVectors;
    import support.SurfaceDistance;

    /**
     * The distances of 24,000 pairs of structures, which are known exactly, in either order of the arguments; and the points: each on its
     * structure, as far apart as the distance. Printed: the largest errors, as fractions of the structures' size.
     */
    public class DistanceVectorsTest
    {
        public static const FIXTURES:Array = PairVectors.fixtures("sphere-sphere", "sphere-capsule", "sphere-box",
                "capsule-capsule", "capsule-box", "box-box");

        // of the size of the larger structure; a hundred thousandth of what is asked
        private static const PRECISION:Number = 1e-14;

        // of the coordinates
        private static const ROUNDING:Number = 1e-15;

        private var _pair:ClosestPair = new ClosestPair();
        private var _turned:ClosestPair = new ClosestPair();

        [Test]
        public function sphereSphere():void
        {
            check("sphere-sphere");
        }

        [Test]
        public function sphereCapsule():void
        {
            check("sphere-capsule");
        }

        [Test]
        public function sphereBox():void
        {
            check("sphere-box");
        }

        [Test]
        public function capsuleCapsule():void
        {
            check("capsule-capsule");
        }

        [Test]
        public function capsuleBox():void
        {
            check("capsule-box");
        }

        [Test]
        public function boxBox():void
        {
            check("box-box");
        }

        private function check(name:String):void
        {
            var vectors:PairVectors = new PairVectors(name);
            var worst:Number = 0;
            var worstFamily:String = "none";
            var apart:int = 0;
            while (vectors.next())
            {
                var a:BoundingStructure = vectors.a;
                var b:BoundingStructure = vectors.b;
                var size:Number = Math.max(sizeOf(a), sizeOf(b));
                findClosest(a, b, _pair);
                findClosest(b, a, _turned);
                var truth:Number = Math.max(0, vectors.distance);
                var error:Number = Math.abs(_pair.distance - truth) / Math.max(size, truth);
                if (error > worst)
                {
                    worst = error;
                    worstFamily = vectors.family;
                }
                assertTrue(vectors.family + ": " + _pair.distance + " is not " + truth + " at size " + size, error <= PRECISION);
                assertEquals(vectors.family + ": hit", truth == 0, _pair.distance <= PRECISION * size);
                assertEquals(vectors.family + ", swapped", _pair.distance, _turned.distance);
                checkPoints(vectors.family, a, b, size, truth);
                apart += truth > 0 ? 1 : 0;
            }
            trace("  " + name + ": " + vectors.count + " pairs, " + apart + " apart; worst error " + worst + " of the size, of \"" + worstFamily + "\"");
            assertTrue(apart + " apart", apart > 0.3 * vectors.count && apart < 0.7 * vectors.count);
        }

        private function checkPoints(family:String, a:BoundingStructure, b:BoundingStructure, size:Number, truth:Number):void
        {
            var pair:ClosestPair = _pair;
            var pointA:Vector3D = new Vector3D(pair.aX, pair.aY, pair.aZ);
            var pointB:Vector3D = new Vector3D(pair.bX, pair.bY, pair.bZ);
            var slack:Number = 10 * PRECISION * (size + truth) + ROUNDING * (pointA.length + pointB.length);
            if (truth > 0)
            {
                assertTrue(family + ": the first point is on the surface", SurfaceDistance.of(a, pointA) <= slack);
                assertTrue(family + ": the second point is on the surface", SurfaceDistance.of(b, pointB) <= slack);
                assertTrue(family + ": as far apart", Math.abs(Vector3D.distance(pointA, pointB) - truth) <= slack);
            }
            else
            {
                assertTrue(family + ": one point", Vector3D.distance(pointA, pointB) <= slack);
                assertTrue(family + ": in both", isIn(a, pointA, slack) && isIn(b, pointA, slack));
            }
        }

        private static function isIn(structure:BoundingStructure, point:Vector3D, slack:Number):Boolean
        {
            return structure.contains(point) || SurfaceDistance.of(structure, point) <= slack;
        }

        private static function sizeOf(structure:BoundingStructure):Number
        {
            if (structure is Sphere)
            {
                return Sphere(structure).radius;
            }
            if (structure is Capsule)
            {
                var capsule:Capsule = Capsule(structure);
                return Vector3D.distance(capsule.start, capsule.end) / 2 + capsule.radius;
            }
            var box:Box = Box(structure);
            return new Vector3D(box.halfX, box.halfY, box.halfZ).length;
        }
    }
}
