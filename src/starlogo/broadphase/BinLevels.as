package starlogo.broadphase
{
    import starlogo.data.IntList;

    /**
     * The levels of cells that extents have needed so far: one for each width.
     *
     * @private
     */
    public final class BinLevels
    {
        // The width of the finest level, for points too. It is used up to 256 patches from the origin, so points of SpaceLand need no coarser level.
        // A power of two.
        private static const LEAST_WIDTH:Number = 1 / (1 << 16);

        // The levels by index, as extents refer to them. The first is none. byWidth has them from the coarsest to the finest.
        internal var byIndex:Vector.<BinLevel> = new <BinLevel>[null];
        internal var byWidth:Vector.<BinLevel> = new Vector.<BinLevel>();

        // The number of buckets of all levels, with the copies of first ones.
        internal var bucketCount:int = 0;

        /**
         * Finds the level for a row's extents, and for the distances of their middle from the world's origin and from the row's place.
         *
         * @return whether the level is coarser because of the distance
         */
        public function assign(extents:Extents, row:int):Boolean
        {
            var half:Number = extents.halfX[row];
            var other:Number = extents.halfY[row];
            if (other > half)
            {
                half = other;
            }
            var level:BinLevel = byIndex[extents.level[row]];
            var middleX:Number = extents.x[row];
            var middleY:Number = extents.y[row];
            var middleZ:Number = extents.z[row];
            var offset:Number = extents.offset[row];
            var distanceSquared:Number = Math.max(middleX * middleX + middleY * middleY + middleZ * middleZ, offset * offset);
            if (level != null && 2 * half <= level.width && (4 * half > level.width || level.width == LEAST_WIDTH) && distanceSquared < level.maxDistanceSquared)
            {
                return false;
            }
            var width:Number = widthFor(2 * half);
            var distant:Number = widthFor(Math.sqrt(distanceSquared) / BinLevel.MAX_DISTANCE);
            extents.level[row] = levelOf(Math.max(width, distant)).index;
            return distant > width;
        }

        /**
         * The square of the distance up to which all levels can be used. Rows farther out must be assigned a level again. Levels without
         * members count too, because rows outside the search have levels, and a search of motions uses other levels.
         */
        public function get maxDistanceSquared():Number
        {
            return byWidth.length == 0 ? Infinity : byWidth[byWidth.length - 1].maxDistanceSquared;
        }

        /**
         * Counts the members of each level in a search of the bins, and gives each level with members its buckets.
         *
         * @param indices by row: the index of its level
         * @param members the rows of the members
         */
        internal function layOut(indices:Vector.<int>, members:IntList):void
        {
            countMembers(indices, members);
            bucketCount = 0;
            for (var i:int = 0; i < byWidth.length; i++)
            {
                var level:BinLevel = byWidth[i];
                if (level.count > 0)
                {
                    bucketCount = level.takeBuckets(bucketCount);
                }
                else
                {
                    level.dropBuckets();
                }
            }
        }

        // Counts the members of each level.
        private function countMembers(indices:Vector.<int>, members:IntList):void
        {
            var rows:Vector.<int> = members.numbers;
            var end:int = members.count;
            var all:Vector.<BinLevel> = byIndex;
            if (all.length == 2)
            {
                all[1].count = end;
                return;
            }
            for (var i:int = 1; i < all.length; i++)
            {
                all[i].count = 0;
            }
            // A long loop is the last thing of its method. V8 does not optimise what it has not seen run, so code after the loop would end
            // the optimised method in every frame.
            for (i = 0; i < end; i++)
            {
                all[indices[rows[i]]].count++;
            }
        }

        // The smallest power of two that is at least this large, and not less than LEAST_WIDTH.
        private static function widthFor(least:Number):Number
        {
            var width:Number = LEAST_WIDTH;
            while (width < least && width < Infinity)
            {
                width *= 2;
            }
            return width;
        }

        // The level of a width, which is a power of two.
        private function levelOf(width:Number):BinLevel
        {
            var index:int = 0;
            while (index < byWidth.length && byWidth[index].width > width)
            {
                index++;
            }
            if (index == byWidth.length || byWidth[index].width != width)
            {
                var level:BinLevel = new BinLevel(byIndex.length, width);
                byWidth.splice(index, 0, level);
                byIndex.push(level);
            }
            return byWidth[index];
        }
    }
}
