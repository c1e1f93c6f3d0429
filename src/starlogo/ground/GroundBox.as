package starlogo.ground
{
    import starlogo.convex.RelativeMotion;

    /**
     * An axis-aligned box, as a record: around a piece of a model, a triangle or a square of the ground, or an agent.
     *
     * @private
     */
    public final class GroundBox
    {
        /** The middle. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Half the lengths. */
        public var halfX:Number = 0;
        public var halfY:Number = 0;
        public var halfZ:Number = 0;

        /** Becomes the same as another box. */
        public function copyFrom(other:GroundBox):void
        {
            x = other.x;
            y = other.y;
            z = other.z;
            halfX = other.halfX;
            halfY = other.halfY;
            halfZ = other.halfZ;
        }

        /** Becomes the box around a triangle, whose corners are nine numbers. */
        public function setToTriangle(corners:Vector.<Number>):void
        {
            var minX:Number = corners[0] < corners[3] ? corners[0] : corners[3];
            var minY:Number = corners[1] < corners[4] ? corners[1] : corners[4];
            var minZ:Number = corners[2] < corners[5] ? corners[2] : corners[5];
            var maxX:Number = corners[0] > corners[3] ? corners[0] : corners[3];
            var maxY:Number = corners[1] > corners[4] ? corners[1] : corners[4];
            var maxZ:Number = corners[2] > corners[5] ? corners[2] : corners[5];
            minX = minX < corners[6] ? minX : corners[6];
            minY = minY < corners[7] ? minY : corners[7];
            minZ = minZ < corners[8] ? minZ : corners[8];
            maxX = maxX > corners[6] ? maxX : corners[6];
            maxY = maxY > corners[7] ? maxY : corners[7];
            maxZ = maxZ > corners[8] ? maxZ : corners[8];
            x = (minX + maxX) / 2;
            y = (minY + maxY) / 2;
            z = (minZ + maxZ) / 2;
            halfX = (maxX - minX) / 2;
            halfY = (maxY - minY) / 2;
            halfZ = (maxZ - minZ) / 2;
        }

        /** Becomes the box around a motion of the box until its latest time. */
        public function extendAlong(motion:RelativeMotion):void
        {
            var half:Number = motion.latestTime / 2;
            x += half * motion.x;
            y += half * motion.y;
            z += half * motion.z;
            halfX += Math.abs(half * motion.x);
            halfY += Math.abs(half * motion.y);
            halfZ += Math.abs(half * motion.z);
        }
    }
}
