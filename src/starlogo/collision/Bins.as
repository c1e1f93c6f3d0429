package starlogo.collision
{
    /**
     * The bins of the ground plane: finds the pairs of bodies whose ground rectangles overlap (thesis §3.7).
     *
     * <p>A body is entered in every bin that its rectangle touches. Bins come in levels (a hierarchical grid: Ericson,
     * Real-Time Collision Detection, §7.2): those of a level are squares, their borders at the multiples of their
     * width, a power of two that is at least twice as wide as the level's widest bodies and less than four times. So a
     * body is in at most four bins of its own level, whatever its size. A unit sphere's bins are 2 wide: one at (1, 1)
     * is in one bin, one at the origin in four (§6.1). A body also looks into the bins of the coarser levels, where the
     * larger bodies are.</p>
     *
     * <p>A pair that shares several bins is reported in just one: that of the later of the two columns, and the later of
     * the two rows, where their rectangles begin (Tsitsigkos, Lampropoulos, Bouros, Mamoulis and Terrovitis, "A two-layer
     * partitioning for non-point spatial data", ICDE 2021). The bins are lists in a hash table, whose size goes with the
     * number of bodies and not with that of the world. Bins far from each other may fall into one list, which only costs
     * time; bins that one pair can reach never do.</p>
     */
    internal final class Bins
    {
        // A point at the origin asks for no width at all.
        private static const MIN_WIDTH:Number = 1e-300;

        /** Entries in bins, in the last search. */
        public var entryCount:int;

        /** Pairs that were handed over, in the last search. */
        public var pairCount:int;

        // From the coarsest to the finest. They stay, since bodies remember theirs.
        private var _levels:Vector.<BinLevel> = new Vector.<BinLevel>();

        /** No bins yet. */
        public function Bins()
        {
        }

        /** Empties the bins. Bodies are then added to the <code>bodies</code> of their levels. */
        public function clear():void
        {
            for (var i:int = 0; i < _levels.length; i++)
            {
                _levels[i].count = 0;
            }
        }

        /** Gives a body the level that its extents and its distance from the world's origin ask for. */
        public function assignLevel(body:Body):void
        {
            var half:Number = body.halfX > body.halfY ? body.halfX : body.halfY;
            var level:BinLevel = body.level;
            if (level == null || half > level.largestHalf || half <= level.tooSmallHalf || body.x * body.x + body.y * body.y >= level.reachSquared)
            {
                var distance:Number = Math.abs(body.x) + Math.abs(body.y);
                body.level = levelFor(Math.max(4 * half, 2 * distance / BinLevel.REACH, MIN_WIDTH));
            }
        }

        /** Finds the pairs whose rectangles overlap and hands each to the collider once. */
        public function findPairs(collider:BinCollider):void
        {
            entryCount = 0;
            pairCount = 0;
            for (var i:int = 0; i < _levels.length; i++)
            {
                var level:BinLevel = _levels[i];
                level.clearBins();
                if (level.count == 0)
                {
                    continue;
                }
                for (var coarser:int = 0; coarser < i; coarser++)
                {
                    if (_levels[coarser].count > 0)
                    {
                        meet(level, _levels[coarser], collider);
                    }
                }
                meet(level, level, collider);
            }
        }

        // The level whose bins are wide enough, and no wider than they must.
        private function levelFor(width:Number):BinLevel
        {
            var powerOfTwo:Number = Math.pow(2, Math.ceil(Math.log(width) * Math.LOG2E));
            // the logarithm may be off by a rounding
            while (powerOfTwo < width)
            {
                powerOfTwo *= 2;
            }
            while (powerOfTwo >= 2 * width)
            {
                powerOfTwo *= 0.5;
            }
            var place:int = 0;
            while (place < _levels.length && _levels[place].width > powerOfTwo)
            {
                place++;
            }
            if (place == _levels.length || _levels[place].width != powerOfTwo)
            {
                _levels.splice(place, 0, new BinLevel(powerOfTwo));
            }
            return _levels[place];
        }

        // The bodies of a level meet those that are in the bins, which are its own or a coarser level's. In its own, a
        // body is entered when it has met those before it. All is in locals, comparisons are one an if, and nothing is
        // called but the collider: this is the inner loop of every frame.
        private function meet(level:BinLevel, bins:BinLevel, collider:BinCollider):void
        {
            var enters:Boolean = bins === level;
            var bodies:Vector.<Body> = level.bodies;
            var heads:Vector.<BinEntry> = bins.heads;
            var perWidth:Number = bins.perWidth;
            var mask:int = bins.mask;
            var stride:int = bins.stride;
            var padding:Number = level.padding;
            var bodyCount:int = level.count;
            var entries:int = 0;
            var pairs:int = 0;
            for (var i:int = 0; i < bodyCount; i++)
            {
                var body:Body = bodies[i];
                var half:Number = body.halfX + padding;
                var left:Number = body.x - half;
                var right:Number = body.x + half;
                half = body.halfY + padding;
                var front:Number = body.y - half;
                var back:Number = body.y + half;
                var entry:BinEntry = body.entry;

                // the floor, without a call; it reaches over one border at most
                var position:Number = left * perWidth;
                var firstColumn:int = position;
                if (firstColumn > position)
                {
                    firstColumn--;
                }
                var lastColumn:int = firstColumn;
                if (firstColumn + 1 <= right * perWidth)
                {
                    lastColumn++;
                }
                position = front * perWidth;
                var firstRow:int = position;
                if (firstRow > position)
                {
                    firstRow--;
                }
                var lastRow:int = firstRow;
                if (firstRow + 1 <= back * perWidth)
                {
                    lastRow++;
                }
                if (enters)
                {
                    body.left = left;
                    body.right = right;
                    body.front = front;
                    body.back = back;
                }
                var rowFlag:int = 0;
                for (var row:int = firstRow; row <= lastRow; row++)
                {
                    var beginsEarlier:int = rowFlag;
                    for (var column:int = firstColumn; column <= lastColumn; column++)
                    {
                        var head:int = (row * stride + column) & mask;
                        var link:BinEntry = heads[head];
                        if (enters)
                        {
                            entry.beginsEarlier = beginsEarlier;
                            entry.next = link;
                            heads[head] = entry;
                            entry = entry.sibling;
                            entries++;
                        }
                        while (link != null)
                        {
                            // where both began in an earlier column, or row, they have met there
                            if ((link.beginsEarlier & beginsEarlier) != 0)
                            {
                                link = link.next;
                                continue;
                            }
                            var other:Body = link.body;
                            link = link.next;
                            if (other.left > right)
                            {
                                continue;
                            }
                            if (other.right < left)
                            {
                                continue;
                            }
                            if (other.front > back)
                            {
                                continue;
                            }
                            if (other.back < front)
                            {
                                continue;
                            }
                            pairs++;
                            collider.considerPair(body, other);
                        }
                        beginsEarlier = rowFlag | 1;
                    }
                    rowFlag = 2;
                }
            }
            entryCount += entries;
            pairCount += pairs;
        }
    }
}
