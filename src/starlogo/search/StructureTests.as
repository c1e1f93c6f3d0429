package starlogo.search
{
    /**
     * How a collider tests the structures of two agents: by the exact test of their kinds (thesis §3.6), optionally after cheaper tests.
     * May be changed at any time; only <code>boxFacesOnly</code> changes what is found.
     */
    public class StructureTests
    {
        /**
         * Whether two structures that are not both spheres are tested only if spheres around them overlap (thesis §7.5). Applies to
         * models that were added with loadAllBoundingStructures.
         */
        public var spheresFirst:Boolean = true;

        /**
         * Whether a box and another box or a capsule are tested only if capsules around them overlap (thesis §7.5), after the
         * spheres. It pays where many boxes are long, thin and near each other. Applies to models that were added with
         * loadAllBoundingStructures.
         */
        public var capsulesFirst:Boolean = false;

        /**
         * Whether two boxes are taken to collide if their extents along x, y and z overlap and none of their faces separates them (thesis
         * §3.6.4). This is conservative: no collision is missed, but boxes that only edges separate are found to collide, by the thesis's estimate in 7.5 % of
         * the tests. It saves about a third of the time of boxes that meet.
         */
        public var boxFacesOnly:Boolean = false;

        /** For the engine's colliders only, which have one each. At first there are exact tests, after those of the spheres around the structures. */
        public function StructureTests()
        {
        }
    }
}
