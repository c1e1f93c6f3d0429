package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.solid.HierarchyTraversal;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.SweptHierarchyTraversal;

    use namespace engine;

    /**
     * Answers for two rows of which at least one is a tree: whether they touch, when, and how (thesis §4.6).
     *
     * @private
     */
    public final class TreePairs
    {
        /** How many levels are visited of the trees of agents without a depth of their own. */
        public var maxDepth:int = 5;

        /** Whether triangles decide, and no depth limit applies. */
        public var exact:Boolean = false;

        private var _tests:int = 0;
        private var _traversal:HierarchyTraversal = new HierarchyTraversal();
        private var _swept:SweptHierarchyTraversal;

        // The motion under way: that which was given, or the other way round.
        private var _motion:RelativeMotion;
        private var _turned:RelativeMotion = new RelativeMotion();
        private var _placementA:Placement = new Placement();
        private var _placementB:Placement = new Placement();

        /** With the settings that colliders begin with. */
        public function TreePairs()
        {
            _swept = new SweptHierarchyTraversal(_traversal);
        }

        /** As RowPairs.keepTouching, of a member that is a tree. */
        public function keepTouching(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var rowAt:Vector.<int> = bins.rowAt;
            var row:int = rowAt[slot];
            var shapes:Vector.<ModelShape> = table.shapes;
            var agents:Vector.<Agent> = table.agents;
            var hierarchy:SolidHierarchy = shapes[row].hierarchy;
            var number:int = agents[row].number;
            var placement:Placement = table.placementOf(row, _placementA);
            var depth:int = depthOf(table, row);
            var isDecided:Boolean = exact;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var otherRow:int = rowAt[others[i]];
                if (!RowPairs.areNear(table.extents, bins, row, otherRow))
                {
                    continue;
                }
                _tests++;
                var other:SolidHierarchy = shapes[otherRow].hierarchy;
                var otherPlacement:Placement = table.placementOf(otherRow, _placementB);
                var otherDepth:int = depthOf(table, otherRow);
                var isTouching:Boolean;
                if (other == null)
                {
                    isTouching = _traversal.structureOverlaps(hierarchy, placement, depth, shapes[otherRow].structure, otherPlacement);
                }
                else if (agents[otherRow].number > number)
                {
                    isTouching = _traversal.hierarchiesOverlap(hierarchy, placement, depth, other, otherPlacement, otherDepth, isDecided);
                }
                else
                {
                    isTouching = _traversal.hierarchiesOverlap(other, otherPlacement, otherDepth, hierarchy, placement, depth, isDecided);
                }
                if (isTouching)
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        /**
         * As RowPairs.areTouching.
         *
         * @param byLeaves whether the leaves of two trees decide in place of triangles: they find all that triangles find, in a tenth of the time
         */
        public function areTouching(table:AgentTable, a:int, b:int, byLeaves:Boolean = false):Boolean
        {
            if (RowPairs.isSecondFirst(table, a, b))
            {
                return areTouching(table, b, a, byLeaves);
            }
            _tests++;
            var shapeA:ModelShape = table.shapes[a];
            var shapeB:ModelShape = table.shapes[b];
            var placementA:Placement = table.placementOf(a, _placementA);
            var placementB:Placement = table.placementOf(b, _placementB);
            if (shapeB.hierarchy == null)
            {
                return _traversal.structureOverlaps(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.structure, placementB);
            }
            return _traversal.hierarchiesOverlap(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.hierarchy, placementB,
                    depthOf(table, b), exact && !byLeaves);
        }

        /** As RowPairs.findTime. */
        public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            _tests++;
            setSweptPair(table, a, b, motion, RowPairs.isSecondFirst(table, a, b), false);
            _swept.findTime(_motion);
            motion.time = _motion.time;
        }

        /** As RowPairs.findContact. */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            setSweptPair(table, a, b, motion, table.forms[a] != ModelShape.TREE, false);
            _swept.findContact(_motion, out);
            if (_motion !== motion)
            {
                out.turn(motion);
            }
        }

        /** As RowPairs.findImpact; <code>byLeaves</code> as in areTouching. */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint, byLeaves:Boolean = false):void
        {
            _tests++;
            setSweptPair(table, a, b, motion, RowPairs.isSecondFirst(table, a, b), byLeaves);
            _swept.findImpact(_motion, out);
            motion.time = _motion.time;
            if (_motion !== motion && out != null && motion.time != RelativeMotion.NEVER)
            {
                out.turn(motion);
            }
        }

        /** As RowPairs.findOuterContact. */
        public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            _swept.findOuterContact(table.shapes[a].structure, table.placementOf(a, _placementA), table.shapes[b].structure,
                    table.placementOf(b, _placementB), out);
        }

        /** How many levels are visited of a row's tree. */
        public function depthOf(table:AgentTable, row:int):int
        {
            var depth:int = table.depths[row] == 0 ? maxDepth : table.depths[row];
            return exact || depth > HierarchyNode.LARGEST_DEPTH ? HierarchyNode.LARGEST_DEPTH : depth;
        }

        /** Begins to count the tests of a search. */
        public function resetCounts():void
        {
            _tests = 0;
            _swept.resetCounts();
            _traversal.resetCounts();
        }

        /** Writes how many tests were made since <code>resetCounts()</code>. */
        public function writeCounts(out:SearchCounts):void
        {
            out.hierarchyTests = _tests;
            out.nodeVisits = _traversal.nodeVisits + _swept.nodeVisits;
            out.triangleTests = _traversal.triangleTests + _swept.triangleTests;
        }

        // Takes two rows in this order or the other, the first being a tree, and their motion. Where both are trees, leaves may decide in place of triangles.
        private function setSweptPair(table:AgentTable, a:int, b:int, motion:RelativeMotion, isTurned:Boolean, byLeaves:Boolean):void
        {
            if (isTurned)
            {
                _turned.turn(motion);
                setSweptPair(table, b, a, _turned, false, byLeaves);
                return;
            }
            var shapeB:ModelShape = table.shapes[b];
            _motion = motion;
            _swept.setPair(table.shapes[a].hierarchy, table.placementOf(a, _placementA), depthOf(table, a), shapeB.hierarchy,
                    shapeB.structure, table.placementOf(b, _placementB), depthOf(table, b), exact && !(byLeaves && shapeB.hierarchy != null));
        }
    }
}
