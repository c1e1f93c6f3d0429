package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;

    /**
     * Tests whether triangles touch a solid box, by separating axes (Ericson, "Real-Time Collision Detection", §5.2.9): the box's three
     * axes, the triangle's normal, and the nine cross products of an edge of each.
     *
     * <p>In the box's space, the cross product with one of the box's axes only exchanges two coordinates. So no axis loses digits, and
     * triangles without area need no special case.</p>
     *
     * @private
     */
    public final class TriangleBox
    {
        /** The box, in the space of the triangles. */
        public var box:Box;

        /** The largest gap that still counts as touching. */
        public var tolerance:Number = 0;

        // The triangle in the box's space: its corners, and the edge from each corner to the next.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _edges:Vector.<Number> = new Vector.<Number>(9, true);

        // The axis that is tried, in the box's space.
        private var _axis:Vector.<Number> = new Vector.<Number>(3, true);

        /**
         * Whether a triangle touches the box, or the gap between them is at most the tolerance.
         *
         * @param corners nine numbers of the triangle: x, y, z of each corner
         * @param at index of the first of them
         */
        public function touches(corners:Vector.<Number>, at:int):Boolean
        {
            project(corners, at, box.axisX, 0);
            project(corners, at, box.axisY, 1);
            project(corners, at, box.axisZ, 2);
            return !isSeparatedByFace(0) && !isSeparatedByFace(1) && !isSeparatedByFace(2) && !isSeparatedByNormal()
                && !isSeparatedAcrossEdges();
        }

        // Computes one coordinate of the corners and of the edges in the box's space.
        private function project(corners:Vector.<Number>, at:int, axis:Vector3D, coordinate:int):void
        {
            var x:Number = axis.x;
            var y:Number = axis.y;
            var z:Number = axis.z;
            var center:Vector3D = box.center;
            for (var i:int = 0; i < 9; i += 3)
            {
                _corners[int(i + coordinate)] = x * (corners[int(at + i)] - center.x) + y * (corners[int(at + i + 1)] - center.y)
                    + z * (corners[int(at + i + 2)] - center.z);
            }
            _edges[coordinate] = _corners[int(3 + coordinate)] - _corners[coordinate];
            _edges[int(3 + coordinate)] = _corners[int(6 + coordinate)] - _corners[int(3 + coordinate)];
            _edges[int(6 + coordinate)] = _corners[coordinate] - _corners[int(6 + coordinate)];
        }

        // Whether the triangle is on one side of the box, seen along one of the box's axes.
        private function isSeparatedByFace(axis:int):Boolean
        {
            var half:Number = axis == 0 ? box.halfX : (axis == 1 ? box.halfY : box.halfZ);
            var first:Number = _corners[axis];
            var second:Number = _corners[int(3 + axis)];
            var third:Number = _corners[int(6 + axis)];
            var far:Number = half + tolerance;
            return first > far && second > far && third > far || first < -far && second < -far && third < -far;
        }

        private function isSeparatedByNormal():Boolean
        {
            var e:Vector.<Number> = _edges;
            _axis[0] = e[1] * e[5] - e[2] * e[4];
            _axis[1] = e[2] * e[3] - e[0] * e[5];
            _axis[2] = e[0] * e[4] - e[1] * e[3];
            return isSeparatedOnAxis();
        }

        private function isSeparatedAcrossEdges():Boolean
        {
            for (var edge:int = 0; edge < 9; edge += 3)
            {
                for (var along:int = 0; along < 3; along++)
                {
                    var next:int = along == 2 ? 0 : along + 1;
                    var last:int = 3 - along - next;
                    _axis[along] = 0;
                    _axis[next] = _edges[int(edge + last)];
                    _axis[last] = -_edges[int(edge + next)];
                    if (isSeparatedOnAxis())
                    {
                        return true;
                    }
                }
            }
            return false;
        }

        // Whether the axis separates the triangle from the box. The axis may have any length.
        private function isSeparatedOnAxis():Boolean
        {
            var x:Number = _axis[0];
            var y:Number = _axis[1];
            var z:Number = _axis[2];
            var p:Vector.<Number> = _corners;
            var first:Number = x * p[0] + y * p[1] + z * p[2];
            var second:Number = x * p[3] + y * p[4] + z * p[5];
            var third:Number = x * p[6] + y * p[7] + z * p[8];
            var low:Number = first < second ? first : second;
            low = third < low ? third : low;
            var high:Number = first > second ? first : second;
            high = third > high ? third : high;
            var gap:Number = -high;
            gap = low > gap ? low : gap;
            var side:Number = x < 0 ? -x : x;
            gap -= box.halfX * side;
            side = y < 0 ? -y : y;
            gap -= box.halfY * side;
            side = z < 0 ? -z : z;
            gap -= box.halfZ * side;
            return gap > 0 && gap * gap > tolerance * tolerance * (x * x + y * y + z * z);
        }
    }
}
