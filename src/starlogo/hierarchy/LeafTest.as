package starlogo.hierarchy
{
    import starlogo.intersection.contact.ContactPoint;

    /**
     * Decides whether two leaves touch by what is in them, once the structures around them do. Abstract: a room below this one knows what that
     * is.
     *
     * @private
     */
    public class LeafTest
    {
        /** Of models that move, before the test: the latest time that is of interest; after it: when the leaves touch. From 0 to 1. */
        public var time:Number = 0;

        /** A test without triangles: leaves touch if their structures do. */
        public function LeafTest()
        {
        }

        /**
         * Of models that move: how the contents that touch first do so, at the pose's time, in the space of the first model.
         *
         * @param out takes it
         */
        public function findContact(out:ContactPoint):void
        {
        }

        /**
         * Whether a leaf of the first model touches one of the second; of models that move, whether they do by that time.
         */
        public function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            return true;
        }
    }
}
