package starlogo.models.polygons
{
    import starlogo.models.files.FileBudget;
    import starlogo.steps.Steps;

    /**
     * Cuts a ring of corners into triangles, one ear at a time. It adds only triangles with an area. This holds for corners in a straight line,
     * and for rings that cross or cover themselves.
     *
     * <p>It ends for every ring, because any corner is cut off after two rounds without an ear.</p>
     */
    internal final class EarClipper implements Steps
    {
        private var _rings:PolygonRings;
        private var _triangles:Vector.<uint>;

        // the present node, the number of corners left, and the number of corners passed since the last ear
        private var _node:int;
        private var _count:int = 0;
        private var _misses:int = 0;

        /**
         * @param rings contains the ring
         * @param start a node of the ring, which must be counter-clockwise
         * @param triangles takes the triangles
         */
        public function EarClipper(rings:PolygonRings, start:int, triangles:Vector.<uint>)
        {
            _rings = rings;
            _triangles = triangles;
            _node = start;
        }

        /** @inheritDoc Cuts until two corners are left, or for one step. */
        public function step():Boolean
        {
            var next:Vector.<int> = _rings.next;
            var vertex:Vector.<uint> = _rings.vertex;
            var budget:FileBudget = _rings.budget;
            var end:Number = budget.cornerTestsLeft - PolygonRings.TESTS_PER_STEP;
            _count ||= _rings.countFrom(_node);
            while (_count > 2 && budget.cornerTestsLeft > end)
            {
                var before:int = _rings.previous[_node];
                var after:int = next[_node];
                var area:Number = _rings.orient2d(before, _node, after);
                // An outline that crosses itself may have no ear left. After one round without an ear any left turn is cut, after two
                // rounds any corner.
                var cutsLeftTurns:Boolean = _misses > _count;
                var cutsAll:Boolean = _misses > 2 * _count || budget.cornerTestsLeft <= 0;
                var isCut:Boolean = cutsAll || area == 0 || cutsLeftTurns && area > 0;
                var outside:int = 0;
                if (!isCut && area > 0)
                {
                    outside = countOutside(before, _node, after);
                    isCut = outside == _count - 3;
                }
                budget.spendCornerTests(1 + outside);
                if (isCut)
                {
                    if (area > 0)
                    {
                        _triangles.push(vertex[before], vertex[_node], vertex[after]);
                    }
                    _rings.remove(_node);
                    // once all are cut, it stays so
                    _misses = cutsAll ? _misses : 0;
                    _count--;
                    // What is left of a cut part goes first, because no other triangle is right while the ring goes there and back.
                    _node = _rings.turnsBack(before) ? before : (_rings.turnsBack(after) ? after : next[after]);
                }
                else
                {
                    _misses++;
                    _node = after;
                }
            }
            return _count > 2;
        }

        // How many of the other corners are outside of the triangle of a left turn, before the first that is inside. If these are all, the turn
        // is an ear.
        private function countOutside(before:int, tip:int, after:int):int
        {
            var xs:Vector.<Number> = _rings.x;
            var minX:Number = Math.min(xs[before], xs[tip], xs[after]);
            var maxX:Number = Math.max(xs[before], xs[tip], xs[after]);
            var count:int = 0;
            for (var node:int = _rings.next[after]; node != before; node = _rings.next[node])
            {
                // most corners are beside the triangle
                if (xs[node] >= minX && xs[node] <= maxX && isInWay(node, before, tip, after))
                {
                    return count;
                }
                count++;
            }
            return count;
        }

        private function isInWay(node:int, before:int, tip:int, after:int):Boolean
        {
            var isAtEnd:Boolean = _rings.areAtOnePlace(node, before) || _rings.areAtOnePlace(node, after);
            return !isAtEnd && (_rings.areAtOnePlace(node, tip) ? _rings.goesInto(node, before, tip, after) : _rings.isInside(node, before, tip, after));
        }
    }
}
