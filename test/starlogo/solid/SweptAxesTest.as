package starlogo.solid
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.Interval;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import support.Complaints;
    import support.Effort;
    import support.RandomConvex;

    /**
     * The axes of a sweep rule out no triangle that the kernel finds to be touched, but those beside the way of a box. The shapes pass a triangle
     * on the border between a touch and none, which bisection finds.
     */
    public class SweptAxesTest
    {
        // Kinds of RandomConvex.
        private static const SPHERE:int = 0;
        private static const CAPSULE:int = 1;
        private static const BOX:int = 2;
        private static const TRIANGLE:int = 3;
        private static const HULL:int = 4;

        // How far from the border a case is, as a fraction of how far the shape is beside the triangle there.
        private static const OFFSETS:Array = [-1e-3, -1e-9, -1e-12, -1e-15, 0, 1e-15, 1e-12, 1e-9, 1e-3, 0.1];
        private static const BISECTIONS:int = 60;

        private var _random:SeededRandom = new SeededRandom(7301);
        private var _shapes:RandomConvex = new RandomConvex(_random);
        private var _axes:SweptAxes = new SweptAxes();
        private var _kernel:ConvexKernel = new ConvexKernel();
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _corners:Vector.<Number> = new Vector.<Number>();
        private var _triangle:ConvexShape = new ConvexShape();

        // How many are touched, and how many the axes rule out.
        private var _wrong:Complaints = new Complaints();
        private var _touched:int = 0;
        private var _ruledOut:int = 0;

        [Test]
        public function spheres():void
        {
            compare(SPHERE);
        }

        [Test]
        public function capsules():void
        {
            compare(CAPSULE);
        }

        [Test]
        public function boxes():void
        {
            compare(BOX);
        }

        [Test]
        public function hulls():void
        {
            compare(HULL);
        }

        [Test]
        public function aTriangleBesideTheWayOfABoxIsRuledOut():void
        {
            var extent:Interval = new Interval();
            for (var i:int = 0; i < 100; i++)
            {
                drawMotion();
                var motion:Vector3D = new Vector3D(_motion.x, _motion.y, _motion.z);
                var box:ConvexShape = _shapes.shape(BOX, RandomConvex.PLAIN, new Vector3D());
                for (var edge:int = 1; edge < box.edges.length; edge += 4)
                {
                    // a small triangle at right angles to the axis across the edge and the motion, beside the middle of the way
                    var along:Vector3D = pointOf(box, box.edges[edge]).subtract(pointOf(box, 0));
                    var axis:Vector3D = along.crossProduct(motion);
                    axis.normalize();
                    box.project(axis, extent);
                    var height:Number = 1.001 * extent.max;
                    var corner:Vector3D = new Vector3D(motion.x / 2 + height * axis.x, motion.y / 2 + height * axis.y, motion.z / 2 + height * axis.z);
                    _corners = new <Number>[corner.x, corner.y, corner.z, corner.x + 1e-3 * along.x, corner.y + 1e-3 * along.y, corner.z + 1e-3 * along.z,
                            corner.x + 1e-3 * motion.x, corner.y + 1e-3 * motion.y, corner.z + 1e-3 * motion.z];
                    _axes.setTo(box, _motion);
                    _wrong.addIf(!_axes.areApart(_corners), "not ruled out", "edge " + edge + " of " + i);
                }
            }
            _wrong.assertNone();
        }

        private static function pointOf(shape:ConvexShape, at:int):Vector3D
        {
            return new Vector3D(shape.points[at], shape.points[at + 1], shape.points[at + 2]);
        }

        private function compare(kind:int):void
        {
            for (var i:int = Effort.choose(300, 20000); i > 0; i--)
            {
                var family:int = i % RandomConvex.FAMILIES;
                drawTriangle(family == RandomConvex.SCALES ? RandomConvex.PLAIN : family);
                passBeside(kind, family == RandomConvex.SCALES ? RandomConvex.PLAIN : family);
            }
            _wrong.assertNone();
            assertTrue(_touched + " touched, " + _ruledOut + " ruled out", _touched > 300 && _ruledOut > 60);
        }

        private function drawTriangle(family:int):void
        {
            var drawn:ConvexShape = _shapes.shape(TRIANGLE, family, new Vector3D(_random.between(-1, 1), _random.between(-1, 1), _random.between(-1, 1)));
            _corners.length = 0;
            for (var i:int = 0; i < drawn.pointsEnd; i += 3)
            {
                _corners.push(drawn.origin.x + drawn.points[i], drawn.origin.y + drawn.points[i + 1], drawn.origin.z + drawn.points[i + 2]);
            }
            _triangle.setTriangle(_corners, 0);
        }

        private function drawMotion():void
        {
            var size:Number = _random.logBetween(0.3, 30);
            _motion.x = size * _random.between(-1, 1);
            _motion.y = size * _random.between(-1, 1);
            _motion.z = size * _random.between(-1, 1);
        }

        // Lets a shape pass the triangle, about as far beside it that it just touches.
        private function passBeside(kind:int, family:int):void
        {
            drawMotion();
            var shape:ConvexShape = _shapes.shape(kind, family, target());
            var side:Vector3D = sideways();
            var touching:Number = 0;
            var apart:Number = 4 * (shape.boundingRadius + shape.radius + _triangle.boundingRadius);
            if (!(apart > 0) || !touches(placed(shape, side, touching)) || touches(placed(shape, side, apart)))
            {
                return;
            }
            for (var i:int = 0; i < BISECTIONS; i++)
            {
                var middle:Number = (touching + apart) / 2;
                if (touches(placed(shape, side, middle)))
                {
                    touching = middle;
                }
                else
                {
                    apart = middle;
                }
            }
            for each (var offset:Number in OFFSETS)
            {
                count(placed(shape, side, touching + offset * touching), kind + " of family " + family + " by " + offset);
            }
        }

        // Where the shape is at the beginning if it meets a point of the triangle on its motion.
        private function target():Vector3D
        {
            var share:Number = _random.next();
            var from:int = 3 * _random.integer(0, 2);
            var to:int = (from + 3) % 9;
            var time:Number = _random.between(0.1, 0.9);
            return new Vector3D(_corners[from] + share * (_corners[to] - _corners[from]) - time * _motion.x,
                    _corners[from + 1] + share * (_corners[to + 1] - _corners[from + 1]) - time * _motion.y,
                    _corners[from + 2] + share * (_corners[to + 2] - _corners[from + 2]) - time * _motion.z);
        }

        // A direction across the motion: mostly across an edge too, with a small part of another direction or none.
        private function sideways():Vector3D
        {
            var motion:Vector3D = new Vector3D(_motion.x, _motion.y, _motion.z);
            var from:int = 3 * _random.integer(0, 2);
            var to:int = (from + 3) % 9;
            var edge:Vector3D = new Vector3D(_corners[to] - _corners[from], _corners[to + 1] - _corners[from + 1], _corners[to + 2] - _corners[from + 2]);
            var part:Number = _random.pick([0, 1e-9, 0.1, 10]);
            edge.x += part * _random.between(-1, 1);
            edge.y += part * _random.between(-1, 1);
            edge.z += part * _random.between(-1, 1);
            var side:Vector3D = motion.crossProduct(edge);
            side.scaleBy(_random.chance() ? 1 : -1);
            side.normalize();
            return side;
        }

        private static function placed(shape:ConvexShape, side:Vector3D, by:Number):ConvexShape
        {
            return RandomConvex.moved(shape, by * side.x, by * side.y, by * side.z);
        }

        private function touches(shape:ConvexShape):Boolean
        {
            _motion.time = RelativeMotion.NEVER;
            _kernel.findTimeOfImpact(shape, _triangle, _motion);
            return _motion.time != RelativeMotion.NEVER;
        }

        private function count(shape:ConvexShape, what:String):void
        {
            var size:Number = 3 * shape.margin + Math.abs(_motion.x) + Math.abs(_motion.y) + Math.abs(_motion.z) + Math.abs(shape.origin.x) + Math.abs(shape.origin.y)
                + Math.abs(shape.origin.z) + shape.boundingRadius;
            _axes.cullDistance = shape.radius + shape.margin + Tolerances.EXTENTS * size;
            _axes.setTo(shape, _motion);
            var isRuledOut:Boolean = _axes.areApart(_corners);
            var isTouched:Boolean = touches(shape);
            _wrong.addIf(isRuledOut && isTouched, "ruled out, but touched", what);
            _touched += int(isTouched);
            _ruledOut += int(isRuledOut);
        }
    }
}
