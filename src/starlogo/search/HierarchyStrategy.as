package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.solid.HierarchyTraversal;
    import starlogo.solid.SolidHierarchy;
    import starlogo.solid.SweptHierarchyTraversal;

    use namespace engine;

    /**
     * Every agent is the hierarchy of its model (thesis §4); two may be a hierarchy and a structure.
     *
     * @private
     */
    public final class HierarchyStrategy extends ShapeStrategy
    {
        /** How many levels are visited of the hierarchies of agents without a depth of their own. */
        public var maxDepth:int = 5;

        /** Whether triangles decide. */
        public var exact:Boolean = false;

        private var _leavesDecide:Boolean = false;
        private var _greatLand:GreatLand;
        private var _traversal:HierarchyTraversal = new HierarchyTraversal();
        private var _swept:SweptHierarchyTraversal;
        private var _turned:RelativeMotion = new RelativeMotion();
        private var _memberPlacement:Placement = new Placement();
        private var _placementA:Placement = new Placement();
        private var _placementB:Placement = new Placement();

        /**
         * @param greatLand has the hierarchies
         */
        public function HierarchyStrategy(greatLand:GreatLand)
        {
            _greatLand = greatLand;
            _swept = new SweptHierarchyTraversal(_traversal);
        }

        /** @inheritDoc */
        override public function kindOf(agent:Agent):int
        {
            return ModelShape.HIERARCHY;
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            if (!_greatLand.hierarchies.has(shape.model))
            {
                throw new ArgumentError(agent
                        + ": its model was added while loadHierarchies was off; set it, and add the model again");
            }
            shape.hierarchy = _greatLand.hierarchies.hierarchy(shape.model);
            shape.structure = shape.hierarchy.root.bounds;
        }

        /** @inheritDoc */
        override public function keepTouching(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var shapes:Vector.<ModelShape> = table.shapes;
            var agents:Vector.<Agent> = table.agents;
            var rowAt:Vector.<int> = bins.rowAt;
            var row:int = rowAt[slot];
            var hierarchy:SolidHierarchy = shapes[row].hierarchy;
            if (hierarchy == null)
            {
                return super.keepTouching(table, bins, slot, others, count);
            }
            var number:int = agents[row].number;
            var placement:Placement = table.placementOf(row, _memberPlacement);
            var depth:int = depthOf(table, row);
            var isDecided:Boolean = exact;
            var kept:int = 0;
            count = keepNear(table.extents, bins, slot, others, count);
            for (var i:int = 0; i < count; i++)
            {
                var otherRow:int = rowAt[others[i]];
                var other:SolidHierarchy = shapes[otherRow].hierarchy;
                var isTouching:Boolean = false;
                if (other == null)
                {
                    isTouching = areTouching(table, row, otherRow);
                }
                else
                {
                    counts.hierarchyTests++;
                    var otherPlacement:Placement = table.placementOf(otherRow, _placementB);
                    var otherDepth:int = depthOf(table, otherRow);
                    if (agents[otherRow].number > number)
                    {
                        isTouching = _traversal.hierarchiesOverlap(hierarchy, placement, depth, other, otherPlacement, otherDepth, isDecided);
                    }
                    else
                    {
                        isTouching = _traversal.hierarchiesOverlap(other, otherPlacement, otherDepth, hierarchy, placement, depth, isDecided);
                    }
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
            if (isSecondFirst(table, a, b))
            {
                var first:int = b;
                b = a;
                a = first;
            }
            counts.hierarchyTests++;
            var shapeA:ModelShape = table.shapes[a];
            var shapeB:ModelShape = table.shapes[b];
            var placementA:Placement = table.placementOf(a, _placementA);
            var placementB:Placement = table.placementOf(b, _placementB);
            if (shapeB.hierarchy == null)
            {
                return _traversal.structureOverlaps(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.structure, placementB);
            }
            return _traversal.hierarchiesOverlap(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.hierarchy, placementB,
                    depthOf(table, b), exact && !_leavesDecide);
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            if (isSecondFirst(table, a, b))
            {
                _turned.turn(motion);
                findTime(table, b, a, _turned);
                motion.time = _turned.time;
                return;
            }
            counts.hierarchyTests++;
            setSweptPair(table, a, b, false);
            _swept.findTime(motion);
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (table.shapes[a].hierarchy == null)
            {
                _turned.turn(motion);
                findContact(table, b, a, _turned, out);
                out.turn(motion);
                return;
            }
            setSweptPair(table, a, b, false);
            _swept.findContact(motion, out);
        }

        /** @inheritDoc */
        override public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (isSecondFirst(table, a, b))
            {
                _turned.turn(motion);
                findImpact(table, b, a, _turned, out);
                motion.time = _turned.time;
                if (motion.time != RelativeMotion.NEVER)
                {
                    out.turn(motion);
                }
                return;
            }
            counts.hierarchyTests++;
            setSweptPair(table, a, b, _leavesDecide);
            _swept.findImpact(motion, out);
        }

        /** @inheritDoc */
        override public function set leavesDecide(value:Boolean):void
        {
            _leavesDecide = value && exact;
        }

        /** @inheritDoc */
        override public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            _swept.findOuterContact(table.shapes[a].structure, table.placementOf(a, _placementA), table.shapes[b].structure,
                    table.placementOf(b, _placementB), out);
        }

        /** @inheritDoc */
        override public function depthOf(table:AgentTable, row:int):int
        {
            if (exact)
            {
                return int.MAX_VALUE;
            }
            return table.depths[row] == 0 ? maxDepth : table.depths[row];
        }

        /** @inheritDoc */
        override public function get isExact():Boolean
        {
            return exact;
        }

        /** @inheritDoc */
        override public function resetCounts():void
        {
            super.resetCounts();
            _swept.resetCounts();
            _traversal.resetCounts();
        }

        /** @inheritDoc */
        override public function finishCounts():void
        {
            counts.nodeVisits = _traversal.nodeVisits + _swept.nodeVisits;
            counts.triangleTests = _traversal.triangleTests + _swept.triangleTests;
        }

        // The first is a hierarchy; where both are, leaves may decide in place of triangles.
        private function setSweptPair(table:AgentTable, a:int, b:int, byLeaves:Boolean):void
        {
            var shapeB:ModelShape = table.shapes[b];
            var toLeaves:Boolean = byLeaves && shapeB.hierarchy != null;
            _swept.setPair(table.shapes[a].hierarchy, table.placementOf(a, _placementA), depthOf(table, a), shapeB.hierarchy,
                    shapeB.structure, table.placementOf(b, _placementB), depthOf(table, b), exact && !toLeaves);
        }

        /**
         * Whether the second of two rows is taken for the first: the hierarchy is, and of two shapes alike that of the agent with the lower number.
         * So rounding is the same in either order.
         */
        public static function isSecondFirst(table:AgentTable, a:int, b:int):Boolean
        {
            var isHierarchy:Boolean = table.shapes[a].hierarchy != null;
            if (isHierarchy != (table.shapes[b].hierarchy != null))
            {
                return !isHierarchy;
            }
            return table.agents[a].number > table.agents[b].number;
        }
    }
}
