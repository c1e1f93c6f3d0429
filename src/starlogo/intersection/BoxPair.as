package starlogo.intersection
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.Polygon;
    import starlogo.intersection.contact.SegmentSum;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.boxBoxImpact;

    /**
     * The kernel of two boxes: separating axes, over time for the sweep, and for the contact that along which the boxes overlap least.
     *
     * <p>The contact is that of any two structures that are sums of segments: two boxes, or a capsule's axis and a box. The shortest separating
     * displacement is at right angles to two of the segments' directions: to a face of one structure, or to an edge of each.</p>
     */
    internal final class BoxPair extends PairKernel
    {
        private var _a:SegmentSum = new SegmentSum();
        private var _b:SegmentSum = new SegmentSum();
        private var _polygonA:Polygon = new Polygon();
        private var _polygonB:Polygon = new Polygon();

        // Made when they are first needed: their class extends SegmentBox, which has a BoxPair.
        private var _edgesA:BoxEdges = null;
        private var _edgesB:BoxEdges = null;

        // The shortest separating displacement so far.
        private var _depth:Number;
        private var _x:Number;
        private var _y:Number;
        private var _z:Number;

        /** No contact yet. */
        public function BoxPair()
        {
        }

        /** @inheritDoc */
        override public function timeOfImpact(a:BoundingStructure, b:BoundingStructure, motion:RelativeMotion):Number
        {
            return boxBoxImpact(a as Box, b as Box, motion);
        }

        /** @inheritDoc */
        override public function findContact(a:BoundingStructure, b:BoundingStructure, displacement:RelativeMotion, out:ContactPoint):void
        {
            findDeepContact(a, b, 0, displacement, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:BoundingStructure, b:BoundingStructure, out:ClosestPair):void
        {
            var boxA:Box = a as Box;
            var boxB:Box = b as Box;
            // always in one order: then rounding is the same in either
            if (boxA.center.x > boxB.center.x || (boxA.center.x == boxB.center.x && isAfter(boxA.center, boxB.center)))
            {
                findClosest(b, a, out);
                out.turn();
                return;
            }
            _edgesA ||= new BoxEdges();
            _edgesB ||= new BoxEdges();
            _edgesA.findNearest(boxA, boxB);
            if (_edgesA.squared > 0 && !_edgesA.isLeast())
            {
                _edgesB.findNearest(boxB, boxA);
                if (_edgesB.squared < _edgesA.squared)
                {
                    _edgesB.write(boxA, true, out);
                    return;
                }
            }
            _edgesA.write(boxB, false, out);
        }

        /**
         * Finds the contact of two boxes, or of a capsule and a box that its axis goes through.
         *
         * @param a a Box, or a Capsule of which the axis counts
         * @param b a Box
         * @param radius how far a reaches beyond that
         * @param displacement where a is, from where it stands
         * @param out takes the contact
         */
        public function findDeepContact(a:BoundingStructure, b:BoundingStructure, radius:Number, displacement:RelativeMotion,
                out:ContactPoint):void
        {
            _a.setTo(a, displacement.startX, displacement.startY, displacement.startZ);
            _b.setTo(b, 0, 0, 0);
            _depth = Infinity;
            tryAll(_b, _b);
            tryAll(_a, _a);
            tryAll(_a, _b);
            out.normalX = _x;
            out.normalY = _y;
            out.normalZ = _z;
            _a.supportInto(_polygonA, -_x, -_y, -_z);
            _b.supportInto(_polygonB, _x, _y, _z);
            _polygonA.findCommonPoint(_polygonB, _x, _y, _z);
            // as far out as the middle between the one's surface and the other's
            out.x = _polygonA.x - radius / 2 * _x;
            out.y = _polygonA.y - radius / 2 * _y;
            out.z = _polygonA.z - radius / 2 * _z;
            var depth:Number = _depth + radius;
            out.depth = depth > 0 ? depth : 0;
        }

        private function tryAll(first:SegmentSum, second:SegmentSum):void
        {
            var u:Vector.<Number> = first.directions;
            var v:Vector.<Number> = second.directions;
            for (var i:int = 0; i < first.end; i += 3)
            {
                var ux:Number = u[i];
                var uy:Number = u[int(i + 1)];
                var uz:Number = u[int(i + 2)];
                for (var k:int = first === second ? i + 3 : 0; k < second.end; k += 3)
                {
                    var vx:Number = v[k];
                    var vy:Number = v[int(k + 1)];
                    var vz:Number = v[int(k + 2)];
                    tryAcross(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
                }
            }
        }

        // A direction; the sine of the angle between the two is its length.
        private function tryAcross(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length < Tolerances.DIRECTION)
            {
                return;
            }
            x /= length;
            y /= length;
            z /= length;
            var along:Number = (_a.x - _b.x) * x + (_a.y - _b.y) * y + (_a.z - _b.z) * z;
            if (along < 0)
            {
                along = -along;
                x = -x;
                y = -y;
                z = -z;
            }
            var reach:Number = _a.reach(x, y, z) + _b.reach(x, y, z);
            // what is shorter by rounding is not shorter
            if (reach - along < _depth - Tolerances.ROUNDING * reach)
            {
                _depth = reach - along;
                _x = x;
                _y = y;
                _z = z;
            }
        }
    }
}
