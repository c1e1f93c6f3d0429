package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.RelativePose;

    use namespace engine;

    /**
     * The triangles of one leaf of the second model, in the first model's space. They are computed again only if another leaf is asked for.
     */
    internal final class MovedTriangles
    {
        /** The triangles' corners, nine numbers each. */
        public var corners:Vector.<Number> = new Vector.<Number>();

        /** The triangles' extents: minX, minY, minZ, maxX, maxY, maxZ of each. */
        public var extents:Vector.<Number> = new Vector.<Number>();

        private var _pose:RelativePose;
        private var _points:Vector.<Number>;
        private var _first:int;

        /**
         * @param pose the second model's pose in the first model's space; kept, and read for each pair of models
         */
        public function MovedTriangles(pose:RelativePose)
        {
            _pose = pose;
        }

        /** Begins with a second model, given by the corners of its triangles. */
        public function begin(points:Vector.<Number>):void
        {
            _points = points;
            _first = -1;
        }

        /** Computes the triangles of a leaf. */
        public function move(leaf:HierarchyNode):void
        {
            if (leaf.first == _first)
            {
                return;
            }
            _first = leaf.first;
            _pose.placement.movePoints(_points, 9 * leaf.first, 9 * leaf.end, corners);
            var count:int = leaf.end - leaf.first;
            if (extents.length < 6 * count)
            {
                extents.length = 6 * count;
            }
            var spans:Vector.<Number> = extents;
            for (var i:int = 0; i < count; i++)
            {
                var from:int = 9 * i;
                var to:int = 6 * i;
                include "../intersection/triangleExtents.inc";
            }
        }
    }
}
