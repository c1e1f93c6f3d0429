package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;

    use namespace engine;

    /**
     * Takes the agents that are hierarchical for the hierarchies of their models, and all others for their tightest fits
     * (thesis §5): precise where a player looks, cheap everywhere else.
     *
     * <p>Two agents that are not hierarchical collide as in the TightestFitCollider, two that are as in the
     * HierarchicalCollider. Of one that is and one that is not, the hierarchy meets the structure: it is visited down to a
     * leaf, or to the depth limit, that the structure overlaps. An agent may become hierarchical, or cease to be, between
     * frames.</p>
     *
     * <p>The hierarchy is needed of models whose agents are hierarchical, the tightest fit of the others.</p>
     */
    public class CombinationCollider extends TightestFitCollider
    {
        /**
         * Whether the triangles of two hierarchical agents decide, as in HierarchicalCollider.exact. A hierarchical agent and
         * one that is not are decided by boxes in any case.
         */
        public var exact:Boolean = false;

        private var _maxDepth:int = 5;
        private var _traversal:BodyTraversal = new BodyTraversal();

        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, loaded with loadTightestFit and loadHierarchies
         * @throws ArgumentError if it is null
         */
        public function CombinationCollider(greatLand:GreatLand)
        {
            super(greatLand);
        }

        /**
         * How many levels of a hierarchy are visited, for agents whose own traversalDepth is 0 (§4.8); the root is one. A
         * number larger than a hierarchy has levels visits them all.
         *
         * @throws RangeError if it is set to less than 1
         */
        public function get maxDepth():int
        {
            return _maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            if (value < 1)
            {
                throw new RangeError("maxDepth must be at least 1: " + value);
            }
            _maxDepth = value;
        }

        /** @private */
        override internal function adopt(body:Body):void
        {
            _greatLand.requireModel(body.agent);
        }

        // The agent's trait may have changed, which counts as a change of the agent.

        /** @private */
        override internal function place(body:Body):void
        {
            if (body.agent.hierarchical)
            {
                if (body.hierarchy == null)
                {
                    body.takeHierarchy(_greatLand);
                    body.worldRoot = body.hierarchy.root.bounds.clone();
                }
                body.isHierarchical = true;
                body.isSphere = false;
                body.hierarchy.root.bounds.place(body.agent.worldPlacement(), body.worldRoot);
                body.takeExtentsOf(body.worldRoot);
                body.depth = body.agent.traversalDepth;
                return;
            }
            if (body.structure == null)
            {
                super.adopt(body);
            }
            body.isHierarchical = false;
            body.isSphere = body.structure.kind == BoundingStructure.SPHERE;
            super.place(body);
        }

        /** @private */
        override internal function test(a:Body, b:Body):Boolean
        {
            if (!a.isHierarchical && !b.isHierarchical)
            {
                return super.test(a, b);
            }
            _pairsOfOthers++;
            var distance:Number = a.z - b.z;
            var reach:Number = a.halfZ + b.halfZ;
            if (distance > reach || distance < -reach)
            {
                return false;
            }
            return _traversal.bodiesMeet(a, b, _maxDepth, exact);
        }

        /** @private */
        override internal function resetCounts():void
        {
            super.resetCounts();
            _traversal.resetCounts();
        }

        /** @private */
        override internal function countTests(statistics:CollisionStatistics):void
        {
            super.countTests(statistics);
            _traversal.countInto(statistics);
        }
    }
}
