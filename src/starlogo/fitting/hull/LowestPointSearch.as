package starlogo.fitting.hull
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the lowest point that is behind none of some planes. This is a linear program of three variables, and the dual simplex method solves
     * it. Three of the planes are the basis: the point is where they meet, and it is the lowest that is behind none of the three. In each iteration
     * the plane that the point is farthest behind enters the basis in place of one of the three, and the point moves up. The first basis is three
     * planes far below.
     *
     * <p>A plane has four numbers: the outward unit normal, and the offset along it. For each plane of the basis there is also the cross product of
     * the normals of the other two. A vector's share of a normal of the basis is its dot product with this cross product, over the determinant.</p>
     */
    internal final class LowestPointSearch
    {
        // The coordinates of points on the planes are about 1.
        private static const FAR:Number = 100;
        private static const NEAR:Number = 10;
        private static const MAX_ITERATIONS:int = 40;

        private static var sBasis:Vector.<Number> = new Vector.<Number>(12, true);
        private static var sCrossProducts:Vector.<Number> = new Vector.<Number>(9, true);

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
            var basis:Vector.<Number> = sBasis;
            var crossProducts:Vector.<Number> = sCrossProducts;
            writeFirstBasis(upX, upY, upZ, basis);
            for (var iteration:int = 0; iteration < MAX_ITERATIONS; iteration++)
            {
                var determinant:Number = findMeetingPoint(basis, crossProducts, out);
                if (!(Math.abs(determinant) > Tolerances.UNIT_ROUNDING))
                {
                    return false;
                }
                var entering:int = farthestBehind(planes, out);
                if (entering < 0)
                {
                    return Math.abs(out.x) < NEAR && Math.abs(out.y) < NEAR && Math.abs(out.z) < NEAR;
                }
                var leaving:int = leavingFor(planes, entering, crossProducts, determinant, upX, upY, upZ);
                if (leaving < 0)
                {
                    return false;
                }
                for (var i:int = 0; i < 4; i++)
                {
                    basis[int(4 * leaving + i)] = planes[int(entering + i)];
                }
            }
            return false;
        }

        // Writes the first basis, with normals along the axes.
        private static function writeFirstBasis(upX:Number, upY:Number, upZ:Number, out:Vector.<Number>):void
        {
            out[0] = upX < 0 ? -1 : 1;
            out[5] = upY < 0 ? -1 : 1;
            out[10] = upZ < 0 ? -1 : 1;
            out[1] = out[2] = out[4] = out[6] = out[8] = out[9] = 0;
            out[3] = out[7] = out[11] = -FAR;
        }

        // Finds the cross products, and the point where the planes of the basis meet. Returns the determinant of the normals; the point is right only
        // if that is not 0.
        private static function findMeetingPoint(basis:Vector.<Number>, crossProducts:Vector.<Number>, out:EdgeCollapse):Number
        {
            writeCross(basis, 4, 8, crossProducts, 0);
            writeCross(basis, 8, 0, crossProducts, 3);
            writeCross(basis, 0, 4, crossProducts, 6);
            var determinant:Number = basis[0] * crossProducts[0] + basis[1] * crossProducts[1] + basis[2] * crossProducts[2];
            out.x = (basis[3] * crossProducts[0] + basis[7] * crossProducts[3] + basis[11] * crossProducts[6]) / determinant;
            out.y = (basis[3] * crossProducts[1] + basis[7] * crossProducts[4] + basis[11] * crossProducts[7]) / determinant;
            out.z = (basis[3] * crossProducts[2] + basis[7] * crossProducts[5] + basis[11] * crossProducts[8]) / determinant;
            return determinant;
        }

        // Writes the cross product of the normals at two indices.
        private static function writeCross(basis:Vector.<Number>, first:int, second:int, out:Vector.<Number>, at:int):void
        {
            var aX:Number = basis[first];
            var aY:Number = basis[int(first + 1)];
            var aZ:Number = basis[int(first + 2)];
            var bX:Number = basis[second];
            var bY:Number = basis[int(second + 1)];
            var bZ:Number = basis[int(second + 2)];
            out[at] = aY * bZ - aZ * bY;
            out[int(at + 1)] = aZ * bX - aX * bZ;
            out[int(at + 2)] = aX * bY - aY * bX;
        }

        // The first number of the plane that a point is farthest behind; -1 if it is behind none.
        private static function farthestBehind(planes:Vector.<Number>, point:EdgeCollapse):int
        {
            var x:Number = point.x;
            var y:Number = point.y;
            var z:Number = point.z;
            var faces:Vector.<int> = point.faces;
            var count:int = point.faceCount;
            var deepest:int = -1;
            var maxDepth:Number = Tolerances.UNIT_ROUNDING;
            for (var i:int = 0; i < count; i++)
            {
                var at:int = 4 * faces[i];
                var depth:Number = planes[int(at + 3)] - planes[at] * x - planes[int(at + 1)] * y - planes[int(at + 2)] * z;
                if (depth > maxDepth)
                {
                    maxDepth = depth;
                    deepest = at;
                }
            }
            return deepest;
        }

        // Which plane of the basis leaves for the entering one: the one with the least ratio of the upward direction's share to the entering normal's share.
        // -1 if each point is behind one of the four planes.
        private static function leavingFor(planes:Vector.<Number>, entering:int, crossProducts:Vector.<Number>, determinant:Number,
                upX:Number, upY:Number, upZ:Number):int
        {
            var normalX:Number = planes[entering];
            var normalY:Number = planes[int(entering + 1)];
            var normalZ:Number = planes[int(entering + 2)];
            var leaving:int = -1;
            var least:Number = Infinity;
            for (var i:int = 0; i < 3; i++)
            {
                var x:Number = crossProducts[int(3 * i)];
                var y:Number = crossProducts[int(3 * i + 1)];
                var z:Number = crossProducts[int(3 * i + 2)];
                var share:Number = (normalX * x + normalY * y + normalZ * z) / determinant;
                var ratio:Number = share > Tolerances.UNIT_ROUNDING ? (upX * x + upY * y + upZ * z) / determinant / share : Infinity;
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
