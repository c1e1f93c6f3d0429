package starlogo.solid
{
    /** The corners of a model's triangles after its vertices are welded, for the triangles that this moves. */
    internal final class WeldedCorners
    {
        /** The corners of the triangles that were moved: nine numbers each. */
        public var corners:Vector.<Number> = new Vector.<Number>();

        /** For each slot, the index of its triangle's first number in <code>corners</code>, or -1 if it is not moved. */
        public var starts:Vector.<int>;

        // How many of the corners' numbers are those of moved triangles.
        private var _count:int = 0;

        /** @param count the number of triangles */
        public function WeldedCorners(count:int)
        {
            starts = new Vector.<int>(count, true);
        }

        /**
         * Takes the triangles of a range of slots. Must be called for all slots in their order.
         *
         * @param mesh the triangles
         * @param welded for each vertex, the vertex whose place it has
         */
        public function weld(first:int, end:int, mesh:TriangleMesh, welded:Vector.<int>):void
        {
            // Writes each triangle after the moved ones, and keeps it if it is elsewhere than its corners.
            for (var slot:int = first; slot < end; slot++)
            {
                mesh.writeCorners(slot, slot + 1, welded, corners, _count);
                starts[slot] = -1;
                if (isElsewhere(slot, mesh.corners))
                {
                    starts[slot] = _count;
                    _count += 9;
                }
            }
        }

        // Whether the corners behind the moved ones are not those of a triangle.
        private function isElsewhere(slot:int, unmoved:Vector.<Number>):Boolean
        {
            for (var k:int = 0; k < 9; k++)
            {
                if (corners[_count + k] != unmoved[9 * slot + k])
                {
                    return true;
                }
            }
            return false;
        }
    }
}
