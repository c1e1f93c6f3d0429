package starlogo.intersection.sweep
{
    /**
     * The separating axes of two triangles: the two normals, the nine cross products of an edge of each, and the six directions in the plane of
     * one at right angles to an edge (Ericson, "Real-Time Collision Detection", §5.2.1). The last six are for triangles that are nearly in
     * one plane.
     *
     * <p>Both triangles are projected on each axis in full. So an axis separates only triangles that have a gap, however short and imprecise it
     * is: nearly parallel edges and needles need no cases of their own.</p>
     *
     * @private
     */
    internal class TriangleAxes
    {
        /** The first triangle's edges: from the first corner to the second, from the first to the third, and from the second to the third. */
        protected var edgesA:Vector.<Number> = new Vector.<Number>(9, true);

        /** The second triangle's, in the same order. */
        protected var edgesB:Vector.<Number> = new Vector.<Number>(9, true);

        /** The corners of both, from the first one's first corner: of the first triangle u and v, of the second p, q and r. */
        protected var ux:Number;

        /** @copy #ux */
        protected var uy:Number;

        /** @copy #ux */
        protected var uz:Number;

        /** @copy #ux */
        protected var vx:Number;

        /** @copy #ux */
        protected var vy:Number;

        /** @copy #ux */
        protected var vz:Number;

        /** @copy #ux */
        protected var px:Number;

        /** @copy #ux */
        protected var py:Number;

        /** @copy #ux */
        protected var pz:Number;

        /** @copy #ux */
        protected var qx:Number;

        /** @copy #ux */
        protected var qy:Number;

        /** @copy #ux */
        protected var qz:Number;

        /** @copy #ux */
        protected var rx:Number;

        /** @copy #ux */
        protected var ry:Number;

        /** @copy #ux */
        protected var rz:Number;

        /** The axis that is tried, of any length: of Numbers that are passed V8 makes objects. */
        protected var axisX:Number = 0;

        /** @copy #axisX */
        protected var axisY:Number = 0;

        /** @copy #axisX */
        protected var axisZ:Number = 0;

        /** Where the second triangle's middle is on the axis, from the first's. */
        protected var at:Number = 0;

        /** How far the two reach along the axis together. */
        protected var reach:Number = 0;

        /** No triangles yet. */
        public function TriangleAxes()
        {
        }

        /**
         * Sets the two triangles.
         *
         * @param a has nine numbers of a triangle: x, y, z of each corner
         * @param atA where in a they begin
         * @param b has nine numbers of the other
         * @param atB where in b they begin
         */
        public final function relate(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):void
        {
            var x:Number = a[atA];
            var y:Number = a[int(atA + 1)];
            var z:Number = a[int(atA + 2)];
            ux = a[int(atA + 3)] - x;
            uy = a[int(atA + 4)] - y;
            uz = a[int(atA + 5)] - z;
            vx = a[int(atA + 6)] - x;
            vy = a[int(atA + 7)] - y;
            vz = a[int(atA + 8)] - z;
            px = b[atB] - x;
            py = b[int(atB + 1)] - y;
            pz = b[int(atB + 2)] - z;
            qx = b[int(atB + 3)] - x;
            qy = b[int(atB + 4)] - y;
            qz = b[int(atB + 5)] - z;
            rx = b[int(atB + 6)] - x;
            ry = b[int(atB + 7)] - y;
            rz = b[int(atB + 8)] - z;
            setEdges(edgesA, ux, uy, uz, vx, vy, vz);
            setEdges(edgesB, qx - px, qy - py, qz - pz, rx - px, ry - py, rz - pz);
        }

        /** Tries the axes at right angles to a triangle until one separates the two; the other methods like this try other axes. */
        protected final function areSeparatedByNormal():Boolean
        {
            setNormal(edgesA);
            if (isAxis())
            {
                return true;
            }
            setNormal(edgesB);
            return isAxis();
        }

        /** Tries the axes at right angles to an edge of each. */
        protected final function areSeparatedAcrossEdges():Boolean
        {
            var a:Vector.<Number> = edgesA;
            var b:Vector.<Number> = edgesB;
            for (var i:int = 0; i < 9; i += 3)
            {
                var x:Number = a[i];
                var y:Number = a[int(i + 1)];
                var z:Number = a[int(i + 2)];
                for (var k:int = 0; k < 9; k += 3)
                {
                    axisX = y * b[int(k + 2)] - z * b[int(k + 1)];
                    axisY = z * b[k] - x * b[int(k + 2)];
                    axisZ = x * b[int(k + 1)] - y * b[k];
                    if (isAxis())
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        /** Tries the axes in the plane of the triangle whose normal is the more precise, at right angles to an edge. */
        protected final function areSeparatedInPlane():Boolean
        {
            setNormal(squaredHeight(edgesA) < squaredHeight(edgesB) ? edgesB : edgesA);
            var x:Number = axisX;
            var y:Number = axisY;
            var z:Number = axisZ;
            return isAcross(edgesA, x, y, z) || isAcross(edgesB, x, y, z);
        }

        /** Whether the axis, on which the triangles are projected, separates them. */
        protected function isSeparating():Boolean
        {
            return false;
        }

        /**
         * The squared height of a triangle over its longest edge, as a fraction of that edge squared; 0 for a point. It says how precise the normal
         * is.
         */
        protected static function squaredHeight(edges:Vector.<Number>):Number
        {
            var longest:Number = 0;
            for (var i:int = 0; i < 9; i += 3)
            {
                var x:Number = edges[i];
                var y:Number = edges[int(i + 1)];
                var z:Number = edges[int(i + 2)];
                var squared:Number = x * x + y * y + z * z;
                longest = squared > longest ? squared : longest;
            }
            x = edges[1] * edges[5] - edges[2] * edges[4];
            y = edges[2] * edges[3] - edges[0] * edges[5];
            z = edges[0] * edges[4] - edges[1] * edges[3];
            return longest > 0 ? (x * x + y * y + z * z) / longest / longest : 0;
        }

        private function isNormal(edges:Vector.<Number>):Boolean
        {
            setNormal(edges);
            return isAxis();
        }

        private function isAcross(edges:Vector.<Number>, nx:Number, ny:Number, nz:Number):Boolean
        {
            for (var i:int = 0; i < 9; i += 3)
            {
                axisX = edges[int(i + 1)] * nz - edges[int(i + 2)] * ny;
                axisY = edges[int(i + 2)] * nx - edges[i] * nz;
                axisZ = edges[i] * ny - edges[int(i + 1)] * nx;
                if (isAxis())
                {
                    return true;
                }
            }
            return false;
        }

        private function setNormal(edges:Vector.<Number>):void
        {
            axisX = edges[1] * edges[5] - edges[2] * edges[4];
            axisY = edges[2] * edges[3] - edges[0] * edges[5];
            axisZ = edges[0] * edges[4] - edges[1] * edges[3];
        }

        // Projects the triangles on the axis.
        private function isAxis():Boolean
        {
            var x:Number = axisX;
            var y:Number = axisY;
            var z:Number = axisZ;
            var second:Number = x * ux + y * uy + z * uz;
            var third:Number = x * vx + y * vy + z * vz;
            var low:Number = second < 0 ? second : 0;
            low = third < low ? third : low;
            var high:Number = second > 0 ? second : 0;
            high = third > high ? third : high;
            var first:Number = x * px + y * py + z * pz;
            second = x * qx + y * qy + z * qz;
            third = x * rx + y * ry + z * rz;
            var lowB:Number = first < second ? first : second;
            lowB = third < lowB ? third : lowB;
            var highB:Number = first > second ? first : second;
            highB = third > highB ? third : highB;
            at = (lowB + highB - low - high) / 2;
            reach = (high - low + highB - lowB) / 2;
            return isSeparating();
        }

        private static function setEdges(edges:Vector.<Number>, x:Number, y:Number, z:Number, nextX:Number, nextY:Number, nextZ:Number):void
        {
            edges[0] = x;
            edges[1] = y;
            edges[2] = z;
            edges[3] = nextX;
            edges[4] = nextY;
            edges[5] = nextZ;
            edges[6] = nextX - x;
            edges[7] = nextY - y;
            edges[8] = nextZ - z;
        }
    }
}
