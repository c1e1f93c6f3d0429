package starlogo.fitting
{
    import starlogo.geometry.ConvexHull;
    import starlogo.geometry.Tolerances;

    /**
     * The smallest box with one axis along a given direction, exactly: its other axes lie along the sides of the smallest
     * rectangle around the hull's outline seen along that direction, one side of which lies on a side of the outline
     * (Freeman, Shapira, "Determining the Minimum-Area Encasing Rectangle for an Arbitrary Closed Curve", Communications of the
     * ACM 18(7), 1975).
     *
     * <p>The outline is found by walking along the hull's edges: the next corner is the neighbour that leaves all others to
     * the left. So a measurement costs about the square root of the number of corners, not the number itself. One object is
     * good for many directions; those close to the one before are the fastest.</p>
     */
    internal final class BoxAlongAxis
    {
        private static const BACK:Number = Tolerances.OUTLINE_BACK;
        private static const LEVEL:Number = Tolerances.OUTLINE_LEVEL;

        /** Unit vector along one side of the box last measured, perpendicular to the direction; the third follows. */
        public var sideX:Number = 0;

        /** @copy #sideX */
        public var sideY:Number = 0;

        /** @copy #sideX */
        public var sideZ:Number = 0;

        /** The corner of the hull that is farthest along the direction last measured. */
        public var highest:int = 0;

        /** The corner that is farthest against it. */
        public var lowest:int = 0;

        private var _hull:ConvexHull;
        private var _points:Vector.<Number>;
        private var _firstNeighbor:Vector.<int>;
        private var _neighbors:Vector.<int>;
        private var _same:Number;

        // the picture's axes
        private var _uX:Number;
        private var _uY:Number;
        private var _uZ:Number;
        private var _vX:Number;
        private var _vY:Number;
        private var _vZ:Number;

        // the outline, counter-clockwise
        private var _u:Vector.<Number> = new Vector.<Number>();
        private var _v:Vector.<Number> = new Vector.<Number>();
        private var _bottom:int = 0;
        private var _cluster:Vector.<int> = new Vector.<int>();

        /**
         * @param hull of the vertices
         */
        public function BoxAlongAxis(hull:ConvexHull)
        {
            _hull = hull;
            _points = hull.convexPoints;
            _firstNeighbor = hull.firstNeighbor;
            _neighbors = hull.neighbors;
            _same = Math.pow(Tolerances.OUTLINE_SAME * hull.extent, 2);
        }

        /**
         * The volume of the smallest box with an axis along a direction; its sides are in <code>sideX</code> and so on then.
         *
         * @param x of the direction, a unit vector
         * @param y of the direction
         * @param z of the direction
         * @param enough a volume that is not interesting any more: if the box cannot be smaller, the answer may be any
         *        volume from that to the box's, and its sides are not computed
         */
        public function measure(x:Number, y:Number, z:Number, enough:Number = Infinity):Number
        {
            highest = _hull.support(x, y, z, highest, _points);
            lowest = _hull.support(-x, -y, -z, lowest, _points);
            var thickness:Number = (_points[3 * highest] - _points[3 * lowest]) * x
                + (_points[3 * highest + 1] - _points[3 * lowest + 1]) * y
                + (_points[3 * highest + 2] - _points[3 * lowest + 2]) * z;
            setPicture(x, y, z);
            walk();
            var atLeast:Number = thickness * outlineArea();
            return atLeast >= enough ? atLeast : Math.max(0, thickness * turnCalipers());
        }

        private function setPicture(x:Number, y:Number, z:Number):void
        {
            if (x * x <= y * y && x * x <= z * z)
            {
                setFirst(0, z, -y);
            }
            else if (y * y <= z * z)
            {
                setFirst(-z, 0, x);
            }
            else
            {
                setFirst(y, -x, 0);
            }
            _vX = y * _uZ - z * _uY;
            _vY = z * _uX - x * _uZ;
            _vZ = x * _uY - y * _uX;
        }

        private function setFirst(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            _uX = x / length;
            _uY = y / length;
            _uZ = z / length;
        }

        // Fills _u and _v with the outline's corners, starting at the bottom.
        private function walk():void
        {
            _bottom = _hull.support(-_vX, -_vY, -_vZ, _bottom, _points);
            var corner:int = _bottom;
            var startU:Number = u(corner);
            var startV:Number = v(corner);
            var fromU:Number = startU;
            var fromV:Number = startV;
            var alongU:Number = 1;
            var alongV:Number = 0;
            var most:int = _firstNeighbor.length + 2;
            var goesDown:Boolean = false;
            _u.length = 0;
            _v.length = 0;
            while (_u.length < most)
            {
                _u.push(fromU);
                _v.push(fromV);
                corner = next(corner, fromU, fromV, alongU, alongV);
                if (corner < 0)
                {
                    return;
                }
                var toU:Number = u(corner);
                var toV:Number = v(corner);
                if ((toU - startU) * (toU - startU) + (toV - startV) * (toV - startV) <= _same)
                {
                    return;
                }
                alongU = toU - fromU;
                alongV = toV - fromV;
                if (goesDown && alongU > 0 && alongV >= -LEVEL * alongU)
                {
                    // at the bottom again, without having met the start: it is inside a side, and was passed over
                    return;
                }
                goesDown = goesDown || alongV < 0 || alongU < 0 && alongV <= -LEVEL * alongU;
                fromU = toU;
                fromV = toV;
            }
        }

        // The neighbour that leaves all others to the left of the way to it; -1 if the picture is a point.
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
                    var toU:Number = x * _uX + y * _uY + z * _uZ - fromU;
                    var toV:Number = x * _vX + y * _vY + z * _vZ - fromV;
                    var square:Number = toU * toU + toV * toV;
                    if (square <= _same)
                    {
                        // behind this corner, or before it: its neighbours count too
                        if (_cluster.indexOf(neighbor) < 0)
                        {
                            _cluster.push(neighbor);
                        }
                        continue;
                    }
                    var turn:Number = alongU * toV - alongV * toU;
                    // straight back, or by rounding beyond it
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

        private function u(corner:int):Number
        {
            return _points[3 * corner] * _uX + _points[3 * corner + 1] * _uY + _points[3 * corner + 2] * _uZ;
        }

        private function v(corner:int):Number
        {
            return _points[3 * corner] * _vX + _points[3 * corner + 1] * _vY + _points[3 * corner + 2] * _vZ;
        }

        private function outlineArea():Number
        {
            var count:int = _u.length;
            var fromU:Number = _u[0];
            var fromV:Number = _v[0];
            var lastU:Number = 0;
            var lastV:Number = 0;
            var sum:Number = 0;
            for (var i:int = 1; i < count; i++)
            {
                var toU:Number = _u[i] - fromU;
                var toV:Number = _v[i] - fromV;
                sum += lastU * toV - lastV * toU;
                lastU = toU;
                lastV = toV;
            }
            return sum / 2;
        }

        // The area of the smallest rectangle around the outline; sets the side. Three corners are followed while the side turns:
        // the farthest along it, away from it, and against it.
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
            sideX = bestU * _uX + bestV * _vX;
            sideY = bestU * _uY + bestV * _vY;
            sideZ = bestU * _uZ + bestV * _vZ;
            return count < 3 ? 0 : least;
        }

        // On around the outline for as long as that leads farther in a direction.
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
