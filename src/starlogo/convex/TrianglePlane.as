package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * The plane of a triangle: a quick test by it, and contacts whose normal is the plane's. Its fields are read only, but for the cull distance.
     *
     * <p>This class alone decides which triangles are flat: needles and points, whose normal would be a rounding error (Tolerances.FLAT_TRIANGLE). A
     * flat triangle has no plane. Its normal is 0 and its offset NaN, so all comparisons with places along the normal are false. ConvexKernel makes no
     * difference: to it a triangle is the hull of its corners, however narrow that is.</p>
     *
     * @private
     */
    public final class TrianglePlane
    {
        // Points of a core are equally deep if their depths differ by less than this fraction of its extent along the normal.
        private static const SAME_DEPTH:Number = 1e-12;

        /** The unit normal. It points to the side from which the corners are counter-clockwise. 0 if the triangle is flat. */
        public var normal:Vector3D = new Vector3D();

        /** Where the plane is: the component of its points along the normal. NaN if the triangle is flat. */
        public var offset:Number = NaN;

        /** The least and the greatest component of a corner along the normal. They differ only by rounding. */
        public var min:Number = NaN;
        public var max:Number = NaN;

        /** Twice the triangle's area. */
        public var doubleArea:Number = 0;

        /**
         * How far from the plane a shape's core may be if it touches the triangle, with all that is rounded. Callers of timeOfEntry() write it. It is a
         * field, because V8 makes an object of a Number that is passed.
         */
        public var cullDistance:Number = 0;

        // How far the last shape's core extends along the normal, relative to the shape's origin.
        private var _ofShape:Interval = new Interval();

        /** Whether the triangle is flat. */
        public function get isFlat():Boolean
        {
            return isNaN(offset);
        }

        /** Sets it to the plane of a triangle: nine numbers of a list, from an index on. */
        public function setTriangle(corners:Vector.<Number>, at:int):void
        {
            var ux:Number = corners[int(at + 3)] - corners[at];
            var uy:Number = corners[int(at + 4)] - corners[int(at + 1)];
            var uz:Number = corners[int(at + 5)] - corners[int(at + 2)];
            var vx:Number = corners[int(at + 6)] - corners[at];
            var vy:Number = corners[int(at + 7)] - corners[int(at + 1)];
            var vz:Number = corners[int(at + 8)] - corners[int(at + 2)];
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var squaredLongest:Number = (ux - vx) * (ux - vx) + (uy - vy) * (uy - vy) + (uz - vz) * (uz - vz);
            squaredLongest = squaredLongest > uu ? squaredLongest : uu;
            squaredLongest = squaredLongest > vv ? squaredLongest : vv;
            var x:Number = uy * vz - uz * vy;
            var y:Number = uz * vx - ux * vz;
            var z:Number = ux * vy - uy * vx;
            doubleArea = Math.sqrt(x * x + y * y + z * z);
            // the height over the longest edge is the double area divided by that edge
            if (!(doubleArea * doubleArea > Tolerances.FLAT_TRIANGLE * squaredLongest * squaredLongest))
            {
                normal.setTo(0, 0, 0);
                offset = min = max = NaN;
                return;
            }
            x /= doubleArea;
            y /= doubleArea;
            z /= doubleArea;
            normal.x = x;
            normal.y = y;
            normal.z = z;
            var first:Number = x * corners[at] + y * corners[int(at + 1)] + z * corners[int(at + 2)];
            var second:Number = x * corners[int(at + 3)] + y * corners[int(at + 4)] + z * corners[int(at + 5)];
            var third:Number = x * corners[int(at + 6)] + y * corners[int(at + 7)] + z * corners[int(at + 8)];
            var least:Number = first < second ? first : second;
            var most:Number = first > second ? first : second;
            offset = first;
            min = least < third ? least : third;
            max = most > third ? most : third;
        }

        /**
         * Finds when a moving shape can first touch the triangle, as far as the plane knows: when the shape comes to the plane. A quick test: the shape
         * is apart from the triangle until then.
         *
         * @param shape where it is at time 0
         * @param motion its vector; nothing else of it counts
         * @return at least 0. 0 for a flat triangle too. RelativeMotion.NEVER if the shape moves away from the plane or beside it
         */
        public function timeOfEntry(shape:ConvexShape, motion:RelativeMotion):Number
        {
            shape.project(normal, _ofShape);
            var projection:Number = normal.x * shape.origin.x + normal.y * shape.origin.y + normal.z * shape.origin.z;
            var speed:Number = normal.x * motion.x + normal.y * motion.y + normal.z * motion.z;
            // how far in front of the plane all of the shape is, and how far behind
            var above:Number = projection - max + _ofShape.min - cullDistance;
            var below:Number = -(projection - min + _ofShape.max + cullDistance);
            return above > 0 ? (speed < 0 ? above / -speed : RelativeMotion.NEVER)
                : below > 0 ? (speed > 0 ? below / speed : RelativeMotion.NEVER) : 0;
        }

        /**
         * Whether a moving shape stays apart from the triangle until the motion's latest time, as far as the plane knows: timeOfEntry() with a distance
         * that covers all that is rounded. Overwrites cullDistance. Of one plane, use either this or timeOfEntry().
         *
         * @param motion its vector and its latest time; nothing else of it counts
         */
        public function areApart(shape:ConvexShape, motion:RelativeMotion):Boolean
        {
            var size:Number = shape.boundingRadius + Math.abs(shape.origin.x) + Math.abs(shape.origin.y) + Math.abs(shape.origin.z) + Math.abs(offset)
                + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z);
            cullDistance = (shape.radius + shape.margin) * Tolerances.OUTER + Tolerances.EXTENTS * size;
            return timeOfEntry(shape, motion) > motion.latestTime;
        }

        /**
         * Turns a contact of a shape and the triangle to the plane's normal, if the shape comes against the plane and is no deeper behind it. An edge of
         * the shape may lie along an edge of the triangle. Then a face of the shape separates the two as well, but not the shape from the next triangle
         * of the surface.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param contact has the depth; receives the normal
         */
        public function alignContact(shape:ConvexShape, motion:RelativeMotion, contact:ContactPoint):void
        {
            if (isHitFromFront(shape, shape.margin, motion, contact))
            {
                contact.setNormal(normal.x, normal.y, normal.z);
            }
        }

        /**
         * Whether a shape that touches the triangle comes against the plane, and is no deeper behind it than in their contact.
         *
         * @param depthTolerance how much deeper it may be, because it is rounded
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param contact has the depth
         */
        public function isHitFromFront(shape:ConvexShape, depthTolerance:Number, motion:RelativeMotion, contact:ContactPoint):Boolean
        {
            var speed:Number = normal.x * motion.x + normal.y * motion.y + normal.z * motion.z;
            if (!(speed < 0))
            {
                return false;
            }
            shape.project(normal, _ofShape);
            var front:Number = normal.x * (shape.origin.x + motion.startX) + normal.y * (shape.origin.y + motion.startY) + normal.z * (shape.origin.z + motion.startZ)
                + motion.time * speed + _ofShape.min - shape.radius;
            return offset - front <= contact.depth + depthTolerance;
        }

        /**
         * Finds the contact that leads a shape out in front of the plane. A shape behind the plane need not touch the triangle.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param out receives the depth behind the plane, the plane's normal, and the middle of the way from the shape's deepest point to the plane.
         *     The depth is negative if the shape is in front of the plane. If the triangle is flat, the normal is 0, and all else is NaN
         */
        public function findBehind(shape:ConvexShape, motion:RelativeMotion, out:ContactPoint):void
        {
            shape.project(normal, _ofShape);
            out.setNormal(normal.x, normal.y, normal.z);
            moveToDeepest(shape, out);
            out.x += motion.startX + motion.time * motion.x;
            out.y += motion.startY + motion.time * motion.y;
            out.z += motion.startZ + motion.time * motion.z;
            out.depth = offset - (out.normalX * out.x + out.normalY * out.y + out.normalZ * out.z);
            out.x += out.depth / 2 * out.normalX;
            out.y += out.depth / 2 * out.normalY;
            out.z += out.depth / 2 * out.normalZ;
        }

        /**
         * Replaces a contact that leads behind the plane of a solid's surface, into the solid. The new contact leads out in front of the plane.
         *
         * @param motion of the shape; the shape is where it is at the motion's time
         * @param contact the shortest way away from the triangle then
         */
        public function leadOutside(shape:ConvexShape, motion:RelativeMotion, contact:ContactPoint):void
        {
            // Where a moving shape first touches a sharp edge, the normal may point behind one of the edge's faces.
            var isFirstTouch:Boolean = motion.time > 0
                && contact.normalX * motion.x + contact.normalY * motion.y + contact.normalZ * motion.z < 0;
            if (!isFirstTouch && contact.along(normal) < -Tolerances.DIRECTION)
            {
                findBehind(shape, motion, contact);
            }
        }

        // Moves a contact to the point of the shape that is farthest against the normal, or to the middle of several. The shape is projected on the normal
        // (_ofShape).
        private function moveToDeepest(shape:ConvexShape, out:ContactPoint):void
        {
            var p:Vector.<Number> = shape.points;
            var end:int = shape.pointsEnd;
            var most:Number = _ofShape.min + SAME_DEPTH * (_ofShape.max - _ofShape.min);
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
            out.x = shape.origin.x + x / count - shape.radius * normal.x;
            out.y = shape.origin.y + y / count - shape.radius * normal.y;
            out.z = shape.origin.z + z / count - shape.radius * normal.z;
        }
    }
}
