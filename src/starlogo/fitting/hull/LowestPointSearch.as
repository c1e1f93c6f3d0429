package starlogo.fitting.hull
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the lowest point that is on no inner side of some planes: a linear program of three variables. It is solved by the dual simplex
     * method. At any time the point is where three planes meet, and it is the lowest point outside of these three. The plane that the point is
     * farthest inside of replaces one of them, and the point moves up. The search begins with three planes far below.
     *
     * <p>The three planes have four numbers each: the outward unit normal, and the offset along it. Each plane also has the cross product of
     * the normals of the other two. A vector v is the sum of (v . cross product) times normal, divided by the determinant of the normals.</p>
     */
    internal final class LowestPointSearch
    {
        // The coordinates of points on the planes are about 1.
        private static const FAR:Number = 100;
        private static const NEAR:Number = 10;
        private static const MAX_TURNS:int = 40;

        private static var sThree:Vector.<Number> = new Vector.<Number>(12, true);
        private static var sCrosses:Vector.<Number> = new Vector.<Number>(9, true);

        /**
         * Finds the point.
         *
         * @param planes four numbers for each face: the outward unit normal, and the offset along it
         * @param upX the direction that is up, of any length
         * @param upY of the direction
         * @param upZ of the direction
         * @param out has the faces whose planes count; its coordinates are set
         * @return whether there is a lowest point near the planes
         */
        public static function find(planes:Vector.<Number>, upX:Number, upY:Number, upZ:Number, out:EdgeCollapse):Boolean
        {
            var three:Vector.<Number> = sThree;
            var crosses:Vector.<Number> = sCrosses;
            writePlanesFarBelow(upX, upY, upZ, three);
            for (var turn:int = 0; turn < MAX_TURNS; turn++)
            {
                var determinant:Number = findMeetingPoint(three, crosses, out);
                if (!(Math.abs(determinant) > Tolerances.UNIT_ROUNDING))
                {
                    return false;
                }
                var entering:int = farthestInside(planes, out);
                if (entering < 0)
                {
                    return Math.abs(out.x) < NEAR && Math.abs(out.y) < NEAR && Math.abs(out.z) < NEAR;
                }
                var leaving:int = leavingFor(planes, entering, crosses, determinant, upX, upY, upZ);
                if (leaving < 0)
                {
                    return false;
                }
                for (var i:int = 0; i < 4; i++)
                {
                    three[int(4 * leaving + i)] = planes[int(entering + i)];
                }
            }
            return false;
        }

        // Writes three planes with normals along the axes.
        private static function writePlanesFarBelow(upX:Number, upY:Number, upZ:Number, out:Vector.<Number>):void
        {
            out[0] = upX < 0 ? -1 : 1;
            out[5] = upY < 0 ? -1 : 1;
            out[10] = upZ < 0 ? -1 : 1;
            out[1] = out[2] = out[4] = out[6] = out[8] = out[9] = 0;
            out[3] = out[7] = out[11] = -FAR;
        }

        // Finds the point where the three planes meet, and the cross products. Returns the determinant of the normals; the point is right only if
        // that is not 0.
        private static function findMeetingPoint(three:Vector.<Number>, crosses:Vector.<Number>, out:EdgeCollapse):Number
        {
            writeCross(three, 4, 8, crosses, 0);
            writeCross(three, 8, 0, crosses, 3);
            writeCross(three, 0, 4, crosses, 6);
            var determinant:Number = three[0] * crosses[0] + three[1] * crosses[1] + three[2] * crosses[2];
            var a:Number = three[3];
            var b:Number = three[7];
            var c:Number = three[11];
            out.x = (a * crosses[0] + b * crosses[3] + c * crosses[6]) / determinant;
            out.y = (a * crosses[1] + b * crosses[4] + c * crosses[7]) / determinant;
            out.z = (a * crosses[2] + b * crosses[5] + c * crosses[8]) / determinant;
            return determinant;
        }

        // Writes the cross product of the normals at two places.
        private static function writeCross(three:Vector.<Number>, first:int, second:int, out:Vector.<Number>, at:int):void
        {
            var aX:Number = three[first];
            var aY:Number = three[int(first + 1)];
            var aZ:Number = three[int(first + 2)];
            var bX:Number = three[second];
            var bY:Number = three[int(second + 1)];
            var bZ:Number = three[int(second + 2)];
            out[at] = aY * bZ - aZ * bY;
            out[int(at + 1)] = aZ * bX - aX * bZ;
            out[int(at + 2)] = aX * bY - aY * bX;
        }

        // The first number of the plane that a point is farthest inside of; -1 if it is inside of none.
        private static function farthestInside(planes:Vector.<Number>, point:EdgeCollapse):int
        {
            var x:Number = point.x;
            var y:Number = point.y;
            var z:Number = point.z;
            var faces:Vector.<int> = point.faces;
            var count:int = point.faceCount;
            var found:int = -1;
            var most:Number = Tolerances.UNIT_ROUNDING;
            for (var i:int = 0; i < count; i++)
            {
                var at:int = 4 * faces[i];
                var depth:Number = planes[int(at + 3)] - planes[at] * x - planes[int(at + 1)] * y - planes[int(at + 2)] * z;
                if (depth > most)
                {
                    most = depth;
                    found = at;
                }
            }
            return found;
        }

        // Which of the three planes leaves for the entering one: the one whose share of the upward direction is used up first by its share of
        // the entering normal. -1 if no point is outside of the four planes.
        private static function leavingFor(planes:Vector.<Number>, entering:int, crosses:Vector.<Number>, determinant:Number,
                upX:Number, upY:Number, upZ:Number):int
        {
            var normalX:Number = planes[entering];
            var normalY:Number = planes[int(entering + 1)];
            var normalZ:Number = planes[int(entering + 2)];
            var leaving:int = -1;
            var least:Number = Infinity;
            for (var i:int = 0; i < 3; i++)
            {
                var x:Number = crosses[int(3 * i)];
                var y:Number = crosses[int(3 * i + 1)];
                var z:Number = crosses[int(3 * i + 2)];
                var fraction:Number = (normalX * x + normalY * y + normalZ * z) / determinant;
                var ratio:Number = fraction > Tolerances.UNIT_ROUNDING ? (upX * x + upY * y + upZ * z) / determinant / fraction : Infinity;
                if (ratio < least)
                {
                    least = ratio;
                    leaving = i;
                }
            }
            return leaving;
        }
    }
}
