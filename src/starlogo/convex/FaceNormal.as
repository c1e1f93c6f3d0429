package starlogo.convex
{
    /**
     * The normal of a triangle, and how far points extend along it.
     *
     * @private
     */
    public final class FaceNormal
    {
        /** The unit normal. It points to the side from which the corners are counter-clockwise. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Twice the triangle's area. If it is 0, the normal means nothing. */
        public var length:Number = 0;

        /** The sum of the squares of the two edges at the first corner. */
        public var squared:Number = 0;

        /** The least and the greatest component along the normal that <code>measure()</code> has found. */
        public var least:Number = 0;
        public var greatest:Number = 0;

        /** Sets it to a triangle: nine numbers of a list, from an index on. */
        public function setTriangle(p:Vector.<Number>, at:int):void
        {
            var ux:Number = p[int(at + 3)] - p[at];
            var uy:Number = p[int(at + 4)] - p[int(at + 1)];
            var uz:Number = p[int(at + 5)] - p[int(at + 2)];
            var vx:Number = p[int(at + 6)] - p[at];
            var vy:Number = p[int(at + 7)] - p[int(at + 1)];
            var vz:Number = p[int(at + 8)] - p[int(at + 2)];
            squared = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz;
            x = uy * vz - uz * vy;
            y = uz * vx - ux * vz;
            z = ux * vy - uy * vx;
            length = Math.sqrt(x * x + y * y + z * z);
            x /= length;
            y /= length;
            z /= length;
        }

        /** Sets the normal to no number, so that all comparisons with it are false. */
        public function clear():void
        {
            x = y = z = NaN;
        }

        /** Finds how far the points of a part of a list extend along the normal. The results are NaN if the normal is. */
        public function measure(points:Vector.<Number>, from:int, end:int):void
        {
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for (var i:int = from; i < end; i += 3)
            {
                var along:Number = x * points[i] + y * points[int(i + 1)] + z * points[int(i + 2)];
                low = low < along ? low : along;
                high = high > along ? high : along;
            }
            least = low;
            greatest = high;
        }
    }
}
