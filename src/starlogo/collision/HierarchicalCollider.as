package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.engine;

    use namespace engine;

    /**
     * Takes every agent for the hierarchy of bounding structures of its model (thesis §4), or, if it is exact, for its
     * model.
     *
     * <p>It is built on the BinCollider (§4.7): an agent is in the bins that the structure around its whole model reaches into.
     * Of two agents whose extents overlap, the hierarchies are visited together, depth-first, down to two structures that
     * overlap and are leaves or at the depth limit (§4.6). A depth counts levels, the root being level 1; where one
     * hierarchy ends before the other, only the other is descended further.</p>
     *
     * <p>The thesis puts the two structures of each pair of nodes into the world (§4.5), and goes down in both hierarchies at
     * once (§4.6). Here one transform for each pair of agents serves all their nodes, and where two nodes overlap the
     * larger one is divided, or both where one's middle is in the other. The answers are the same but that an overlap of two
     * nodes at their depth limits counts, whatever their levels.</p>
     *
     * <p>With models that have triangles, no depth ever misses a collision of the surfaces, and a greater depth finds fewer
     * false ones; see HierarchiesLibrary.</p>
     */
    public class HierarchicalCollider extends BinCollider
    {
        /**
         * Whether triangles decide, so that the answer is the models' own. Leaves that overlap then are looked into, no depth
         * limit counts, and a model that is inside of another without touching its surface collides with it if that surface
         * is closed. An agent whose model has no triangles is decided by the leaves of its hierarchy.
         *
         * <p>The first frame that an exact collider meets a model in takes some time to prepare its triangles: tens of
         * milliseconds for thousands.</p>
         */
        public var exact:Boolean = false;

        private var _maxDepth:int = 5;
        private var _traversal:BodyTraversal = new BodyTraversal();

        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, loaded with loadHierarchies
         * @throws ArgumentError if it is null
         */
        public function HierarchicalCollider(greatLand:GreatLand)
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
            body.takeHierarchy(_greatLand);
            body.structure = body.hierarchy.root.bounds;
            body.world = body.structure.clone();
            body.isHierarchical = true;
        }

        /** @private */
        override internal function place(body:Body):void
        {
            body.structure.place(body.agent.worldPlacement(), body.world);
            body.takeExtentsOf(body.world);
            body.depth = body.agent.traversalDepth;
        }

        /** @private */
        override internal function test(a:Body, b:Body):Boolean
        {
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
            _traversal.resetCounts();
        }

        /** @private */
        override internal function countTests(statistics:CollisionStatistics):void
        {
            _traversal.countInto(statistics);
        }
    }
}
