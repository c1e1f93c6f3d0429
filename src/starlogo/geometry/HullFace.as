package starlogo.geometry
{
    /**
     * A triangle of a hull that QuickHull is building: its corners counter-clockwise seen from outside, its
     * neighbours, its plane, and the list of points beyond that plane that are still to be dealt with.
     * Coordinates are those of QuickHull's grid.
     */
    public final class HullFace
    {
        /** A corner, as the index of a point. */
        public var a:int;

        /** @copy #a */
        public var b:int;

        /** @copy #a */
        public var c:int;

        /** The face across the edge from a to b; the other two alike. */
        public var acrossAB:HullFace;

        /** @copy #acrossAB */
        public var acrossBC:HullFace;

        /** @copy #acrossAB */
        public var acrossCA:HullFace;

        /** The outward normal (b - a) x (c - a): whole numbers below 2^53, hence exact. */
        public var exactX:Number;

        /** @copy #exactX */
        public var exactY:Number;

        /** @copy #exactX */
        public var exactZ:Number;

        /** The outward unit normal, rounded. */
        public var normalX:Number;

        /** @copy #normalX */
        public var normalY:Number;

        /** @copy #normalX */
        public var normalZ:Number;

        /** The plane's distance from the grid's origin along the unit normal. */
        public var offset:Number;

        /** The first point of the list of points beyond this face, -1 when there is none. */
        public var firstOutside:int = -1;

        /** The point of that list farthest from the plane, -1 when there is none. */
        public var farthest:int = -1;

        /** Its distance from the plane. */
        public var farthestDistance:Number = 0;

        /** Whether a later vertex has seen this face: it is no longer part of the hull. */
        public var isBuried:Boolean = false;

        /** Whether a walk over the finished hull has been here. */
        public var isVisited:Boolean = false;

        /**
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
            exactX = crossX;
            exactY = crossY;
            exactZ = crossZ;
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
    }
}
