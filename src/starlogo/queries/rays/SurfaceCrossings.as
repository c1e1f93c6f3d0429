package starlogo.queries.rays
{
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;

    /**
     * The surfaces of one shape that a ray crosses, in the order of the ray: its crossings without those that are no surface of their own.
     * AgentRays.castAll says the rules.
     *
     * @private
     */
    public final class SurfaceCrossings
    {
        /** All crossings of the ray with the shape, in any order. RowRayTest writes them before it calls one of the methods. */
        public var crossings:RayCrossings = new RayCrossings();

        // The indices of the crossings that are surfaces.
        private var _indices:IntList = new IntList();

        // The indices of all crossings, in the order of the ray.
        private var _all:SortableIntList = new SortableIntList();

        /** How many surfaces the ray crosses. */
        public function get count():int
        {
            return _indices.count;
        }

        /** One of them. */
        public function surfaceAt(index:int):RayCrossing
        {
            return crossings.items[_indices.values[index]];
        }

        /**
         * Finds the surfaces of a structure, or of nodes: where the ray enters the first of parts that overlap, and where it leaves the last. The
         * crossings are those with each part.
         */
        public function findSurfacesOfParts():void
        {
            _all.count = _indices.count = 0;
            for (var k:int = 0; k < crossings.count; k++)
            {
                _all.add(k, endKeyOf(crossings.items[k]));
            }
            _all.sortFirst(_all.count);
            // the number of parts that the ray is in
            var depth:int = 0;
            // where the ray begins, if that is inside of a part
            var insideFrom:Number = -Infinity;
            for (var i:int = 0; i < crossings.count; i++)
            {
                var crossing:RayCrossing = crossings.items[_all.values[i]];
                var isKept:Boolean = crossing.side == RayCrossing.INSIDE;
                if (isKept)
                {
                    insideFrom = crossing.distance;
                }
                else if (crossing.side == RayCrossing.ENTERS)
                {
                    isKept = depth == 0 && _all.keys[i] > insideFrom;
                    depth++;
                }
                else
                {
                    depth--;
                    isKept = depth == 0;
                }
                if (isKept)
                {
                    _indices.add(_all.values[i]);
                }
            }
        }

        // By what an entry and a way out are sorted. Where the ray begins inside comes first; nodes that touch up to rounding overlap.
        private static function endKeyOf(crossing:RayCrossing):Number
        {
            if (crossing.side == RayCrossing.INSIDE)
            {
                return -Infinity;
            }
            return crossing.side == RayCrossing.ENTERS ? crossing.distance - crossing.rounding : crossing.distance;
        }

        /**
         * Finds the surfaces of triangles: one of those that the ray meets at the same place from the same side, and one of those that it runs along. The
         * crossings are those with each triangle. The side of one may become that of another of the same surface.
         */
        public function findSurfacesOfTriangles():void
        {
            _all.count = _indices.count = 0;
            for (var k:int = 0; k < crossings.count; k++)
            {
                _all.add(k, crossings.items[k].distance);
            }
            _all.sortFirst(_all.count);
            var runsUntil:Number = -Infinity;
            var mostSlack:Number = 0;
            for (var i:int = 0; i < crossings.count; i++)
            {
                var index:int = _all.values[i];
                var crossing:RayCrossing = crossings.items[index];
                if (crossing.side == RayCrossing.EDGE_ON)
                {
                    var runsOn:Boolean = crossing.distance <= runsUntil;
                    runsUntil = Math.max(runsUntil, crossing.end);
                    if (runsOn)
                    {
                        continue;
                    }
                }
                if (!joinKept(index, mostSlack))
                {
                    mostSlack = Math.max(mostSlack, crossing.rounding);
                    _indices.add(index);
                }
            }
        }

        // Joins a crossing to a kept one of the same surface. Returns whether there is one. As in ShearedRay, a triangle that the ray runs along
        // gives way to one that it crosses at the same place.
        private function joinKept(index:int, mostSlack:Number):Boolean
        {
            var crossing:RayCrossing = crossings.items[index];
            for (var k:int = _indices.count - 1; k >= 0; k--)
            {
                var kept:RayCrossing = crossings.items[_indices.values[k]];
                var gap:Number = crossing.distance - kept.distance;
                if (gap > crossing.rounding + mostSlack)
                {
                    return false;
                }
                if (areOneSurface(crossing.side, kept.side) && gap <= crossing.rounding + kept.rounding)
                {
                    if (kept.side == RayCrossing.EDGE_ON && crossing.side != RayCrossing.EDGE_ON)
                    {
                        kept.side = crossing.side;
                        if (gap <= kept.rounding)
                        {
                            // none is kept between the two, because it would have joined the other one
                            _indices.values[k] = index;
                        }
                    }
                    return true;
                }
            }
            return false;
        }

        // Whether a crossing from one side and a kept one at the same place can be of one surface.
        private static function areOneSurface(side:int, kept:int):Boolean
        {
            return kept != RayCrossing.INSIDE && (side == kept || side == RayCrossing.EDGE_ON || kept == RayCrossing.EDGE_ON);
        }
    }
}
