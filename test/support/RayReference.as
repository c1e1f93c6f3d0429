package support
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;

    /**
     * Where rays meet shapes, found in other ways than the engine's: for structures by going on along the ray as far as the structure is away (Hart,
     * "Sphere tracing", The Visual Computer 12, 1996), for triangles one after the other (Möller and Trumbore, 1997).
     */
    public final class RayReference
    {
        private static const STEPS:int = 400;

        /** How far a point is from a structure; negative or 0 in it. */
        public static function distance(structure:BoundingStructure, point:Vector3D):Number
        {
            if (structure is Sphere)
            {
                return Vector3D.distance(point, Sphere(structure).center) - Sphere(structure).radius;
            }
            if (structure is Capsule)
            {
                var capsule:Capsule = Capsule(structure);
                var along:Vector3D = capsule.end.subtract(capsule.start);
                var offset:Vector3D = point.subtract(capsule.start);
                var share:Number = along.lengthSquared > 0 ? offset.dotProduct(along) / along.lengthSquared : 0;
                along.scaleBy(Math.max(0, Math.min(1, share)));
                return offset.subtract(along).length - capsule.radius;
            }
            if (structure is Hull)
            {
                return heightOver(Hull(structure), point);
            }
            var box:Box = Box(structure);
            var aside:Vector3D = point.subtract(box.center);
            var x:Number = Math.max(0, Math.abs(aside.dotProduct(box.axisX)) - box.halfX);
            var y:Number = Math.max(0, Math.abs(aside.dotProduct(box.axisY)) - box.halfY);
            var z:Number = Math.max(0, Math.abs(aside.dotProduct(box.axisZ)) - box.halfZ);
            return Math.sqrt(x * x + y * y + z * z);
        }

        // How far a point is above the planes of a hull's faces, which is never more than its distance.
        private static function heightOver(hull:Hull, point:Vector3D):Number
        {
            var most:Number = -Infinity;
            var corners:Vector.<Number> = hull.corners;
            for (var i:int = 0; i < hull.faces.length; i += 3)
            {
                var a:Vector3D = cornerOf(corners, hull.faces[i]);
                var normal:Vector3D = cornerOf(corners, hull.faces[i + 1]).subtract(a).crossProduct(cornerOf(corners, hull.faces[i + 2]).subtract(a));
                normal.normalize();
                most = Math.max(most, normal.dotProduct(point.subtract(a)));
            }
            return most;
        }

        private static function cornerOf(corners:Vector.<Number>, corner:int):Vector3D
        {
            return new Vector3D(corners[3 * corner], corners[3 * corner + 1], corners[3 * corner + 2]);
        }

        /**
         * How far along a ray a structure begins.
         *
         * @param direction of length 1
         * @param most how far the ray goes
         * @param near how close is there
         * @return Infinity for never; NaN if the ray passes so closely that it is not clear
         */
        public static function firstTouch(structure:BoundingStructure, origin:Vector3D, direction:Vector3D, most:Number, near:Number):Number
        {
            var at:Number = 0;
            for (var i:int = 0; i < STEPS; i++)
            {
                var gap:Number = distance(structure, pointAt(origin, direction, at));
                if (gap <= near)
                {
                    // neither a face that the ray runs along nor an edge
                    var deeper:Number = distance(structure, pointAt(origin, direction, at + 1e3 * near));
                    return deeper <= near ? at : NaN;
                }
                at += gap;
                if (at > most)
                {
                    return Infinity;
                }
            }
            return NaN;
        }

        /**
         * How far along a ray the nearest triangle is; Infinity for none.
         *
         * @param corners nine numbers a triangle
         * @param direction of length 1
         */
        public static function firstTriangle(corners:Vector.<Number>, origin:Vector3D, direction:Vector3D):Number
        {
            var least:Number = Infinity;
            var dx:Number = direction.x;
            var dy:Number = direction.y;
            var dz:Number = direction.z;
            var length:int = corners.length;
            for (var i:int = 0; i < length; i += 9)
            {
                var x:Number = corners[i];
                var y:Number = corners[int(i + 1)];
                var z:Number = corners[int(i + 2)];
                var ux:Number = corners[int(i + 3)] - x;
                var uy:Number = corners[int(i + 4)] - y;
                var uz:Number = corners[int(i + 5)] - z;
                var vx:Number = corners[int(i + 6)] - x;
                var vy:Number = corners[int(i + 7)] - y;
                var vz:Number = corners[int(i + 8)] - z;
                var px:Number = dy * vz - dz * vy;
                var py:Number = dz * vx - dx * vz;
                var pz:Number = dx * vy - dy * vx;
                var volume:Number = ux * px + uy * py + uz * pz;
                x = origin.x - x;
                y = origin.y - y;
                z = origin.z - z;
                var u:Number = (x * px + y * py + z * pz) / volume;
                if (!(u >= 0 && u <= 1))
                {
                    continue;
                }
                var qx:Number = y * uz - z * uy;
                var qy:Number = z * ux - x * uz;
                var qz:Number = x * uy - y * ux;
                var v:Number = (dx * qx + dy * qy + dz * qz) / volume;
                if (!(v >= 0 && u + v <= 1))
                {
                    continue;
                }
                var at:Number = (vx * qx + vy * qy + vz * qz) / volume;
                if (at >= 0 && at < least)
                {
                    least = at;
                }
            }
            return least;
        }

        private static function pointAt(origin:Vector3D, direction:Vector3D, at:Number):Vector3D
        {
            return new Vector3D(origin.x + at * direction.x, origin.y + at * direction.y, origin.z + at * direction.z);
        }
    }
}
