package starlogo.broadphase
{
    /**
     * The members of a search in the order of their cells. A member's index in this order is its slot. A counting sort finds it.
     *
     * @private
     */
    internal final class SortedMembers
    {
        /** So many first buckets of a level are copied after its last one, so that the neighbours of the last cells are in one run too. */
        internal static const COPIED:int = 2;

        /** By slot: the member's row. */
        internal var rows:Vector.<int> = new Vector.<int>();

        /** By slot: the middle of the member. */
        internal var xs:Vector.<Number> = new Vector.<Number>();
        internal var ys:Vector.<Number> = new Vector.<Number>();

        /** By slot: the radius of the member's circle. */
        internal var radii:Vector.<Number> = new Vector.<Number>();

        /** By bucket: the slot of its first member, which is the slot after the last member of the bucket before. */
        internal var starts:Vector.<int> = new Vector.<int>();

        // By bucket: the number of its members, which is 0 between searches. By member: its bucket.
        private var _counts:Vector.<int> = new Vector.<int>();
        private var _buckets:Vector.<int> = new Vector.<int>();

        private var _levels:BinLevels;

        /** @param levels the levels of the cells */
        public function SortedMembers(levels:BinLevels)
        {
            _levels = levels;
        }

        /** Sorts the members of a search. The parameters are those of <code>Bins.findPairs()</code>. */
        public function sort(extents:Extents, members:Vector.<int>, count:int):void
        {
            countMembers(extents.level, members, count);
            var bucketCount:int = layOutBuckets(count);
            fillBuckets(extents, members, count);
            var slots:int = findStarts(bucketCount);
            if (slots > rows.length)
            {
                rows.length = xs.length = ys.length = radii.length = slots;
            }
            sortByBuckets(members, count);
            copyFirstBuckets();
            copyCircles(extents, slots);
        }

        // Counts the members of each level. indices: by row, the index of its level.
        private function countMembers(indices:Vector.<int>, members:Vector.<int>, count:int):void
        {
            var all:Vector.<BinLevel> = _levels.byIndex;
            if (all.length == 2)
            {
                all[1].count = count;
                return;
            }
            for (var i:int = 1; i < all.length; i++)
            {
                all[i].count = 0;
            }
            // A long loop is the last thing of its method. V8 does not optimise what it has not seen run, so code after the loop would end
            // the optimised method in every frame.
            for (i = 0; i < count; i++)
            {
                all[indices[members[i]]].count++;
            }
        }

        // Gives the levels their buckets. Returns the number of buckets.
        private function layOutBuckets(count:int):int
        {
            var bucketCount:int = 0;
            var byWidth:Vector.<BinLevel> = _levels.byWidth;
            for (var i:int = 0; i < byWidth.length; i++)
            {
                if (byWidth[i].count > 0)
                {
                    bucketCount = byWidth[i].takeBuckets(bucketCount);
                }
            }
            if (bucketCount > _counts.length)
            {
                _counts.length = bucketCount;
                starts.length = bucketCount + 1;
            }
            if (count > _buckets.length)
            {
                _buckets.length = count;
            }
            return bucketCount;
        }

        // Finds each member's bucket. Counts the members of the buckets.
        private function fillBuckets(extents:Extents, members:Vector.<int>, count:int):void
        {
            var fromX:Vector.<Number> = extents.x;
            var fromY:Vector.<Number> = extents.y;
            var indices:Vector.<int> = extents.level;
            var buckets:Vector.<int> = _buckets;
            var counts:Vector.<int> = _counts;
            var index:int = 0;
            var cellsPerPatch:Number = 0;
            var mask:int = 0;
            var stride:int = 0;
            var first:int = 0;
            var copies:int = 0;
            var byIndex:Vector.<BinLevel> = _levels.byIndex;
            var bias:Number = BinLevel.BIAS;
            for (var i:int = 0; i < count; i++)
            {
                var row:int = members[i];
                if (indices[row] != index)
                {
                    index = indices[row];
                    var level:BinLevel = byIndex[index];
                    cellsPerPatch = level.cellsPerPatch;
                    mask = level.mask;
                    stride = level.stride;
                    first = level.firstBucket;
                    copies = level.endBucket;
                }
                // BinLevel.bucketAt() as a loop. CellLists relies on the same buckets
                var column:int = fromX[row] * cellsPerPatch + bias;
                var line:int = fromY[row] * cellsPerPatch + bias;
                var bucket:int = ((line & mask) * stride + column) & mask;
                if (bucket < COPIED)
                {
                    counts[int(copies + bucket)]++;
                }
                bucket += first;
                buckets[i] = bucket;
                counts[bucket]++;
            }
        }

        // Computes the slot where each bucket starts, and stores it one place further on: while the bucket is filled, its next free slot is there. When it
        // is full, that is the slot where the next bucket starts. Returns the number of slots.
        private function findStarts(bucketCount:int):int
        {
            var counts:Vector.<int> = _counts;
            var begins:Vector.<int> = starts;
            var sum:int = 0;
            for (var i:int = 0; i < bucketCount; i++)
            {
                var inBucket:int = counts[i];
                counts[i] = 0;
                begins[i + 1] = sum;
                sum += inBucket;
            }
            return sum;
        }

        private function sortByBuckets(members:Vector.<int>, count:int):void
        {
            var toRow:Vector.<int> = rows;
            var buckets:Vector.<int> = _buckets;
            var begins:Vector.<int> = starts;
            for (var i:int = 0; i < count; i++)
            {
                var next:int = buckets[i] + 1;
                var slot:int = begins[next];
                toRow[slot] = members[i];
                begins[next] = slot + 1;
            }
        }

        // Lists the members of the first buckets of each level after its last bucket once more.
        private function copyFirstBuckets():void
        {
            var byWidth:Vector.<BinLevel> = _levels.byWidth;
            for (var i:int = 0; i < byWidth.length; i++)
            {
                if (byWidth[i].count > 0)
                {
                    copyFirstBucketsOf(byWidth[i]);
                }
            }
        }

        private function copyFirstBucketsOf(level:BinLevel):void
        {
            var first:int = level.firstBucket;
            var copies:int = level.endBucket;
            var offset:int = starts[copies] - starts[first];
            for (var i:int = 1; i <= COPIED; i++)
            {
                starts[copies + i] = offset + starts[first + i];
            }
            for (var slot:int = starts[copies]; slot < starts[copies + COPIED]; slot++)
            {
                rows[slot] = rows[slot - offset];
            }
        }

        // Copies the circles of all members. The reads are scattered in memory and the writes are in order. The reverse would be slower.
        private function copyCircles(extents:Extents, slots:int):void
        {
            var fromX:Vector.<Number> = extents.x;
            var fromY:Vector.<Number> = extents.y;
            var fromRadius:Vector.<Number> = extents.radius;
            var bySlot:Vector.<int> = rows;
            var toX:Vector.<Number> = xs;
            var toY:Vector.<Number> = ys;
            var toRadius:Vector.<Number> = radii;
            for (var slot:int = 0; slot < slots; slot++)
            {
                var row:int = bySlot[slot];
                toX[slot] = fromX[row];
                toY[slot] = fromY[row];
                toRadius[slot] = fromRadius[row];
            }
        }
    }
}
