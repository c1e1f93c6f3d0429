package starlogo.fitting.minimal
{
    import starlogo.geometry.ConvexHull;

    /**
     * Finds the smallest box with one axis along a given direction, exactly. Its other axes are parallel to the sides of the smallest
     * rectangle around the hull's outline, as seen along the direction. One side of this rectangle lies on a side of the outline
     * (Freeman, Shapira, "Determining the Minimum-Area Encasing Rectangle for an Arbitrary Closed Curve", Communications of the ACM
     * 18(7), 1975).
     *
     * <p>One object can measure many directions. A direction close to the one before is fastest (see HullOutline).</p>
     *
     * @private
     */
    public final class BoxAlongAxis
    {
        /** Unit vector along one side of the last box, perpendicular to the direction. The third axis follows from both. */
        public var sideX:Number = 0;

        /** @copy #sideX */
        public var sideY:Number = 0;

        /** @copy #sideX */
        public var sideZ:Number = 0;

        /** The corner of the hull that is farthest along the last direction. */
        public var highest:int = 0;

        /** The corner of the hull that is farthest against the last direction. */
        public var lowest:int = 0;

        private var _hull:ConvexHull;
        private var _points:Vector.<Number>;
        private var _outline:HullOutline;
        private var _u:Vector.<Number>;
        private var _v:Vector.<Number>;

        /**
         * @param hull the hull of the vertices
         */
        public function BoxAlongAxis(hull:ConvexHull)
        {
            _hull = hull;
            _points = hull.convexPoints;
            _outline = new HullOutline(hull);
            _u = _outline.u;
            _v = _outline.v;
        }

        /**
         * The volume of the smallest box with an axis along a direction. Sets <code>sideX</code>, <code>sideY</code> and
         * <code>sideZ</code>.
         *
         * @param x of the direction, a unit vector
         * @param y of the direction
         * @param z of the direction
         * @param enough boxes of this volume or more are of no interest. If the box cannot be smaller, the result may be any volume from
         *     <code>enough</code> to the box's volume, and the sides are not computed
         */
        public function measure(x:Number, y:Number, z:Number, enough:Number = Infinity):Number
        {
            highest = _hull.support(x, y, z, highest, _points);
            lowest = _hull.support(-x, -y, -z, lowest, _points);
            var thickness:Number = (_points[3 * highest] - _points[3 * lowest]) * x
                + (_points[3 * highest + 1] - _points[3 * lowest + 1]) * y
                + (_points[3 * highest + 2] - _points[3 * lowest + 2]) * z;
            _outline.look(x, y, z);
            var atLeast:Number = thickness * _outline.area;
            return atLeast >= enough ? atLeast : Math.max(0, thickness * turnCalipers());
        }

        // The area of the smallest rectangle around the outline. Sets the side. Three corners are followed while the side turns: the
        // farthest along it, away from it, and against it.
        private function turnCalipers():Number
        {
            var count:int = _u.length;
            var least:Number = Infinity;
            var bestU:Number = 1;
            var bestV:Number = 0;
            var right:int = 1;
            var top:int = 1;
            var left:int = 1;
            for (var i:int = 0; i < count && count > 1; i++)
            {
                var u0:Number = _u[i];
                var v0:Number = _v[i];
                var j:int = i + 1 == count ? 0 : i + 1;
                var alongU:Number = _u[j] - u0;
                var alongV:Number = _v[j] - v0;
                var length:Number = Math.sqrt(alongU * alongU + alongV * alongV);
                alongU /= length;
                alongV /= length;
                right = advance(i == 0 ? 1 : right, alongU, alongV);
                top = advance(i == 0 ? right : top, -alongV, alongU);
                left = advance(i == 0 ? top : left, -alongU, -alongV);
                var width:Number = alongU * (_u[right] - _u[left]) + alongV * (_v[right] - _v[left]);
                var area:Number = width * (alongU * (_v[top] - v0) - alongV * (_u[top] - u0));
                if (area < least)
                {
                    least = area;
                    bestU = alongU;
                    bestV = alongV;
                }
            }
            sideX = bestU * _outline.uX + bestV * _outline.vX;
            sideY = bestU * _outline.uY + bestV * _outline.vY;
            sideZ = bestU * _outline.uZ + bestV * _outline.vZ;
            return count < 3 ? 0 : least;
        }

        // Continues around the outline as long as that leads farther in a direction.
        private function advance(from:int, alongU:Number, alongV:Number):int
        {
            var count:int = _u.length;
            if (from >= count)
            {
                from = 0;
            }
            var far:Number = _u[from] * alongU + _v[from] * alongV;
            for (var steps:int = 0; steps < count; steps++)
            {
                var to:int = from + 1 == count ? 0 : from + 1;
                var value:Number = _u[to] * alongU + _v[to] * alongV;
                if (value < far)
                {
                    break;
                }
                far = value;
                from = to;
            }
            return from;
        }
    }
}
