package starlogo.convex
{
    import flash.geom.Vector3D;

    /**
     * How two shapes a and b touch or overlap, as a record: the point, the normal and the depth.
     *
     * @private
     */
    public final class ContactPoint
    {
        /** The middle of the overlap, in the shapes' space. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** The direction that separates a from b: a unit vector. */
        public var normalX:Number = 0;
        public var normalY:Number = 0;
        public var normalZ:Number = 1;

        /** The length of the overlap along the normal: 0 if the shapes just touch. */
        public var depth:Number = 0;

        /**
         * The number of the tree's triangle if one of a and b is a tree, the other a structure, and this triangle decides. -1 if none does. Tests of
         * trees and of rays write it after a kernel has found the contact.
         */
        public var triangle:int = -1;

        /**
         * Whether the deepest point is known to be a point of a, so that it has to get out of b. Tests of the ground write it and the bound after a kernel
         * has found the contact. It counts until the two are separated.
         */
        public var isDeepestOfA:Boolean = false;

        /** If so, no exit of the deepest point from b is shorter: a length. 0 if no bound is known. */
        public var exitBound:Number = 0;

        /** Becomes the same as another contact. */
        public function copyFrom(other:ContactPoint):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            normalX = other.normalX;
            normalY = other.normalY;
            normalZ = other.normalZ;
            depth = other.depth;
            triangle = other.triangle;
            isDeepestOfA = other.isDeepestOfA;
            exitBound = other.exitBound;
        }

        /** Writes the deepest point. The contact's point is the middle of the overlap, so it is half of the depth behind that one. */
        public function writeDeepestPoint(out:Vector3D):void
        {
            var back:Number = depth / 2;
            out.x = x - back * normalX;
            out.y = y - back * normalY;
            out.z = z - back * normalZ;
        }

        /** Makes all unknown that a kernel does not find: the triangle, and whether the deepest point is one of a. Each kernel begins with it. */
        public function forget():void
        {
            triangle = -1;
            forgetDeepest();
        }

        /** Makes the deepest point unknown: it need not be a point of a. */
        public function forgetDeepest():void
        {
            isDeepestOfA = false;
            exitBound = 0;
        }

        /**
         * Turns the contact of b and a into that of a and b. The normal separates a then.
         *
         * @param motion the motion of a; a is where it is at the motion's time
         */
        public function swap(motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            x += motion.startX + time * motion.x;
            y += motion.startY + time * motion.y;
            z += motion.startZ + time * motion.z;
            normalX = -normalX;
            normalY = -normalY;
            normalZ = -normalZ;
        }

        /**
         * Sets the contact of two shapes whose cores are apart, or are two points.
         *
         * @param gap the gap between the cores, and the radii. If its length is 0, the normal points upwards
         * @param motion the motion of a; a is where it is at the motion's time
         */
        public function setFromGap(gap:CoreGap, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            var length:Number = Math.sqrt(gap.x * gap.x + gap.y * gap.y + gap.z * gap.z);
            normalX = length > 0 ? gap.x / length : 0;
            normalY = length > 0 ? gap.y / length : 0;
            normalZ = length > 0 ? gap.z / length : 1;
            depth = gap.radiusA + gap.radiusB - length;
            // rounding can make it negative
            depth = depth > 0 ? depth : 0;
            forget();
            var back:Number = gap.radiusA - depth / 2;
            x = gap.point.x + (motion.startX + time * motion.x) - back * normalX;
            y = gap.point.y + (motion.startY + time * motion.y) - back * normalY;
            z = gap.point.z + (motion.startZ + time * motion.z) - back * normalZ;
        }

        /** Sets the normal without normalising it. The function is short so that V8 inlines it and allocates no objects for the Numbers. */
        public function setNormal(x:Number, y:Number, z:Number):void
        {
            normalX = x;
            normalY = y;
            normalZ = z;
        }

        /** Makes the normal a unit vector. Its length must not be 0. */
        public function normalise():void
        {
            var length:Number = Math.sqrt(normalX * normalX + normalY * normalY + normalZ * normalZ);
            normalX /= length;
            normalY /= length;
            normalZ /= length;
        }

        /** The component of a vector along the normal. */
        public function along(vector:Vector3D):Number
        {
            return normalX * vector.x + normalY * vector.y + normalZ * vector.z;
        }

        /** Moves a point along the normal. */
        public function movePoint(point:Vector3D, by:Number):void
        {
            point.x += by * normalX;
            point.y += by * normalY;
            point.z += by * normalZ;
        }

        /** Sets the normal to the opposite of the motion's direction. */
        public function setNormalAgainst(motion:RelativeMotion):void
        {
            setNormal(-motion.x, -motion.y, -motion.z);
            normalise();
        }
    }
}
