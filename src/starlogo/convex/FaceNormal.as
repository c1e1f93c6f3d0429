package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * The normal and the plane of a triangle. Its fields are read only.
     *
     * @private
     */
    public final class FaceNormal
    {
        /** The unit normal. It points to the side from which the corners are counter-clockwise. */
        public var x:Number = 0;
        public var y:Number = 0;
        public var z:Number = 0;

        /** Where the plane is: the component of the first corner along the normal. */
        public var offset:Number = 0;

        /** Twice the triangle's area. If it is 0, the normal means nothing. */
        public var doubleArea:Number = 0;

        /** Whether the triangle counts as a segment, so that its normal is a rounding error. */
        public var isFlat:Boolean = false;

        /** Sets it to a triangle: nine numbers of a list, from an index on. */
        public function setTriangle(p:Vector.<Number>, at:int):void
        {
            var ux:Number = p[int(at + 3)] - p[at];
            var uy:Number = p[int(at + 4)] - p[int(at + 1)];
            var uz:Number = p[int(at + 5)] - p[int(at + 2)];
            var vx:Number = p[int(at + 6)] - p[at];
            var vy:Number = p[int(at + 7)] - p[int(at + 1)];
            var vz:Number = p[int(at + 8)] - p[int(at + 2)];
            var edgesSquared:Number = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz;
            x = uy * vz - uz * vy;
            y = uz * vx - ux * vz;
            z = ux * vy - uy * vx;
            doubleArea = Math.sqrt(x * x + y * y + z * z);
            isFlat = !(doubleArea * doubleArea > Tolerances.FLAT_TRIANGLE * edgesSquared * edgesSquared);
            x /= doubleArea;
            y /= doubleArea;
            z /= doubleArea;
            offset = x * p[at] + y * p[int(at + 1)] + z * p[int(at + 2)];
        }

        /** Sets the normal and the plane to no number, so that all comparisons with them are false. */
        public function clear():void
        {
            x = y = z = offset = NaN;
        }

        /** Finds how far the points of a part of a list extend along the normal. The results are NaN if the normal is. */
        public function project(points:Vector.<Number>, from:int, end:int, out:Interval):void
        {
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for (var i:int = from; i < end; i += 3)
            {
                var along:Number = x * points[i] + y * points[int(i + 1)] + z * points[int(i + 2)];
                low = low < along ? low : along;
                high = high > along ? high : along;
            }
            out.least = low;
            out.greatest = high;
        }
    }
}
