package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyTraversal;
    import starlogo.hierarchy.SweptHierarchyTraversal;
    import starlogo.motion.Touch;
    import starlogo.motion.Way;

    use namespace engine;

    /** Every agent is the hierarchy of its model (thesis §4); two may be a hierarchy and a structure. */
    internal final class HierarchyStrategy extends ShapeStrategy
    {
        /** How many levels are visited of the hierarchies of agents without a depth of their own. */
        public var maxDepth:int = 5;

        /** Whether triangles decide. */
        public var exact:Boolean = false;

        private var _greatLand:GreatLand;
        private var _traversal:HierarchyTraversal = new HierarchyTraversal();
        private var _swept:SweptHierarchyTraversal;
        private var _turned:Way = new Way();
        private var _placementA:Placement = new Placement();
        private var _placementB:Placement = new Placement();
        private var _pairs:int = 0;

        /**
         * @param greatLand has the hierarchies
         */
        public function HierarchyStrategy(greatLand:GreatLand)
        {
            _greatLand = greatLand;
            _swept = new SweptHierarchyTraversal(_traversal);
        }

        /** @inheritDoc */
        override public function bindModel(shape:WorldShape):void
        {
            var agent:Agent = shape.agent;
            if (!_greatLand.hierarchies.has(agent.shape))
            {
                throw new ArgumentError(agent
                        + ": its model was added while loadHierarchies was off; set it, and add the model again");
            }
            shape.hierarchy = _greatLand.hierarchies.hierarchy(agent.shape);
            shape.root = shape.hierarchy.root.bounds;
            shape.isHierarchical = true;
        }

        /** @inheritDoc */
        override public function updateWorldShape(shape:WorldShape):void
        {
            shape.takeExtentsOf(shape.root);
            shape.depth = shape.agent.traversalDepth;
        }

        /** @inheritDoc */
        override public function overlaps(a:WorldShape, b:WorldShape):Boolean
        {
            _pairs++;
            // the same way round whoever comes first, so that rounding is too
            if (a.serial > b.serial)
            {
                var first:WorldShape = b;
                b = a;
                a = first;
            }
            if (!a.isHierarchical)
            {
                return structureOverlaps(b, a);
            }
            if (!b.isHierarchical)
            {
                return structureOverlaps(a, b);
            }
            return _traversal.hierarchiesOverlap(a.hierarchy, a.placement, depthOf(a), b.hierarchy, b.placement, depthOf(b), exact);
        }

        /** @inheritDoc */
        override public function firstOverlap(a:WorldShape, b:WorldShape, way:Way):Number
        {
            _pairs++;
            // the same way round whoever comes first, so that rounding is too
            if (a.serial > b.serial && a.isHierarchical == b.isHierarchical || !a.isHierarchical)
            {
                _turned.turn(way);
                way = _turned;
                var first:WorldShape = b;
                b = a;
                a = first;
            }
            var placementA:Placement = seenPlacement(a, _placementA);
            var placementB:Placement = seenPlacement(b, _placementB);
            if (!b.isHierarchical)
            {
                return _swept.structureTouches(a.hierarchy, placementA, depthOf(a), b.structure, placementB, way);
            }
            return _swept.hierarchiesTouch(a.hierarchy, placementA, depthOf(a), b.hierarchy, placementB, depthOf(b), exact, way);
        }

        /** @inheritDoc */
        override public function findTouch(a:WorldShape, b:WorldShape, way:Way, time:Number, out:Touch):void
        {
            var placementA:Placement = seenPlacement(a, _placementA);
            var placementB:Placement = seenPlacement(b, _placementB);
            if (!a.isHierarchical)
            {
                _turned.turn(way);
                _swept.findStructureTouch(b.hierarchy, placementB, depthOf(b), a.structure, placementA, _turned, time, out);
                out.turn(way.startX + time * way.x, way.startY + time * way.y, way.startZ + time * way.z);
            }
            else if (!b.isHierarchical)
            {
                _swept.findStructureTouch(a.hierarchy, placementA, depthOf(a), b.structure, placementB, way, time, out);
            }
            else
            {
                _swept.findTouch(a.hierarchy, placementA, depthOf(a), b.hierarchy, placementB, depthOf(b), exact, way, time, out);
            }
        }

        // Where a shape was when it was computed, though its agent may have moved since.
        private static function seenPlacement(shape:WorldShape, scratch:Placement):Placement
        {
            if (shape.revision == shape.agent.revision)
            {
                return shape.placement;
            }
            scratch.copyFrom(shape.placement);
            scratch.x = shape.x - shape.offsetX;
            scratch.y = shape.y - shape.offsetY;
            scratch.z = shape.z - shape.offsetZ;
            return scratch;
        }

        private function depthOf(shape:WorldShape):int
        {
            return shape.depth == 0 ? maxDepth : shape.depth;
        }

        /** @inheritDoc */
        override public function resetCounts():void
        {
            _pairs = 0;
            _swept.resetCounts();
            _traversal.resetCounts();
        }

        /** @inheritDoc */
        override public function countInto(statistics:CollisionStatistics):void
        {
            statistics.hierarchyTests += _pairs;
            statistics.nodeVisits += _traversal.nodeVisits + _swept.nodeVisits;
            statistics.triangleTests += _traversal.triangleTests + _swept.triangleTests;
        }

        private function structureOverlaps(hierarchical:WorldShape, other:WorldShape):Boolean
        {
            return _traversal.structureOverlaps(hierarchical.hierarchy, hierarchical.placement, depthOf(hierarchical), other.structure,
                    other.placement);
        }
    }
}
