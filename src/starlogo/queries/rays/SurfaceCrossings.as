package starlogo.queries.rays
{
    import starlogo.data.IntList;
    import starlogo.data.SortableIntList;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;

    /**
     * The crossings of a ray with one shape, in the order of the ray, without those that are no surface of their own. AgentRays.castAll says the
     * rules.
     *
     * @private
     */
    public final class SurfaceCrossings
    {
        /** The indices of the crossings that are surfaces. */
        public var indices:IntList = new IntList();

        // The indices of all crossings, in the order of the ray.
        private var _all:SortableIntList = new SortableIntList();

        // By surface: the side from which the ray comes.
        private var _sides:Vector.<int> = new Vector.<int>();

        /**
         * Finds which crossings are surfaces.
         *
         * @param crossings how a ray crosses a shape
         * @param areTriangles whether triangles are crossed; otherwise structures or nodes, which the ray enters and leaves
         */
        public function find(crossings:RayCrossings, areTriangles:Boolean):void
        {
            _all.count = indices.count = 0;
            for (var i:int = 0; i < crossings.count; i++)
            {
                _all.add(i, areTriangles ? crossings.all[i].distance : endKeyOf(crossings, i));
            }
            _all.sortFirst(_all.count);
            if (areTriangles)
            {
                keepTriangles(crossings);
            }
            else
            {
                keepEnds(crossings);
            }
        }

        // By what an entry and a way out are sorted. Where the ray begins inside comes first; nodes that touch up to rounding overlap.
        private static function endKeyOf(crossings:RayCrossings, index:int):Number
        {
            switch (crossings.all[index].side)
            {
                case RayCrossing.INSIDE:
                    return -Infinity;
                case RayCrossing.ENTERS:
                    return crossings.all[index].distance - crossings.all[index].rounding;
                default:
                    return crossings.all[index].distance;
            }
        }

        // Keeps where the ray enters the first of parts that overlap, and where it leaves the last.
        private function keepEnds(crossings:RayCrossings):void
        {
            var depth:int = 0;
            // where the ray begins, if that is inside of a part
            var insideFrom:Number = -Infinity;
            for (var i:int = 0; i < crossings.count; i++)
            {
                var index:int = _all.values[i];
                var isKept:Boolean = true;
                switch (crossings.all[index].side)
                {
                    case RayCrossing.INSIDE:
                        insideFrom = crossings.all[index].distance;
                        break;
                    case RayCrossing.ENTERS:
                        isKept = depth == 0 && _all.keys[i] > insideFrom;
                        depth++;
                        break;
                    default:
                        depth--;
                        isKept = depth == 0;
                        break;
                }
                if (isKept)
                {
                    indices.add(index);
                }
            }
        }

        // Keeps one of the triangles that the ray meets at the same place from the same side, and one of those that it runs along.
        private function keepTriangles(crossings:RayCrossings):void
        {
            var runsUntil:Number = -Infinity;
            var mostSlack:Number = 0;
            for (var i:int = 0; i < crossings.count; i++)
            {
                var index:int = _all.values[i];
                var side:int = crossings.all[index].side;
                if (side == RayCrossing.EDGE_ON)
                {
                    var runsOn:Boolean = crossings.all[index].distance <= runsUntil;
                    runsUntil = Math.max(runsUntil, crossings.all[index].end);
                    if (runsOn)
                    {
                        continue;
                    }
                }
                if (!joinKept(crossings, index, side, mostSlack))
                {
                    _sides[indices.count] = side;
                    mostSlack = Math.max(mostSlack, crossings.all[index].rounding);
                    indices.add(index);
                }
            }
        }

        // Joins a crossing to a kept one of the same surface. Returns whether there is one. As in ShearedRay, a triangle that the ray runs along
        // gives way to one that it crosses at the same place.
        private function joinKept(crossings:RayCrossings, index:int, side:int, mostSlack:Number):Boolean
        {
            var distance:Number = crossings.all[index].distance;
            var slack:Number = crossings.all[index].rounding;
            for (var k:int = indices.count - 1; k >= 0; k--)
            {
                var other:int = indices.values[k];
                var gap:Number = distance - crossings.all[other].distance;
                if (gap > slack + mostSlack)
                {
                    return false;
                }
                if (areOneSurface(side, _sides[k]) && gap <= slack + crossings.all[other].rounding)
                {
                    if (_sides[k] == RayCrossing.EDGE_ON && side != RayCrossing.EDGE_ON)
                    {
                        _sides[k] = side;
                        // none is kept between the two, because it would have joined the other one
                        indices.values[k] = gap <= crossings.all[other].rounding ? index : other;
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
