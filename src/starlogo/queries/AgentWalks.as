package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.Contact;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.search.pairs.TreePairTests;

    use namespace engine;

    /**
     * Moves characters, and answers how far something can go: the questions of AgentQueries about motions, for games that load no others.
     * Their rules stand there.
     */
    public final class AgentWalks
    {
        private var _moves:MoveQueries;
        private var _walks:WalkQueries;

        /**
         * Asks about the agents of a SeenAgents. Others may ask about the same.
         *
         * @param seen the agents that the questions see
         * @throws ArgumentError if it is null
         */
        public function AgentWalks(seen:SeenAgents)
        {
            requireGiven("seen", seen);
            // A LevelShapes has no tests of pairs. A collision system has those that it needs, so an AgentQueries loads no tests of trees for a game
            // without trees. For the same reason it does not hold an AgentWalks.
            seen.needTests(StructurePairTests.addTo);
            seen.needTests(TreePairTests.addTo);
            _moves = new MoveQueries(seen);
            _walks = new WalkQueries(seen);
        }

        /** See AgentQueries.castShape. It has the same arguments, answers and errors. */
        public function castShape(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            return _moves.castShape(structure, dx, dy, dz, filter, hit);
        }

        /** See AgentQueries.castShapeAll. It has the same arguments, answers and errors. */
        public function castShapeAll(structure:BoundingStructure, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            return _moves.castShapeAll(structure, dx, dy, dz, filter, out);
        }

        /** See AgentQueries.castAgent. It has the same arguments, answers and errors. */
        public function castAgent(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, hit:ShapeHit = null):ShapeHit
        {
            return _moves.castAgent(agent, dx, dy, dz, filter, hit);
        }

        /** See AgentQueries.castAgentAll. It has the same arguments, answers and errors. */
        public function castAgentAll(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null,
                out:Vector.<ShapeHit> = null):Vector.<ShapeHit>
        {
            return _moves.castAgentAll(agent, dx, dy, dz, filter, out);
        }

        /** See AgentQueries.moveUntilTouch. It has the same arguments, answers and errors. */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null, contact:Contact = null):Number
        {
            return _moves.moveUntilTouch(agent, dx, dy, dz, filter, contact);
        }

        /** See AgentQueries.slide. It has the same arguments, answers and errors. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter = null):Number
        {
            return _moves.slide(agent, dx, dy, dz, filter);
        }

        /** See AgentQueries.walk. It has the same arguments, answers and errors. */
        public function walk(agent:Agent, dx:Number, dy:Number, options:WalkOptions = null, out:Footing = null):Footing
        {
            return _walks.walk(agent, dx, dy, options, out);
        }
    }
}
