package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexPair;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.FaceNormal;
    import starlogo.convex.Interval;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A convex shape and a triangle: whether the two touch, when and how they first touch, and how far they are apart. The shape is set once, and
     * then one triangle after the other, each a part of a list. ConvexPair decides. This class adds a quick test that comes before it, and
     * what depends on a triangle's two sides.
     *
     * @private
     */
    public final class ConvexTrianglePair
    {
        // Points of the core are equally deep if their depths differ by less than this fraction of its extent along the normal.
        private static const LEVEL:Number = 1e-12;

        /** The shape, in the triangles' space. Only its margin may be changed. */
        public var shape:ConvexShape = new ConvexShape();

        private var _pair:ConvexPair = new ConvexPair();

        // The shape where it is placed: a structure for each kind, and a triangle's corners.
        private var _structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);
        private var _placed:Vector.<Number> = new Vector.<Number>();

        // The triangle: nine numbers of a list. Its shape and its face are set when they are needed. The normal is NaN if the triangle has no area or
        // is a needle, because comparisons with NaN are false.
        private var _corners:Vector.<Number> = null;
        private var _at:int = 0;
        private var _isSet:Boolean = false;
        private var _triangle:ConvexShape = new ConvexShape();
        private var _hasFace:Boolean = false;
        private var _face:FaceNormal = new FaceNormal();

        private var _deepest:Vector3D = new Vector3D();
        private var _ofShape:Interval = new Interval();
        private var _ofTriangle:Interval = new Interval();

        /**
         * Sets the shape to a structure.
         *
         * @param structure not kept
         * @param placement moves it into the triangles' space
         * @return the structure there. The next call for the same kind overwrites it
         */
        public function setStructure(structure:BoundingStructure, placement:Placement):BoundingStructure
        {
            var placed:BoundingStructure = _structures[structure.kind] = structure.place(placement, _structures[structure.kind]);
            shape.setStructure(placed);
            return placed;
        }

        /** Sets the shape to a triangle: nine numbers of a list, from an index on. The placement moves it into the other triangles' space. */
        public function setShapeToTriangle(corners:Vector.<Number>, at:int, placement:Placement):void
        {
            placement.placePoints(corners, at, at + 9, _placed);
            shape.setTriangle(_placed, 0);
        }

        /**
         * Sets the triangle.
         *
         * @param corners has nine numbers of it; kept
         * @param at index of the first of them
         */
        public function setTriangle(corners:Vector.<Number>, at:int):void
        {
            _corners = corners;
            _at = at;
            _isSet = _hasFace = false;
        }

        /** Whether the two touch. */
        public function areTouching():Boolean
        {
            prepare();
            return _pair.areTouching(shape, _triangle);
        }

        /**
         * Finds when the shape first touches the triangle while it moves.
         *
         * @param motion of the shape; receives the time, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            prepare();
            _pair.findTime(shape, _triangle, motion);
        }

        /**
         * Finds how the two touch or overlap.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the contact, with a normal that points from the triangle to the shape
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            prepare();
            _pair.findContact(shape, _triangle, motion, out);
        }

        /**
         * Replaces a contact with this triangle, which is of the outside of a solid, if the normal points into the solid. The new contact leads out
         * of the triangle's plane.
         *
         * @param motion the motion of <code>findContact()</code>
         * @param contact the contact that it found
         */
        public function leadOutside(motion:RelativeMotion, contact:ContactPoint):void
        {
            // Where a moving shape first touches a sharp edge, the normal may point behind one of the edge's faces.
            var isFirstTouch:Boolean = motion.time > 0
                && contact.normalX * motion.x + contact.normalY * motion.y + contact.normalZ * motion.z < 0;
            if (!isFirstTouch)
            {
                prepareFace();
                var face:FaceNormal = _face;
                if (contact.normalX * face.x + contact.normalY * face.y + contact.normalZ * face.z < -Tolerances.DIRECTION)
                {
                    findBehind(motion, contact);
                }
            }
        }

        /**
         * Finds how far the shape is behind the triangle's plane.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the depth, the triangle's normal, and the middle of the overlap at the shape's deepest point. All are NaN if the
         *     triangle has no area
         * @return whether the point of the plane that is nearest to the deepest point is in the triangle
         */
        public function findBehind(motion:RelativeMotion, out:ContactPoint):Boolean
        {
            prepareFace();
            out.setNormal(_face.x, _face.y, _face.z);
            findDeepestPoint();
            var deepest:Vector3D = _deepest;
            deepest.x += motion.startX + motion.time * motion.x;
            deepest.y += motion.startY + motion.time * motion.y;
            deepest.z += motion.startZ + motion.time * motion.z;
            out.depth = _face.offset - out.along(deepest);
            out.x = deepest.x + out.depth / 2 * out.normalX;
            out.y = deepest.y + out.depth / 2 * out.normalY;
            out.z = deepest.z + out.depth / 2 * out.normalZ;
            return isOver(deepest);
        }

        // Finds the point of the shape that is farthest against the triangle's normal. If there are several, it is their middle. NaN if the normal is.
        private function findDeepestPoint():void
        {
            var normal:FaceNormal = _face;
            var p:Vector.<Number> = shape.points;
            var end:int = shape.end;
            normal.project(p, 0, end, _ofShape);
            var most:Number = _ofShape.least + LEVEL * (_ofShape.greatest - _ofShape.least);
            var count:int = 0;
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var i:int = 0; i < end; i += 3)
            {
                if (normal.x * p[i] + normal.y * p[int(i + 1)] + normal.z * p[int(i + 2)] <= most)
                {
                    x += p[i];
                    y += p[int(i + 1)];
                    z += p[int(i + 2)];
                    count++;
                }
            }
            _deepest.x = shape.x + x / count - shape.radius * normal.x;
            _deepest.y = shape.y + y / count - shape.radius * normal.y;
            _deepest.z = shape.z + z / count - shape.radius * normal.z;
        }

        /**
         * Whether another triangle is behind the triangle's plane.
         *
         * @param corners has nine numbers of the other triangle
         * @param slack how far it may be in front of the plane
         */
        public function isBehindPlane(corners:Vector.<Number>, slack:Number):Boolean
        {
            prepareFace();
            _face.project(corners, 0, 9, _ofTriangle);
            return _ofTriangle.greatest <= _face.offset + slack;
        }

        /**
         * Finds the closest points of the two, if they are closer than those of a triangle before.
         *
         * @param out the distance and the points of the triangle before; overwritten if this one is closer
         * @return whether it is closer
         */
        public function findCloser(out:ClosestPoints):Boolean
        {
            prepare();
            return _pair.findCloser(shape, _triangle, out);
        }

        /**
         * Whether the shape stays on one side of the triangle's plane until the motion's latest time. A quick test.
         *
         * @param motion of the shape; its start must be 0
         */
        public function stayApart(motion:RelativeMotion):Boolean
        {
            prepare();
            prepareFace();
            var face:FaceNormal = _face;
            var travel:Number = motion.latest * (face.x * motion.x + face.y * motion.y + face.z * motion.z);
            var place:Number = face.x * (shape.x - _triangle.x) + face.y * (shape.y - _triangle.y) + face.z * (shape.z - _triangle.z);
            face.project(_triangle.points, 0, 9, _ofTriangle);
            face.project(shape.points, 0, shape.end, _ofShape);
            var touchingDistance:Number = (shape.radius + shape.margin) * Tolerances.OUTER
                + Tolerances.ROUNDING * (shape.extent + _triangle.extent + Math.abs(place) + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            return place + _ofShape.least + Math.min(travel, 0) - _ofTriangle.greatest > touchingDistance
                || _ofTriangle.least - place - _ofShape.greatest - Math.max(travel, 0) > touchingDistance;
        }

        // Whether a place is over the triangle or behind it: its foot on the triangle's plane is in the triangle. False if the normal is NaN.
        private function isOver(place:Vector3D):Boolean
        {
            var p:Vector.<Number> = _corners;
            var from:int = _at + 6;
            for (var to:int = _at; to < _at + 9; to += 3)
            {
                var ux:Number = p[to] - p[from];
                var uy:Number = p[int(to + 1)] - p[int(from + 1)];
                var uz:Number = p[int(to + 2)] - p[int(from + 2)];
                var vx:Number = place.x - p[from];
                var vy:Number = place.y - p[int(from + 1)];
                var vz:Number = place.z - p[int(from + 2)];
                if (!(_face.x * (uy * vz - uz * vy) + _face.y * (uz * vx - ux * vz) + _face.z * (ux * vy - uy * vx) >= 0))
                {
                    return false;
                }
                from = to;
            }
            return true;
        }

        private function prepare():void
        {
            if (!_isSet)
            {
                _isSet = true;
                _triangle.setTriangle(_corners, _at);
            }
        }

        private function prepareFace():void
        {
            if (!_hasFace)
            {
                _hasFace = true;
                _face.setTriangle(_corners, _at);
                if (_face.isFlat)
                {
                    _face.clear();
                }
            }
        }
    }
}
