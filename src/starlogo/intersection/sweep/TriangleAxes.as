package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;

    /**
     * The separating axes of two triangles (Ericson, "Real-Time Collision Detection", §5.2.1): the two normals, the nine cross products of
     * an edge of each, and six directions that lie in the plane of a triangle and are perpendicular to an edge. The last six are for
     * triangles that are nearly in one plane.
     *
     * <p>Both triangles are projected in full on each axis. So an axis separates only triangles that have a gap, even if the axis is short
     * and imprecise. Nearly parallel edges and needles need no special case.</p>
     *
     * @private
     */
    internal class TriangleAxes
    {
        /**
         * The first triangle's edges: from its first corner to the second, from the first to the third, and from the second to the third.
         */
        protected var edgesA:Vector.<Number> = new Vector.<Number>(9, true);

        /** The second triangle's edges, in the same order. */
        protected var edgesB:Vector.<Number> = new Vector.<Number>(9, true);

        /** The second triangle's corners, relative to the first triangle's first corner. */
        protected var cornersB:Vector.<Number> = new Vector.<Number>(9, true);

        /** The first triangle's first corner. */
        protected var origin:Vector3D = new Vector3D();

        /** The largest gap that still counts as touching. */
        public var tolerance:Number = 0;

        /** The motion of the second triangle. */
        protected var motion:RelativeMotion;

        /** The axis to try, of any length. Fields, because V8 would allocate objects for Numbers that are passed. */
        protected var axisX:Number = 0;
        protected var axisY:Number = 0;
        protected var axisZ:Number = 0;

        /** The place of the second triangle's middle on the axis, as seen from the first triangle's middle. */
        protected var at:Number = 0;

        /** The sum of how far both triangles extend along the axis. */
        protected var reach:Number = 0;

        /**
         * The squared ratio of a triangle's height to its longest edge; 0 for a point. It says how precise the normal is. It is a field because
         * V8 makes an object for each Number that is returned.
         */
        protected var height:Number = 0;

        /**
         * Sets the two triangles.
         *
         * @param a nine numbers of the first triangle: x, y, z of each corner
         * @param atA index of the first of them in a
         * @param b nine numbers of the second triangle, in the same space
         * @param atB index of the first of them in b
         */
        public final function relate(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int):void
        {
            setEdges(edgesA, a, atA);
            origin.setTo(a[atA], a[int(atA + 1)], a[int(atA + 2)]);
            for (var i:int = 0; i < 3; i++)
            {
                var first:Number = a[int(atA + i)];
                cornersB[i] = b[int(atB + i)] - first;
                cornersB[int(i + 3)] = b[int(atB + i + 3)] - first;
                cornersB[int(i + 6)] = b[int(atB + i + 6)] - first;
            }
            setEdges(edgesB, cornersB, 0);
        }

        /** Tries the normals of both triangles until one separates the two. */
        protected final function areSeparatedByNormal():Boolean
        {
            setNormal(edgesA);
            if (isSeparatedOnAxis())
            {
                return true;
            }
            setNormal(edgesB);
            return isSeparatedOnAxis();
        }

        /** Tries the axes perpendicular to an edge of each triangle until one separates the two. */
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
                    if (isSeparatedOnAxis())
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        /**
         * Tries the axes in a triangle's plane that are perpendicular to an edge until one separates the two. The given edges should belong to
         * the triangle with the more precise normal.
         */
        protected final function areSeparatedInPlane(edges:Vector.<Number>):Boolean
        {
            setNormal(edges);
            var x:Number = axisX;
            var y:Number = axisY;
            var z:Number = axisZ;
            return isSeparatedInPlane(edgesA, x, y, z) || isSeparatedInPlane(edgesB, x, y, z);
        }

        /** Whether the axis separates the triangles. They have been projected on it. */
        protected function isSeparating():Boolean
        {
            return false;
        }

        /** Computes <code>height</code> for one of the two triangles. The axis becomes its normal. */
        protected function measure(edges:Vector.<Number>):void
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
            setNormal(edges);
            height = longest > 0 ? (axisX * axisX + axisY * axisY + axisZ * axisZ) / longest / longest : 0;
        }

        private function isSeparatedInPlane(edges:Vector.<Number>, nx:Number, ny:Number, nz:Number):Boolean
        {
            for (var i:int = 0; i < 9; i += 3)
            {
                axisX = edges[int(i + 1)] * nz - edges[int(i + 2)] * ny;
                axisY = edges[int(i + 2)] * nx - edges[i] * nz;
                axisZ = edges[i] * ny - edges[int(i + 1)] * nx;
                if (isSeparatedOnAxis())
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

        // Projects the triangles on the axis, and tests it.
        private function isSeparatedOnAxis():Boolean
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
