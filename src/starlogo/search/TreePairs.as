package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.TreePair;

    use namespace engine;

    /**
     * Tests two rows of which at least one is a tree: whether they touch, when they touch, and how (thesis §4.6).
     *
     * @private
     */
    public final class TreePairs extends PairTests
    {
        /** The number of levels that a test visits in a tree, unless the agent has a depth limit of its own. */
        public var maxDepth:int = 5;

        /** Whether triangles decide. Then no depth limit applies. */
        public var exact:Boolean = false;

        /**
         * Whether the leaves of two trees are tested instead of triangles for a while. They find every touch that triangles find, in a tenth of
         * the time.
         */
        public var byLeaves:Boolean = false;

        private var _tests:int = 0;
        private var _pair:TreePair = new TreePair();

        // The motion under way: the given motion, or its opposite if the two rows are tested in the other order.
        private var _motion:RelativeMotion;
        private var _turned:RelativeMotion = new RelativeMotion();
        private var _placementA:Placement = new Placement();
        private var _placementB:Placement = new Placement();

        /** Begins with the settings that a new collider has. */
        public function TreePairs()
        {
        }

        /** See RowPairs.keepTouching. The row is a tree. */
        public function keepTouching(table:AgentTable, bins:Bins, row:int, rows:Vector.<int>, others:Vector.<int>, count:int):int
        {
            var shapes:Vector.<ModelShape> = table.shapes;
            var agents:Vector.<Agent> = table.agents;
            var tree:SolidHierarchy = shapes[row].hierarchy;
            var number:int = agents[row].number;
            var placement:Placement = table.placementOf(row, _placementA);
            var depth:int = depthOf(table, row);
            var isExact:Boolean = exact;
            var pair:TreePair = _pair;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var otherRow:int = rows[others[i]];
                if (!RowPairs.areNear(table.extents, bins, row, otherRow))
                {
                    continue;
                }
                _tests++;
                var other:SolidHierarchy = shapes[otherRow].hierarchy;
                var otherPlacement:Placement = table.placementOf(otherRow, _placementB);
                var otherDepth:int = depthOf(table, otherRow);
                var isTouching:Boolean;
                if (other == null || agents[otherRow].number > number)
                {
                    isTouching = pair.areOverlapping(tree, placement, depth, other, shapes[otherRow].structure, otherPlacement, otherDepth, isExact && other != null);
                }
                else
                {
                    isTouching = pair.areOverlapping(other, otherPlacement, otherDepth, tree, null, placement, depth, isExact);
                }
                if (isTouching)
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            if (RowPairs.isSecondFirst(table, a, b))
            {
                return areTouching(table, b, a);
            }
            _tests++;
            var shapeB:ModelShape = table.shapes[b];
            return _pair.areOverlapping(table.shapes[a].hierarchy, table.placementOf(a, _placementA), depthOf(table, a), shapeB.hierarchy, shapeB.structure,
                    table.placementOf(b, _placementB), depthOf(table, b), areExact(shapeB));
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            _tests++;
            setMovingPair(table, a, b, motion, RowPairs.isSecondFirst(table, a, b));
            _pair.findTime(_motion);
            motion.time = _motion.time;
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            setMovingPair(table, a, b, motion, table.forms[a] != ModelShape.TREE);
            _pair.findContact(_motion, out);
            // two leaves overlap by the depth at least
            needed = exact && !byLeaves ? 0 : out.depth;
            if (_motion !== motion)
            {
                out.turn(motion);
            }
        }

        /** @inheritDoc */
        override public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            _tests++;
            setMovingPair(table, a, b, motion, RowPairs.isSecondFirst(table, a, b));
            _pair.findImpact(_motion, out);
            motion.time = _motion.time;
            if (_motion !== motion && out != null && motion.time != RelativeMotion.NEVER)
            {
                out.turn(motion);
            }
        }

        /** @inheritDoc */
        override public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            _pair.findOuterContact(table.shapes[a].structure, table.placementOf(a, _placementA), table.shapes[b].structure,
                    table.placementOf(b, _placementB), out);
        }

        /** @inheritDoc */
        override public function findClosest(table:AgentTable, a:int, b:int, areTouching:Boolean, out:ClosestPair):void
        {
            setPair(table, a, b);
            _pair.findClosest(areTouching, out);
        }

        /** The number of levels that a test visits in a row's tree. */
        public function depthOf(table:AgentTable, row:int):int
        {
            var depth:int = table.depths[row] == 0 ? maxDepth : table.depths[row];
            return exact || depth > HierarchyNode.LARGEST_DEPTH ? HierarchyNode.LARGEST_DEPTH : depth;
        }

        /** Sets all counts to 0. */
        public function resetCounts():void
        {
            _tests = 0;
            _pair.resetCounts();
        }

        /** Writes the numbers of tests since <code>resetCounts()</code>. */
        public function writeCounts(out:SearchCounts):void
        {
            out.hierarchyTests = _tests;
            out.nodeVisits = _pair.nodeVisits;
            out.triangleTests = _pair.triangleTests;
        }

        // Whether triangles decide about a tree and the second row of a pair.
        private function areExact(shapeB:ModelShape):Boolean
        {
            return exact && !byLeaves && (shapeB.hierarchy != null || shapeB.meetsTriangles);
        }

        // Sets the two rows in this order or the opposite order, and the motion of the row that is then first.
        private function setMovingPair(table:AgentTable, a:int, b:int, motion:RelativeMotion, isTurned:Boolean):void
        {
            _motion = motion;
            if (isTurned)
            {
                _motion = _turned;
                _turned.turn(motion);
            }
            setPair(table, isTurned ? b : a, isTurned ? a : b);
        }

        // Sets two rows. The first one is a tree.
        private function setPair(table:AgentTable, a:int, b:int):void
        {
            var shapeB:ModelShape = table.shapes[b];
            _pair.setTo(table.shapes[a].hierarchy, table.placementOf(a, _placementA), depthOf(table, a), shapeB.hierarchy, shapeB.structure,
                    table.placementOf(b, _placementB), depthOf(table, b), areExact(shapeB));
        }
    }
}
