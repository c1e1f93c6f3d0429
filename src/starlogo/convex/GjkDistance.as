package starlogo.convex
{
    import flash.geom.Vector3D;

    /**
     * Finds the closest points of two cores by GJK (Gilbert, Johnson and Keerthi, "A fast procedure for computing the distance between complex objects
     * in three-dimensional space", 1988). All differences of a point of the first core and a point of the second form a convex set, the Minkowski
     * difference, and the cores' distance is the set's distance from the origin. Each step adds the corner of the set that is farthest towards the
     * origin to a simplex. Then it drops the corners that the simplex does not need for its point nearest to the origin.
     *
     * <p>The result is exact except for rounding, which is 1e-15 of the bounding radii, however small the distance is. The separation proves it where it is the
     * same length. Between hulls that are hardly thicker than rounding it may be less, because no direction of the search is precise. The search ends,
     * because no simplex comes twice: each step finds a nearer one, but for the few that rounding hides. Two hulls of 40,000 points each need up to 27
     * steps.</p>
     */
    internal final class GjkDistance
    {
        // The search ends after so many steps that came no nearer, because rounding hides where nearer points are. After one or two of them, a step may
        // still come nearer.
        private static const MAX_STALLS:int = 8;

        private var _simplex:Simplex = new Simplex();

        /** Finds the closest points. */
        public function find(cores:CorePair, out:GjkResult):void
        {
            _simplex.begin(cores);
            var first:int = cores.first.coreKind;
            var second:int = cores.second.coreKind;
            if (first == ConvexShape.POINT && second == ConvexShape.TRIANGLE || first == ConvexShape.TRIANGLE && second == ConvexShape.POINT)
            {
                beginAsTriangle(cores);
            }
            else
            {
                // not setTo, because V8 makes objects of the Numbers where it does not inline the call
                var direction:Vector3D = _simplex.nearest.direction;
                direction.x = cores.x;
                direction.y = cores.y;
                direction.z = cores.z;
            }
            search(cores, out);
        }

        /**
         * Finds the closest points after the first core has moved. The last call must have been about the same two cores. It goes on from their
         * simplex.
         */
        public function findAfterMove(cores:CorePair, out:GjkResult):void
        {
            _simplex.recompute(cores);
            search(cores, out);
        }

        // Begins with the differences of a point and each corner of a triangle: the whole set is one triangle.
        private function beginAsTriangle(cores:CorePair):void
        {
            var isTriangleFirst:Boolean = cores.first.coreKind == ConvexShape.TRIANGLE;
            for (var i:int = 0; i < 9; i += 3)
            {
                var ofFirst:int = isTriangleFirst ? i : 0;
                _simplex.add(cores, ofFirst, i - ofFirst);
            }
            _simplex.reduce(Simplex.NO_NEWEST, false);
        }

        // Searches from the simplex on. If it is empty, only the direction is set.
        private function search(cores:CorePair, out:GjkResult):void
        {
            var nearest:NearestPoint = _simplex.nearest;
            // the least squared distance of all steps
            var least:Number = Infinity;
            out.axis.separation = -Infinity;
            if (_simplex.count > 0)
            {
                least = nearest.squaredDistance;
                writeNearest(cores, out);
            }
            var stalls:int = 0;
            while (stalls < MAX_STALLS && addSupport(cores, out))
            {
                var origin:int = _simplex.reduce(_simplex.count - 1, out.axis.separation > _simplex.rounding);
                if (origin == Simplex.UNDECIDED)
                {
                    // no step can come nearer
                    return;
                }
                if (nearest.squaredDistance < least)
                {
                    least = nearest.squaredDistance;
                    writeNearest(cores, out);
                }
                else
                {
                    stalls++;
                }
                if (origin == Simplex.INSIDE || least <= _simplex.rounding * _simplex.rounding)
                {
                    return;
                }
            }
        }

        // Adds the corner that is farthest towards the origin. Returns false if the search ends: the corner does not bring the simplex nearer, or the
        // cores are too far apart.
        private function addSupport(cores:CorePair, out:GjkResult):Boolean
        {
            var direction:Vector3D = _simplex.nearest.direction;
            var x:Number = direction.x;
            var y:Number = direction.y;
            var z:Number = direction.z;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (!(length > 0))
            {
                return _simplex.count == 0 && _simplex.add(cores, 0, 0);
            }
            x /= length;
            y /= length;
            z /= length;
            var ofFirst:int = cores.first.support(direction, -1);
            var ofSecond:int = cores.second.support(direction, 1);
            var first:Vector.<Number> = cores.first.points;
            var second:Vector.<Number> = cores.second.points;
            var separation:Number = x * (first[ofFirst] - second[ofSecond] + cores.x)
                + y * (first[int(ofFirst + 1)] - second[int(ofSecond + 1)] + cores.y)
                + z * (first[int(ofFirst + 2)] - second[int(ofSecond + 2)] + cores.z);
            if (separation > out.axis.separation)
            {
                out.axis.setTo(x, y, z, separation);
                if (areTooFar(cores, out.axis))
                {
                    out.distance = Infinity;
                    return false;
                }
            }
            // The simplex is in the plane through its nearest point. No corner is beyond that plane if this one is not.
            var corners:Vector.<Number> = _simplex.corners;
            if (_simplex.count > 0 && separation >= x * corners[0] + y * corners[1] + z * corners[2] - _simplex.rounding)
            {
                return false;
            }
            return _simplex.add(cores, ofFirst, ofSecond);
        }

        // Whether the cores are known to be farther apart than the search has to know, also in all the time that is left.
        private static function areTooFar(cores:CorePair, axis:SeparatingAxis):Boolean
        {
            var gap:Number = axis.separation - cores.searchLimit;
            return gap > 0 && gap > -cores.timeLeft * (axis.x * cores.motionX + axis.y * cores.motionY + axis.z * cores.motionZ);
        }

        // Writes the gap between the points that the simplex's nearest point is the difference of. The gap gets the direction to that point, which is
        // more precise.
        private function writeNearest(cores:CorePair, out:GjkResult):void
        {
            var nearest:NearestPoint = _simplex.nearest;
            var direction:Vector3D = nearest.direction;
            var squared:Number = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
            // of a vector as short as rounding nothing may be left across an edge
            var factor:Number = squared > 0 ? Math.sqrt(nearest.squaredDistance / squared) : 0;
            var gap:CoreGap = out.gap;
            gap.x = factor > 0 ? factor * direction.x : nearest.x;
            gap.y = factor > 0 ? factor * direction.y : nearest.y;
            gap.z = factor > 0 ? factor * direction.z : nearest.z;
            out.distance = Math.sqrt(nearest.squaredDistance);
            _simplex.writePoint(cores, gap);
        }
    }
}
