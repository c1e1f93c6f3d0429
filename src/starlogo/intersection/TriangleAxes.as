package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Separating axes of two triangles, all of them: the two normals, the nine cross products of an edge of each, and for
     * triangles that are nearly in one plane the six directions in it at right angles to an edge (Ericson, "Real-Time
     * Collision Detection", §5.2.1).
     *
     * <p>Each is projected on in full: however short and imprecise an axis is, it separates only triangles that have a gap, so
     * that nearly parallel edges and needle-like triangles need no cases of their own. A triangle without area is a segment or
     * a point; of two of them, the distance is computed.</p>
     */
    internal final class TriangleAxes
    {
        /** Squared: how many tolerances away from a plane a corner is clearly off it. */
        public static const CLEARLY:Number = 1e14;

        /** One over the squared sine of the angle at a triangle's first corner, up to which it is no needle. */
        public static const SLIMMEST:Number = 1e6;

        /** What these two leave uncertain of a place on the line in both planes, as a fraction of how far the triangles go along it. */
        public static const UNSURE:Number = 1e-4;

        private static const SEGMENT_A:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);
        private static const SEGMENT_B:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        /**
         * Whether two triangles have a gap of more than the tolerance.
         *
         * @param a has nine numbers of a triangle: x, y, z of each corner
         * @param atA where in a they begin
         * @param b has nine numbers of the other
         * @param atB where in b they begin
         * @param tolerance the gap that does not count
         */
        public static function areSeparated(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, tolerance:Number):Boolean
        {
            // all relative to a's first corner
            var x:Number = a[atA];
            var y:Number = a[int(atA + 1)];
            var z:Number = a[int(atA + 2)];
            var ux:Number = a[int(atA + 3)] - x;
            var uy:Number = a[int(atA + 4)] - y;
            var uz:Number = a[int(atA + 5)] - z;
            var vx:Number = a[int(atA + 6)] - x;
            var vy:Number = a[int(atA + 7)] - y;
            var vz:Number = a[int(atA + 8)] - z;
            var px:Number = b[atB] - x;
            var py:Number = b[int(atB + 1)] - y;
            var pz:Number = b[int(atB + 2)] - z;
            var qx:Number = b[int(atB + 3)] - x;
            var qy:Number = b[int(atB + 4)] - y;
            var qz:Number = b[int(atB + 5)] - z;
            var rx:Number = b[int(atB + 6)] - x;
            var ry:Number = b[int(atB + 7)] - y;
            var rz:Number = b[int(atB + 8)] - z;
            var limit:Number = tolerance * tolerance;
            if (hasCornerAt(0, 0, 0, px, py, pz, qx, qy, qz, rx, ry, rz, limit) || hasCornerAt(ux, uy, uz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || hasCornerAt(vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit))
            {
                return false;
            }

            // b on one side of a's plane
            var nx:Number = uy * vz - uz * vy;
            var ny:Number = uz * vx - ux * vz;
            var nz:Number = ux * vy - uy * vx;
            var areaA:Number = nx * nx + ny * ny + nz * nz;
            var atP:Number = nx * px + ny * py + nz * pz;
            var atQ:Number = nx * qx + ny * qy + nz * qz;
            var atR:Number = nx * rx + ny * ry + nz * rz;
            if (atP > 0 && atQ > 0 && atR > 0 || atP < 0 && atQ < 0 && atR < 0)
            {
                if (separates(nx, ny, nz,
                            ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit))
                {
                    return true;
                }
            }

            // a on one side of b's plane
            var fx:Number = qx - px;
            var fy:Number = qy - py;
            var fz:Number = qz - pz;
            var gx:Number = rx - px;
            var gy:Number = ry - py;
            var gz:Number = rz - pz;
            var mx:Number = fy * gz - fz * gy;
            var my:Number = fz * gx - fx * gz;
            var mz:Number = fx * gy - fy * gx;
            var areaB:Number = mx * mx + my * my + mz * mz;
            atP = -mx * px - my * py - mz * pz;
            atQ = atP + mx * ux + my * uy + mz * uz;
            atR = atP + mx * vx + my * vy + mz * vz;
            if (atP > 0 && atQ > 0 && atR > 0 || atP < 0 && atQ < 0 && atR < 0)
            {
                if (separates(mx, my, mz,
                            ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit))
                {
                    return true;
                }
            }

            // The third edges.
            var wx:Number = vx - ux;
            var wy:Number = vy - uy;
            var wz:Number = vz - uz;
            var hx:Number = gx - fx;
            var hy:Number = gy - fy;
            var hz:Number = gz - fz;

            // Squared heights over the longest edges, relative to these: what becomes of the normals' precision.
            var longestA:Number = longest(ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz, wx * wx + wy * wy + wz * wz);
            var longestB:Number = longest(fx * fx + fy * fy + fz * fz, gx * gx + gy * gy + gz * gz, hx * hx + hy * hy + hz * hz);
            var isFlatA:Boolean = areaA <= Tolerances.FLAT_TRIANGLE * longestA * longestA;
            var isFlatB:Boolean = areaB <= Tolerances.FLAT_TRIANGLE * longestB * longestB;
            if (isFlatA && isFlatB)
            {
                return !segmentsMeet(a, atA, b, atB, limit);
            }

            if (separates(uy * fz - uz * fy, uz * fx - ux * fz, ux * fy - uy * fx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(uy * gz - uz * gy, uz * gx - ux * gz, ux * gy - uy * gx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(uy * hz - uz * hy, uz * hx - ux * hz, ux * hy - uy * hx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(vy * fz - vz * fy, vz * fx - vx * fz, vx * fy - vy * fx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(vy * gz - vz * gy, vz * gx - vx * gz, vx * gy - vy * gx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(vy * hz - vz * hy, vz * hx - vx * hz, vx * hy - vy * hx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(wy * fz - wz * fy, wz * fx - wx * fz, wx * fy - wy * fx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(wy * gz - wz * gy, wz * gx - wx * gz, wx * gy - wy * gx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                    || separates(wy * hz - wz * hy, wz * hx - wx * hz, wx * hy - wy * hx,
                        ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit))
            {
                return true;
            }

            // In the plane of the one whose normal is the more precise.
            if (isFlatA || (!isFlatB && areaA * longestB * longestB < areaB * longestA * longestA))
            {
                nx = mx;
                ny = my;
                nz = mz;
            }
            return separates(uy * nz - uz * ny, uz * nx - ux * nz, ux * ny - uy * nx,
                    ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                || separates(vy * nz - vz * ny, vz * nx - vx * nz, vx * ny - vy * nx,
                    ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                || separates(wy * nz - wz * ny, wz * nx - wx * nz, wx * ny - wy * nx,
                    ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                || separates(fy * nz - fz * ny, fz * nx - fx * nz, fx * ny - fy * nx,
                    ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                || separates(gy * nz - gz * ny, gz * nx - gx * nz, gx * ny - gy * nx,
                    ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit)
                || separates(hy * nz - hz * ny, hz * nx - hx * nz, hx * ny - hy * nx,
                    ux, uy, uz, vx, vy, vz, px, py, pz, qx, qy, qz, rx, ry, rz, limit);
        }

        // Triangles of one surface, or of models that stand in one place, share corners.
        private static function hasCornerAt(x:Number, y:Number, z:Number, px:Number, py:Number, pz:Number, qx:Number, qy:Number,
                qz:Number, rx:Number, ry:Number, rz:Number, limit:Number):Boolean
        {
            px -= x;
            py -= y;
            pz -= z;
            if (px * px + py * py + pz * pz <= limit)
            {
                return true;
            }
            qx -= x;
            qy -= y;
            qz -= z;
            if (qx * qx + qy * qy + qz * qz <= limit)
            {
                return true;
            }
            rx -= x;
            ry -= y;
            rz -= z;
            return rx * rx + ry * ry + rz * rz <= limit;
        }

        private static function longest(a:Number, b:Number, c:Number):Number
        {
            a = a > b ? a : b;
            return a > c ? a : c;
        }

        /** Whether the projections of (0, u, v) and (p, q, r) on an axis have a gap whose square is more than the limit. */
        public static function separates(x:Number, y:Number, z:Number, ux:Number, uy:Number, uz:Number, vx:Number, vy:Number, vz:Number,
                px:Number, py:Number, pz:Number, qx:Number, qy:Number, qz:Number, rx:Number, ry:Number, rz:Number, limit:Number):Boolean
        {
            var u:Number = x * ux + y * uy + z * uz;
            var v:Number = x * vx + y * vy + z * vz;
            var p:Number = x * px + y * py + z * pz;
            var q:Number = x * qx + y * qy + z * qz;
            var r:Number = x * rx + y * ry + z * rz;
            var low:Number = u < 0 ? u : 0;
            low = v < low ? v : low;
            var high:Number = u > 0 ? u : 0;
            high = v > high ? v : high;
            var gap:Number = 0;
            if (p > high && q > high && r > high)
            {
                gap = p < q ? p : q;
                gap = gap < r ? gap : r;
                gap -= high;
            }
            else if (p < low && q < low && r < low)
            {
                gap = p > q ? p : q;
                gap = gap > r ? gap : r;
                gap = low - gap;
            }
            return gap > 0 && gap * gap > limit * (x * x + y * y + z * z);
        }

        // Whether the longest edges of two triangles without area are close.
        private static function segmentsMeet(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, limit:Number):Boolean
        {
            setLongestEdge(SEGMENT_A, a, atA);
            setLongestEdge(SEGMENT_B, b, atB);
            SEGMENT_A.radius = Math.sqrt(limit);
            return capsuleCapsule(SEGMENT_A, SEGMENT_B);
        }

        private static function setLongestEdge(segment:Capsule, corners:Vector.<Number>, at:int):void
        {
            var most:Number = -1;
            for (var i:int = 0; i < 9; i += 3)
            {
                var k:int = (i + 3) % 9;
                var x:Number = corners[at + k] - corners[at + i];
                var y:Number = corners[at + k + 1] - corners[at + i + 1];
                var z:Number = corners[at + k + 2] - corners[at + i + 2];
                if (x * x + y * y + z * z > most)
                {
                    most = x * x + y * y + z * z;
                    segment.start.x = corners[at + i];
                    segment.start.y = corners[at + i + 1];
                    segment.start.z = corners[at + i + 2];
                    segment.end.x = corners[at + k];
                    segment.end.y = corners[at + k + 1];
                    segment.end.z = corners[at + k + 2];
                }
            }
        }
    }
}
