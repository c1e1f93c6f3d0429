package starlogo.fitting.hull
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the lowest point that is on no inner side of some planes: a linear program of three variables. It is solved by the dual simplex
     * method. At any time the point is where three planes meet, and it is the lowest point outside of these three. The plane that the point is
     * farthest inside of replaces one of them, and the point moves up. The search begins with three planes far
     * below.
     *
     * @param planes four numbers for each face: the outward unit normal, and the offset along it. The coordinates of the points on them
     *     are about 1
     * @param faces the faces whose planes count
     * @param count the number of these faces
     * @param upX the direction that is up, of any length
     * @param upY of the direction
     * @param upZ of the direction
     * @param out its coordinates are set if there is such a point
     * @return whether there is a lowest point near the planes
     * @private
     */
    public function findLowestPoint(planes:Vector.<Number>, faces:Vector.<int>, count:int, upX:Number, upY:Number, upZ:Number,
            out:OuterPoint):Boolean
    {
        const FAR:Number = 100;
        const NEAR:Number = 10;
        const MOST_TURNS:int = 40;
        // the three planes: normals and offsets
        var aX:Number = upX < 0 ? -1 : 1;
        var aY:Number = 0;
        var aZ:Number = 0;
        var a:Number = -FAR;
        var bX:Number = 0;
        var bY:Number = upY < 0 ? -1 : 1;
        var bZ:Number = 0;
        var b:Number = -FAR;
        var cX:Number = 0;
        var cY:Number = 0;
        var cZ:Number = upZ < 0 ? -1 : 1;
        var c:Number = -FAR;
        for (var turn:int = 0; turn < MOST_TURNS; turn++)
        {
            // A vector v is the sum of (v . bc) a, (v . ca) b and (v . ab) c, divided by the determinant.
            var bcX:Number = bY * cZ - bZ * cY;
            var bcY:Number = bZ * cX - bX * cZ;
            var bcZ:Number = bX * cY - bY * cX;
            var caX:Number = cY * aZ - cZ * aY;
            var caY:Number = cZ * aX - cX * aZ;
            var caZ:Number = cX * aY - cY * aX;
            var abX:Number = aY * bZ - aZ * bY;
            var abY:Number = aZ * bX - aX * bZ;
            var abZ:Number = aX * bY - aY * bX;
            var determinant:Number = aX * bcX + aY * bcY + aZ * bcZ;
            if (!(Math.abs(determinant) > Tolerances.UNIT_ROUNDING))
            {
                return false;
            }
            var x:Number = (a * bcX + b * caX + c * abX) / determinant;
            var y:Number = (a * bcY + b * caY + c * abY) / determinant;
            var z:Number = (a * bcZ + b * caZ + c * abZ) / determinant;
            var entering:int = -1;
            var most:Number = Tolerances.UNIT_ROUNDING;
            for (var i:int = 0; i < count; i++)
            {
                var at:int = 4 * faces[i];
                var depth:Number = planes[int(at + 3)] - planes[at] * x - planes[int(at + 1)] * y - planes[int(at + 2)] * z;
                if (depth > most)
                {
                    most = depth;
                    entering = at;
                }
            }
            if (entering < 0)
            {
                out.x = x;
                out.y = y;
                out.z = z;
                return Math.abs(x) < NEAR && Math.abs(y) < NEAR && Math.abs(z) < NEAR;
            }
            // The plane leaves whose share of the upward direction is used up first by the share of the entering normal.
            var normalX:Number = planes[entering];
            var normalY:Number = planes[int(entering + 1)];
            var normalZ:Number = planes[int(entering + 2)];
            var shareA:Number = (normalX * bcX + normalY * bcY + normalZ * bcZ) / determinant;
            var shareB:Number = (normalX * caX + normalY * caY + normalZ * caZ) / determinant;
            var shareC:Number = (normalX * abX + normalY * abY + normalZ * abZ) / determinant;
            var lastsA:Number = shareA > Tolerances.UNIT_ROUNDING ? (upX * bcX + upY * bcY + upZ * bcZ) / determinant / shareA : Infinity;
            var lastsB:Number = shareB > Tolerances.UNIT_ROUNDING ? (upX * caX + upY * caY + upZ * caZ) / determinant / shareB : Infinity;
            var lastsC:Number = shareC > Tolerances.UNIT_ROUNDING ? (upX * abX + upY * abY + upZ * abZ) / determinant / shareC : Infinity;
            if (lastsA == Infinity && lastsB == Infinity && lastsC == Infinity)
            {
                // No point is outside of these four planes.
                return false;
            }
            if (lastsA <= lastsB && lastsA <= lastsC)
            {
                aX = normalX;
                aY = normalY;
                aZ = normalZ;
                a = planes[int(entering + 3)];
            }
            else if (lastsB <= lastsC)
            {
                bX = normalX;
                bY = normalY;
                bZ = normalZ;
                b = planes[int(entering + 3)];
            }
            else
            {
                cX = normalX;
                cY = normalY;
                cZ = normalZ;
                c = planes[int(entering + 3)];
            }
        }
        return false;
    }
}
