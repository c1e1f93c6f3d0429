package starlogo.models.polygons
{
    /**
     * Cuts a ring of corners into triangles, one ear at a time. It adds only triangles with an area. This holds for corners in a straight
     * line, and for rings that cross or cover themselves.
     *
     * <p>It ends for every ring, because any corner is cut off after two rounds without an ear.</p>
     */
    internal final class EarClipper
    {
        private var _rings:PolygonRings;

        // the present node, the number of corners left, and the number of corners passed since the last ear
        private var _node:int = 0;
        private var _count:int = 0;
        private var _misses:int = 0;

        /** @param rings contains the ring */
        public function EarClipper(rings:PolygonRings)
        {
            _rings = rings;
        }

        /** Sets the ring: the one that contains a node. It must be counter-clockwise. */
        internal function setRing(start:int):void
        {
            _node = start;
            _count = 1;
            for (var node:int = _rings.next[start]; node != start; node = _rings.next[node])
            {
                _count++;
            }
            _misses = 0;
        }

        /**
         * Cuts until two corners are left, or until the given amount of work is done.
         *
         * @return whether more work is left
         */
        internal function cut(most:int):Boolean
        {
            var next:Vector.<int> = _rings.next;
            var previous:Vector.<int> = _rings.previous;
            var vertex:Vector.<uint> = _rings.vertex;
            var count:int = _count;
            var node:int = _node;
            // An outline that crosses itself may have no ear left. After one round without an ear any left turn is cut, after two rounds
            // any corner.
            var misses:int = _misses;
            var end:int = _rings.work + most;
            while (count > 2 && _rings.work < end)
            {
                var before:int = previous[node];
                var after:int = next[node];
                var area:Number = _rings.orient2d(before, node, after);
                var isCut:Boolean = area == 0 || misses > 2 * count || ++_rings.work > _rings.mostWork;
                if (isCut || area > 0 && (misses > count || isEar(before, node, after)))
                {
                    if (area > 0)
                    {
                        _rings.addTriangle(vertex[before], vertex[node], vertex[after]);
                    }
                    _rings.remove(node);
                    count--;
                    misses = misses > 2 * count ? misses : 0;
                    node = next[after];
                }
                else
                {
                    misses++;
                    node = after;
                }
            }
            _count = count;
            _node = node;
            _misses = misses;
            return count > 2;
        }

        /** Whether no other corner lies in the triangle of a left turn. */
        private function isEar(before:int, tip:int, after:int):Boolean
        {
            var xs:Vector.<Number> = _rings.x;
            var ys:Vector.<Number> = _rings.y;
            var next:Vector.<int> = _rings.next;
            var ax:Number = xs[before];
            var ay:Number = ys[before];
            var bx:Number = xs[tip];
            var by:Number = ys[tip];
            var cx:Number = xs[after];
            var cy:Number = ys[after];
            var minX:Number = Math.min(ax, bx, cx);
            var maxX:Number = Math.max(ax, bx, cx);
            var minY:Number = Math.min(ay, by, cy);
            var maxY:Number = Math.max(ay, by, cy);
            var seen:int = 0;
            var isClear:Boolean = true;
            for (var node:int = next[after]; node != before && isClear; node = next[node])
            {
                seen++;
                var x:Number = xs[node];
                if (x < minX || x > maxX)
                {
                    continue;
                }
                var y:Number = ys[node];
                if (y < minY || y > maxY || x == ax && y == ay || x == bx && y == by || x == cx && y == cy)
                {
                    continue;
                }
                isClear = !_rings.isInside(node, before, tip, after);
            }
            _rings.work += seen;
            return isClear;
        }
    }
}
