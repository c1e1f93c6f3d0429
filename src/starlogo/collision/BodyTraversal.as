package starlogo.collision
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyTraversal;

    use namespace engine;

    /** Decides whether two bodies meet of which one is hierarchical at least. */
    internal final class BodyTraversal
    {
        private var _pairs:int = 0;
        private var _traversal:HierarchyTraversal = new HierarchyTraversal();

        /** Nothing counted yet. */
        public function BodyTraversal()
        {
        }

        /** Begins to count. */
        public function resetCounts():void
        {
            _pairs = 0;
            _traversal.resetCounts();
        }

        /** Reports the counts. */
        public function countInto(statistics:CollisionStatistics):void
        {
            statistics.hierarchyTests = _pairs;
            statistics.nodeVisits = _traversal.nodeVisits;
            statistics.triangleTests = _traversal.triangleTests;
        }

        /** Whether two bodies meet; the answer does not depend on their order. */
        public function bodiesMeet(first:Body, second:Body, maxDepth:int, exact:Boolean):Boolean
        {
            var a:Body = first;
            var b:Body = second;
            if (first.serial > second.serial)
            {
                a = second;
                b = first;
            }
            _pairs++;
            var depthA:int = a.depth == 0 ? maxDepth : a.depth;
            var depthB:int = b.depth == 0 ? maxDepth : b.depth;
            if (!a.isHierarchical)
            {
                return _traversal.structureOverlaps(b.hierarchy, b.agent.placement, depthB, a.structure, a.agent.placement);
            }
            if (!b.isHierarchical)
            {
                return _traversal.structureOverlaps(a.hierarchy, a.agent.placement, depthA, b.structure, b.agent.placement);
            }
            return _traversal.hierarchiesOverlap(a.hierarchy, a.agent.placement, depthA, b.hierarchy, b.agent.placement, depthB,
                    exact);
        }
    }
}
