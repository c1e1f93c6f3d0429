package starlogo.solid.interior
{
    import starlogo.hierarchy.TriangleMesh;

    /** Finds the outermost points of groups of triangles: of a surface's parts, or of its shells. @private */
    public final class OutermostPoints
    {
        /** The numbers that points has for each group: the coordinates of six points. */
        public static const STRIDE:int = 18;

        /** For each group that has triangles, the vertices with the smallest and largest x, y and z. */
        public var points:Vector.<Number> = new Vector.<Number>();

        // For each group, the index of its points, or -1 if it has none yet.
        private var _starts:Vector.<int>;

        private var _mesh:TriangleMesh;

        /**
         * @param mesh the triangles
         * @param count greater than any group's number
         */
        public function OutermostPoints(mesh:TriangleMesh, count:int)
        {
            _mesh = mesh;
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
                beginGroup(group, _mesh.corners[3 * slot]);
            }
            for (var corner:int = 3 * slot; corner < 3 * slot + 3; corner++)
            {
                extendGroup(_starts[group], _mesh.corners[corner]);
            }
        }

        /** Where a group's points begin. It must have triangles. */
        public function startOf(group:int):int
        {
            return _starts[group];
        }

        /**
         * Forgets the points of groups that others stand for. Nothing may be asked about one group afterwards.
         *
         * @param sets of groups; the representative of a set stands for all of it
         */
        public function keepRepresentatives(sets:DisjointSets):void
        {
            var kept:Vector.<Number> = new Vector.<Number>();
            for (var group:int = 0; group < _starts.length; group++)
            {
                for (var i:int = 0; i < STRIDE && sets.rootOf(group) == group; i++)
                {
                    kept.push(points[_starts[group] + i]);
                }
            }
            points = kept;
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

        private function beginGroup(group:int, vertex:int):void
        {
            var vertices:Vector.<Number> = _mesh.vertices;
            _starts[group] = points.length;
            for (var i:int = 0; i < STRIDE; i += 3)
            {
                points.push(vertices[vertex], vertices[vertex + 1], vertices[vertex + 2]);
            }
        }

        // The coordinate along an axis of the point that is first or last along it is 7 numbers after that of the axis before.
        private function extendGroup(start:int, vertex:int):void
        {
            var vertices:Vector.<Number> = _mesh.vertices;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var coordinate:Number = vertices[int(vertex + axis)];
                var low:int = start + 7 * axis;
                if (coordinate < points[low])
                {
                    setPoint(low - axis, vertex);
                }
                else if (coordinate > points[int(low + 3)])
                {
                    setPoint(low + 3 - axis, vertex);
                }
            }
        }

        private function setPoint(at:int, vertex:int):void
        {
            points[at] = _mesh.vertices[vertex];
            points[at + 1] = _mesh.vertices[vertex + 1];
            points[at + 2] = _mesh.vertices[vertex + 2];
        }
    }
}
