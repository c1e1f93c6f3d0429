package starlogo.queries
{
    import flash.errors.IllegalOperationError;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.collision.QuerySource;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.requireGiven;
    import starlogo.search.AgentTable;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.ModelShapes;
    import starlogo.search.NarrowPhase;
    import starlogo.search.ListedAgents;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * Keeps the agents of a list as a collision system sees them, for questions: in a table of its own, with a tree of their places and a tree
     * of their extents. Each tree is built when a question first needs it.
     *
     * @private
     */
    public final class QueryWorld
    {
        /** The agents. Questions only read them. */
        public var table:AgentTable;

        /** Tests which rows touch. It belongs to the collision system and has its settings. */
        public var narrowPhase:NarrowPhase;

        /** The number of questions under way that are calling a filter's accepts. Meanwhile the list must not change. */
        public var asking:int = 0;

        private var _source:QuerySource;

        // Functions that bring the tests which some questions need.
        private var _needs:Vector.<Function> = new Vector.<Function>();

        private var _terrain:Terrain = null;
        private var _places:RowTree = new RowTree();
        private var _extents:RowTree = new RowTree();
        private var _isRead:Boolean = false;

        /**
         * @param source a Collision, one of the engine's colliders, or the shapes of a level
         * @throws ArgumentError if it is none of them, or if the Collision's system is not one of the engine's
         */
        public function QueryWorld(source:Object)
        {
            _source = source as QuerySource;
            if (_source == null)
            {
                throw QuerySource.errorAbout(source);
            }
            narrowPhase = _source.findTests();
            table = newTable(narrowPhase);
        }

        /** See AgentQueries.terrain. */
        public function get terrain():Terrain
        {
            return _source.groundFor(_terrain);
        }

        public function set terrain(value:Terrain):void
        {
            _source.takeGround(value);
            _terrain = value;
        }

        /**
         * Questions need tests that their collision system may lack. It has them from now on.
         *
         * @param bringTo <code>function(narrowPhase:NarrowPhase):void</code>
         */
        public function need(bringTo:Function):void
        {
            _needs.push(bringTo);
            bringTo(narrowPhase);
        }

        /** See AgentQueries.update. */
        public function update(agents:Vector.<Agent>):void
        {
            requireGiven("agents", agents);
            requireQuiet("update");
            var tests:NarrowPhase = _source.findTests();
            var next:AgentTable = tests === narrowPhase ? table : newTable(tests);
            next.read(agents);
            next.readWorldAgent(ListedAgents.GROUND, terrain == null ? null : terrain.agent);
            table = next;
            see(tests);
            _places.movesLeft = _extents.movesLeft = -1;
            _isRead = true;
        }

        /** See AgentQueries.refresh. */
        public function moved(agent:Agent):void
        {
            requireQuiet("refresh");
            var row:int = rowOf(agent);
            if (row < ListedAgents.LISTED)
            {
                throw new ArgumentError(agent + " is not in the list of the last update");
            }
            table.readRow(row);
            _places.move(row);
            _extents.move(row);
        }

        /** Throws an error if a filter's <code>accepts</code> is being called, because what questions see must not change then. */
        public function requireQuiet(what:String):void
        {
            if (asking > 0)
            {
                throw new IllegalOperationError(what + " must not be called from a filter's accepts");
            }
        }

        /** Throws an error if a filter's <code>accepts</code> is being called and the agent is in the list. */
        public function requireMovable(agent:Agent, what:String):void
        {
            if (agent != null && table.list.rowOf(agent) >= 0)
            {
                requireQuiet(what);
            }
        }

        /** The row of an agent; -1 if it is not in the list. */
        public function rowOf(agent:Agent):int
        {
            requireAgent(agent);
            return table.list.rowOf(agent);
        }

        /** Where an agent is now. Throws an ArgumentError if it is null, or has no place because it is the ground's or the edges'. */
        public function placeOf(agent:Agent):Placement
        {
            requireAgent(agent);
            if (Breeds.isReserved(agent.breedNumber))
            {
                throw new ArgumentError(agent + " has no place, and does not move: it stands for the ground or the edges of the world");
            }
            return agent.placement;
        }

        /** Returns the tree of the places, and builds it first if it is stale. Throws an error before the first update. */
        public function findPlaces():RowTree
        {
            requireRead();
            if (_places.movesLeft < 0)
            {
                _places.build(table.list.rows, table.list.count, table.places.now);
            }
            _places.breeds.learn(_places, table.list.agents);
            return _places;
        }

        /** Returns the tree of the extents, and builds it first if it is stale. Throws an error before the first update. While a model is loading, its extents mean nothing. */
        public function findExtents():RowTree
        {
            requireRead();
            if (_extents.movesLeft < 0)
            {
                _extents.build(table.list.rows, table.list.count, table.extents);
            }
            _extents.breeds.learn(_extents, table.list.agents);
            return _extents;
        }

        private function requireRead():void
        {
            if (!_isRead)
            {
                throw new IllegalOperationError("update(agents) must be called before the first question, and then once a frame");
            }
        }

        /** Begins a search for rows whose extents are near the extents of a body. */
        public function beginWay(search:SweptBoxSearch, body:Body):void
        {
            search.begin(findExtents(), body.x, body.y, body.z, body.halfX, body.halfY, body.halfZ);
            if (body.form >= ModelShape.GROUND)
            {
                // the ground and the edges of the world are near all rows
                search.widen(4 * Agent.LARGEST_COORDINATE);
            }
        }

        private function see(tests:NarrowPhase):void
        {
            if (narrowPhase !== tests)
            {
                narrowPhase = tests;
                for (var i:int = 0; i < _needs.length; i++)
                {
                    _needs[i](tests);
                }
            }
        }

        private static function newTable(tests:NarrowPhase):AgentTable
        {
            return new AgentTable(new ModelShapes(tests.choice), null);
        }

        /** Throws an ArgumentError if an agent is null. */
        public static function requireAgent(agent:Agent):void
        {
            if (agent == null)
            {
                throw new ArgumentError("an agent is needed, not null");
            }
        }
    }
}
