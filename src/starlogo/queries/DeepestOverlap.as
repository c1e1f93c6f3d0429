package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.intersection.contact.ContactPoint;

    /**
     * Finds the deepest overlap of a body with some rows. An overlap that a motion only lifts out of does not count. Neither does an overlap with a
     * tree that is deeper than the middle of the body, because the shortest way out may lead through a wall of the tree.
     *
     * @private
     */
    public final class DeepestOverlap
    {
        /** The contact of the deepest overlap. */
        public var contact:ContactPoint = new ContactPoint();

        /** The sum of the depths of all overlaps. */
        public var sum:Number = 0;

        private var _tried:ContactPoint = new ContactPoint();

        /**
         * Finds it.
         *
         * @param sweep has the body
         * @param at the body's place
         * @param others the rows
         * @param count the number of the rows
         * @return whether there is one
         */
        public function find(sweep:CoreSweep, at:Vector3D, others:Vector.<int>, count:int):Boolean
        {
            contact.depth = sum = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (sweep.isDeepIn(others[i], at, _tried))
                {
                    sum += _tried.depth;
                    if (_tried.depth > contact.depth)
                    {
                        contact.copyFrom(_tried);
                    }
                }
            }
            return sum > 0;
        }
    }
}
