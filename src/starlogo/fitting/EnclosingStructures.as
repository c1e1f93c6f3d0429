package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;

    /**
     * The last step of every fit: finds the tightest structure around all vertices. The structure's place or direction is given. The
     * computation has double precision, and takes one or two passes over the vertices.
     *
     * @private
     */
    public final class EnclosingStructures
    {
        /**
         * Finds the smallest sphere with a given centre.
         *
         * @param vertices x, y, z of each
         * @param x of the centre
         * @param y of the centre
         * @param z of the centre
         * @param leastRadius the smallest radius that the sphere may have
         */
        public static function sphere(vertices:Vector.<Number>, x:Number, y:Number, z:Number, leastRadius:Number = 0):Sphere
        {
            var most:Number = leastRadius * leastRadius;
            var length:int = vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var toX:Number = vertices[i] - x;
                var toY:Number = vertices[i + 1] - y;
                var toZ:Number = vertices[i + 2] - z;
                var square:Number = toX * toX + toY * toY + toZ * toZ;
                most = square > most ? square : most;
            }
            return new Sphere(new Vector3D(x, y, z), Math.sqrt(most));
        }

        /**
         * Finds the smallest box with given axes.
         *
         * @param vertices x, y, z of each
         * @param axes three perpendicular unit vectors, nine numbers
         */
        public static function box(vertices:Vector.<Number>, axes:Vector.<Number>):Box
        {
            var xX:Number = axes[0];
            var xY:Number = axes[1];
            var xZ:Number = axes[2];
            var yX:Number = axes[3];
            var yY:Number = axes[4];
            var yZ:Number = axes[5];
            var zX:Number = axes[6];
            var zY:Number = axes[7];
            var zZ:Number = axes[8];
            var lowX:Number = Infinity;
            var lowY:Number = Infinity;
            var lowZ:Number = Infinity;
            var highX:Number = -Infinity;
            var highY:Number = -Infinity;
            var highZ:Number = -Infinity;
            var length:int = vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var x:Number = vertices[i];
                var y:Number = vertices[i + 1];
                var z:Number = vertices[i + 2];
                var along:Number = x * xX + y * xY + z * xZ;
                lowX = along < lowX ? along : lowX;
                highX = along > highX ? along : highX;
                along = x * yX + y * yY + z * yZ;
                lowY = along < lowY ? along : lowY;
                highY = along > highY ? along : highY;
                along = x * zX + y * zY + z * zZ;
                lowZ = along < lowZ ? along : lowZ;
                highZ = along > highZ ? along : highZ;
            }
            x = (lowX + highX) / 2;
            y = (lowY + highY) / 2;
            z = (lowZ + highZ) / 2;
            return new Box(new Vector3D(x * xX + y * yX + z * zX, x * xY + y * yY + z * zY, x * xZ + y * yZ + z * zZ),
                    new Vector3D(xX, xY, xZ), new Vector3D(yX, yY, yZ), new Vector3D(zX, zY, zZ),
                    (highX - lowX) / 2, (highY - lowY) / 2, (highZ - lowZ) / 2);
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
            var pointX:Number = point.x;
            var pointY:Number = point.y;
            var pointZ:Number = point.z;
            var axisX:Number = axis.x;
            var axisY:Number = axis.y;
            var axisZ:Number = axis.z;
            var square:Number = radius * radius;
            var length:int = vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var x:Number = vertices[i] - pointX;
                var y:Number = vertices[i + 1] - pointY;
                var z:Number = vertices[i + 2] - pointZ;
                var along:Number = x * axisX + y * axisY + z * axisZ;
                if (along >= low && along <= high)
                {
                    continue;
                }
                x -= along * axisX;
                y -= along * axisY;
                z -= along * axisZ;
                var reach:Number = square - (x * x + y * y + z * z);
                reach = reach > 0 ? Math.sqrt(reach) : 0;
                low = along + reach < low ? along + reach : low;
                high = along - reach > high ? along - reach : high;
            }
            if (low > high)
            {
                low = high = (low + high) / 2;
            }
            return new Capsule(new Vector3D(pointX + low * axisX, pointY + low * axisY, pointZ + low * axisZ),
                    new Vector3D(pointX + high * axisX, pointY + high * axisY, pointZ + high * axisZ), radius);
        }

        /**
         * Finds the cylinder around a given segment whose radius encloses every vertex. The ends of the segment do not move.
         *
         * @param vertices x, y, z of each
         * @param middle of the segment
         * @param axis unit vector along the segment
         * @param half half of the segment's length
         */
        public static function cylinder(vertices:Vector.<Number>, middle:Vector3D, axis:Vector3D, half:Number):Cylinder
        {
            return new Cylinder(
                    new Vector3D(middle.x - half * axis.x, middle.y - half * axis.y, middle.z - half * axis.z),
                    new Vector3D(middle.x + half * axis.x, middle.y + half * axis.y, middle.z + half * axis.z),
                    distanceFromLine(vertices, middle, axis));
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
            var pointX:Number = point.x;
            var pointY:Number = point.y;
            var pointZ:Number = point.z;
            var axisX:Number = axis.x;
            var axisY:Number = axis.y;
            var axisZ:Number = axis.z;
            var most:Number = 0;
            var length:int = vertices.length;
            for (var i:int = 0; i < length; i += 3)
            {
                var x:Number = vertices[i] - pointX;
                var y:Number = vertices[i + 1] - pointY;
                var z:Number = vertices[i + 2] - pointZ;
                var along:Number = x * axisX + y * axisY + z * axisZ;
                x -= along * axisX;
                y -= along * axisY;
                z -= along * axisZ;
                var square:Number = x * x + y * y + z * z;
                most = square > most ? square : most;
            }
            return Math.sqrt(most);
        }
    }
}
