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

        /** The second triangle's corners, from the first one's first corner. */
        protected var cornersB:Vector.<Number> = new Vector.<Number>(9, true);

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
            setEdges(edgesA, a, atA);
            for (var i:int = 0; i < 3; i++)
            {
                var first:Number = a[int(atA + i)];
                cornersB[i] = b[int(atB + i)] - first;
                cornersB[int(i + 3)] = b[int(atB + i + 3)] - first;
                cornersB[int(i + 6)] = b[int(atB + i + 6)] - first;
            }
            setEdges(edgesB, cornersB, 0);
        }

        /** Tries the axes at right angles to a triangle until one separates the two; the other methods like this try other axes. */
        protected final function areSeparatedByNormal():Boolean
        {
            return isNormal(edgesA) || isNormal(edgesB);
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

        /** Tries the axes in the plane of the triangle whose edges are given, at right angles to an edge: of the one whose normal is the more precise. */
        protected final function areSeparatedInPlane(edges:Vector.<Number>):Boolean
        {
            setNormal(edges);
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
            var a:Vector.<Number> = edgesA;
            var b:Vector.<Number> = cornersB;
            var second:Number = x * a[0] + y * a[1] + z * a[2];
            var third:Number = x * a[3] + y * a[4] + z * a[5];
            var low:Number = second < 0 ? second : 0;
            low = third < low ? third : low;
            var high:Number = second > 0 ? second : 0;
            high = third > high ? third : high;
            var first:Number = x * b[0] + y * b[1] + z * b[2];
            second = x * b[3] + y * b[4] + z * b[5];
            third = x * b[6] + y * b[7] + z * b[8];
            var lowB:Number = first < second ? first : second;
            lowB = third < lowB ? third : lowB;
            var highB:Number = first > second ? first : second;
            highB = third > highB ? third : highB;
            at = (lowB + highB - low - high) / 2;
            reach = (high - low + highB - lowB) / 2;
            return isSeparating();
        }

        private static function setEdges(edges:Vector.<Number>, corners:Vector.<Number>, start:int):void
        {
            for (var i:int = 0; i < 3; i++)
            {
                var first:Number = corners[int(start + i)];
                var toSecond:Number = corners[int(start + i + 3)] - first;
                var toThird:Number = corners[int(start + i + 6)] - first;
                edges[i] = toSecond;
                edges[int(i + 3)] = toThird;
                edges[int(i + 6)] = toThird - toSecond;
            }
        }
    }
}
