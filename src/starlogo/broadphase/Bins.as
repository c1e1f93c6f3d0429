package starlogo.broadphase
{
    /**
     * The bins of the ground plane: finds the pairs of proxies whose ground rectangles overlap (thesis §3.7).
     *
     * <p>A proxy is entered in every bin that its rectangle touches. Bins come in levels (a hierarchical grid: Ericson,
     * Real-Time Collision Detection, §7.2): those of a level are squares, their borders at the multiples of their
     * width, a power of two that is at least twice as wide as the level's widest proxies and less than four times. So a
     * proxy is in at most four bins of its own level, whatever its size. A unit sphere's bins are 2 wide: one at (1, 1)
     * is in one bin, one at the origin in four (§6.1). A proxy also looks into the bins of the coarser levels, where the
     * larger proxies are.</p>
     *
     * <p>A pair that shares several bins is reported in just one: that of the later of the two columns, and the later of
     * the two rows, where their rectangles begin (Tsitsigkos, Lampropoulos, Bouros, Mamoulis and Terrovitis, "A two-layer
     * partitioning for non-point spatial data", ICDE 2021). The bins are lists in a hash table, whose size goes with the
     * number of proxies and not with that of the world. Bins far from each other may fall into one list, which only costs
     * time; bins that one pair can reach never do.</p>
     *
     * <p>Bins know nothing of what their user does with the pairs. A search is: <code>clear()</code>, <code>add()</code> for
     * each proxy, which <code>fit()</code> has seen since its extents changed, <code>findPairs()</code>. It takes time in
     * proportion to the proxies and the pairs that overlap, memory in proportion to the proxies, and allocates nothing once
     * it has run.</p>
     *
     * @private
     */
    public final class Bins
    {
        // A point at the origin asks for no width at all.
        private static const MIN_WIDTH:Number = 1e-300;

        /** Pairs that were handed over, in the last search. */
        public var pairCount:int = 0;

        /** Entries in bins, in the last search. */
        public var entryCount:int = 0;

        // Whether the last search came to its end.
        private var _isFinished:Boolean = true;

        // Those that the proxy at hand may meet.
        private var _candidates:Vector.<AgentProxy> = new Vector.<AgentProxy>();

        // From the coarsest to the finest. They stay, since proxies remember theirs.
        private var _levels:Vector.<BinLevel> = new Vector.<BinLevel>();

        /** No bins yet. */
        public function Bins()
        {
        }

        /** Begins a search: no proxy is added yet. */
        public function clear():void
        {
            for (var i:int = 0; i < _levels.length; i++)
            {
                if (!_isFinished)
                {
                    _levels[i].releaseAll();
                }
                _levels[i].clear();
            }
            _isFinished = false;
        }

        /**
         * Begins a search with the proxies of the last one, none of which has got another level since.
         *
         * @return false if the last one did not come to its end: then nothing has begun
         */
        public function repeat():Boolean
        {
            if (!_isFinished)
            {
                return false;
            }
            _isFinished = false;
            return true;
        }

        /** Adds a proxy to this search. */
        public function add(proxy:AgentProxy):void
        {
            var level:BinLevel = proxy.level;
            level.proxies[level.count] = proxy;
            level.count++;
        }

        /**
         * Gives a proxy the level that its extents and its distance from the world's origin ask for, and puts its rectangle
         * around its middle.
         */
        public function fit(proxy:AgentProxy):void
        {
            var half:Number = proxy.halfX;
            if (proxy.halfY > half)
            {
                half = proxy.halfY;
            }
            var level:BinLevel = proxy.level;
            if (level == null || half > level.largestHalf || half <= level.tooSmallHalf || isBeyondReach(proxy))
            {
                var distance:Number = Math.abs(proxy.x) + Math.abs(proxy.y) + Math.abs(proxy.z);
                // two by two: Math.max of three makes an Array
                level = levelFor(Math.max(Math.max(4 * half, 2 * distance / BinLevel.REACH), MIN_WIDTH));
                proxy.level = level;
            }
            var padding:Number = level.padding;
            proxy.reachX = proxy.halfX + padding;
            proxy.reachY = proxy.halfY + padding;
            proxy.reachZ = proxy.halfZ + padding;
            proxy.minX = proxy.x - proxy.reachX;
            proxy.maxX = proxy.x + proxy.reachX;
            proxy.minY = proxy.y - proxy.reachY;
            proxy.maxY = proxy.y + proxy.reachY;
        }

        /** Whether a proxy that has a level has moved farther out than the level reaches. */
        public function isBeyondReach(proxy:AgentProxy):Boolean
        {
            return proxy.x * proxy.x + proxy.y * proxy.y + proxy.z * proxy.z >= proxy.level.reachSquared;
        }

        /**
         * Finds the pairs whose rectangles overlap and hands each to the sink once.
         *
         * @param sink takes the pairs
         * @param somebodyLeft whether a proxy of the search before may not be in this one; false spares the work of letting go of it
         */
        public function findPairs(sink:PairSink, somebodyLeft:Boolean = true):void
        {
            pairCount = 0;
            entryCount = 0;
            if (somebodyLeft)
            {
                releasePrevious();
            }
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
                        collidePairs(level, _levels[coarser], sink);
                    }
                }
                collidePairs(level, level, sink);
            }
            _candidates.length = 0;
            _isFinished = true;
        }

        // Before any is entered: one may have come from another level.
        private function releasePrevious():void
        {
            for (var i:int = 0; i < _levels.length; i++)
            {
                _levels[i].releasePrevious();
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

        // Finds the pairs of a level's proxies with those that are in the bins, which are its own or a coarser level's. In its
        // own, a proxy is entered as it looks for those before it. All is in locals, comparisons are one an if, and nothing is
        // called but the sink: this is the inner loop of every frame.
        private function collidePairs(level:BinLevel, bins:BinLevel, sink:PairSink):void
        {
            var enters:Boolean = bins === level;
            var proxies:Vector.<AgentProxy> = level.proxies;
            var heads:Vector.<BinEntry> = bins.heads;
            var perWidth:Number = bins.perWidth;
            var mask:int = bins.mask;
            var stride:int = bins.stride;
            var candidates:Vector.<AgentProxy> = _candidates;
            var count:int = level.count;
            var entries:int = 0;
            var pairs:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var proxy:AgentProxy = proxies[i];
                var minX:Number = proxy.minX;
                var maxX:Number = proxy.maxX;
                var minY:Number = proxy.minY;
                var maxY:Number = proxy.maxY;
                var entry:BinEntry = proxy.entry;

                // the floor, without a call
                var position:Number = minX * perWidth;
                var column:int = position;
                if (column > position)
                {
                    column--;
                }
                position = minY * perWidth;
                var row:int = position;
                if (row > position)
                {
                    row--;
                }
                // over one border at most: bit 0 for the next column, bit 1 for the next row
                var reaches:int = 0;
                if (column + 1 <= maxX * perWidth)
                {
                    reaches = 1;
                }
                if (row + 1 <= maxY * perWidth)
                {
                    reaches |= 2;
                }
                var first:int = row * stride + column;
                var bin:int = first;
                var beginsEarlier:int = 0;
                var found:int = 0;
                while (true)
                {
                    var head:int = bin & mask;
                    var link:BinEntry = heads[head];
                    if (enters)
                    {
                        entry.next = link;
                        heads[head] = entry;
                    }
                    while (link != null)
                    {
                        var other:AgentProxy = link.proxy;
                        // where both began in an earlier column, or row, they have met there
                        var haveMet:int = link.beginsEarlier & beginsEarlier;
                        link = link.next;
                        if (haveMet != 0)
                        {
                            continue;
                        }
                        if (other.minX > maxX)
                        {
                            continue;
                        }
                        if (other.maxX < minX)
                        {
                            continue;
                        }
                        if (other.minY > maxY)
                        {
                            continue;
                        }
                        if (other.maxY < minY)
                        {
                            continue;
                        }
                        candidates[found] = other;
                        found++;
                    }
                    if (beginsEarlier == reaches)
                    {
                        break;
                    }
                    // the next of 0, 1, 2, 3 that has no other bits
                    entries++;
                    beginsEarlier++;
                    entry = entry.sibling;
                    bin++;
                    if (beginsEarlier == 2)
                    {
                        bin = first + stride;
                    }
                    else if (reaches == 2)
                    {
                        beginsEarlier = 2;
                        entry = entry.sibling;
                        bin = first + stride;
                    }
                }
                if (found > 0)
                {
                    pairs += found;
                    sink.onCandidates(proxy, candidates, found);
                }
            }
            if (enters)
            {
                // each is in a bin, and some in others
                entryCount += count + entries;
            }
            pairCount += pairs;
        }
    }
}
