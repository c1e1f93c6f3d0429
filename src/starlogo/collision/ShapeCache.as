package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.agents.CacheToken;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /** Keeps a collider's world shapes with the agents, and up to date (thesis §3.5). */
    internal final class ShapeCache
    {
        /** Marks the collider's shapes among the agents' records; another one when a model was replaced, which makes all void. */
        public var token:CacheToken = new CacheToken();

        /** Whether a shape has got another level of the bins, or none; who keeps shapes by level sets it to false. */
        public var levelsChanged:Boolean = false;

        private var _greatLand:GreatLand;
        private var _strategy:ShapeStrategy;
        private var _bins:Bins;
        private var _greatLandRevision:int;

        /**
         * @param greatLand has the models of the agents
         * @param strategy says what shapes they have
         * @param bins assign each shape its level
         * @throws ArgumentError if greatLand is null
         */
        public function ShapeCache(greatLand:GreatLand, strategy:ShapeStrategy, bins:Bins)
        {
            if (greatLand == null)
            {
                throw new ArgumentError("greatLand must not be null");
            }
            _greatLand = greatLand;
            _strategy = strategy;
            _bins = bins;
            _greatLandRevision = greatLand.revision;
        }

        /**
         * Begins a search, or a question about two agents.
         *
         * @return whether shapes that were found before may not be the agents' own any more
         */
        public function noteUse():Boolean
        {
            var isRevoked:Boolean = _greatLand.revision != _greatLandRevision;
            if (isRevoked)
            {
                _greatLandRevision = _greatLand.revision;
                token.revoke();
                token = new CacheToken();
            }
            return token.noteUse() || isRevoked;
        }

        /**
         * An agent's shape, up to date.
         *
         * @return one without a level while the agent's model is loading
         * @throws ArgumentError if the model is unknown, or what is needed of it was not loaded
         */
        public function shapeOf(agent:Agent):WorldShape
        {
            var shape:WorldShape = find(agent);
            if (shape.revision != agent.revision)
            {
                update(shape, agent);
            }
            return shape;
        }

        /** An agent's shape as it is, or a new one. */
        public function find(agent:Agent):WorldShape
        {
            var record:AgentRecord = agent.records;
            while (record != null && record.cacheToken !== token)
            {
                record = record.next;
            }
            if (record != null)
            {
                return record as WorldShape;
            }
            var shape:WorldShape = new WorldShape(agent, token);
            agent.addRecord(shape);
            return shape;
        }

        /**
         * Brings a shape up to date whose agent has changed.
         *
         * @return false if the agent's model is loading
         * @throws ArgumentError if the model is unknown, or what is needed of it was not loaded
         */
        public function update(shape:WorldShape, agent:Agent):Boolean
        {
            var level:BinLevel = shape.level;
            var placement:Placement = agent.worldPlacement();
            if (shape.extentsRevision != placement.extentsRevision)
            {
                if (shape.model != agent.shape && !bindModel(shape, agent))
                {
                    levelsChanged = levelsChanged || level != null;
                    return false;
                }
                _strategy.updateWorldShape(shape);
                shape.extentsRevision = placement.extentsRevision;
            }
            shape.revision = agent.revision;
            shape.x = placement.x + shape.offsetX;
            shape.y = placement.y + shape.offsetY;
            shape.z = placement.z + shape.offsetZ;
            _bins.fit(shape);
            if (shape.level !== level)
            {
                levelsChanged = true;
            }
            return true;
        }

        // Whether the agent's model is there; otherwise it is loading.
        private function bindModel(shape:WorldShape, agent:Agent):Boolean
        {
            shape.unbind();
            if (!_greatLand.hasModel(agent.shape))
            {
                if (_greatLand.isLoading(agent.shape))
                {
                    return false;
                }
                throw new ArgumentError(agent + ": there is no model \"" + agent.shape + "\"; add it to the GreatLand first");
            }
            _strategy.bindModel(shape);
            shape.model = agent.shape;
            return true;
        }
    }
}
