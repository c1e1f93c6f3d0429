package starlogo.fitting.minimal
{
    import starlogo.geometry.ConvexHull;
    import starlogo.geometry.Tolerances;

    /**
     * The outline of a hull as seen along a direction. It is found by walking along the hull's edges: the next corner is the neighbour that
     * leaves all others on its left. So the cost is about the square root of the number of corners. One object can look along many
     * directions. A direction close to the one before is fastest.
     *
     * @private
     */
    internal final class HullOutline
    {
        private static const BACK:Number = Tolerances.OUTLINE_BACK;
        private static const LEVEL:Number = Tolerances.OUTLINE_LEVEL;

        /** The outline's corners, counter-clockwise: their coordinates along the picture's first axis. */
        public var u:Vector.<Number> = new Vector.<Number>();

        /** The corners' coordinates along the picture's second axis. */
        public var v:Vector.<Number> = new Vector.<Number>();

        /** The picture's first axis, a unit vector perpendicular to the direction. */
        public var uX:Number;

        /** @copy #uX */
        public var uY:Number;

        /** @copy #uX */
        public var uZ:Number;

        /** The picture's second axis, a unit vector perpendicular to the direction and the first axis. */
        public var vX:Number;

        /** @copy #vX */
        public var vY:Number;

        /** @copy #vX */
        public var vZ:Number;

        private var _hull:ConvexHull;
        private var _points:Vector.<Number>;
        private var _firstNeighbor:Vector.<int>;
        private var _neighbors:Vector.<int>;
        private var _same:Number;
        private var _bottom:int = 0;
        private var _cluster:Vector.<int> = new Vector.<int>();

        /**
         * @param hull the hull whose outlines are found
         */
        public function HullOutline(hull:ConvexHull)
        {
            _hull = hull;
            _points = hull.convexPoints;
            _firstNeighbor = hull.firstNeighbor;
            _neighbors = hull.neighbors;
            _same = Tolerances.OUTLINE_SAME * hull.extent;
            _same *= _same;
        }

        /**
         * Looks along a direction: sets <code>u</code>, <code>v</code> and the picture's axes.
         *
         * @param x of the direction, a unit vector
         * @param y of the direction
         * @param z of the direction
         */
        public function look(x:Number, y:Number, z:Number):void
        {
            if (x * x <= y * y && x * x <= z * z)
            {
                setFirstAxis(0, z, -y);
            }
            else if (y * y <= z * z)
            {
                setFirstAxis(-z, 0, x);
            }
            else
            {
                setFirstAxis(y, -x, 0);
            }
            vX = y * uZ - z * uY;
            vY = z * uX - x * uZ;
            vZ = x * uY - y * uX;
            walk();
        }

        /** The area that the outline encloses. */
        public function get area():Number
        {
            var count:int = u.length;
            var fromU:Number = u[0];
            var fromV:Number = v[0];
            var lastU:Number = 0;
            var lastV:Number = 0;
            var sum:Number = 0;
            for (var i:int = 1; i < count; i++)
            {
                var toU:Number = u[i] - fromU;
                var toV:Number = v[i] - fromV;
                sum += lastU * toV - lastV * toU;
                lastU = toU;
                lastV = toV;
            }
            return sum / 2;
        }

        private function setFirstAxis(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            uX = x / length;
            uY = y / length;
            uZ = z / length;
        }

        // Fills u and v with the outline's corners, starting at the bottom.
        private function walk():void
        {
            _bottom = _hull.support(-vX, -vY, -vZ, _bottom, _points);
            var corner:int = _bottom;
            var startU:Number = along(corner, uX, uY, uZ);
            var startV:Number = along(corner, vX, vY, vZ);
            var fromU:Number = startU;
            var fromV:Number = startV;
            var alongU:Number = 1;
            var alongV:Number = 0;
            var most:int = _firstNeighbor.length + 2;
            var goesDown:Boolean = false;
            u.length = 0;
            v.length = 0;
            while (u.length < most)
            {
                u.push(fromU);
                v.push(fromV);
                corner = next(corner, fromU, fromV, alongU, alongV);
                if (corner < 0)
                {
                    return;
                }
                var toU:Number = along(corner, uX, uY, uZ);
                var toV:Number = along(corner, vX, vY, vZ);
                if ((toU - startU) * (toU - startU) + (toV - startV) * (toV - startV) <= _same)
                {
                    return;
                }
                alongU = toU - fromU;
                alongV = toV - fromV;
                if (goesDown && alongU > 0 && alongV >= -LEVEL * alongU)
                {
                    // The walk is at the bottom again without having met the start. The start is inside of a side and was skipped.
                    return;
                }
                goesDown = goesDown || alongV < 0 || alongU < 0 && alongV <= -LEVEL * alongU;
                fromU = toU;
                fromV = toV;
            }
        }

        // Finds the neighbour that leaves all others to the left of the line to it. Returns -1 if the picture is a point.
        private function next(corner:int, fromU:Number, fromV:Number, alongU:Number, alongV:Number):int
        {
            var best:int = -1;
            var bestU:Number = 0;
            var bestV:Number = 0;
            var bestSquare:Number = 0;
            _cluster.length = 0;
            _cluster.push(corner);
            for (var i:int = 0; i < _cluster.length; i++)
            {
                var end:int = _firstNeighbor[_cluster[i] + 1];
                for (var k:int = _firstNeighbor[_cluster[i]]; k < end; k++)
                {
                    var neighbor:int = _neighbors[k];
                    var at:int = 3 * neighbor;
                    var x:Number = _points[at];
                    var y:Number = _points[at + 1];
                    var z:Number = _points[at + 2];
                    var toU:Number = x * uX + y * uY + z * uZ - fromU;
                    var toV:Number = x * vX + y * vY + z * vZ - fromV;
                    var square:Number = toU * toU + toV * toV;
                    if (square <= _same)
                    {
                        // The neighbour is at the same place in the picture, farther or nearer along the direction of view. So its
                        // neighbours count too.
                        if (_cluster.indexOf(neighbor) < 0)
                        {
                            _cluster.push(neighbor);
                        }
                        continue;
                    }
                    var turn:Number = alongU * toV - alongV * toU;
                    // straight back, or slightly beyond that by rounding
                    if (turn <= -BACK * (alongU * toU + alongV * toV))
                    {
                        continue;
                    }
                    var side:Number = bestU * toV - bestV * toU;
                    if (best < 0 || side < 0 || side == 0 && square > bestSquare)
                    {
                        best = neighbor;
                        bestU = toU;
                        bestV = toV;
                        bestSquare = square;
                    }
                }
            }
            return best;
        }

        private function along(corner:int, x:Number, y:Number, z:Number):Number
        {
            return _points[3 * corner] * x + _points[3 * corner + 1] * y + _points[3 * corner + 2] * z;
        }
    }
}
