package starlogo.hierarchy
{
    /** A model's triangles, for exact tests: their corners and extents by slot, which is the order of the tree. @private */
    public final class TriangleMesh
    {
        /** The boxes around the triangles. */
        public var tree:BoxTree;

        /** The triangles' corners: nine numbers each. */
        public var corners:Vector.<Number>;

        // Null before they are asked for: only pairs of trees need them.
        private var _extents:Vector.<Number> = null;

        /** @param tree the boxes around the triangles */
        public function TriangleMesh(tree:BoxTree)
        {
            this.tree = tree;
            corners = new Vector.<Number>(9 * tree.items.length, true);
        }

        /** Fills in the corners of a range of triangles. Must be called for all triangles before anything else. */
        public function fillCorners(first:int, end:int):void
        {
            var out:Vector.<Number> = corners;
            var to:int = 9 * first;
            var vertices:Vector.<Number> = tree.vertices;
            var triangles:Vector.<uint> = tree.triangles;
            for (var i:int = first; i < end; i++)
            {
                var corner:int = 3 * tree.items[i];
                for (var last:int = corner + 3; corner < last; corner++)
                {
                    var at:int = 3 * triangles[corner];
                    out[to] = vertices[at];
                    out[int(to + 1)] = vertices[int(at + 1)];
                    out[int(to + 2)] = vertices[int(at + 2)];
                    to += 3;
                }
            }
        }

        /** Follows the tree, which has new boxes and vertices. */
        public function refit():void
        {
            fillCorners(0, corners.length / 9);
            if (_extents != null)
            {
                fillExtents();
            }
        }

        /** The triangles' extents: minX, maxX, minY, maxY, minZ, maxZ of each. */
        public function get extents():Vector.<Number>
        {
            if (_extents == null)
            {
                _extents = new Vector.<Number>(6 * corners.length / 9, true);
                fillExtents();
            }
            return _extents;
        }

        private function fillExtents():void
        {
            var count:int = corners.length / 9;
            for (var i:int = 0; i < count; i++)
            {
                tree.writeExtents(i, i + 1, _extents, 6 * i);
            }
        }
    }
}
