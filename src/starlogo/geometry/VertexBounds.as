package starlogo.geometry
{
    /**
     * The axis-aligned box around vertices, which may be looked at some at a time, and whether they are numbers.
     *
     * @private
     */
    public final class VertexBounds
    {
        /** Products of three coordinates up to this are finite. Hulls and hierarchies refuse larger ones. */
        public static const LARGEST_COORDINATE:Number = 1e100;

        /** The least x. */
        public var minX:Number = Infinity;

        /** The least y. */
        public var minY:Number = Infinity;

        /** The least z. */
        public var minZ:Number = Infinity;

        /** The greatest x. */
        public var maxX:Number = -Infinity;

        /** The greatest y. */
        public var maxY:Number = -Infinity;

        /** The greatest z. */
        public var maxZ:Number = -Infinity;

        /** Whether all coordinates were finite numbers: the box is only right if they were. */
        public var areFinite:Boolean = true;

        /** A box around nothing. */
        public function VertexBounds()
        {
        }

        /** The longest side of the box. */
        public function get extent():Number
        {
            return Math.max(maxX - minX, maxY - minY, maxZ - minZ);
        }

        /** The largest absolute coordinate. */
        public function get largest():Number
        {
            return Math.max(-minX, -minY, -minZ, maxX, maxY, maxZ);
        }

        /** Throws an ArgumentError if an absolute coordinate is too large. */
        public static function requireWithin(largest:Number):void
        {
            if (!(largest <= LARGEST_COORDINATE))
            {
                throw new ArgumentError("coordinates must be at most " + LARGEST_COORDINATE + ": " + largest);
            }
        }

        /**
         * Takes vertices in.
         *
         * @param vertices x, y, z each
         * @param first the number of the first of them
         * @param end the number of the one behind the last
         */
        public function add(vertices:Vector.<Number>, first:int, end:int):void
        {
            var differences:Number = 0;
            var lowX:Number = minX;
            var lowY:Number = minY;
            var lowZ:Number = minZ;
            var highX:Number = maxX;
            var highY:Number = maxY;
            var highZ:Number = maxZ;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var x:Number = vertices[i];
                var y:Number = vertices[int(i + 1)];
                var z:Number = vertices[int(i + 2)];
                // infinity minus itself is NaN
                differences += (x - x) + (y - y) + (z - z);
                lowX = x < lowX ? x : lowX;
                highX = x > highX ? x : highX;
                lowY = y < lowY ? y : lowY;
                highY = y > highY ? y : highY;
                lowZ = z < lowZ ? z : lowZ;
                highZ = z > highZ ? z : highZ;
            }
            areFinite = areFinite && differences == 0;
            minX = lowX;
            minY = lowY;
            minZ = lowZ;
            maxX = highX;
            maxY = highY;
            maxZ = highZ;
        }
    }
}
