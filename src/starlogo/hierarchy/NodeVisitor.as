package starlogo.hierarchy
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.RelativeMotion;

    /**
     * Decides about the nodes at which a BoxSearch ends, which calls it for each one, in the order in which its box may meet them, or from the
     * nearest on. Abstract. A Node visitor decides by the boxes of the nodes. The package solid has others, which know the items.
     *
     * @private
     */
    public class NodeVisitor
    {
        /**
         * How far the search goes. In <code>BoxSearch.find()</code> it is a multiple of the box's motion: a time, or a distance if the motion has
         * length 1. In <code>BoxSearch.findNear()</code> it is a distance from the box. Nodes beyond it are not visited. Whoever begins a search
         * sets it. A visitor that has found something makes it less, so that only better nodes follow.
         */
        public var limit:Number = 0;

        /** Ends the search: no node is within the limit any more. */
        protected final function endSearch():void
        {
            limit = -Infinity;
        }

        /**
         * Keeps the time of a touch if it is within the limit and earlier than those of all touches before. Then the limit is that time. The search ends
         * if it is 0, because nothing is touched earlier than at the beginning.
         *
         * @param motion has the time
         * @param earliest has the time of the earliest touch so far; receives this one if it is earlier
         * @return whether it is
         */
        protected final function keepEarlier(motion:RelativeMotion, earliest:RelativeMotion):Boolean
        {
            if (!(motion.time <= limit && motion.time < earliest.time))
            {
                return false;
            }
            limit = earliest.time = motion.time;
            if (!(limit > 0))
            {
                endSearch();
            }
            return true;
        }

        /**
         * Decides about a node, by its box or its items.
         *
         * @param tree the tree
         * @param node the node
         */
        public function visit(tree:BoxTree, node:int):void
        {
            throw new IllegalOperationError(this + " does not implement visit");
        }
    }
}
