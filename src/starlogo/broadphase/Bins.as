package starlogo.broadphase
{
    /**
     * The bins of the ground plane: finds the pairs of rows of a table whose circles on the ground overlap (thesis §3.7).
     *
     * <p>The rows that a search is about are its members. A member has a number, its index in the list of rows, and a slot, its index in the
     * order of the cells.</p>
     *
     * <p>A member is in one cell, that of its middle, and cells are as wide as their members: so two that overlap are in one cell or
     * in two side by side. The members are put into the order of their cells by counting, with copies of what the search reads: what
     * is near on the ground is near in memory. Of each cell, the members meet those after them in it and in its right neighbour,
     * which are one run, and those in the three cells of the next row, which are another: each pair comes from one cell.</p>
     *
     * <p>Members of different sizes are in levels (a hierarchical grid: Ericson, Real-Time Collision Detection, §7.2), whose widths
     * are powers of two; a member also looks into the cells of the coarser levels, where the larger ones are. Cells are numbered by a
     * hash, whose size goes with the number of members and not with that of the world. Cells far from each other may share a
     * number, which only costs time; cells that one pair can reach never do.</p>
     *
     * <p>Bins do not depend on what becomes of the pairs, and keep nothing from search to search but allocated memory. A search takes time
     * in proportion to the members and the pairs that overlap, memory in proportion to the members, and allocates nothing once it has
     * run.</p>
     *
     * @private
     */
    public final class Bins
    {
        /** The first cells of a level are repeated after its last, so that neighbours are one run there too. */
        internal static const COPIED:int = 2;

        // Makes the number of any cell positive, where cutting off the decimals is the floor: even, and beyond a level's reach.
        private static const BIAS:Number = 1 << 26;

        /** The levels of the members. */
        public var levels:BinLevels = new BinLevels();

        /** By slot: the number of the member, which is its index in the list of rows that was searched. */
        public var memberAt:Vector.<int> = new Vector.<int>();

        /** By slot: the member's row. */
        public var rowAt:Vector.<int> = new Vector.<int>();

        /** By slot: the middle of its extents. */
        public var x:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var y:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var z:Vector.<Number> = new Vector.<Number>();

        /** By slot: the radius of its circle. */
        public var radius:Vector.<Number> = new Vector.<Number>();

        /** By how much pairs that are handed over may miss each other, at the time of the call: more than rounding comes to. */
        public var slack:Number;

        /** Pairs that were handed over, in the last search. */
        public var pairCount:int = 0;

        /**
         * Entries of members in the thesis's bins, in the last search: squares twice as wide as a level's cells, of which a member may reach
         * into four. A unit sphere's bins are 2 wide: one at (1, 1) is in one bin, one at the origin in four (§6.1).
         */
        public var entryCount:int = 0;

        // The levels by their numbers, and from the coarsest to the finest: those of BinLevels.
        private var _levels:Vector.<BinLevel>;
        private var _byWidth:Vector.<BinLevel>;

        // By member: the number of its cell's counter.
        private var _cells:Vector.<int> = new Vector.<int>();

        // By counter: how many members, 0 between searches; and, one further on, the slot after the cell's last member.
        private var _counts:Vector.<int> = new Vector.<int>();
        private var _ends:Vector.<int> = new Vector.<int>();

        // The slots of the candidates of the member at hand.
        private var _candidates:Vector.<int> = new Vector.<int>();

        /** No bins yet. */
        public function Bins()
        {
            _levels = levels.byNumber;
            _byWidth = levels.byWidth;
        }

        /**
         * Finds the pairs whose circles on the ground overlap, or nearly so, and hands each to the sink once.
         *
         * @param extents fitted since they have changed
         * @param rows the rows of the members
         * @param count how many of the rows, from the beginning
         * @param sink takes the pairs
         */
        public function findPairs(extents:Extents, rows:Vector.<int>, count:int, sink:PairSink):void
        {
            pairCount = 0;
            var counters:int = layOut(extents, rows, count);
            countCells(extents, rows, count);
            var slots:int = sumUp(counters);
            if (slots > rowAt.length)
            {
                memberAt.length = rowAt.length = slots;
                x.length = y.length = z.length = radius.length = slots;
            }
            sortByCells(count);
            gather(extents, rows, slots);
            for (var i:int = 0; i < _byWidth.length; i++)
            {
                var level:BinLevel = _byWidth[i];
                if (level.count == 0)
                {
                    continue;
                }
                for (var coarser:int = 0; coarser < i; coarser++)
                {
                    if (_byWidth[coarser].count > 0)
                    {
                        collideLevels(level, _byWidth[coarser], sink);
                    }
                }
                collideLevel(level, sink);
            }
        }

        // How many members each level has, and where its counters are. Returns how many counters there are.
        private function layOut(extents:Extents, rows:Vector.<int>, count:int):int
        {
            var allLevels:Vector.<BinLevel> = _levels;
            var numbers:Vector.<int> = extents.level;
            for (var i:int = 1; i < allLevels.length; i++)
            {
                allLevels[i].count = 0;
            }
            for (i = 0; i < count; i++)
            {
                allLevels[numbers[rows[i]]].count++;
            }
            var counters:int = 0;
            for (i = 0; i < _byWidth.length; i++)
            {
                if (_byWidth[i].count > 0)
                {
                    counters = _byWidth[i].makeRoom(counters);
                }
            }
            if (counters > _counts.length)
            {
                _counts.length = counters;
                _ends.length = counters + 1;
            }
            if (count > _cells.length)
            {
                _cells.length = count;
            }
            return counters;
        }

        // Finds each member's cell, and counts the members of the cells and the entries in the thesis's bins.
        private function countCells(extents:Extents, rows:Vector.<int>, count:int):void
        {
            var xs:Vector.<Number> = extents.x;
            var ys:Vector.<Number> = extents.y;
            var halfXs:Vector.<Number> = extents.halfX;
            var halfYs:Vector.<Number> = extents.halfY;
            var numbers:Vector.<int> = extents.level;
            var cells:Vector.<int> = _cells;
            var counts:Vector.<int> = _counts;
            var number:int = 0;
            var cellsPerPatch:Number = 0;
            var mask:int = 0;
            var stride:int = 0;
            var base:int = 0;
            var entries:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var row:int = rows[i];
                if (numbers[row] != number)
                {
                    number = numbers[row];
                    var level:BinLevel = _levels[number];
                    cellsPerPatch = level.cellsPerPatch;
                    mask = level.mask;
                    stride = level.stride;
                    base = level.base;
                }
                var position:Number = xs[row] * cellsPerPatch + BIAS;
                var column:int = position;
                // odd columns end a bin: how far in from the border of one the middle is, and whether the rectangle reaches as far
                var odd:int = column & 1;
                position -= column;
                var crossed:int = halfXs[row] * cellsPerPatch - position + odd * (2 * position - 1) + 1;
                position = ys[row] * cellsPerPatch + BIAS;
                var line:int = position;
                odd = line & 1;
                position -= line;
                var crossedLines:int = halfYs[row] * cellsPerPatch - position + odd * (2 * position - 1) + 1;
                entries += (1 + crossed) * (1 + crossedLines);
                var cell:int = ((line & mask) * stride + column) & mask;
                if (cell < COPIED)
                {
                    counts[base + mask + 1 + cell]++;
                }
                cell += base;
                cells[i] = cell;
                counts[cell]++;
            }
            entryCount = entries;
        }

        // Finds the slots where the cells begin: one further on, those are where the cells end once they are filled. Returns how many
        // slots there are.
        private function sumUp(counters:int):int
        {
            var counts:Vector.<int> = _counts;
            var ends:Vector.<int> = _ends;
            var sum:int = 0;
            for (var i:int = 0; i < counters; i++)
            {
                var members:int = counts[i];
                counts[i] = 0;
                ends[i + 1] = sum;
                sum += members;
            }
            return sum;
        }

        private function sortByCells(count:int):void
        {
            var members:Vector.<int> = memberAt;
            var cells:Vector.<int> = _cells;
            var ends:Vector.<int> = _ends;
            for (var i:int = 0; i < count; i++)
            {
                var next:int = cells[i] + 1;
                var slot:int = ends[next];
                members[slot] = i;
                ends[next] = slot + 1;
            }
            for (i = 0; i < _byWidth.length; i++)
            {
                if (_byWidth[i].count > 0)
                {
                    copyFirstCells(_byWidth[i]);
                }
            }
        }

        private function copyFirstCells(level:BinLevel):void
        {
            var from:int = _ends[level.base];
            var copies:int = level.base + level.mask + 1;
            var to:int = _ends[copies];
            for (var i:int = 1; i <= COPIED; i++)
            {
                _ends[copies + i] = to + _ends[level.base + i] - from;
            }
            for (var slot:int = to; slot < _ends[copies + COPIED]; slot++)
            {
                memberAt[slot] = memberAt[from + slot - to];
            }
        }

        // Reads what is far apart in memory and writes it side by side: the reverse takes longer.
        private function gather(extents:Extents, rows:Vector.<int>, slots:int):void
        {
            var fromX:Vector.<Number> = extents.x;
            var fromY:Vector.<Number> = extents.y;
            var fromZ:Vector.<Number> = extents.z;
            var fromRadius:Vector.<Number> = extents.radius;
            var members:Vector.<int> = memberAt;
            var toRow:Vector.<int> = rowAt;
            var toX:Vector.<Number> = x;
            var toY:Vector.<Number> = y;
            var toZ:Vector.<Number> = z;
            var toRadius:Vector.<Number> = radius;
            for (var slot:int = 0; slot < slots; slot++)
            {
                var row:int = rows[members[slot]];
                toRow[slot] = row;
                toX[slot] = fromX[row];
                toY[slot] = fromY[row];
                toZ[slot] = fromZ[row];
                toRadius[slot] = fromRadius[row];
            }
        }

        // The pairs of members of one level. All numbers are in locals, each if compares once, and nothing is called but the sink: this and the
        // next function are the inner loops of every frame.
        private function collideLevel(level:BinLevel, sink:PairSink):void
        {
            var xs:Vector.<Number> = x;
            var ys:Vector.<Number> = y;
            var radii:Vector.<Number> = radius;
            var ends:Vector.<int> = _ends;
            var candidates:Vector.<int> = _candidates;
            var margin:Number = level.slack;
            var farthest:Number = level.width + margin;
            var base:int = level.base;
            var mask:int = level.mask;
            var toNextLine:int = level.stride - 1 - base;
            var last:int = ends[base + mask + 1];
            var pairs:int = 0;
            slack = margin;
            var end:int = ends[base];
            for (var cell:int = base; end < last; cell++)
            {
                var slot:int = end;
                end = ends[cell + 1];
                if (slot == end)
                {
                    continue;
                }
                // the cell with its right neighbour is one run, the three of the next line are another
                var runEnd:int = ends[cell + 2];
                var below:int = ((cell + toNextLine) & mask) + base;
                var nextLine:int = ends[below];
                var nextLineEnd:int = ends[below + 3];
                for (; slot < end; slot++)
                {
                    var middleX:Number = xs[slot];
                    var middleY:Number = ys[slot];
                    var ownReach:Number = radii[slot] + margin;
                    var candidateCount:int = 0;
                    for (var other:int = slot + 1; other < runEnd; other++)
                    {
                        var distanceX:Number = xs[other] - middleX;
                        if (distanceX <= farthest)
                        {
                            var distanceY:Number = ys[other] - middleY;
                            var reach:Number = ownReach + radii[other];
                            if (distanceX * distanceX + distanceY * distanceY <= reach * reach)
                            {
                                candidates[candidateCount] = other;
                                candidateCount++;
                            }
                        }
                    }
                    for (other = nextLine; other < nextLineEnd; other++)
                    {
                        distanceX = xs[other] - middleX;
                        distanceY = ys[other] - middleY;
                        reach = ownReach + radii[other];
                        if (distanceX * distanceX + distanceY * distanceY <= reach * reach)
                        {
                            candidates[candidateCount] = other;
                            candidateCount++;
                        }
                    }
                    if (candidateCount > 0)
                    {
                        pairs += candidateCount;
                        sink.onCandidates(slot, candidates, candidateCount);
                    }
                }
            }
            pairCount += pairs;
        }

        // The pairs of members of one level with those of a coarser one: of at most three lines of its cells, at most three cells each.
        private function collideLevels(level:BinLevel, coarser:BinLevel, sink:PairSink):void
        {
            var xs:Vector.<Number> = x;
            var ys:Vector.<Number> = y;
            var radii:Vector.<Number> = radius;
            var ends:Vector.<int> = _ends;
            var candidates:Vector.<int> = _candidates;
            var margin:Number = coarser.slack;
            var cellsPerPatch:Number = coarser.cellsPerPatch;
            var mask:int = coarser.mask;
            var stride:int = coarser.stride;
            var base:int = coarser.base;
            var last:int = ends[level.base + level.mask + 1];
            var pairs:int = 0;
            slack = margin;
            for (var slot:int = ends[level.base]; slot < last; slot++)
            {
                var middleX:Number = xs[slot];
                var middleY:Number = ys[slot];
                var ownReach:Number = radii[slot] + margin;
                var wide:Number = level.largestHalf + coarser.largestHalf + margin;
                var column:int = (middleX - wide) * cellsPerPatch + BIAS;
                var columns:int = int((middleX + wide) * cellsPerPatch + BIAS) - column + 1;
                var line:int = (middleY - wide) * cellsPerPatch + BIAS;
                var lastLine:int = (middleY + wide) * cellsPerPatch + BIAS;
                var candidateCount:int = 0;
                for (; line <= lastLine; line++)
                {
                    var cell:int = (((line & mask) * stride + column) & mask) + base;
                    var end:int = ends[cell + columns];
                    for (var other:int = ends[cell]; other < end; other++)
                    {
                        var distanceX:Number = xs[other] - middleX;
                        var distanceY:Number = ys[other] - middleY;
                        var reach:Number = ownReach + radii[other];
                        if (distanceX * distanceX + distanceY * distanceY <= reach * reach)
                        {
                            candidates[candidateCount] = other;
                            candidateCount++;
                        }
                    }
                }
                if (candidateCount > 0)
                {
                    pairs += candidateCount;
                    sink.onCandidates(slot, candidates, candidateCount);
                }
            }
            pairCount += pairs;
        }
    }
}
