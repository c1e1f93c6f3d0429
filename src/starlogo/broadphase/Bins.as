// This room finds which agents are near each other on the ground plane, as rows of a table. Bins find all pairs of rows. SortedMembers puts the
// rows into the order of their cells, and BinLevels has cells of each width that is needed (BinLevel). CellLists finds what is near single rows that
// have changed since. Read this file first, then SortedMembers, then CellLists.
package starlogo.broadphase
{
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
     * <p>The bins do not know how the pairs are used. Each search begins anew. CellLists takes over the cells of the last one. The time of a search is
     * proportional to the number of members and overlapping pairs, the memory to the number of members. After the first search nothing is
     * allocated.</p>
     *
     * @private
     */
    public final class Bins
    {
        /** The levels of the cells. */
        public var levels:BinLevels = new BinLevels();

        private var _members:SortedMembers;

        // The rows of the candidates of the present member.
        private var _candidates:Vector.<int> = new Vector.<int>();

        public function Bins()
        {
            _members = new SortedMembers(levels);
        }

        /**
         * Finds all pairs whose extents overlap, and some others that are as near. Each pair is passed to the sink once.
         *
         * @param extents must fit their levels
         * @param rows the rows of the members
         * @param count the number of rows to use, from the beginning
         * @param sink takes the pairs
         */
        public function findPairs(extents:Extents, rows:Vector.<int>, count:int, sink:PairSink):void
        {
            _members.sort(extents, rows, count);
            var byWidth:Vector.<BinLevel> = levels.byWidth;
            for (var i:int = 0; i < byWidth.length; i++)
            {
                var level:BinLevel = byWidth[i];
                if (level.count == 0)
                {
                    continue;
                }
                for (var coarser:int = 0; coarser < i; coarser++)
                {
                    if (byWidth[coarser].count > 0)
                    {
                        findPairsBetween(level, byWidth[coarser], sink);
                    }
                }
                findPairsWithin(level, sink);
            }
        }

        // The pairs of members of one level.
        private function findPairsWithin(level:BinLevel, sink:PairSink):void
        {
            var starts:Vector.<int> = _members.starts;
            var rows:Vector.<int> = _members.rows;
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
                    var found:int = collectRun(slot, slot + 1, runEnd, level.slack, 0);
                    found = collectRun(slot, nextLine, nextLineEnd, level.slack, found);
                    if (found > 0)
                    {
                        sink.onCandidates(rows[slot], _candidates, found, level);
                    }
                }
            }
        }

        // The pairs of members of one level with members of a coarser level. A member meets at most three cells in each of three lines of cells.
        private function findPairsBetween(level:BinLevel, coarser:BinLevel, sink:PairSink):void
        {
            var distance:Number = level.width / 2 + coarser.width / 2 + coarser.slack;
            var starts:Vector.<int> = _members.starts;
            var xs:Vector.<Number> = _members.xs;
            var ys:Vector.<Number> = _members.ys;
            var last:int = starts[level.endBucket];
            for (var slot:int = starts[level.firstBucket]; slot < last; slot++)
            {
                var column:int = coarser.cellIndexAt(xs[slot] - distance);
                var columns:int = coarser.cellIndexAt(xs[slot] + distance) - column + 1;
                var lastLine:int = coarser.cellIndexAt(ys[slot] + distance);
                var found:int = 0;
                for (var line:int = coarser.cellIndexAt(ys[slot] - distance); line <= lastLine; line++)
                {
                    var bucket:int = coarser.bucketOf(column, line);
                    found = collectRun(slot, starts[bucket], starts[bucket + columns], coarser.slack, found);
                }
                if (found > 0)
                {
                    sink.onCandidates(_members.rows[slot], _candidates, found, coarser);
                }
            }
        }

        // Adds the members in a run of slots whose circles overlap a member's circle to its candidates. Returns how many candidates there are. This
        // is the inner loop of every frame, so all that it reads is in locals.
        private function collectRun(slot:int, from:int, end:int, slack:Number, found:int):int
        {
            var members:SortedMembers = _members;
            var rows:Vector.<int> = members.rows;
            var xs:Vector.<Number> = members.xs;
            var ys:Vector.<Number> = members.ys;
            var radii:Vector.<Number> = members.radii;
            var candidates:Vector.<int> = _candidates;
            var x:Number = xs[slot];
            var y:Number = ys[slot];
            var radius:Number = radii[slot] + slack;
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
