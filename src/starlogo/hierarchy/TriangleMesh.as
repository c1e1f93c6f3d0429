package starlogo.hierarchy
{
    /**
     * A model's triangles, for exact tests: which vertices are their corners. They are listed by primitive index: see BoxTree.
     *
     * @private
     */
    public final class TriangleMesh
    {
        /** The boxes around the triangles. */
        public var tree:BoxTree;

        /** The model's vertices. */
        public var vertices:Vector.<Number>;

        /** The triangles' corners, three each: where the coordinates of the vertex begin in the list of vertices. */
        public var cornerOffsets:Vector.<int>;

        /** @param tree the boxes around the triangles. Its nodes are made */
        public function TriangleMesh(tree:BoxTree)
        {
            var primitives:Vector.<int> = tree.primitives;
            var triangles:Vector.<uint> = tree.triangles;
            var out:Vector.<int> = new Vector.<int>(3 * primitives.length, true);
            for (var index:int = 0; index < primitives.length; index++)
            {
                var from:int = 3 * primitives[index];
                var to:int = 3 * index;
                out[to] = 3 * triangles[from];
                out[int(to + 1)] = 3 * triangles[int(from + 1)];
                out[int(to + 2)] = 3 * triangles[int(from + 2)];
            }
            this.tree = tree;
            vertices = tree.vertices;
            cornerOffsets = out;
        }

        /**
         * Reads the corners' coordinates of a triangle.
         *
         * @param out receives nine numbers
         * @param at index at which they begin
         */
        public function readTriangle(index:int, out:Vector.<Number>, at:int = 0):void
        {
            var points:Vector.<Number> = vertices;
            var a:int = cornerOffsets[int(3 * index)];
            var b:int = cornerOffsets[int(3 * index + 1)];
            var c:int = cornerOffsets[int(3 * index + 2)];
            out[at] = points[a];
            out[int(at + 1)] = points[int(a + 1)];
            out[int(at + 2)] = points[int(a + 2)];
            out[int(at + 3)] = points[b];
            out[int(at + 4)] = points[int(b + 1)];
            out[int(at + 5)] = points[int(b + 2)];
            out[int(at + 6)] = points[c];
            out[int(at + 7)] = points[int(c + 1)];
            out[int(at + 8)] = points[int(c + 2)];
        }
    }
}
