package starlogo.solid
{
    /** Finds the outermost points of groups of triangles: of a surface's parts, or of its shells. */
    internal final class PartExtremes
    {
        /** The numbers that points has for each group: the coordinates of six points. */
        public static const STRIDE:int = 18;

        /** For each group, the vertices with the smallest and largest x, y and z: see <code>Interior.partPoints</code>. */
        public var points:Vector.<Number> = new Vector.<Number>();

        /** For each group, the index of its points, or -1 if it has none yet. */
        public var pointsAt:Vector.<int>;

        private var _corners:Vector.<Number>;

        /**
         * @param corners the corners of the triangles by slot, nine numbers each
         * @param count greater than any group's number
         */
        public function PartExtremes(corners:Vector.<Number>, count:int)
        {
            _corners = corners;
            pointsAt = new Vector.<int>(count, true);
            for (var i:int = 0; i < count; i++)
            {
                pointsAt[i] = -1;
            }
        }

        /** Adds a triangle to a group. */
        public function add(group:int, slot:int):void
        {
            if (pointsAt[group] < 0)
            {
                beginGroup(group, 9 * slot);
            }
            for (var corner:int = 9 * slot; corner < 9 * slot + 9; corner += 3)
            {
                extendGroup(pointsAt[group], corner);
            }
        }

        /** The longest of a group's three extents. @param at the index of its points */
        public function extentAt(at:int):Number
        {
            return Math.max(points[at + 3] - points[at], points[at + 10] - points[at + 7], points[at + 17] - points[at + 14]);
        }

        private function beginGroup(group:int, corner:int):void
        {
            pointsAt[group] = points.length;
            for (var i:int = 0; i < STRIDE; i += 3)
            {
                points.push(_corners[corner], _corners[corner + 1], _corners[corner + 2]);
            }
        }

        private function extendGroup(at:int, corner:int):void
        {
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:int = at + 6 * axis;
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
