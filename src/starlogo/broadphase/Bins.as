// This room finds which agents are near each other on the ground plane, as rows of a table. Bins sort the rows by their cells, and find all
// pairs of rows, or the rows near one. Extents have the boxes of the rows; a BinLevel has the cells of one width. Read this file first, then BinLevel.
package starlogo.broadphase
{
    import starlogo.data.IntList;
    import starlogo.data.IntSet;
    import starlogo.data.makeRoom;

    /**
     * The broad phase: finds the pairs of agents that are near each other on the ground (thesis §3.7). More exactly: all pairs of rows
     * whose extents overlap, and some others whose circles on the ground do.
     *
     * <p>The rows of a search are its members. A member has a slot, which is its index in the order of the cells.</p>
     *
     * <p>A member is in one cell: the cell of its middle. A cell is wider than every member of its level. It is at most about twice as wide,
     * except for the smallest members and for those far from the origin. So if two members of a level overlap, they are in the same cell or in
     * neighbouring cells. A counting sort puts the members into the order of their cells, with copies of the data that the search reads. So
     * members that are near on the ground are near in memory. The members of a cell are tested against two runs of slots. The first run is the rest
     * of the cell and its right neighbour. The second run is three cells of the next line. So each pair is found from one cell only.</p>
     *
     * <p>Members of different sizes are in different levels of a hierarchical grid (Ericson, Real-Time Collision Detection, §7.2). The
     * widths of the levels are powers of two. A member is also tested against the cells of the coarser levels, which contain the larger
     * members. Cells are hashed into buckets. The number of buckets depends on the number of members, not on the size of the world. Cells
     * far from each other may share a bucket, which only costs time. Cells that one pair can reach never share one.</p>
     *
     * <p>The bins do not know how the pairs are used. The time of a search is proportional to the number of members and overlapping pairs, the memory
     * to the number of members. After the first search nothing is allocated.</p>
     *
     * @private
     */
    public final class Bins
    {
        // The levels of cells by their indices, from the finest to the coarsest that was needed so far. The first is none.
        private var _levels:Vector.<BinLevel> = new <BinLevel>[null];

        // By slot: the member's row, its middle, and the radius of its circle.
        private var _rows:Vector.<int> = new Vector.<int>();
        private var _xs:Vector.<Number> = new Vector.<Number>();
        private var _ys:Vector.<Number> = new Vector.<Number>();
        private var _radii:Vector.<Number> = new Vector.<Number>();

        // By bucket: the slot of its first member, which is the slot after the last member of the bucket before.
        private var _starts:Vector.<int> = new Vector.<int>();

        // By bucket: the number of its members, which is 0 between searches.
        private var _counts:Vector.<int> = new Vector.<int>();

        // By member: its bucket.
        private var _buckets:Vector.<int> = new Vector.<int>();

        // The rows of the candidates of the present member, and those that findNear() has kept.
        private var _candidates:Vector.<int> = new Vector.<int>();
        private var _kept:IntSet = new IntSet();

        /**
         * Finds all pairs whose extents overlap, and some others that are as near. Each pair is passed to the sink once.
         *
         * @param extents each has its level
         * @param members the rows of the members
         * @param sink takes the pairs
         */
        public function findPairs(extents:Extents, members:IntList, sink:PairSink):void
        {
            sortIntoCells(extents, members);
            for (var i:int = 1; i < _levels.length; i++)
            {
                var level:BinLevel = _levels[i];
                if (!level.hasBuckets)
                {
                    continue;
                }
                for (var coarser:int = i + 1; coarser < _levels.length; coarser++)
                {
                    if (_levels[coarser].hasBuckets)
                    {
                        findPairsBetween(level, _levels[coarser], sink);
                    }
                }
                findPairsWithin(level, sink);
            }
        }

        /**
         * Finds the members that are near a row now, level by level, and passes them to the sink. The row need not be a member.
         *
         * @param leftOut members that are left out. The extents of all others are still the ones that the bins have sorted
         */
        public function findNear(row:int, extents:Extents, leftOut:IntSet, sink:PairSink):void
        {
            if (extents.levelIndices[row] >= _levels.length)
            {
                makeLevels(extents);
            }
            var own:BinLevel = _levels[extents.levelIndices[row]];
            // the slot behind those of all members
            var slot:int = _rows.length - 1;
            _xs[slot] = extents.x[row];
            _ys[slot] = extents.y[row];
            _radii[slot] = extents.radiusXY[row];
            for (var i:int = 1; i < _levels.length; i++)
            {
                var level:BinLevel = _levels[i];
                if (level.hasBuckets)
                {
                    var found:int = keepEach(collectNear(slot, own, level), leftOut, extents.x.length);
                    if (found > 0)
                    {
                        sink.onCandidates(row, _candidates, found, level.coarserOf(own));
                    }
                }
            }
        }

        // Keeps the candidates that are not left out, each once.
        private function keepEach(count:int, leftOut:IntSet, rowCount:int):int
        {
            var kept:int = 0;
            _kept.clear(rowCount);
            for (var i:int = 0; i < count; i++)
            {
                var other:int = _candidates[i];
                if (!leftOut.has(other) && _kept.add(other))
                {
                    _candidates[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /** Puts the members into the order of their cells, by a counting sort. */
        public function sortIntoCells(extents:Extents, members:IntList):void
        {
            countMembers(extents, members);
            var bucketCount:int = layOutBuckets();
            makeRoom(_buckets, members.count);
            fillBuckets(extents, members);
            var slots:int = findStarts(bucketCount);
            if (slots >= _rows.length)
            {
                // with one more, for findNear()
                _rows.length = _xs.length = _ys.length = _radii.length = slots + 1;
            }
            sortByBuckets(members);
            copyFirstBuckets();
            copyCircles(extents, slots);
        }

        // Makes the levels that the extents have needed so far.
        private function makeLevels(extents:Extents):void
        {
            while (_levels.length < extents.levelWidths.length)
            {
                _levels.push(new BinLevel(extents.levelWidths[_levels.length]));
            }
        }

        // Counts the members of each level.
        private function countMembers(extents:Extents, members:IntList):void
        {
            var rows:Vector.<int> = members.values;
            var end:int = members.count;
            var indices:Vector.<int> = extents.levelIndices;
            var all:Vector.<BinLevel> = _levels;
            makeLevels(extents);
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

        // Gives each level its buckets, and makes room for them. Returns the number of all buckets, with the copies of first ones.
        private function layOutBuckets():int
        {
            var bucketCount:int = 0;
            for (var i:int = 1; i < _levels.length; i++)
            {
                bucketCount = _levels[i].layOutBuckets(bucketCount);
            }
            makeRoom(_counts, bucketCount);
            makeRoom(_starts, bucketCount + 1);
            return bucketCount;
        }

        // Finds each member's bucket. Counts the members of the buckets.
        private function fillBuckets(extents:Extents, members:IntList):void
        {
            var rows:Vector.<int> = members.values;
            var end:int = members.count;
            var fromX:Vector.<Number> = extents.x;
            var fromY:Vector.<Number> = extents.y;
            var indices:Vector.<int> = extents.levelIndices;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = rows[i];
                var level:BinLevel = _levels[indices[row]];
                var bucket:int = level.bucketAt(fromX[row], fromY[row]);
                if (bucket < level.firstBucket + BinLevel.COPIED)
                {
                    _counts[int(bucket + level.mask + 1)]++;
                }
                _buckets[i] = bucket;
                _counts[bucket]++;
            }
        }

        // Computes the slot where each bucket starts, and stores it one place further on. sortByBuckets() fills the buckets and counts it up to the slot
        // where the next bucket starts, which is what belongs there. Returns the number of slots.
        private function findStarts(bucketCount:int):int
        {
            var counts:Vector.<int> = _counts;
            var starts:Vector.<int> = _starts;
            var sum:int = 0;
            starts[0] = 0;
            for (var i:int = 0; i < bucketCount; i++)
            {
                var inBucket:int = counts[i];
                counts[i] = 0;
                starts[i + 1] = sum;
                sum += inBucket;
            }
            return sum;
        }

        private function sortByBuckets(members:IntList):void
        {
            var fromRow:Vector.<int> = members.values;
            var toRow:Vector.<int> = _rows;
            var buckets:Vector.<int> = _buckets;
            var starts:Vector.<int> = _starts;
            var end:int = members.count;
            for (var i:int = 0; i < end; i++)
            {
                var next:int = buckets[i] + 1;
                var slot:int = starts[next];
                toRow[slot] = fromRow[i];
                starts[next] = slot + 1;
            }
        }

        // Lists the members of the first buckets of each level after its last bucket once more.
        private function copyFirstBuckets():void
        {
            for (var i:int = 1; i < _levels.length; i++)
            {
                var level:BinLevel = _levels[i];
                if (!level.hasBuckets)
                {
                    continue;
                }
                var copies:int = level.endBucket;
                var offset:int = _starts[copies] - _starts[level.firstBucket];
                for (var k:int = 1; k <= BinLevel.COPIED; k++)
                {
                    _starts[copies + k] = offset + _starts[level.firstBucket + k];
                }
                for (var slot:int = _starts[copies]; slot < _starts[copies + BinLevel.COPIED]; slot++)
                {
                    _rows[slot] = _rows[slot - offset];
                }
            }
        }

        // Copies the circles of all members. The reads are scattered in memory and the writes are in order. The reverse would be slower.
        private function copyCircles(extents:Extents, slots:int):void
        {
            var fromX:Vector.<Number> = extents.x;
            var fromY:Vector.<Number> = extents.y;
            var fromRadius:Vector.<Number> = extents.radiusXY;
            var bySlot:Vector.<int> = _rows;
            var toX:Vector.<Number> = _xs;
            var toY:Vector.<Number> = _ys;
            var toRadius:Vector.<Number> = _radii;
            for (var slot:int = 0; slot < slots; slot++)
            {
                var row:int = bySlot[slot];
                toX[slot] = fromX[row];
                toY[slot] = fromY[row];
                toRadius[slot] = fromRadius[row];
            }
        }

        // The pairs of members of one level.
        private function findPairsWithin(level:BinLevel, sink:PairSink):void
        {
            var starts:Vector.<int> = _starts;
            var rows:Vector.<int> = _rows;
            var first:int = level.firstBucket;
            var mask:int = level.mask;
            // added to a bucket, it gives the one of the next line and the column before, counted from the first
            var toNextLine:int = level.stride - 1 - first;
            var last:int = starts[level.endBucket];
            var end:int = starts[first];
            for (var bucket:int = first; end < last; bucket++)
            {
                var slot:int = end;
                end = starts[bucket + 1];
                if (slot == end)
                {
                    continue;
                }
                // the first run is the cell and its right neighbour, the second run is three cells of the next line
                var runEnd:int = starts[bucket + 2];
                var below:int = ((bucket + toNextLine) & mask) + first;
                var nextLine:int = starts[below];
                var nextLineEnd:int = starts[below + 3];
                for (; slot < end; slot++)
                {
                    var found:int = collectRun(slot, slot + 1, runEnd, level, 0);
                    found = collectRun(slot, nextLine, nextLineEnd, level, found);
                    if (found > 0)
                    {
                        sink.onCandidates(rows[slot], _candidates, found, level);
                    }
                }
            }
        }

        // The pairs of members of one level with members of a coarser level.
        private function findPairsBetween(level:BinLevel, coarser:BinLevel, sink:PairSink):void
        {
            var last:int = _starts[level.endBucket];
            for (var slot:int = _starts[level.firstBucket]; slot < last; slot++)
            {
                var found:int = collectNear(slot, level, coarser);
                if (found > 0)
                {
                    sink.onCandidates(_rows[slot], _candidates, found, coarser);
                }
            }
        }

        // Makes the members of a level that are near the circle in a slot the candidates, and returns how many they are. Those of a finer level than the
        // circle's own may come more than once. Of a coarser level, a circle meets at most three cells in each of three lines.
        private function collectNear(slot:int, own:BinLevel, level:BinLevel):int
        {
            var coarser:BinLevel = level.coarserOf(own);
            var distance:Number = own.width / 2 + level.width / 2 + coarser.slack;
            var starts:Vector.<int> = _starts;
            var x:Number = _xs[slot];
            var y:Number = _ys[slot];
            var cellsAcross:Number = 2 * distance * level.cellsPerPatch + 2;
            if (cellsAcross * cellsAcross > level.mask)
            {
                return collectRun(slot, starts[level.firstBucket], starts[level.endBucket], coarser, 0);
            }
            if (!level.isWithin(x, y))
            {
                return 0;
            }
            var found:int = 0;
            var firstColumn:int = level.cellIndexAt(x - distance);
            var endColumn:int = level.cellIndexAt(x + distance) + 1;
            var lastLine:int = level.cellIndexAt(y + distance);
            for (var line:int = level.cellIndexAt(y - distance); line <= lastLine; line++)
            {
                for (var column:int = firstColumn; column < endColumn; column += BinLevel.RUN)
                {
                    var bucket:int = level.bucketOf(column, line);
                    var columns:int = endColumn - column < BinLevel.RUN ? endColumn - column : BinLevel.RUN;
                    found = collectRun(slot, starts[bucket], starts[bucket + columns], coarser, found);
                }
            }
            return found;
        }

        // Adds the members in a run of slots whose circles overlap a member's circle, but for the slack of a level, to its candidates. Returns how many
        // candidates there are. This is the inner loop of every frame, so all that it reads is in locals.
        private function collectRun(slot:int, from:int, end:int, level:BinLevel, found:int):int
        {
            var rows:Vector.<int> = _rows;
            var xs:Vector.<Number> = _xs;
            var ys:Vector.<Number> = _ys;
            var radii:Vector.<Number> = _radii;
            var candidates:Vector.<int> = _candidates;
            var x:Number = xs[slot];
            var y:Number = ys[slot];
            var radius:Number = radii[slot] + level.slack;
            for (var other:int = from; other < end; other++)
            {
                var distanceX:Number = xs[other] - x;
                var distanceY:Number = ys[other] - y;
                var touchingDistance:Number = radius + radii[other];
                if (distanceX * distanceX + distanceY * distanceY <= touchingDistance * touchingDistance)
                {
                    candidates[found] = rows[other];
                    found++;
                }
            }
            return found;
        }
    }
}
