package starlogo.broadphase
{
    /**
     * Columns of axis-aligned extents: the middle and the half lengths of each row, in patches, and the level of cells that fits them. The first level is
     * the finest, and each further one has cells twice as wide (BinLevel).
     *
     * @private
     */
    public final class Extents extends Points
    {
        /** The radius of a circle around the extents, as seen from above. */
        public var radiusXY:Vector.<Number> = new Vector.<Number>();

        /** Half the length along x. */
        public var halfX:Vector.<Number> = new Vector.<Number>();

        /** Half the length along y. */
        public var halfY:Vector.<Number> = new Vector.<Number>();

        /** Half the length along z. */
        public var halfZ:Vector.<Number> = new Vector.<Number>();

        /** The way to the middle from the place that it was computed from. That place is rounded too, and may be farther from the origin. */
        public var offsets:Points = new Points();

        /** The index of the row's level, from 1 on; 0 if it is not known yet. */
        public var levelIndices:Vector.<int> = new Vector.<int>();

        // By index, for the levels so far: the width that rows may have (BinLevel.width). Cells are a little wider. The first is none.
        internal var levelWidths:Vector.<Number> = new <Number>[0, BinLevel.MIN_WIDTH];

        /** Makes room for so many rows, which are more than before. New rows are points at the origin without a level. */
        override public function grow(length:int):void
        {
            super.grow(length);
            offsets.grow(length);
            radiusXY.length = halfX.length = halfY.length = halfZ.length = levelIndices.length = length;
        }

        /**
         * Whether the extents of two rows overlap, or nearly do. The heights are compared first, because the bins have already compared the
         * circles on the ground.
         *
         * @param slack how far apart they may be
         */
        public function areNear(a:int, b:int, slack:Number):Boolean
        {
            var distance:Number = z[a] - z[b];
            var maxDistance:Number = halfZ[a] + halfZ[b] + slack;
            if (distance > maxDistance || distance < -maxDistance)
            {
                return false;
            }
            distance = x[a] - x[b];
            maxDistance = halfX[a] + halfX[b] + slack;
            if (distance > maxDistance || distance < -maxDistance)
            {
                return false;
            }
            distance = y[a] - y[b];
            maxDistance = halfY[a] + halfY[b] + slack;
            return distance <= maxDistance && distance >= -maxDistance;
        }

        /** Moves the middle of a row's extents with the row's place. */
        public function follow(places:Points, row:int):void
        {
            x[row] = places.x[row] + offsets.x[row];
            y[row] = places.y[row] + offsets.y[row];
            z[row] = places.z[row] + offsets.z[row];
        }

        /** How far the middle of a row's extents is from the row's place. */
        public function distanceFromPlace(row:int):Number
        {
            return Math.sqrt(offsets.squaredLengthOf(row));
        }

        /** Finds the level for a row's extents, and for the distances of their middle from the world's origin and from the row's place. */
        public function assignLevel(row:int):void
        {
            var half:Number = halfX[row];
            var other:Number = halfY[row];
            if (other > half)
            {
                half = other;
            }
            var distanceSquared:Number = Math.max(squaredLengthOf(row), offsets.squaredLengthOf(row));
            var minWidth:Number = Math.max(2 * half, Math.sqrt(distanceSquared) / BinLevel.MAX_DISTANCE);
            levelIndices[row] = finestIndexFor(minWidth, levelIndices[row]);
        }

        // The index of the finest level of at least this width. It looks from an index on, because most rows keep theirs.
        private function finestIndexFor(minWidth:Number, startIndex:int):int
        {
            var index:int = startIndex == 0 ? 1 : startIndex;
            while (index > 1 && levelWidths[index - 1] >= minWidth)
            {
                index--;
            }
            while (levelWidths[index] < minWidth && levelWidths[index] < Infinity)
            {
                if (index + 1 == levelWidths.length)
                {
                    levelWidths.push(2 * levelWidths[index]);
                }
                index++;
            }
            return index;
        }
    }
}
