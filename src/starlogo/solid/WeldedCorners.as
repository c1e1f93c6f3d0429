package starlogo.solid
{
    import starlogo.steps.StepSequence;

    /** The corners of a model's triangles after its vertices are welded, for the triangles that this moves. Found in steps. */
    internal final class WeldedCorners extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** The corners of the triangles that were moved: nine numbers each. */
        public var corners:Vector.<Number> = new Vector.<Number>();

        /** For each slot, the index of its triangle's first number in <code>corners</code>, or -1 if it is not moved. */
        public var starts:Vector.<int>;

        private var _mesh:TriangleMesh;
        private var _welded:Vector.<int>;

        // How many of the corners' numbers are those of moved triangles.
        private var _count:int = 0;

        /**
         * @param mesh the triangles
         * @param welded for each vertex, the vertex whose place it has
         */
        public function WeldedCorners(mesh:TriangleMesh, welded:Vector.<int>)
        {
            _mesh = mesh;
            _welded = welded;
            starts = new Vector.<int>(mesh.tree.itemCount, true);
            slices(starts.length, TRIANGLES_PER_STEP, weld);
        }

        // Writes each triangle after the moved ones, and keeps it if it is elsewhere than its corners.
        private function weld(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                _mesh.writeCorners(slot, slot + 1, _welded, corners, _count);
                starts[slot] = -1;
                if (isElsewhere(slot))
                {
                    starts[slot] = _count;
                    _count += 9;
                }
            }
        }

        // Whether the corners behind the moved ones are not those of a triangle.
        private function isElsewhere(slot:int):Boolean
        {
            for (var k:int = 0; k < 9; k++)
            {
                if (corners[_count + k] != _mesh.corners[9 * slot + k])
                {
                    return true;
                }
            }
            return false;
        }
    }
}
