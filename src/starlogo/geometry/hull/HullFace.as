package starlogo.geometry.hull
{
    import starlogo.geometry.Tolerances;

    /**
     * A triangle of the hull that QuickHull is building: its corners counter-clockwise seen from outside, its neighbours, its plane, and
     * the list of points beyond that plane that QuickHull has not processed yet. Coordinates are those of QuickHull's grid.
     *
     * <p>QuickHull writes the neighbours and the state. OutsidePoints writes the lists. All else is read only.</p>
     */
    internal final class HullFace
    {
        /** The states: part of the hull; buried in it, because a vertex that was added later lies beyond the face; listed after the hull was built. */
        public static const ON_HULL:int = 0;
        public static const BURIED:int = 1;
        public static const LISTED:int = 2;

        // The number at which a normal's components are split for exact products.
        private static const SPLIT:Number = 67108864;

        /** A corner, as the index of a point. */
        public var a:int;
        public var b:int;
        public var c:int;

        /** The neighbours: the faces across the edges from a to b, from b to c and from c to a. */
        public var acrossAB:HullFace;
        public var acrossBC:HullFace;
        public var acrossCA:HullFace;

        /** The outward unit normal, rounded. */
        public var normalX:Number;
        public var normalY:Number;
        public var normalZ:Number;

        /** The plane's distance from the grid's origin along the unit normal. */
        public var offset:Number;

        /** The first point on the list of points beyond this face, or -1 if there is none. */
        public var firstOutside:int = -1;

        /** The point on that list that is farthest from the plane, or -1 if there is none. */
        public var farthest:int = -1;

        /** The farthest point's distance from the plane. */
        public var farthestDistance:Number = 0;

        /** One of the states. */
        public var state:int = ON_HULL;

        // The outward normal (b - a) x (c - a). It is exact, because its components are whole numbers below 2^53.
        private var _exactX:Number;
        private var _exactY:Number;
        private var _exactZ:Number;

        /**
         * A face without neighbours, and without points beyond it.
         *
         * @param points x, y, z of every point
         * @param a index of the first corner
         * @param b index of the second, counter-clockwise seen from outside
         * @param c index of the third
         */
        public function HullFace(points:Vector.<Number>, a:int, b:int, c:int)
        {
            this.a = a;
            this.b = b;
            this.c = c;
            var i:int = 3 * a;
            var x:Number = points[i];
            var y:Number = points[i + 1];
            var z:Number = points[i + 2];
            i = 3 * b;
            var abX:Number = points[i] - x;
            var abY:Number = points[i + 1] - y;
            var abZ:Number = points[i + 2] - z;
            i = 3 * c;
            var acX:Number = points[i] - x;
            var acY:Number = points[i + 1] - y;
            var acZ:Number = points[i + 2] - z;
            var crossX:Number = abY * acZ - abZ * acY;
            var crossY:Number = abZ * acX - abX * acZ;
            var crossZ:Number = abX * acY - abY * acX;
            var scale:Number = 1 / Math.sqrt(crossX * crossX + crossY * crossY + crossZ * crossZ);
            _exactX = crossX;
            _exactY = crossY;
            _exactZ = crossZ;
            normalX = crossX * scale;
            normalY = crossY * scale;
            normalZ = crossZ * scale;
            offset = (crossX * x + crossY * y + crossZ * z) * scale;
        }

        /** Makes <code>face</code> the neighbour across the edge that runs from <code>from</code> to <code>to</code> here. */
        public function setNeighbor(from:int, to:int, face:HullFace):void
        {
            if (from == a && to == b)
            {
                acrossAB = face;
            }
            else if (from == b && to == c)
            {
                acrossBC = face;
            }
            else
            {
                acrossCA = face;
            }
        }

        /** The side of the face's plane on which a point is: 1 beyond it, -1 behind it, and 0 if it is exactly in the plane. */
        public function side(points:Vector.<Number>, point:int):int
        {
            var x:Number = points[3 * point];
            var y:Number = points[3 * point + 1];
            var z:Number = points[3 * point + 2];
            var distance:Number = normalX * x + normalY * y + normalZ * z - offset;
            if (distance > Tolerances.HULL_CERTAIN || distance < -Tolerances.HULL_CERTAIN)
            {
                return distance > 0 ? 1 : -1;
            }
            x -= points[3 * a];
            y -= points[3 * a + 1];
            z -= points[3 * a + 2];
            var highX:Number = Math.floor(_exactX / SPLIT);
            var highY:Number = Math.floor(_exactY / SPLIT);
            var highZ:Number = Math.floor(_exactZ / SPLIT);
            var high:Number = highX * x + highY * y + highZ * z;
            var low:Number = (_exactX - highX * SPLIT) * x + (_exactY - highY * SPLIT) * y
                + (_exactZ - highZ * SPLIT) * z;
            var exact:Number = high * SPLIT + low;
            return exact > 0 ? 1 : exact < 0 ? -1 : 0;
        }

        /** Whether a point is over the triangle, or over a place that is at most HULL_COPLANAR beside it. */
        public function isOver(points:Vector.<Number>, x:Number, y:Number, z:Number):Boolean
        {
            return isWithinEdge(points, a, b, x, y, z) && isWithinEdge(points, b, c, x, y, z) && isWithinEdge(points, c, a, x, y, z);
        }

        // Whether a point is on the inner side of an edge, or at most HULL_COPLANAR beside it and past its ends. Beyond the tip of a narrow triangle,
        // places far from the triangle are near the lines of two edges.
        private function isWithinEdge(points:Vector.<Number>, from:int, to:int, x:Number, y:Number, z:Number):Boolean
        {
            var edgeX:Number = points[3 * to] - points[3 * from];
            var edgeY:Number = points[3 * to + 1] - points[3 * from + 1];
            var edgeZ:Number = points[3 * to + 2] - points[3 * from + 2];
            x -= points[3 * from];
            y -= points[3 * from + 1];
            z -= points[3 * from + 2];
            var outside:Number = normalX * (edgeZ * y - edgeY * z) + normalY * (edgeX * z - edgeZ * x) + normalZ * (edgeY * x - edgeX * y);
            if (outside <= 0)
            {
                return true;
            }
            var along:Number = edgeX * x + edgeY * y + edgeZ * z;
            var square:Number = edgeX * edgeX + edgeY * edgeY + edgeZ * edgeZ;
            var slack:Number = Tolerances.HULL_COPLANAR * Math.sqrt(square);
            return outside <= slack && along >= -slack && along <= square + slack;
        }
    }
}
