package starlogo.search
{
    /**
     * The settings for how a collider tests the structures of two agents. A cheaper test can come before the exact test of their kinds (thesis
     * §3.6). You may change the settings at any time. Only <code>boxFacesOnly</code> changes which collisions are found.
     */
    public class StructureTests
    {
        /**
         * Whether the spheres around two structures are tested first. The exact test follows only if these spheres overlap (thesis §7.5).
         * Applies to pairs of capsules and boxes, if the models were added with loadAllBoundingStructures.
         */
        public var spheresFirst:Boolean = true;

        /**
         * Whether the capsules around two structures are tested before the exact test, and after the spheres (thesis §7.5). It saves time if
         * many boxes are long, thin and near each other. Applies to pairs of two boxes, or of a box and a capsule, if the models were added with
         * loadAllBoundingStructures.
         */
        public var capsulesFirst:Boolean = false;

        /**
         * Whether two boxes count as colliding as soon as their extents along x, y and z overlap and none of their faces separates them. No
         * collision is missed. But boxes that are separated by edges alone count as colliding too, in an estimated 7.5 % of the tests (thesis
         * §3.6.4). The setting saves about a third of the time for boxes that meet.
         */
        public var boxFacesOnly:Boolean = false;

        /** For the engine's colliders only. Each of them has one. */
        public function StructureTests()
        {
        }
    }
}
