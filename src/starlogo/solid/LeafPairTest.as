package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;

    use namespace engine;

    /** Decides about leaves by their triangles. Base class of the tests for standing models, for moving models, and for distances. */
    internal class LeafPairTest extends LeafTest
    {
        /** The number of pairs of triangles tested, or measured. The caller sets it to 0. */
        public var triangleTests:int = 0;

        protected var pose:RelativePose;
        protected var solidA:Solid;
        protected var solidB:Solid;

        /** The triangles of a leaf of the second model, in the first model's space. */
        protected var moved:MovedTriangles;

        /** The largest gap across which triangles of these models touch. */
        protected var touching:Number;

        /**
         * @param pose the second model's pose in the first model's space; kept, and read for each pair of models
         */
        public function LeafPairTest(pose:RelativePose)
        {
            this.pose = pose;
            moved = new MovedTriangles(pose);
        }

        /** Begins with two models that have triangles. The pose must relate them already. Returns this. */
        public function begin(a:SolidHierarchy, b:SolidHierarchy):LeafTest
        {
            solidA = a.facets;
            solidB = b.facets;
            moved.begin(solidB.corners);
            touching = pose.gap + Tolerances.SURFACES * (a.root.radius + b.root.radius * pose.placement.size);
            return this;
        }
    }
}
