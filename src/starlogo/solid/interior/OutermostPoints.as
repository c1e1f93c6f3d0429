package starlogo.solid.interior
{
    /** Finds the outermost points of groups of triangles: of a surface's parts, or of its shells. @private */
    public final class OutermostPoints
    {
        /** The numbers that points has for each group: the coordinates of six points. */
        public static const STRIDE:int = 18;

        /** For each group that has triangles, the vertices with the smallest and largest x, y and z. */
        public var points:Vector.<Number> = new Vector.<Number>();

        // For each group, the index of its points, or -1 if it has none yet.
        private var _starts:Vector.<int>;

        private var _corners:Vector.<Number>;

        /**
         * @param corners the corners of the triangles by slot, nine numbers each
         * @param count greater than any group's number
         */
        public function OutermostPoints(corners:Vector.<Number>, count:int)
        {
            _corners = corners;
            _starts = new Vector.<int>(count, true);
            for (var i:int = 0; i < count; i++)
            {
                _starts[i] = -1;
            }
        }

        /** Adds a triangle to a group. */
        public function add(group:int, slot:int):void
        {
            if (_starts[group] < 0)
            {
                beginGroup(group, 9 * slot);
            }
            for (var corner:int = 9 * slot; corner < 9 * slot + 9; corner += 3)
            {
                extendGroup(_starts[group], corner);
            }
        }

        /** The index of a group's points, or -1 if it has no triangles. */
        public function startOf(group:int):int
        {
            return _starts[group];
        }

        /** The longest of a group's three extents. It must have triangles. */
        public function extentOf(group:int):Number
        {
            return extentAt(_starts[group]);
        }

        /** The least of these extents of all groups. */
        public function get leastExtent():Number
        {
            var least:Number = Infinity;
            for (var start:int = 0; start < points.length; start += STRIDE)
            {
                least = Math.min(least, extentAt(start));
            }
            return least;
        }

        /** Whether the extents of a group contain those of another one. @param slack how much may be outside, as a fraction of the other extents */
        public function contains(outer:int, inner:int, slack:Number):Boolean
        {
            for (var axis:int = 0; axis < 3; axis++)
            {
                var a:int = _starts[outer] + 7 * axis;
                var b:int = _starts[inner] + 7 * axis;
                var rounding:Number = slack * (points[b + 3] - points[b]);
                if (!(points[a] <= points[b] + rounding && points[a + 3] >= points[b + 3] - rounding))
                {
                    return false;
                }
            }
            return true;
        }

        private function extentAt(start:int):Number
        {
            return Math.max(points[start + 3] - points[start], points[start + 10] - points[start + 7], points[start + 17] - points[start + 14]);
        }

        private function beginGroup(group:int, corner:int):void
        {
            _starts[group] = points.length;
            for (var i:int = 0; i < STRIDE; i += 3)
            {
                points.push(_corners[corner], _corners[corner + 1], _corners[corner + 2]);
            }
        }

        // The coordinate along an axis of the point that is first or last along it is 7 numbers after that of the axis before.
        private function extendGroup(start:int, corner:int):void
        {
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:int = start + 6 * axis;
                var coordinate:Number = _corners[int(corner + axis)];
                var to:int = coordinate < points[int(low + axis)] ? low : low + 3;
                if (to == low || coordinate > points[int(to + axis)])
                {
                    points[to] = _corners[corner];
                    points[to + 1] = _corners[corner + 1];
                    points[to + 2] = _corners[corner + 2];
                }
            }
        }
    }
}
