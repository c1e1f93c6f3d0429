package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * The traversal of pairs of nodes of two trees, depth-first (thesis §4.6): where two nodes touch, the children of one of them are looked
     * at, until two that are leaves or at their depth limit touch. A subclass decides about a pair.
     *
     * <p>For models that move a pair has an interval of time in which its nodes may touch, and what is looked for is the first moment at
     * which two that decide do: a pair whose interval begins later than what was found is left out. For models that stand still all
     * happens at time 0, and the first two end the search.</p>
     *
     * <p>Times are fields, not arguments or results: passed between functions, JavaScript's machines put each into an object of its own.</p>
     *
     * @private
     */
    public class NodePairTraversal
    {
        /** Pairs of nodes that were visited; set to 0 from outside. */
        public var nodeVisits:int = 0;

        /** Whether the roots overlapped that were asked about last. */
        public var rootsOverlapped:Boolean;

        /** When the trees touched that were asked about last, from 0 to 1; or RelativeMotion.NEVER. */
        public var time:Number;

        /** The nodes that did, if any. */
        public var firstA:HierarchyNode = null;

        /** @copy #firstA */
        public var firstB:HierarchyNode = null;

        /** Where the second model is in the space of the first. */
        protected var pose:RelativePose;

        /** When the nodes of the pair under way may touch for the first time. */
        protected var from:Number;

        /** When they may for the last time. */
        protected var to:Number;

        // The pairs that are left, and their intervals.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _times:Vector.<Number> = new Vector.<Number>();
        private var _top:int;

        /**
         * @param pose where the second model is in the space of the first at time 0, whenever two are asked about
         */
        public function NodePairTraversal(pose:RelativePose)
        {
            this.pose = pose;
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
            time = RelativeMotion.NEVER;
            firstA = firstB = null;
            rootsOverlapped = false;
            from = 0;
            to = 1;
            _top = 0;
            begin(a, b);
            while (_top > 0)
            {
                _top -= 2;
                from = _times[_top];
                if (from >= time)
                {
                    continue;
                }
                to = _times[int(_top + 1)];
                a = _nodes[_top];
                b = _nodes[int(_top + 1)];
                if (!touch(a, b) || from >= time)
                {
                    continue;
                }
                rootsOverlapped = true;
                var aEnds:Boolean = a.cutoffLevel >= depthA;
                var bEnds:Boolean = b.cutoffLevel >= depthB;
                if (!aEnds || !bEnds)
                {
                    divide(a, aEnds, b, bEnds);
                }
                else if (leaves == null ? decide(a, b) : decideBy(leaves, a, b))
                {
                    time = from;
                    firstA = a;
                    firstB = b;
                    if (time == 0)
                    {
                        return true;
                    }
                }
            }
            return time <= 1;
        }

        /** Begins with two roots. */
        protected function begin(a:HierarchyNode, b:HierarchyNode):void
        {
            push(a, b);
        }

        /** Whether two nodes touch between <code>from</code> and <code>to</code>: then <code>from</code> becomes the time when they do. */
        protected function touch(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            return true;
        }

        /** Whether two nodes that touch do so in truth, as leaves: likewise, before <code>time</code>. */
        protected function decide(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            return true;
        }

        /** Pushes what two nodes that touch are divided into, what is to be visited first last; not both end. */
        protected function divide(a:HierarchyNode, aEnds:Boolean, b:HierarchyNode, bEnds:Boolean):void
        {
        }

        /** Pushes a pair of nodes that may touch between <code>from</code> and <code>to</code>. */
        protected final function push(a:HierarchyNode, b:HierarchyNode):void
        {
            _nodes[_top] = a;
            _nodes[int(_top + 1)] = b;
            _times[_top] = from;
            _times[int(_top + 1)] = to;
            _top += 2;
        }

        private function decideBy(leaves:LeafTest, a:HierarchyNode, b:HierarchyNode):Boolean
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
