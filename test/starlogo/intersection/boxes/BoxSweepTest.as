package starlogo.intersection.boxes
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.Box;
    import starlogo.convex.RelativeMotion;
    import support.Complaints;

    /** Boxes that stand almost a tolerance apart, beside a loop over the fifteen axes as unit vectors. */
    public class BoxSweepTest
    {
        private static const TOLERANCE:Number = 0.02;
        private static const PAIRS:int = 3000;
        private static const ROUNDING:Number = 1e-9;

        // The tolerance of a cross product of edges is up to the root of two as large, because its length is only known by a bound.
        private static const LARGEST:Number = TOLERANCE * Math.SQRT2;

        private var _random:SeededRandom = new SeededRandom(1507);
        private var _structures:RandomStructures = new RandomStructures(_random);
        private var _sweep:BoxSweep = new BoxSweep();
        private var _pair:BoxPair = new BoxPair();
        private var _motion:RelativeMotion = new RelativeMotion();

        [Test]
        public function theToleranceIsTheSameAlongAllAxes():void
        {
            var wrong:Complaints = new Complaints();
            var touching:int = 0;
            var apart:int = 0;
            for (var i:int = 0; i < PAIRS; i++)
            {
                var a:Box = _structures.box(1, 0);
                var b:Box = _structures.box(1, 0);
                var axes:Vector.<Vector3D> = axesOf(a, b);
                var axis:Vector3D = _random.pick([axes[0], axes[4], axes[6 + _random.integer(0, axes.length - 7)]]);
                axis.scaleBy(halfAlong(a, axis) + halfAlong(b, axis) + TOLERANCE * _random.between(0, 5));
                b.center.copyFrom(axis);
                axis.normalize();
                var gap:Number = largestGap(a, b, axes);
                setPair(a, b);
                _sweep.findTimeOfImpact(_pair, _motion);
                wrong.addIf(gap < TOLERANCE - ROUNDING && _motion.time != 0, "apart", i + ": the gap is " + gap);
                wrong.addIf(gap > LARGEST + ROUNDING && _motion.time == 0, "touching", i + ": the gap is " + gap);
                touching += gap < TOLERANCE ? 1 : 0;
                apart += gap > LARGEST && gap < 3 * LARGEST ? 1 : 0;
            }
            wrong.assertNone();
            assertTrue(touching + " touch, " + apart + " are a little farther apart", touching > PAIRS / 20 && apart > PAIRS / 20);
        }

        private function setPair(a:Box, b:Box):void
        {
            var between:Vector3D = b.center.subtract(a.center);
            _pair.offset[0] = between.dotProduct(a.axisX);
            _pair.offset[1] = between.dotProduct(a.axisY);
            _pair.offset[2] = between.dotProduct(a.axisZ);
            _pair.setBoxes(a, b);
            _pair.margin = TOLERANCE;
        }

        // The axes of both boxes, and the cross products of their edges, all of length 1.
        private static function axesOf(a:Box, b:Box):Vector.<Vector3D>
        {
            var axes:Vector.<Vector3D> = new <Vector3D>[a.axisX.clone(), a.axisY.clone(), a.axisZ.clone(), b.axisX.clone(), b.axisY.clone(), b.axisZ.clone()];
            for (var i:int = 0; i < 3; i++)
            {
                for (var j:int = 3; j < 6; j++)
                {
                    var across:Vector3D = axes[i].crossProduct(axes[j]);
                    if (across.normalize() > 1e-6)
                    {
                        axes.push(across);
                    }
                }
            }
            return axes;
        }

        private static function largestGap(a:Box, b:Box, axes:Vector.<Vector3D>):Number
        {
            var largest:Number = -Infinity;
            for each (var axis:Vector3D in axes)
            {
                var distance:Number = Math.abs(b.center.subtract(a.center).dotProduct(axis));
                largest = Math.max(largest, distance - halfAlong(a, axis) - halfAlong(b, axis));
            }
            return largest;
        }

        private static function halfAlong(box:Box, axis:Vector3D):Number
        {
            return box.halfX * Math.abs(box.axisX.dotProduct(axis)) + box.halfY * Math.abs(box.axisY.dotProduct(axis))
                + box.halfZ * Math.abs(box.axisZ.dotProduct(axis));
        }
    }
}
