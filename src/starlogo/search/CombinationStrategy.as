package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * An agent that is hierarchical is the hierarchy of its model, any other its tightest fit (thesis §5).
     *
     * @private
     */
    public final class CombinationStrategy extends ShapeStrategy
    {
        private var _tightestFit:TightestFitStrategy;
        private var _hierarchy:HierarchyStrategy;

        // Whether any agent has ever been hierarchical: mostly none is.
        private var _hasHierarchies:Boolean = false;

        // Those of the candidates at hand that are hierarchical.
        private var _hierarchical:Vector.<int> = new Vector.<int>();

        /**
         * @param tightestFit for those that are not hierarchical
         * @param hierarchy for pairs of which at least one agent is hierarchical
         */
        public function CombinationStrategy(tightestFit:TightestFitStrategy, hierarchy:HierarchyStrategy)
        {
            _tightestFit = tightestFit;
            _hierarchy = hierarchy;
            tightestFit.counts = hierarchy.counts = counts;
        }

        /** @inheritDoc */
        override public function kindOf(agent:Agent):int
        {
            return agent.hierarchical ? ModelShape.HIERARCHY : _tightestFit.kindOf(agent);
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            var isHierarchy:Boolean = shape.kind == ModelShape.HIERARCHY;
            var strategy:ShapeStrategy = isHierarchy ? _hierarchy : _tightestFit;
            strategy.bind(shape, agent);
            _hasHierarchies ||= isHierarchy;
        }

        /** @inheritDoc */
        override public function boxOf(structure:BoundingStructure):Box
        {
            return _tightestFit.boxOf(structure);
        }

        /** @inheritDoc */
        override public function keepTouching(table:AgentTable, bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            if (!_hasHierarchies)
            {
                return _tightestFit.keepTouching(table, bins, slot, others, count);
            }
            var shapes:Vector.<ModelShape> = table.shapes;
            var rowAt:Vector.<int> = bins.rowAt;
            if (shapes[rowAt[slot]].hierarchy != null)
            {
                return _hierarchy.keepTouching(table, bins, slot, others, count);
            }
            var plain:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                if (shapes[rowAt[other]].hierarchy == null)
                {
                    others[plain] = other;
                    plain++;
                }
                else
                {
                    _hierarchical[i - plain] = other;
                }
            }
            var kept:int = _tightestFit.keepTouching(table, bins, slot, others, plain);
            var keptOfThem:int = _hierarchy.keepTouching(table, bins, slot, _hierarchical, count - plain);
            for (i = 0; i < keptOfThem; i++)
            {
                others[kept + i] = _hierarchical[i];
            }
            return kept + keptOfThem;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            return strategyOf(table, a, b).areTouching(table, a, b);
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            strategyOf(table, a, b).findTime(table, a, b, motion);
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            strategyOf(table, a, b).findContact(table, a, b, motion, out);
        }

        /** @inheritDoc */
        override public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            strategyOf(table, a, b).findImpact(table, a, b, motion, out);
        }

        /** @inheritDoc */
        override public function set leavesDecide(value:Boolean):void
        {
            _hierarchy.leavesDecide = value;
        }

        /** @inheritDoc */
        override public function findOuterContact(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            strategyOf(table, a, b).findOuterContact(table, a, b, out);
        }

        /** @inheritDoc */
        override public function hasExactContact(table:AgentTable, a:int, b:int):Boolean
        {
            return strategyOf(table, a, b).hasExactContact(table, a, b);
        }

        /** @inheritDoc */
        override public function depthOf(table:AgentTable, row:int):int
        {
            return _hierarchy.depthOf(table, row);
        }

        /** @inheritDoc */
        override public function get isExact():Boolean
        {
            return _hierarchy.isExact;
        }

        /** @inheritDoc */
        override public function get touchesAcrossGaps():Boolean
        {
            return _tightestFit.touchesAcrossGaps;
        }

        /** @inheritDoc */
        override public function resetCounts():void
        {
            _hierarchy.resetCounts();
        }

        /** @inheritDoc */
        override public function finishCounts():void
        {
            _hierarchy.finishCounts();
        }

        private function strategyOf(table:AgentTable, a:int, b:int):ShapeStrategy
        {
            var isByHierarchy:Boolean = table.shapes[a].hierarchy != null || table.shapes[b].hierarchy != null;
            return isByHierarchy ? _hierarchy : _tightestFit;
        }
    }
}
