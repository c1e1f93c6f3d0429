package starlogo.geometry.vertices
{
    /**
     * The axis-aligned box around vertices, and whether all their coordinates are finite. Vertices can be added a part at a time.
     *
     * @private
     */
    public final class VertexBounds
    {
        /** The largest coordinate that hulls and hierarchies accept. The structures around such vertices are within their limits. */
        public static const LARGEST_VERTEX:Number = 1e60;

        /** The least coordinates. */
        public var minX:Number = Infinity;
        public var minY:Number = Infinity;
        public var minZ:Number = Infinity;

        /** The greatest coordinates. */
        public var maxX:Number = -Infinity;
        public var maxY:Number = -Infinity;
        public var maxZ:Number = -Infinity;

        /** Whether all coordinates were finite. Otherwise the box is wrong. */
        public var areFinite:Boolean = true;

        /** Leaves no vertices. */
        public function clear():void
        {
            minX = minY = minZ = Infinity;
            maxX = maxY = maxZ = -Infinity;
            areFinite = true;
        }

        /** The box around all vertices of a list: x, y, z of each. */
        public static function of(vertices:Vector.<Number>):VertexBounds
        {
            var bounds:VertexBounds = new VertexBounds();
            bounds.add(vertices, 0, vertices.length / 3);
            return bounds;
        }

        /** The length of the box in x. */
        public function get extentX():Number
        {
            return maxX - minX;
        }

        /** The length of the box in y. */
        public function get extentY():Number
        {
            return maxY - minY;
        }

        /** The length of the box in z. */
        public function get extentZ():Number
        {
            return maxZ - minZ;
        }

        /** The longest side of the box. */
        public function get extent():Number
        {
            return Math.max(extentX, extentY, extentZ);
        }

        /** The largest absolute coordinate. */
        public function get largest():Number
        {
            return Math.max(-minX, -minY, -minZ, maxX, maxY, maxZ);
        }

        /** Throws an ArgumentError if the largest absolute coordinate is too large. @param beginning the beginning of its message */
        public static function requireWithin(largest:Number, beginning:String = ""):void
        {
            if (!(largest <= LARGEST_VERTEX))
            {
                throw new ArgumentError(beginning + "coordinates must be at most " + LARGEST_VERTEX + ": " + largest);
            }
        }

        /**
         * Adds vertices.
         *
         * @param vertices x, y, z of each
         * @param first index of the first vertex to add
         * @param end index after the last vertex to add
         */
        public function add(vertices:Vector.<Number>, first:int, end:int):void
        {
            var differences:Number = 0;
            for (var i:int = 3 * first; i < 3 * end; i += 3)
            {
                var x:Number = vertices[i];
                var y:Number = vertices[int(i + 1)];
                var z:Number = vertices[int(i + 2)];
                // Infinity minus itself is NaN.
                differences += (x - x) + (y - y) + (z - z);
                minX = x < minX ? x : minX;
                maxX = x > maxX ? x : maxX;
                minY = y < minY ? y : minY;
                maxY = y > maxY ? y : maxY;
                minZ = z < minZ ? z : minZ;
                maxZ = z > maxZ ? z : maxZ;
            }
            areFinite = areFinite && differences == 0;
        }
    }
}
