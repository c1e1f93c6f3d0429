package starlogo.broadphase
{
    import starlogo.data.IntList;
    import starlogo.data.IntSet;

    /**
     * Finds rows near one row, among members that hardly change. Each bucket of cells has a list of its members, so a member that has moved changes
     * two lists. The buckets are those of the last search of the bins, as long as the numbers of members need no others.
     *
     * @private
     */
    public final class CellLists
    {
        private static const NONE:int = -1;

        // So many times may each member move to another bucket, on average, before the numbers of buckets may be wrong.
        private static const MAX_MOVES:int = 4;

        // The rows of the buckets near a row. Some may come more than once. keepNear() moves those that it keeps to the beginning.
        private var _candidates:Vector.<int> = new Vector.<int>();

        private var _levels:Vector.<BinLevel>;
        private var _extents:Extents = null;

        /** The number of the members. Read only. */
        public var count:int = 0;

        // How many rows may enter a bucket from now on.
        private var _entriesLeft:int = 0;

        // The rows that keepNear() has kept, and the row that they are near.
        private var _kept:IntSet = new IntSet();

        // By bucket: the first row of its list, or NONE.
        private var _heads:Vector.<int> = new Vector.<int>();

        // By row: its bucket, or NONE if the row is no member.
        private var _buckets:Vector.<int> = new Vector.<int>();

        // By row: the next row in the list of its bucket, or NONE.
        private var _next:Vector.<int> = new Vector.<int>();

        /** @param levels those of the bins, with the buckets that it takes over */
        public function CellLists(levels:Vector.<BinLevel>)
        {
            _levels = levels;
        }

        /**
         * Begins with the members of the last search of the bins.
         *
         * @param extents the extents of all rows. They are read again in each call
         * @param members the rows of the members. Those that have no level with buckets any more are left out
         * @param length all rows are less than this number
         */
        public function begin(extents:Extents, members:IntList, length:int):void
        {
            _extents = extents;
            count = 0;
            var end:int = 0;
            for (var level:int = 1; level < _levels.length; level++)
            {
                end = _levels[level].hasBuckets ? _levels[level].endBucket : end;
            }
            if (end > _heads.length)
            {
                _heads.length = end;
            }
            for (var bucket:int = 0; bucket < end; bucket++)
            {
                _heads[bucket] = NONE;
            }
            makeRoom(length);
            for (var row:int = 0; row < _buckets.length; row++)
            {
                _buckets[row] = NONE;
            }
            for (var i:int = 0; i < members.count; i++)
            {
                tryUpdate(members.values[i]);
            }
            _entriesLeft = MAX_MOVES * members.count;
        }

        /** Makes sure that there are this many rows. */
        public function makeRoom(length:int):void
        {
            var row:int = _buckets.length;
            if (length > row)
            {
                _buckets.length = length;
                _next.length = length;
                for (; row < length; row++)
                {
                    _buckets[row] = NONE;
                }
            }
        }

        /** Whether a row is a member. */
        public function has(row:int):Boolean
        {
            return _buckets[row] != NONE;
        }

        /** Moves a row to the bucket of its extents, and makes it a member if it is none. Returns false if its level has no buckets for it. */
        public function tryUpdate(row:int):Boolean
        {
            var index:int = _extents.levelIndices[row];
            if (index == 0 || index >= _levels.length || !_levels[index].hasBuckets)
            {
                return false;
            }
            var bucket:int = _levels[index].bucketAt(_extents.x[row], _extents.y[row]);
            if (_buckets[row] != bucket)
            {
                remove(row);
                count++;
                _entriesLeft--;
                _next[row] = _heads[bucket];
                _heads[bucket] = row;
                _buckets[row] = bucket;
            }
            return true;
        }

        /** From now on a row is no member. */
        public function remove(row:int):void
        {
            var bucket:int = _buckets[row];
            if (bucket == NONE)
            {
                return;
            }
            var before:int = _heads[bucket];
            if (before == row)
            {
                _heads[bucket] = _next[row];
            }
            else
            {
                while (_next[before] != row)
                {
                    before = _next[before];
                }
                _next[before] = _next[row];
            }
            _buckets[row] = NONE;
            count--;
        }

        /**
         * Whether the members may have outgrown the numbers of buckets, because many rows have moved to other buckets since the beginning. A search of
         * all rows, which finds the right numbers, then costs little for each of these moves.
         */
        public function get needsNewBuckets():Boolean
        {
            return _entriesLeft < 0;
        }

        /**
         * Finds the members near a member, as <code>Bins.findPairs()</code> does, level by level, and passes them to the sink.
         *
         * @param changed all rows for which this is called. A row of these is left out if it is less than the member, because the pair is found from there
         */
        public function findNear(row:int, changed:IntSet, sink:PairSink):void
        {
            var own:BinLevel = _levels[_extents.levelIndices[row]];
            for (var i:int = 1; i < _levels.length; i++)
            {
                var level:BinLevel = _levels[i];
                if (level.hasBuckets)
                {
                    var coarser:BinLevel = own.width > level.width ? own : level;
                    var found:int = findOfLevel(row, level, own.width / 2 + level.width / 2 + coarser.slack);
                    found = keepNear(row, found, coarser.slack, changed);
                    if (found > 0)
                    {
                        sink.onCandidates(row, _candidates, found, coarser);
                    }
                }
            }
        }

        // Finds the members of a level in the cells within a distance of a member, and those of other cells that share their buckets. Some may come
        // more than once. Returns their number.
        private function findOfLevel(row:int, level:BinLevel, distance:Number):int
        {
            var found:int = 0;
            var cellsAcross:Number = 2 * distance * level.cellsPerPatch + 2;
            if (cellsAcross * cellsAcross > level.mask)
            {
                for (var bucket:int = level.firstBucket; bucket < level.endBucket; bucket++)
                {
                    found = collectBucket(bucket, found);
                }
                return found;
            }
            var x:Number = _extents.x[row];
            var y:Number = _extents.y[row];
            if (!level.isWithin(x, y))
            {
                return 0;
            }
            var lastColumn:int = level.cellIndexAt(x + distance);
            var lastLine:int = level.cellIndexAt(y + distance);
            for (var line:int = level.cellIndexAt(y - distance); line <= lastLine; line++)
            {
                for (var column:int = level.cellIndexAt(x - distance); column <= lastColumn; column++)
                {
                    found = collectBucket(level.bucketOf(column, line), found);
                }
            }
            return found;
        }

        // Adds the rows of a bucket to _candidates. Returns their number with the ones before.
        private function collectBucket(bucket:int, found:int):int
        {
            for (var row:int = _heads[bucket]; row != NONE; row = _next[row])
            {
                _candidates[found] = row;
                found++;
            }
            return found;
        }

        // Keeps the rows that make a pair with a member: whose circles overlap its own, and whose pair is not found from them. Each is kept once.
        private function keepNear(row:int, count:int, slack:Number, changed:IntSet):int
        {
            var xs:Vector.<Number> = _extents.x;
            var ys:Vector.<Number> = _extents.y;
            var radii:Vector.<Number> = _extents.radiusXY;
            var x:Number = xs[row];
            var y:Number = ys[row];
            var ownRadius:Number = radii[row] + slack;
            var kept:int = 0;
            _kept.clear(_buckets.length);
            _kept.add(row);
            for (var i:int = 0; i < count; i++)
            {
                var other:int = _candidates[i];
                var distanceX:Number = xs[other] - x;
                var distanceY:Number = ys[other] - y;
                var touchingDistance:Number = ownRadius + radii[other];
                if (distanceX * distanceX + distanceY * distanceY <= touchingDistance * touchingDistance && (other > row || !changed.has(other))
                        && _kept.add(other))
                {
                    _candidates[kept] = other;
                    kept++;
                }
            }
            return kept;
        }
    }
}
