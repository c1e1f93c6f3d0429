package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;

    use namespace engine;

    /** Decides about leaves by their triangles. Base class of the tests for standing models, for moving models, and for distances. */
    internal class LeafPairTest extends LeafTest
    {
        /** The second model's pose in the first model's space. */
        protected var pose:RelativePose = null;

        protected var solidA:Solid;
        protected var solidB:Solid;

        /** The largest gap across which triangles of these models touch. */
        protected var touching:Number;

        /** The corners of the second model's triangles in the leaf of the last <code>move()</code>, in the first model's space: nine numbers each. */
        protected var movedCorners:Vector.<Number> = new Vector.<Number>();

        /** The extents of these triangles: minX, minY, minZ, maxX, maxY, maxZ of each. */
        protected var movedExtents:Vector.<Number> = new Vector.<Number>();

        private var _movedFirst:int;

        /** Begins with two models that have triangles. The pose must relate them already. Returns this. */
        public function begin(a:SolidHierarchy, b:SolidHierarchy, pose:RelativePose):LeafTest
        {
            // Writing an object to a field costs Adobe's VM more than comparing it first.
            if (this.pose !== pose)
            {
                this.pose = pose;
            }
            solidA = a.facets;
            solidB = b.facets;
            _movedFirst = -1;
            touching = pose.gap + Tolerances.SURFACES * (a.root.radius + b.root.radius * pose.placement.size);
            return this;
        }

        /** Computes the triangles of a leaf of the second model. If the leaf is the same as the last one, they are kept. */
        protected function move(leaf:HierarchyNode):void
        {
            if (leaf.first == _movedFirst)
            {
                return;
            }
            _movedFirst = leaf.first;
            pose.placement.movePoints(solidB.corners, 9 * leaf.first, 9 * leaf.end, movedCorners);
            var corners:Vector.<Number> = movedCorners;
            var spans:Vector.<Number> = movedExtents;
            var count:int = leaf.end - leaf.first;
            if (spans.length < 6 * count)
            {
                spans.length = 6 * count;
            }
            for (var i:int = 0; i < count; i++)
            {
                var from:int = 9 * i;
                var to:int = 6 * i;
                include "../intersection/triangleExtents.inc";
            }
        }
    }
}
