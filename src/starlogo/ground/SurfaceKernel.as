package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.Interval;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.TriangleKernel;

    /**
     * The kernel of a convex shape and a triangle of a solid's surface. The corners of the triangle are counter-clockwise as seen from outside of the
     * solid. So a contact leads out of the solid, and the kernel says how far the shape is behind the triangle's plane too.
     *
     * @private
     */
    public final class SurfaceKernel
    {
        // Points of the core are equally deep if their depths differ by less than this fraction of its extent along the normal.
        private static const SAME_DEPTH:Number = 1e-12;

        private var _kernel:TriangleKernel;

        // The triangle: nine numbers. Its plane is set at the first question.
        private var _corners:Vector.<Number> = null;
        private var _isPlaneSet:Boolean = false;
        private var _plane:TrianglePlane = new TrianglePlane();

        private var _ofShape:Interval = new Interval();

        /** @param kernel has the shape, in the triangles' space; kept */
        public function SurfaceKernel(kernel:TriangleKernel)
        {
            _kernel = kernel;
        }

        /** Sets the triangle: nine numbers. The list is kept. */
        public function setTriangle(corners:Vector.<Number>):void
        {
            _corners = corners;
            _isPlaneSet = false;
        }

        /** The triangle's plane. Read only. */
        public function get plane():TrianglePlane
        {
            preparePlane();
            return _plane;
        }

        /** Whether the shape touches the triangle. */
        public function areTouching():Boolean
        {
            return _kernel.areTouching(_corners, 0);
        }

        /**
         * Finds when the shape first touches the triangle while it moves.
         *
         * @param motion of the shape; its start must be 0. Receives the time, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            _kernel.findTime(_corners, 0, motion);
        }

        /**
         * Finds the contact that leads the shape, which touches the triangle, out of the solid. It is the shortest way away from the triangle. If that
         * leads into the solid, or if the shape comes from the front of the triangle's plane, it is the way out in front of this plane.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the contact
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            _kernel.findContact(_corners, 0, motion, out);
            leadOutside(motion, out);
            preparePlane();
            _plane.turnContact(_kernel.shape, motion, out);
        }

        /**
         * Finds the shortest way of the standing shape away from the triangle, into the solid or out of it, if the two touch.
         *
         * @param out receives the contact
         * @return whether they touch
         */
        public function findOverlap(out:ContactPoint):Boolean
        {
            if (!_kernel.areTouching(_corners, 0))
            {
                return false;
            }
            _kernel.findContact(_corners, 0, RelativeMotion.NONE, out);
            return true;
        }

        /**
         * Finds the closest points of the triangle and the shape, if they are closer than those found before.
         *
         * @param out the points found before; overwritten if these are closer
         * @return whether these are closer
         */
        public function findCloser(out:ClosestPoints):Boolean
        {
            return _kernel.findCloser(_corners, 0, out);
        }

        /**
         * Whether the shape is known to be apart from the triangle until the motion's latest time. A quick test, by the triangle's plane. Make it before
         * the others; they do not, because V8 would then make objects for its Numbers.
         *
         * @param motion of the shape; its start must be 0
         */
        public function stayApart(motion:RelativeMotion):Boolean
        {
            preparePlane();
            var shape:ConvexShape = _kernel.shape;
            var size:Number = shape.extent + Math.abs(shape.x) + Math.abs(shape.y) + Math.abs(shape.z) + Math.abs(_plane.offset)
                + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z);
            var margin:Number = (shape.radius + shape.margin) * Tolerances.OUTER + Tolerances.EXTENTS * size;
            return _plane.findEntry(shape, margin, motion) > motion.latest;
        }

        /**
         * Replaces the shortest way away from the triangle if it leads into the solid. The new contact leads out in front of the triangle's plane.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param contact the shortest way then
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
         * Finds the contact that leads the shape out in front of the triangle's plane. What is behind the plane of a surface's triangle need not touch the
         * triangle.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the depth behind the plane, the triangle's normal, and the middle of the way from the shape's deepest point to the plane.
         *     The depth is negative if the shape is in front of the plane. If the triangle is flat, the normal is 0, and all else is NaN
         */
        public function findBehind(motion:RelativeMotion, out:ContactPoint):void
        {
            preparePlane();
            out.setNormal(_plane.normal.x, _plane.normal.y, _plane.normal.z);
            moveToDeepest(out);
            out.x += motion.startX + motion.time * motion.x;
            out.y += motion.startY + motion.time * motion.y;
            out.z += motion.startZ + motion.time * motion.z;
            out.depth = _plane.offset - (out.normalX * out.x + out.normalY * out.y + out.normalZ * out.z);
            out.x += out.depth / 2 * out.normalX;
            out.y += out.depth / 2 * out.normalY;
            out.z += out.depth / 2 * out.normalZ;
        }

        /** Whether the way out of a contact of <code>findBehind()</code> passes through the triangle, seen along its normal. False if the triangle is flat. */
        public function isThroughTriangle(contact:ContactPoint):Boolean
        {
            var p:Vector.<Number> = _corners;
            var from:int = 6;
            for (var to:int = 0; to < 9; to += 3)
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

        // Moves a contact to the point of the shape that is farthest against the triangle's normal. If there are several, it is their middle.
        private function moveToDeepest(out:ContactPoint):void
        {
            var normal:Vector3D = _plane.normal;
            var shape:ConvexShape = _kernel.shape;
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

        private function preparePlane():void
        {
            if (!_isPlaneSet)
            {
                _isPlaneSet = true;
                _plane.setTriangle(_corners, 0);
            }
        }
    }
}
