package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /**
     * Finds the point of a simplex that is nearest to the origin, a part at a time: a corner, an edge or a triangle. A part is tried together with the
     * smaller parts that it is made of.
     *
     * <p>In a triangle the point is located along the longest edge first and then across it. The usual weights, from areas over the triangle's sides
     * (Ericson, "Real-Time Collision Detection", §5.1.5), cancel in needles. The direction to the point is the triangle's own normal where that is more
     * precise than the vector to the point. So needles and tiny distances lose no digits.</p>
     *
     * <p>In the arithmetic, u is the vector of an edge, h the height of a triangle over it, and uu and hh are their squared lengths. (toX, toY, toZ) is
     * the vector from the origin to the point as far as it is known. All methods take the corners w of the simplex, x, y, z of each, and the indices
     * i, j, k of some. <code>newest</code> is the corner that was added last: no part without it is tried, because the simplex before was nearer than
     * that. It is -1 if all parts are. <code>out</code> has the nearest point so far, and receives a nearer one.</p>
     *
     * @private
     */
    public final class SimplexPart
    {
        // How far outside of a triangle a point may be because of rounding, as a weight.
        private static const BORDER:Number = 1e-15;

        /** The weight of a triangle's corner that has no share of a point on the triangle's border. It is kept, as corners without a weight are not. */
        public static const LEAST_WEIGHT:Number = 1e-300;

        /** Tries a corner. */
        public static function tryCorner(w:Vector.<Number>, i:int, out:NearestPoint):void
        {
            var at:int = 3 * i;
            var toX:Number = w[at];
            var toY:Number = w[int(at + 1)];
            var toZ:Number = w[int(at + 2)];
            var squared:Number = toX * toX + toY * toY + toZ * toZ;
            if (squared < out.squaredDistance)
            {
                out.squaredDistance = squared;
                out.clearWeights();
                out.weights[i] = 1;
                out.x = out.direction.x = toX;
                out.y = out.direction.y = toY;
                out.z = out.direction.z = toZ;
            }
        }

        /** Tries the edge between two corners. */
        public static function tryEdge(w:Vector.<Number>, i:int, j:int, newest:int, out:NearestPoint):void
        {
            var from:int = 3 * i;
            var to:int = 3 * j;
            var toX:Number = w[from];
            var toY:Number = w[int(from + 1)];
            var toZ:Number = w[int(from + 2)];
            var ux:Number = w[to] - toX;
            var uy:Number = w[int(to + 1)] - toY;
            var uz:Number = w[int(to + 2)] - toZ;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var projection:Number = -(toX * ux + toY * uy + toZ * uz);
            if (!(projection > 0) || projection >= uu)
            {
                var end:int = projection > 0 ? j : i;
                if (newest < 0 || newest == end)
                {
                    tryCorner(w, end, out);
                }
                return;
            }
            var fraction:Number = projection / uu;
            toX += fraction * ux;
            toY += fraction * uy;
            toZ += fraction * uz;
            var squared:Number = toX * toX + toY * toY + toZ * toZ;
            if (squared < out.squaredDistance)
            {
                out.squaredDistance = squared;
                out.clearWeights();
                out.weights[i] = 1 - fraction;
                out.weights[j] = fraction;
                out.x = toX;
                out.y = toY;
                out.z = toZ;
                setDirectionAcross(w, from, to, out);
            }
        }

        // Sets the direction to the point, but perpendicular to an edge. A short vector to the point is not quite perpendicular.
        private static function setDirectionAcross(w:Vector.<Number>, from:int, to:int, out:NearestPoint):void
        {
            var ux:Number = w[to] - w[from];
            var uy:Number = w[int(to + 1)] - w[int(from + 1)];
            var uz:Number = w[int(to + 2)] - w[int(from + 2)];
            var off:Number = (out.x * ux + out.y * uy + out.z * uz) / (ux * ux + uy * uy + uz * uz);
            out.direction.x = out.x - off * ux;
            out.direction.y = out.y - off * uy;
            out.direction.z = out.z - off * uz;
        }

        /** Tries the triangle of three corners. Its longest edge becomes the base. */
        public static function tryTriangle(w:Vector.<Number>, i:int, j:int, k:int, newest:int, out:NearestPoint):void
        {
            if (!isLonger(w, i, j, j, k) && !isLonger(w, k, i, j, k))
            {
                tryTriangleOnBase(w, j, k, i, newest, out);
            }
            else if (isLonger(w, k, i, i, j))
            {
                tryTriangleOnBase(w, k, i, j, newest, out);
            }
            else
            {
                tryTriangleOnBase(w, i, j, k, newest, out);
            }
        }

        // Tries a triangle on its base, the longest edge, which goes from i to j. If the origin is not over it, tries its edges. Over an edge it is over the
        // triangle as well: the nearest point is the same, but only the triangle's normal says where nearer points are.
        private static function tryTriangleOnBase(w:Vector.<Number>, i:int, j:int, k:int, newest:int, out:NearestPoint):void
        {
            var from:int = 3 * i;
            var to:int = 3 * j;
            var apex:int = 3 * k;
            var toX:Number = w[from];
            var toY:Number = w[int(from + 1)];
            var toZ:Number = w[int(from + 2)];
            var ux:Number = w[to] - toX;
            var uy:Number = w[int(to + 1)] - toY;
            var uz:Number = w[int(to + 2)] - toZ;
            var hx:Number = w[apex] - toX;
            var hy:Number = w[int(apex + 1)] - toY;
            var hz:Number = w[int(apex + 2)] - toZ;
            var uu:Number = ux * ux + uy * uy + uz * uz;
            // the height, from its foot on the base
            var foot:Number = (hx * ux + hy * uy + hz * uz) / uu;
            hx -= foot * ux;
            hy -= foot * uy;
            hz -= foot * uz;
            var hh:Number = hx * hx + hy * hy + hz * hz;
            var projection:Number = -(toX * ux + toY * uy + toZ * uz) / uu;
            toX += projection * ux;
            toY += projection * uy;
            toZ += projection * uz;
            var up:Number = -(toX * hx + toY * hy + toZ * hz) / hh;
            var low:Number = projection - foot * up;
            var rest:Number = 1 - up - low;
            if (!(hh > Tolerances.NARROW_TRIANGLE * uu && up >= -BORDER && low >= -BORDER && rest >= -BORDER))
            {
                tryEdges(w, i, j, k, newest, out);
                return;
            }
            toX += up * hx;
            toY += up * hy;
            toZ += up * hz;
            var squared:Number = toX * toX + toY * toY + toZ * toZ;
            if (squared < out.squaredDistance)
            {
                out.squaredDistance = squared;
                out.clearWeights();
                out.weights[i] = rest > LEAST_WEIGHT ? rest : LEAST_WEIGHT;
                out.weights[j] = low > LEAST_WEIGHT ? low : LEAST_WEIGHT;
                out.weights[k] = up > LEAST_WEIGHT ? up : LEAST_WEIGHT;
                out.x = toX;
                out.y = toY;
                out.z = toZ;
                if (squared < hh)
                {
                    // the triangle's normal is more precise than the vector
                    var normalX:Number = uy * hz - uz * hy;
                    var normalY:Number = uz * hx - ux * hz;
                    var normalZ:Number = ux * hy - uy * hx;
                    var sign:int = normalX * toX + normalY * toY + normalZ * toZ < 0 ? -1 : 1;
                    out.direction.x = sign * normalX;
                    out.direction.y = sign * normalY;
                    out.direction.z = sign * normalZ;
                    return;
                }
                setDirectionAcross(w, from, to, out);
            }
        }

        // Tries a triangle's edges, but not the one without the newest corner.
        private static function tryEdges(w:Vector.<Number>, i:int, j:int, k:int, newest:int, out:NearestPoint):void
        {
            if (newest != k)
            {
                tryEdge(w, i, j, newest, out);
            }
            if (newest != i)
            {
                tryEdge(w, j, k, newest, out);
            }
            if (newest != j)
            {
                tryEdge(w, k, i, newest, out);
            }
        }

        // Whether the edge from i to j is longer than the edge from k to l. It compares two, because V8 makes objects for squares that are returned.
        private static function isLonger(w:Vector.<Number>, i:int, j:int, k:int, l:int):Boolean
        {
            var ijX:Number = w[int(3 * j)] - w[int(3 * i)];
            var ijY:Number = w[int(3 * j + 1)] - w[int(3 * i + 1)];
            var ijZ:Number = w[int(3 * j + 2)] - w[int(3 * i + 2)];
            var klX:Number = w[int(3 * l)] - w[int(3 * k)];
            var klY:Number = w[int(3 * l + 1)] - w[int(3 * k + 1)];
            var klZ:Number = w[int(3 * l + 2)] - w[int(3 * k + 2)];
            return ijX * ijX + ijY * ijY + ijZ * ijZ > klX * klX + klY * klY + klZ * klZ;
        }
    }
}
