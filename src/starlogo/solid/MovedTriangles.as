package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.RelativePose;

    use namespace engine;

    /** Two models' triangles in one space: those of the first model as they are, and those of one leaf of the second model, moved. */
    internal final class MovedTriangles
    {
        /** The second model's pose in the first model's space. */
        public var pose:RelativePose = null;

        public var meshA:TriangleMesh = null;
        public var meshB:TriangleMesh = null;

        /** The largest distance at which triangles of these models touch. */
        public var tolerance:Number = 0;

        /**
         * The tolerance of quick tests, which is larger: it includes the margin of the motion and Tolerances.CORES of the two triangles. A second
         * <code>tolerance</code> is more than those CORES, because it has SURFACES of the radii.
         */
        public var outerTolerance:Number = 0;

        /** The corners of the triangles in the leaf of the last <code>move()</code>: nine numbers each. */
        public var moved:Vector.<Number> = new Vector.<Number>();

        /** The extents of these triangles: minX, minY, minZ, maxX, maxY, maxZ of each. */
        public var extents:Vector.<Number> = new Vector.<Number>();

        private var _first:int = -1;

        /** Begins with two models that have triangles. The pose must relate them already. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose):void
        {
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (this.pose !== pose)
            {
                this.pose = pose;
            }
            meshA = a.mesh;
            meshB = b.mesh;
            _first = -1;
            tolerance = pose.tolerance + Touching.marginOfSurface(a.tree.radius + b.tree.radius * pose.placement.size);
            outerTolerance = 2 * tolerance + Tolerances.EXTENTS * (Math.abs(pose.motion.x) + Math.abs(pose.motion.y) + Math.abs(pose.motion.z));
        }

        /** Computes the triangles of a leaf of the second model, and returns their number. If the leaf is the same as the last one, they are kept. */
        public function move(tree:BoxTree, leaf:int):int
        {
            var first:int = tree.first[leaf];
            var count:int = tree.end[leaf] - first;
            if (first == _first)
            {
                return count;
            }
            _first = first;
            pose.placement.placePoints(meshB.corners, 9 * first, 9 * (first + count), moved);
            var corners:Vector.<Number> = moved;
            var spans:Vector.<Number> = extents;
            if (spans.length < 6 * count)
            {
                spans.length = 6 * count;
            }
            for (var i:int = 0; i < count; i++)
            {
                writeTriangleExtents(corners, 9 * i, spans, 6 * i);
            }
            return count;
        }
    }
}
