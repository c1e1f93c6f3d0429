package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * The last step of most fits: finds the tightest structure around all vertices. The structure's place or direction is given. The
     * computation has double precision, and takes up to three passes over the vertices.
     *
     * @private
     */
    public final class EnclosingStructures
    {
        /**
         * Finds the smallest sphere with a given centre.
         *
         * @param vertices x, y, z of each
         * @param center of the sphere
         * @param leastRadius the smallest radius that the sphere may have
         */
        public static function sphere(vertices:Vector.<Number>, center:Vector3D, leastRadius:Number = 0):Sphere
        {
            var square:Number = squaredDistance(vertices, farthest(vertices, center), center);
            return new Sphere(center, Math.sqrt(Math.max(square, leastRadius * leastRadius)));
        }

        /** The index of the first number of the vertex that is farthest from a point. */
        public static function farthest(vertices:Vector.<Number>, point:Vector3D):int
        {
            var result:int = 0;
            var most:Number = -1;
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                var x:Number = vertices[i] - point.x;
                var y:Number = vertices[i + 1] - point.y;
                var z:Number = vertices[i + 2] - point.z;
                var square:Number = x * x + y * y + z * z;
                if (square > most)
                {
                    most = square;
                    result = i;
                }
            }
            return result;
        }

        /** The squared distance from a point to the vertex whose first number has the index i. */
        public static function squaredDistance(vertices:Vector.<Number>, i:int, point:Vector3D):Number
        {
            var x:Number = point.x - vertices[i];
            var y:Number = point.y - vertices[i + 1];
            var z:Number = point.z - vertices[i + 2];
            return x * x + y * y + z * z;
        }

        /**
         * Finds the smallest box with given axes.
         *
         * @param vertices x, y, z of each
         * @param axes three perpendicular unit vectors, nine numbers
         */
        public static function box(vertices:Vector.<Number>, axes:Vector.<Number>):Box
        {
            var x:Vector.<Number> = extentAlong(vertices, axes[0], axes[1], axes[2]);
            var y:Vector.<Number> = extentAlong(vertices, axes[3], axes[4], axes[5]);
            var z:Vector.<Number> = extentAlong(vertices, axes[6], axes[7], axes[8]);
            var center:Vector3D = new Vector3D(x[0] * axes[0] + y[0] * axes[3] + z[0] * axes[6], x[0] * axes[1] + y[0] * axes[4] + z[0] * axes[7],
                    x[0] * axes[2] + y[0] * axes[5] + z[0] * axes[8]);
            return new Box(center, new Vector3D(axes[0], axes[1], axes[2]), new Vector3D(axes[3], axes[4], axes[5]),
                    new Vector3D(axes[6], axes[7], axes[8]), x[1], y[1], z[1]);
        }

        /** The middle and half the length of the vertices' extent along a unit vector. */
        public static function extentAlong(vertices:Vector.<Number>, x:Number, y:Number, z:Number):Vector.<Number>
        {
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                var along:Number = vertices[i] * x + vertices[i + 1] * y + vertices[i + 2] * z;
                low = along < low ? along : low;
                high = along > high ? along : high;
            }
            return new <Number>[(low + high) / 2, (high - low) / 2];
        }

        /**
         * Finds the shortest capsule with a given radius whose segment is on a line.
         *
         * @param vertices x, y, z of each
         * @param point on the line
         * @param axis unit vector along the line
         * @param low the segment must begin here or lower: a distance from the point along the axis
         * @param high the segment must end here or higher. If high is less than low, the segment may be anywhere on the line. It is a
         *     point if a point is enough
         * @param radius at least distanceFromLine()
         */
        public static function capsule(vertices:Vector.<Number>, point:Vector3D, axis:Vector3D, low:Number, high:Number,
                radius:Number):Capsule
        {
            var square:Number = radius * radius;
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                var x:Number = vertices[i] - point.x;
                var y:Number = vertices[i + 1] - point.y;
                var z:Number = vertices[i + 2] - point.z;
                var along:Number = x * axis.x + y * axis.y + z * axis.z;
                if (along >= low && along <= high)
                {
                    continue;
                }
                x -= along * axis.x;
                y -= along * axis.y;
                z -= along * axis.z;
                var halfChord:Number = square - (x * x + y * y + z * z);
                halfChord = halfChord > 0 ? Math.sqrt(halfChord) : 0;
                low = along + halfChord < low ? along + halfChord : low;
                high = along - halfChord > high ? along - halfChord : high;
            }
            if (low > high)
            {
                low = high = (low + high) / 2;
            }
            return new Capsule(new Vector3D(point.x + low * axis.x, point.y + low * axis.y, point.z + low * axis.z),
                    new Vector3D(point.x + high * axis.x, point.y + high * axis.y, point.z + high * axis.z), radius);
        }

        /**
         * The largest distance of a vertex from a line.
         *
         * @param vertices x, y, z of each
         * @param point on the line
         * @param axis unit vector along the line
         */
        public static function distanceFromLine(vertices:Vector.<Number>, point:Vector3D, axis:Vector3D):Number
        {
            var most:Number = 0;
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                var x:Number = vertices[i] - point.x;
                var y:Number = vertices[i + 1] - point.y;
                var z:Number = vertices[i + 2] - point.z;
                var along:Number = x * axis.x + y * axis.y + z * axis.z;
                x -= along * axis.x;
                y -= along * axis.y;
                z -= along * axis.z;
                var square:Number = x * x + y * y + z * z;
                most = square > most ? square : most;
            }
            return Math.sqrt(most);
        }
    }
}
