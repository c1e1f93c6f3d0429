package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexKernel;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.Interval;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * The kernel of a convex shape and a triangle: whether the two touch, when and how they first touch, and how far they are apart. The shape is set
     * once, and then one triangle after the other, each a part of a list. ConvexKernel decides. This class adds a quick test that comes before it,
     * and what depends on a triangle's two sides.
     *
     * @private
     */
    public final class TriangleKernel
    {
        // Points of the core are equally deep if their depths differ by less than this fraction of its extent along the normal.
        private static const SAME_DEPTH:Number = 1e-12;

        /** The shape, in the triangles' space. Only its margin may be changed. */
        public var shape:ConvexShape = new ConvexShape();

        private var _kernel:ConvexKernel = new ConvexKernel();

        // The shape where it is placed: a structure for each kind, and a triangle's corners.
        private var _structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(BoundingStructure.KIND_COUNT, true);
        private var _placed:Vector.<Number> = new Vector.<Number>();

        // The triangle: nine numbers of a list. Its shape and its plane are set at the first question that needs them.
        private var _corners:Vector.<Number> = null;
        private var _at:int = 0;
        private var _isTriangleSet:Boolean = false;
        private var _triangle:ConvexShape = new ConvexShape();
        private var _isPlaneSet:Boolean = false;
        private var _plane:TrianglePlane = new TrianglePlane();

        private var _deepest:Vector3D = new Vector3D();
        private var _ofShape:Interval = new Interval();

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
            placed.shapeInto(shape);
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
            _isTriangleSet = _isPlaneSet = false;
        }

        /** Whether the two touch. */
        public function areTouching():Boolean
        {
            prepareTriangle();
            return _kernel.areTouching(shape, _triangle);
        }

        /**
         * Finds when the shape first touches the triangle while it moves.
         *
         * @param motion of the shape; receives the time, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            prepareTriangle();
            _kernel.findTime(shape, _triangle, motion);
        }

        /**
         * Finds how the two touch or overlap.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the contact, with a normal that points from the triangle to the shape
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            prepareTriangle();
            _kernel.findContact(shape, _triangle, motion, out);
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
                preparePlane();
                if (contact.along(_plane.normal) < -Tolerances.DIRECTION)
                {
                    findBehind(motion, contact);
                }
            }
        }

        /**
         * Finds how far the shape is behind the triangle's plane.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the depth, the triangle's normal, and the middle of the overlap at the shape's deepest point. If the triangle is flat,
         *     the normal is 0, and all else is NaN
         */
        public function findBehind(motion:RelativeMotion, out:ContactPoint):void
        {
            preparePlane();
            out.setNormal(_plane.normal.x, _plane.normal.y, _plane.normal.z);
            var deepest:Vector3D = _deepest;
            findDeepestPoint(deepest);
            deepest.x += motion.startX + motion.time * motion.x;
            deepest.y += motion.startY + motion.time * motion.y;
            deepest.z += motion.startZ + motion.time * motion.z;
            out.depth = _plane.offset - out.along(deepest);
            out.x = deepest.x + out.depth / 2 * out.normalX;
            out.y = deepest.y + out.depth / 2 * out.normalY;
            out.z = deepest.z + out.depth / 2 * out.normalZ;
        }

        /** Whether the point of a contact of <code>findBehind()</code> is over the triangle or behind it. False if the triangle is flat. */
        public function isOverTriangle(contact:ContactPoint):Boolean
        {
            var p:Vector.<Number> = _corners;
            var from:int = _at + 6;
            for (var to:int = _at; to < _at + 9; to += 3)
            {
                var ux:Number = p[to] - p[from];
                var uy:Number = p[int(to + 1)] - p[int(from + 1)];
                var uz:Number = p[int(to + 2)] - p[int(from + 2)];
                var vx:Number = contact.x - p[from];
                var vy:Number = contact.y - p[int(from + 1)];
                var vz:Number = contact.z - p[int(from + 2)];
                if (!(contact.normalX * (uy * vz - uz * vy) + contact.normalY * (uz * vx - ux * vz) + contact.normalZ * (ux * vy - uy * vx) >= 0))
                {
                    return false;
                }
                from = to;
            }
            return true;
        }

        /**
         * Whether another triangle is behind the triangle's plane.
         *
         * @param corners has nine numbers of the other triangle
         * @param slack how far it may be in front of the plane
         */
        public function isBehindPlane(corners:Vector.<Number>, slack:Number):Boolean
        {
            preparePlane();
            var normal:Vector3D = _plane.normal;
            var most:Number = _plane.offset + slack;
            for (var i:int = 0; i < 9; i += 3)
            {
                if (!(normal.x * corners[i] + normal.y * corners[int(i + 1)] + normal.z * corners[int(i + 2)] <= most))
                {
                    return false;
                }
            }
            return true;
        }

        /**
         * Finds the closest points of the two, if they are closer than those of a triangle before.
         *
         * @param out the distance and the points of the triangle before; overwritten if this one is closer
         * @return whether it is closer
         */
        public function findCloser(out:ClosestPoints):Boolean
        {
            prepareTriangle();
            return _kernel.findCloser(shape, _triangle, out);
        }

        /**
         * Whether the shape is known to be apart from the triangle until the motion's latest time. A quick test, by the triangle's plane.
         *
         * @param motion of the shape; its start must be 0
         */
        public function stayApart(motion:RelativeMotion):Boolean
        {
            preparePlane();
            var size:Number = shape.extent + Math.abs(shape.x) + Math.abs(shape.y) + Math.abs(shape.z) + Math.abs(_plane.offset)
                + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z);
            var margin:Number = (shape.radius + shape.margin) * Tolerances.OUTER + Tolerances.EXTENTS * size;
            return _plane.findEntry(shape, margin, motion) > motion.latest;
        }

        // Finds the point of the shape that is farthest against the triangle's normal. If there are several, it is their middle.
        private function findDeepestPoint(out:Vector3D):void
        {
            var normal:Vector3D = _plane.normal;
            var p:Vector.<Number> = shape.points;
            var end:int = shape.end;
            shape.project(normal, _ofShape);
            var most:Number = _ofShape.least + SAME_DEPTH * (_ofShape.greatest - _ofShape.least);
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
            out.x = shape.x + x / count - shape.radius * normal.x;
            out.y = shape.y + y / count - shape.radius * normal.y;
            out.z = shape.z + z / count - shape.radius * normal.z;
        }

        // Sets the triangle's shape, unless a question before has set it.
        private function prepareTriangle():void
        {
            if (!_isTriangleSet)
            {
                _isTriangleSet = true;
                _triangle.setTriangle(_corners, _at);
            }
        }

        private function preparePlane():void
        {
            if (!_isPlaneSet)
            {
                _isPlaneSet = true;
                _plane.setTriangle(_corners, _at);
            }
        }
    }
}
