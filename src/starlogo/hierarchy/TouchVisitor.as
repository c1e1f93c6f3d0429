package starlogo.hierarchy
{
    import starlogo.convex.RelativeMotion;

    /**
     * Decides when a structure first touches what a tree has, and whether it does if it is still (thesis §5.2). Abstract: a subclass knows what that
     * is, the boxes of the nodes or the items in them, each by its number. It tests them, and this class keeps what is touched first.
     *
     * @private
     */
    public class TouchVisitor extends NodeVisitor
    {
        /** The structure's motion, which receives the time of the first touch. */
        protected var motion:RelativeMotion = null;

        /** A copy of the motion for one test, which writes the time. It ends at the limit. */
        protected var sweep:RelativeMotion = new RelativeMotion();

        /** Extents of the structure: minX, maxX, minY, ... */
        protected var extents:Vector.<Number> = new Vector.<Number>(6, true);

        // What is touched first, or -1.
        private var _found:int = -1;

        /** @param counts counts the nodes that are visited */
        public function TouchVisitor(counts:TreeCounts)
        {
            super(counts);
        }

        /** Sets the motion, before <code>findFirst()</code>. If it is still, the structure touches at time 0 or never. */
        protected final function setMotion(motion:RelativeMotion):void
        {
            this.motion = motion;
            limit = motion.isStill ? 0 : motion.latest;
            search.setMotion(motion);
            sweep.copyVector(motion);
            sweep.earliest = motion.earliest;
            sweep.latest = limit;
        }

        /** Finds the number of what is touched first, or -1. The search has the structure's box. @param depth how many of the tree's levels are visited */
        protected final function findFirst(tree:BoxTree, depth:int):int
        {
            motion.time = RelativeMotion.NEVER;
            _found = -1;
            search.find(tree, depth, this);
            return _found;
        }

        /**
         * Keeps what a test has found: its time in the sweep. Nothing is touched earlier than at the beginning, so the search may end.
         *
         * @param number of what was tested
         * @return whether it is touched earlier than all before
         */
        protected final function keepEarlier(number:int):Boolean
        {
            var time:Number = sweep.time;
            if (!(time <= limit && time < motion.time))
            {
                return false;
            }
            limit = sweep.latest = motion.time = time;
            _found = number;
            if (!(time > 0))
            {
                endSearch();
            }
            return true;
        }
    }
}
