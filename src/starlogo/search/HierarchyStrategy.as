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

        private var _greatLand:GreatLand;
        private var _traversal:HierarchyTraversal = new HierarchyTraversal();
        private var _swept:SweptHierarchyTraversal;
        private var _turned:RelativeMotion = new RelativeMotion();
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
        override public function keepTouching(table:AgentTable, bins:Bins, place:int, others:Vector.<int>, count:int):int
        {
            var shapes:Vector.<ModelShape> = table.shapes;
            var agents:Vector.<Agent> = table.agents;
            var depths:Vector.<int> = table.depths;
            var rowAt:Vector.<int> = bins.rowAt;
            var row:int = rowAt[place];
            var agent:Agent = agents[row];
            var shape:ModelShape = shapes[row];
            var serial:int = agent.serial;
            var depth:int = depthOf(table, row);
            var kept:int = 0;
            count = keepNear(table.extents, bins, place, others, count);
            counts.hierarchyTests += count;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var otherRow:int = rowAt[other];
                var otherAgent:Agent = agents[otherRow];
                var otherShape:ModelShape = shapes[otherRow];
                var otherDepth:int = depths[otherRow];
                if (otherDepth == 0)
                {
                    otherDepth = maxDepth;
                }
                // as areTouching does, with what is known of the one already
                var touches:Boolean;
                if (shape.hierarchy == null)
                {
                    touches = _traversal.structureOverlaps(otherShape.hierarchy, otherAgent.placement, otherDepth, shape.structure, agent.placement);
                }
                else if (otherShape.hierarchy == null)
                {
                    touches = _traversal.structureOverlaps(shape.hierarchy, agent.placement, depth, otherShape.structure, otherAgent.placement);
                }
                else if (serial < otherAgent.serial)
                {
                    touches = _traversal.hierarchiesOverlap(shape.hierarchy, agent.placement, depth, otherShape.hierarchy,
                            otherAgent.placement, otherDepth, exact);
                }
                else
                {
                    touches = _traversal.hierarchiesOverlap(otherShape.hierarchy, otherAgent.placement, otherDepth, shape.hierarchy,
                            agent.placement, depth, exact);
                }
                if (touches)
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            counts.hierarchyTests++;
            if (isTheOtherWayRound(table, a, b))
            {
                var first:int = b;
                b = a;
                a = first;
            }
            var shapeA:ModelShape = table.shapes[a];
            var shapeB:ModelShape = table.shapes[b];
            var placementA:Placement = table.placementOf(a, _placementA);
            var placementB:Placement = table.placementOf(b, _placementB);
            if (shapeB.hierarchy == null)
            {
                return _traversal.structureOverlaps(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.structure, placementB);
            }
            return _traversal.hierarchiesOverlap(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.hierarchy, placementB,
                    depthOf(table, b), exact);
        }

        /** @inheritDoc */
        override public function impactTime(table:AgentTable, a:int, b:int, way:RelativeMotion):Number
        {
            counts.hierarchyTests++;
            if (isTheOtherWayRound(table, a, b))
            {
                _turned.turn(way);
                way = _turned;
                var first:int = b;
                b = a;
                a = first;
            }
            var shapeA:ModelShape = table.shapes[a];
            var shapeB:ModelShape = table.shapes[b];
            var placementA:Placement = table.placementOf(a, _placementA);
            var placementB:Placement = table.placementOf(b, _placementB);
            if (shapeB.hierarchy == null)
            {
                return _swept.structureTouches(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.structure, placementB, way);
            }
            return _swept.hierarchiesTouch(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.hierarchy, placementB,
                    depthOf(table, b), exact, way);
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, way:RelativeMotion, time:Number, out:ContactPoint):void
        {
            var shapeA:ModelShape = table.shapes[a];
            var shapeB:ModelShape = table.shapes[b];
            var placementA:Placement = table.placementOf(a, _placementA);
            var placementB:Placement = table.placementOf(b, _placementB);
            if (shapeA.hierarchy == null)
            {
                _turned.turn(way);
                _swept.findStructureContact(shapeB.hierarchy, placementB, depthOf(table, b), shapeA.structure, placementA, _turned, time, out);
                out.turn(way.startX + time * way.x, way.startY + time * way.y, way.startZ + time * way.z);
            }
            else if (shapeB.hierarchy == null)
            {
                _swept.findStructureContact(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.structure, placementB, way, time, out);
            }
            else
            {
                _swept.findContact(shapeA.hierarchy, placementA, depthOf(table, a), shapeB.hierarchy, placementB, depthOf(table, b), exact,
                        way, time, out);
            }
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

        // The hierarchy before the structure, and the older agent before the younger: the same whichever comes first, so that rounding is too.
        private static function isTheOtherWayRound(table:AgentTable, a:int, b:int):Boolean
        {
            var isHierarchy:Boolean = table.shapes[a].hierarchy != null;
            if (isHierarchy != (table.shapes[b].hierarchy != null))
            {
                return !isHierarchy;
            }
            return table.agents[a].serial > table.agents[b].serial;
        }

        private function depthOf(table:AgentTable, row:int):int
        {
            return table.depths[row] == 0 ? maxDepth : table.depths[row];
        }
    }
}
