package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Decides whether two trees touch: the depth-first traversal of pairs of nodes (thesis §4.6). If two nodes touch, the children of one
     * of them are visited. The search ends when it finds two touching nodes that are leaves or at their depth limit. A subclass tests a
     * pair.
     *
     * <p>For moving models a pair has an interval of time in which its nodes may touch. The search looks for the first moment at which two
     * deciding nodes touch. It skips a pair if its interval begins after the earliest moment found so far. For standing models everything
     * happens at time 0, and the first two deciding nodes end the search.</p>
     *
     * <p>Times are fields and not arguments or results, because JavaScript engines allocate an object for each Number that functions
     * pass.</p>
     *
     * @private
     */
    public class NodePairTraversal
    {
        /** Result of <code>visit()</code>: the nodes do not touch. */
        protected static const APART:int = -1;

        /** Result of <code>visit()</code>: the nodes touch and are not divided any further. */
        protected static const TOUCHING:int = 0;

        /**
         * Result of <code>visit()</code>: next comes the pair with this child of one of the nodes. The pair with the other child comes
         * later.
         */
        protected static const LEFT_OF_A:int = 1;

        /** @copy #LEFT_OF_A */
        protected static const RIGHT_OF_A:int = 2;

        /** @copy #LEFT_OF_A */
        protected static const LEFT_OF_B:int = 3;

        /** @copy #LEFT_OF_A */
        protected static const RIGHT_OF_B:int = 4;

        /** The number of pairs of nodes visited. The caller sets it to 0. */
        public var nodeVisits:int = 0;

        /** Whether the roots overlapped although the trees do not. */
        public var rootsOverlapped:Boolean;

        /** When the trees of the last <code>find()</code> touch, from 0 to 1, or RelativeMotion.NEVER. */
        public var time:Number;

        /** For moving models, the nodes that touch first. Undefined if the trees do not touch. */
        public var firstA:HierarchyNode = null;

        /** @copy #firstA */
        public var firstB:HierarchyNode = null;

        /** The second model's pose in the first model's space. */
        protected var pose:RelativePose;

        /** Whether the second model moves from there. */
        protected var isSwept:Boolean;

        /** The first time at which the nodes of the current pair may touch. */
        protected var from:Number;

        /** The last time at which they may touch. */
        protected var to:Number;

        /** The first time at which the pair with the child that is visited later may touch. */
        protected var otherFrom:Number = 0;

        /** Whether a LeafTest decides about touching nodes that are not divided. */
        protected var isByLeaves:Boolean;

        // The pairs still to visit, and their intervals.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _times:Vector.<Number> = new Vector.<Number>();

        /**
         * @param pose the second model's pose in the first model's space at time 0; kept, and read for each pair of models
         * @param isSwept whether the second model moves from there
         */
        public function NodePairTraversal(pose:RelativePose, isSwept:Boolean)
        {
            this.pose = pose;
            this.isSwept = isSwept;
        }

        /**
         * Whether two trees touch, and when: sets <code>time</code>. The nodes that decide are leaves or at their depth limit.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many of its levels are visited
         * @param b the root of the second model's hierarchy
         * @param depthB how many of its levels are visited
         * @param leaves decides about such nodes if they touch; null if touching is enough
         */
        public function find(a:HierarchyNode, depthA:int, b:HierarchyNode, depthB:int, leaves:LeafTest):Boolean
        {
            var nodes:Vector.<HierarchyNode> = _nodes;
            var times:Vector.<Number> = _times;
            var top:int = 0;
            var isDivided:Boolean = false;
            isByLeaves = leaves != null;
            time = RelativeMotion.NEVER;
            from = 0;
            to = 1;
            beginRoots(a, b);
            while (true)
            {
                if (from < time)
                {
                    var next:int = visit(a, a.cutoffLevel >= depthA, b, b.cutoffLevel >= depthB);
                    if (next > TOUCHING)
                    {
                        isDivided = true;
                        var otherA:HierarchyNode = a;
                        var otherB:HierarchyNode = b;
                        if (next == LEFT_OF_A)
                        {
                            a = otherA.low;
                            otherA = otherA.high;
                        }
                        else if (next == RIGHT_OF_A)
                        {
                            a = otherA.high;
                            otherA = otherA.low;
                        }
                        else if (next == LEFT_OF_B)
                        {
                            b = otherB.low;
                            otherB = otherB.high;
                        }
                        else
                        {
                            b = otherB.high;
                            otherB = otherB.low;
                        }
                        if (otherFrom <= 1)
                        {
                            nodes[top] = otherA;
                            nodes[top + 1] = otherB;
                            if (isSwept)
                            {
                                times[top] = otherFrom;
                                times[top + 1] = to;
                            }
                            top += 2;
                        }
                        continue;
                    }
                    if (next == TOUCHING && (leaves == null || decide(leaves, a, b)))
                    {
                        time = from;
                        if (isSwept)
                        {
                            firstA = a;
                            firstB = b;
                        }
                        if (time == 0)
                        {
                            return true;
                        }
                    }
                }
                if (top == 0)
                {
                    rootsOverlapped = isDivided;
                    return time <= 1;
                }
                top -= 2;
                a = nodes[top];
                b = nodes[top + 1];
                if (isSwept)
                {
                    from = times[top];
                    to = times[top + 1];
                }
            }
            return false;
        }

        /** Prepares the traversal of two trees, and finds when their roots may touch. */
        protected function beginRoots(a:HierarchyNode, b:HierarchyNode):void
        {
        }

        /**
         * Visits two nodes. aEnds and bEnds say which of them is not divided any further. Finds whether they touch between
         * <code>from</code> and <code>to</code> and before <code>time</code>, and what comes next. Sets <code>from</code> to the first
         * moment at which the next pair may touch. For a pair that is divided, it also sets <code>otherFrom</code> and <code>to</code>.
         */
        protected function visit(a:HierarchyNode, aEnds:Boolean, b:HierarchyNode, bEnds:Boolean):int
        {
            return APART;
        }

        private function decide(leaves:LeafTest, a:HierarchyNode, b:HierarchyNode):Boolean
        {
            leaves.time = time < 1 ? time : 1;
            if (!leaves.touch(a, b) || !(leaves.time < time))
            {
                return false;
            }
            from = leaves.time;
            return true;
        }
    }
}
