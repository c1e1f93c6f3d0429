package starlogo.intersection
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.findTimeOfImpact;
    import support.MotionVectors;

    /**
     * First touches and contacts against 24,000 ways whose truth is proved in 60 digits: no wrong verdict, in either order of the
     * arguments. Printed: the largest errors.
     */
    public class MotionVectorsTest
    {
        public static const FIXTURES:Array = MotionVectors.fixtures("sphere-sphere", "sphere-capsule", "sphere-box",
                "capsule-capsule", "capsule-box", "box-box");

        // The oracle's times are within 1e-9; more is lost where the structures only graze each other.
        private static const TIME:Number = 1e-8;
        private static const NORMAL:Number = 1e-5;
        private static const TOUCHING:Number = 1e-6;

        private var _finder:ContactFinder = new ContactFinder();
        private var _touch:ContactPoint = new ContactPoint();
        private var _back:ContactPoint = new ContactPoint();

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
            var vectors:MotionVectors = new MotionVectors(name);
            var back:RelativeMotion = new RelativeMotion();
            var wrong:Array = [];
            var touching:int = 0;
            var normals:int = 0;
            var timeError:Number = 0;
            var normalError:Number = 0;
            var depthError:Number = 0;
            var count:int = 0;
            while (vectors.next())
            {
                count++;
                var way:RelativeMotion = vectors.way;
                var label:String = vectors.index + " (" + vectors.family + ")";
                back.turn(way);
                findTimeOfImpact(vectors.a, vectors.b, way);
                findTimeOfImpact(vectors.b, vectors.a, back);
                var time:Number = way.time;
                var timeBack:Number = back.time;
                var isTouching:Boolean = vectors.time == vectors.time;
                if ((time <= 1) != isTouching || (timeBack <= 1) != isTouching)
                {
                    wrong.push(label + ": " + time + ", " + timeBack + " and not " + vectors.time);
                    continue;
                }
                if (!isTouching)
                {
                    continue;
                }
                touching++;
                var error:Number = Math.max(Math.abs(time - vectors.time), Math.abs(timeBack - vectors.time));
                timeError = Math.max(timeError, error);
                if (!(error <= TIME))
                {
                    wrong.push(label + ": time " + time + ", " + timeBack + ", not " + vectors.time);
                }
                _finder.displacement.stopAt(way);
                _finder.find(vectors.a, vectors.b, _touch);
                back.turn(way);
                _finder.displacement.stopAt(back);
                _finder.find(vectors.b, vectors.a, _back);
                var size:Number = sizeOf(vectors.a) + sizeOf(vectors.b);
                error = Math.max(Math.abs(_touch.depth - vectors.depth), Math.abs(_back.depth - vectors.depth)) / size;
                depthError = Math.max(depthError, error);
                if (!(error <= TIME))
                {
                    wrong.push(label + ": depth " + _touch.depth + ", " + _back.depth + ", not " + vectors.depth);
                }
                if (vectors.normalX == vectors.normalX)
                {
                    normals++;
                    error = Math.max(distance(_touch, vectors, 1), distance(_back, vectors, -1));
                    normalError = Math.max(normalError, error);
                    if (!(error <= NORMAL))
                    {
                        wrong.push(label + ": normal off by " + error + " at " + time);
                    }
                }
            }
            trace("  " + name + ": " + count + " ways, " + touching + " touches, " + normals + " normals; largest errors: time "
                    + timeError.toExponential(1) + ", depth " + depthError.toExponential(1) + " of the size, normal "
                    + normalError.toExponential(1) + "; " + wrong.length + " wrong");
            assertEquals(wrong.slice(0, 20).join("\n"), 0, wrong.length);
            assertTrue("touches: " + touching, touching > 0.4 * count && touching < 0.8 * count);
            assertTrue("normals: " + normals, normals > 0.5 * touching);
        }

        private static function distance(touch:ContactPoint, vectors:MotionVectors, sign:Number):Number
        {
            var x:Number = sign * touch.normalX - vectors.normalX;
            var y:Number = sign * touch.normalY - vectors.normalY;
            var z:Number = sign * touch.normalZ - vectors.normalZ;
            return Math.sqrt(x * x + y * y + z * z);
        }

        private static function sizeOf(structure:BoundingStructure):Number
        {
            var extents:Vector.<Number> = new Vector.<Number>(6);
            structure.extentsInto(extents);
            return (extents[1] - extents[0] + extents[3] - extents[2] + extents[5] - extents[4]) / 2;
        }
    }
}
