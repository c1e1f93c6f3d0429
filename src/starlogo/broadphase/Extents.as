package starlogo.broadphase
{
    /**
     * Columns of axis-aligned extents: the middle and the half lengths of each row, in patches, and the level of bins that fits the row.
     * BinLevels.assign finds the level.
     *
     * @private
     */
    public final class Extents extends Points
    {
        /** The radius of a circle on the ground around the extents. */
        public var radius:Vector.<Number> = new Vector.<Number>();

        /** Half the length along x. */
        public var halfX:Vector.<Number> = new Vector.<Number>();

        /** Half the length along y. */
        public var halfY:Vector.<Number> = new Vector.<Number>();

        /** Half the length along z. */
        public var halfZ:Vector.<Number> = new Vector.<Number>();

        /** The index of the level of bins that fits; 0 if it is not known yet. */
        public var level:Vector.<int> = new Vector.<int>();

        /** How far the middle is from the place that it was computed from. That place is rounded too, and may be farther from the origin. */
        public var offset:Vector.<Number> = new Vector.<Number>();

        /** Makes room for so many rows, which are more than before. New rows are points at the origin without a level. */
        override public function grow(length:int):void
        {
            super.grow(length);
            radius.length = halfX.length = halfY.length = halfZ.length = offset.length = level.length = length;
        }

        /**
         * Whether the extents of two rows overlap, or nearly do. The heights are compared first, because the bins have already compared the
         * circles on the ground.
         *
         * @param slack how far apart they may be
         */
        public function areNear(a:int, b:int, slack:Number):Boolean
        {
            if (!areHeightsNear(a, b, slack))
            {
                return false;
            }
            var distance:Number = x[a] - x[b];
            var maxDistance:Number = halfX[a] + halfX[b] + slack;
            if (distance > maxDistance || distance < -maxDistance)
            {
                return false;
            }
            distance = y[a] - y[b];
            maxDistance = halfY[a] + halfY[b] + slack;
            return distance <= maxDistance && distance >= -maxDistance;
        }

        /** Whether the extents of two rows overlap along z, or nearly do. */
        public function areHeightsNear(a:int, b:int, slack:Number):Boolean
        {
            var distance:Number = z[a] - z[b];
            var maxDistance:Number = halfZ[a] + halfZ[b] + slack;
            return distance <= maxDistance && distance >= -maxDistance;
        }
    }
}
