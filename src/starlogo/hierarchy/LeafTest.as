package starlogo.hierarchy
{
    import starlogo.intersection.contact.ContactPoint;

    /**
     * Decides whether two leaves touch by their contents. It is asked only if the leaves' structures touch. Abstract: a lower package
     * defines the contents.
     *
     * @private
     */
    public class LeafTest
    {
        /** For moving models. Before the test: the latest time to look at. After it: when the leaves touch. From 0 to 1. */
        public var time:Number = 0;

        /**
         * For moving models, finds the contact of the contents that touch first, at the pose's time. It is in the first model's space.
         *
         * @param out receives the contact
         */
        public function findContact(out:ContactPoint):void
        {
        }

        /** Whether a leaf of the first model touches a leaf of the second. For moving models, whether they touch by <code>time</code>. */
        public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            return true;
        }
    }
}
