package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * The traversal of pairs of nodes of two trees, depth-first (thesis §4.6): where two nodes touch, the children of one of them are looked
     * at, until two that are leaves or at their depth limit touch. A subclass decides about a pair.
     *
     * <p>For models that move a pair has an interval of time in which its nodes may touch, and what is looked for is the first moment at which two
     * nodes that decide touch: a pair whose interval begins after the earliest moment found so far is left out. For models that stand still all
     * happens at time 0, and the first two end the search.</p>
     *
     * <p>Times are fields, not arguments or results: passed between functions, JavaScript's machines put each into an object of its own.</p>
     *
     * @private
     */
    public class NodePairTraversal
    {
        /** What comes next of a pair: nothing, because its nodes do not touch. */
        protected static const APART:int = -1;

        /** Its nodes touch and are not divided any further. */
        protected static const TOUCHING:int = 0;

        /** The pair with this child of one of the nodes, and the one with the other child later. */
        protected static const LEFT_OF_A:int = 1;

        /** @copy #LEFT_OF_A */
        protected static const RIGHT_OF_A:int = 2;

        /** @copy #LEFT_OF_A */
        protected static const LEFT_OF_B:int = 3;

        /** @copy #LEFT_OF_A */
        protected static const RIGHT_OF_B:int = 4;

        /** Pairs of nodes that were visited; set to 0 from outside. */
        public var nodeVisits:int = 0;

        /** Whether the roots overlapped of two trees that do not. */
        public var rootsOverlapped:Boolean;

        /** When the trees touched that were asked about last, from 0 to 1; or RelativeMotion.NEVER. */
        public var time:Number;

        /** The nodes that touched first, of models that move; arbitrary where the trees do not touch. */
        public var firstA:HierarchyNode = null;

        /** @copy #firstA */
        public var firstB:HierarchyNode = null;

        /** Where the second model is in the space of the first. */
        protected var pose:RelativePose;

        /** Whether it moves from there. */
        protected var isSwept:Boolean;

        /** When the nodes of the pair under way may touch for the first time. */
        protected var from:Number;

        /** When they may for the last time. */
        protected var to:Number;

        /** When the pair may with the child of a divided node that is visited later. */
        protected var otherFrom:Number = 0;

        /** Whether a LeafTest decides about nodes that touch and are not divided. */
        protected var isByLeaves:Boolean;

        // The pairs that are left, and their intervals.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _times:Vector.<Number> = new Vector.<Number>();

        /**
         * @param pose where the second model is in the space of the first at time 0, whenever two are asked about
         * @param isSwept whether the second moves from there
         */
        public function NodePairTraversal(pose:RelativePose, isSwept:Boolean)
        {
            this.pose = pose;
            this.isSwept = isSwept;
        }

        /**
         * Whether two nodes that are leaves or at their depth limit touch, and when.
         *
         * @param a the root of the first model's hierarchy
         * @param depthA how many levels of it are visited
         * @param b the root of the second model's
         * @param depthB how many levels of that are visited
         * @param leaves decides about such nodes that touch; null if touching is enough
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

        /** Prepares for two roots, and finds out when they may touch. */
        protected function beginRoots(a:HierarchyNode, b:HierarchyNode):void
        {
        }

        /**
         * Visits two nodes, of which some are not divided any further: finds out whether they touch between <code>from</code> and
         * <code>to</code>, before <code>time</code>, and what comes next. Sets <code>from</code> to when that may touch, and for a pair that
         * is divided <code>otherFrom</code> and <code>to</code> likewise.
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
