package starlogo.broadphase
{
    /**
     * The levels of bins. There is one level for each width that extents have needed.
     *
     * @private
     */
    public final class BinLevels
    {
        // A point at the origin has no width, so it gets this one.
        private static const MIN_WIDTH:Number = 1e-300;

        // The levels by number, as extents refer to them. byWidth has them from the coarsest to the finest.
        internal var byNumber:Vector.<BinLevel> = new <BinLevel>[null];
        internal var byWidth:Vector.<BinLevel> = new Vector.<BinLevel>();

        /** Creates an object without levels. */
        public function BinLevels()
        {
        }

        /**
         * Finds the level for a row's extents and its distance from the world's origin.
         *
         * @return whether the level is coarser because of the distance
         */
        public function fit(extents:Extents, row:int):Boolean
        {
            var half:Number = extents.halfX[row];
            var other:Number = extents.halfY[row];
            if (other > half)
            {
                half = other;
            }
            var level:BinLevel = byNumber[extents.level[row]];
            if (level == null || half > level.largestHalf || half <= level.tooSmallHalf)
            {
                level = levelFor(Math.max(2 * half, MIN_WIDTH));
            }
            var middleX:Number = extents.x[row];
            var middleY:Number = extents.y[row];
            var middleZ:Number = extents.z[row];
            var distanceSquared:Number = middleX * middleX + middleY * middleY + middleZ * middleZ;
            var isFar:Boolean = false;
            while (distanceSquared >= level.reachSquared)
            {
                level = levelFor(2 * level.width);
                isFar = true;
            }
            extents.level[row] = level.number;
            return isFar;
        }

        /**
         * The square of the distance that all levels reach. Rows farther out must be fitted again. Levels without members count too,
         * because rows outside the search have levels, and a search of motions uses other levels.
         */
        public function get reachSquared():Number
        {
            return byWidth.length == 0 ? Infinity : byWidth[byWidth.length - 1].reachSquared;
        }

        // The level whose width is the smallest power of two that is at least this large.
        private function levelFor(least:Number):BinLevel
        {
            var width:Number = 1;
            while (width < least)
            {
                width *= 2;
            }
            while (width >= 2 * least)
            {
                width *= 0.5;
            }
            var index:int = 0;
            while (index < byWidth.length && byWidth[index].width > width)
            {
                index++;
            }
            if (index == byWidth.length || byWidth[index].width != width)
            {
                var level:BinLevel = new BinLevel(byNumber.length, width);
                byWidth.splice(index, 0, level);
                byNumber.push(level);
            }
            return byWidth[index];
        }
    }
}
