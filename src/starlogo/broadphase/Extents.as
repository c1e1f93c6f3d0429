package starlogo.broadphase
{
    import starlogo.data.IntList;

    /**
     * Columns of axis-aligned extents: the middle and the half lengths of each row, in patches. Each row has the level of cells that fits its extents.
     * There is a level for each width that rows have needed so far.
     *
     * @private
     */
    public final class Extents extends Points
    {
        // The width of the finest level, for points too. It is used up to 256 patches from the origin, so points of SpaceLand need no coarser level.
        // A power of two.
        private static const LEAST_WIDTH:Number = 1 / (1 << 16);

        /** The radius of a circle on the ground around the extents. */
        public var radius:Vector.<Number> = new Vector.<Number>();

        /** Half the length along x. */
        public var halfX:Vector.<Number> = new Vector.<Number>();

        /** Half the length along y. */
        public var halfY:Vector.<Number> = new Vector.<Number>();

        /** Half the length along z. */
        public var halfZ:Vector.<Number> = new Vector.<Number>();

        /** How far the middle is from the place that it was computed from. That place is rounded too, and may be farther from the origin. */
        public var offset:Vector.<Number> = new Vector.<Number>();

        /** The index of the row's level; 0 if it is not known yet. */
        public var level:Vector.<int> = new Vector.<int>();

        // The levels by index. The first is none. byWidth has them from the coarsest to the finest.
        internal var byIndex:Vector.<BinLevel> = new <BinLevel>[null];
        internal var byWidth:Vector.<BinLevel> = new Vector.<BinLevel>();

        // The number of buckets of all levels, with the copies of first ones.
        internal var bucketCount:int = 0;

        // Whether a row ever had a coarser level because it was far out. From then on each row that moves is assigned a level, so it gets a finer one
        // when it comes back.
        private var _wasOneFarOut:Boolean = false;

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

        /** Finds the level for a row's extents, and for the distances of their middle from the world's origin and from the row's place. */
        public function assignLevel(row:int):void
        {
            var half:Number = halfX[row];
            var other:Number = halfY[row];
            if (other > half)
            {
                half = other;
            }
            var present:BinLevel = byIndex[level[row]];
            var middleX:Number = x[row];
            var middleY:Number = y[row];
            var middleZ:Number = z[row];
            var fromPlace:Number = offset[row];
            var distanceSquared:Number = Math.max(middleX * middleX + middleY * middleY + middleZ * middleZ, fromPlace * fromPlace);
            if (present != null && 2 * half <= present.width && (4 * half > present.width || present.width == LEAST_WIDTH)
                    && distanceSquared < present.maxDistanceSquared)
            {
                return;
            }
            var width:Number = widthFor(2 * half);
            var distant:Number = widthFor(Math.sqrt(distanceSquared) / BinLevel.MAX_DISTANCE);
            level[row] = levelOf(Math.max(width, distant)).index;
            _wasOneFarOut ||= distant > width;
        }

        /**
         * The square of the distance from the world's origin up to which each row keeps its level when it moves. Levels without members count too,
         * because rows outside the search have levels.
         */
        public function get levelsEndSquared():Number
        {
            if (_wasOneFarOut)
            {
                return 0;
            }
            return byWidth.length == 0 ? Infinity : byWidth[byWidth.length - 1].maxDistanceSquared;
        }

        /**
         * Counts the members of each level in a search of the bins, and gives each level with members its buckets.
         *
         * @param members the rows of the members
         */
        internal function layOut(members:IntList):void
        {
            countMembers(members);
            bucketCount = 0;
            for (var i:int = 0; i < byWidth.length; i++)
            {
                var next:BinLevel = byWidth[i];
                if (next.count > 0)
                {
                    bucketCount = next.takeBuckets(bucketCount);
                }
                else
                {
                    next.dropBuckets();
                }
            }
        }

        // Counts the members of each level.
        private function countMembers(members:IntList):void
        {
            var rows:Vector.<int> = members.numbers;
            var end:int = members.count;
            var all:Vector.<BinLevel> = byIndex;
            var indices:Vector.<int> = level;
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
                var added:BinLevel = new BinLevel(byIndex.length, width);
                byWidth.splice(index, 0, added);
                byIndex.push(added);
            }
            return byWidth[index];
        }
    }
}
