package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.LeafTest;
    import starlogo.hierarchy.RelativePose;

    use namespace engine;

    /** Decides by the models' triangles whether leaves touch. What the tests of models that stand still and of those that move have in common. */
    internal class TrianglePairTest extends LeafTest
    {
        /** Pairs of triangles that were tested; set to 0 from outside. */
        public var triangleTests:int = 0;

        protected var pose:RelativePose;
        protected var solidA:Solid;
        protected var solidB:Solid;

        /** The triangles of a leaf of the second model in the space of the first. */
        protected var moved:MovedTriangles;

        /** How close triangles of these models touch. */
        protected var touching:Number;

        /**
         * @param pose where the second model is in the space of the first, whenever two are asked about
         */
        public function TrianglePairTest(pose:RelativePose)
        {
            this.pose = pose;
            moved = new MovedTriangles(pose);
        }

        /** Begins with two models that the pose relates, both with triangles. */
        public function begin(a:SolidHierarchy, b:SolidHierarchy):void
        {
            solidA = a.solid;
            solidB = b.solid;
            moved.begin(solidB.corners);
            touching = pose.gap + Tolerances.SURFACES * (a.root.radius + b.root.radius * pose.placement.size);
        }
    }
}
