// This room answers questions about agents in space. Games ask an AgentQueries, which has all questions, or for a smaller game AgentPlaces (what is
// near), AgentRays (what a ray meets) and AgentMotions (how far something can go). Each class of questions searches the trees of a SeenAgents, tests what
// it finds, and gives it to a Collector. AgentPlaces and AgentRays do so themselves. TouchQueries answers AgentQueries alone. MoveQueries answers
// AgentQueries and AgentMotions, because AgentMotions loads the tests of trees.
// - trees/: the trees of places and extents, their searches, the Collector and its RowFilter; motion/: how a body moves among rows
// - rays/: how a ray meets a row, and the hits of rays and casts
// - LevelShapes, LevelChoice, LevelCollider: shapes without a GreatLand
// Read this file first, then AgentRays for a ray, or AgentMotions for a motion or a walk.
package starlogo.queries
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.collision.Collision;
    import starlogo.collision.QuerySource;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.queries.trees.Collector;
    import starlogo.queries.trees.RowTree;
    import starlogo.search.Body;
    import starlogo.search.NarrowPhase;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * The agents that questions see, for games that load only some kinds of questions: AgentPlaces (what is near), AgentRays (what a ray
     * meets), AgentMotions (how far something can go). All of them may share one SeenAgents. An AgentQueries has all questions, and agents of
     * its own.
     *
     * <listing version="3.0">
     * var seen:SeenAgents = new SeenAgents(collision);
     * var places:AgentPlaces = new AgentPlaces(seen);
     * // every frame
     * seen.update(agents);
     * var prey:Agent = places.nearest(agents[0], 20);
     * </listing>
     */
    public final class SeenAgents
    {
        /** @private The agents as rows. Questions only read them. */
        engine var table:AgentTable;

        /** @private The tests of their bodies. They belong to the collision system and have its settings. */
        engine var narrowPhase:NarrowPhase;

        /**
         * @private How many questions under way are calling a filter's <code>accepts</code>. It may ask questions itself, nested one deeper than the
         * question that calls it, but not change the agents. What a question needs after these calls is NestedPool. Only a Collector counts it.
         */
        engine var callbackDepth:int = 0;

        /** @private The heights of the rows in the last updates. */
        engine var heights:SeenHeights = new SeenHeights();

        private var _source:QuerySource;

        // Functions that add the tests which some questions need.
        private var _testAdders:Vector.<Function> = new Vector.<Function>();

        private var _terrain:Terrain = null;

        // Trees of the places and of the extents. Each is built when a question first needs it.
        private var _placeTree:RowTree = new RowTree();
        private var _extentTree:RowTree = new RowTree();
        private var _isUpdated:Boolean = false;

        // The body of an agent that has changed since the last update.
        private var _spare:Body = new Body();

        // What collects the rows of a question.
        private var _collectorPool:NestedPool;

        /**
         * Begins without agents, as an AgentQueries does.
         *
         * @param collisionOrShapes a Collision, one of the engine's collision systems, or a LevelShapes. It decides how agents are seen
         * @throws ArgumentError if it is none of these, or if the Collision's system is not one of the engine's
         */
        public function SeenAgents(collisionOrShapes:Object)
        {
            _source = collisionOrShapes as QuerySource;
            if (_source == null)
            {
                throw QuerySource.errorAbout(collisionOrShapes);
            }
            narrowPhase = _source.findNarrowPhase();
            table = new AgentTable(narrowPhase.shapeChoice);
            _collectorPool = new NestedPool(this, Collector);
        }

        /**
         * The ground that questions see after the next update; null for none. If the questions were made for a Collision, this is the
         * Collision's ground, and setting it changes the Collision.
         *
         * <p>The ground touches agents, blocks rays and stops motions as an agent does. Answers have its <code>agent</code>. If the ground
         * and an agent are equally far away, the agent comes first. In lists of agents that touch, the ground comes last. Questions about
         * near agents never find it. A filter can exclude it.</p>
         */
        public function get terrain():Terrain
        {
            var collision:Collision = _source.collisionOfGround;
            return collision == null ? _terrain : collision.terrain;
        }

        public function set terrain(value:Terrain):void
        {
            var collision:Collision = _source.collisionOfGround;
            if (collision == null)
            {
                _terrain = value;
            }
            else
            {
                collision.terrain = value;
            }
        }

        /**
         * Sets the agents that questions are about, and reads each of them as it is now.
         *
         * @param agents the list. You may change it afterwards; questions do not see the change
         * @throws ArgumentError if the list or an agent is null, if an agent is listed twice, if a model is unknown or lacks data that the
         *     collision system needs, or if a Collision's system is not one of the engine's. Questions are then still about the old agents
         * @throws RangeError if a structure is out of the world. Questions are then still about the old agents
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function update(agents:Vector.<Agent>):void
        {
            requireGiven("agents", agents);
            requireOutsideFilter("update");
            var newNarrowPhase:NarrowPhase = _source.findNarrowPhase();
            var isOtherNarrowPhase:Boolean = newNarrowPhase !== narrowPhase;
            // another table has the same rows
            var next:AgentTable = isOtherNarrowPhase ? new AgentTable(newNarrowPhase.shapeChoice, table.listed) : table;
            next.read(agents);
            next.environment.read(terrain == null ? null : terrain.environmentAgent, null);
            table = next;
            heights.read(table);
            narrowPhase = newNarrowPhase;
            if (isOtherNarrowPhase)
            {
                for (var i:int = 0; i < _testAdders.length; i++)
                {
                    _testAdders[i](newNarrowPhase);
                }
            }
            _placeTree.makeStale();
            _extentTree.makeStale();
            _isUpdated = true;
        }

        /**
         * Reads one agent again, as it is now.
         *
         * @param agent an agent of the last update's list
         * @throws ArgumentError if it is null or not in that list, or if its model is unknown or lacks data that the collision system needs.
         *     Questions then see it as before
         * @throws RangeError if its structure is out of the world. Questions then see it as before
         * @throws flash.errors.IllegalOperationError if called from a filter's <code>accepts</code>
         */
        public function refresh(agent:Agent):void
        {
            requireOutsideFilter("refresh");
            var row:int = rowOf(agent);
            if (row < ListedAgents.FIRST_LISTED)
            {
                throw new ArgumentError(agent + " is not in the list of the last update");
            }
            table.readRow(row);
            _placeTree.enlargeAround(row, table.places, null);
            _extentTree.enlargeAround(row, table.extents, table.extents);
        }

        /**
         * @private Adds tests that questions need and their collision system may lack: now, and when they see with another one.
         *
         * @param addTo <code>function(narrowPhase:NarrowPhase):void</code>
         */
        engine function needTests(addTo:Function):void
        {
            if (_testAdders.indexOf(addTo) < 0)
            {
                _testAdders.push(addTo);
                addTo(narrowPhase);
            }
        }

        /** @private Begins the search of a question, and returns what collects its rows: see Collector.begin. */
        engine function beginCollecting(maxCount:int, limit:Number, asker:Agent, filter:AgentFilter):Collector
        {
            var collector:Collector = Collector(_collectorPool.current);
            return collector.begin(maxCount, limit, asker, filter);
        }

        /** @private Throws an error if a filter's <code>accepts</code> is being called and the agent is in the list. */
        engine function requireMovable(agent:Agent, what:String):void
        {
            if (agent != null && table.listed.rowOf(agent) >= ListedAgents.FIRST_LISTED)
            {
                requireOutsideFilter(what);
            }
        }

        /** @private The row of an agent; -1 if it is not in the list. */
        engine function rowOf(agent:Agent):int
        {
            requireGiven("agent", agent);
            return table.listed.rowOf(agent);
        }

        /** @private Throws an ArgumentError if an agent is null, or has no place because it is the ground's or the edges'. */
        engine function requirePlaced(agent:Agent):void
        {
            requireGiven("agent", agent);
            if (agent.isEnvironment)
            {
                throw new ArgumentError(agent + " has no place, and does not move: it stands for the ground or the edges of the world");
            }
        }

        /**
         * @private The body of an agent as it is now. Its shape is null while the agent's model is loading. Do not change it.
         *
         * @param spare becomes this body if the agent has changed since the last update. If it is null, the body is valid until the next call
         * @throws ArgumentError if the agent is null, or its model is unknown or lacks data that is needed
         */
        engine function currentBodyOf(agent:Agent, spare:Body = null):Body
        {
            requireGiven("agent", agent);
            return table.currentBodyOf(agent, spare || _spare);
        }

        /**
         * @private Moves an agent, turns it by some degrees, and reads it again.
         *
         * @throws ArgumentError if the filter's accepts has removed the agent's model. The agent has then not moved
         */
        engine function moveAgent(agent:Agent, at:Vector3D, turn:Number = 0):void
        {
            // refuses an agent whose model is gone, before it moves
            currentBodyOf(agent);
            agent.moveTo(at.x, at.y, at.z);
            if (turn != 0)
            {
                agent.heading += turn;
            }
            if (rowOf(agent) >= 0)
            {
                refresh(agent);
            }
        }

        /** @private Returns the tree of the places, and builds it first if it is stale. Throws an error before the first update. */
        engine function treeOfPlaces():RowTree
        {
            return prepare(_placeTree, table.places, null);
        }

        /**
         * @private Returns the tree of the extents, and builds it first if it is stale. The row of the ground is as the ground is now. Throws
         *     an error before the first update. While a model is loading, its extents mean nothing.
         */
        engine function treeOfExtents():RowTree
        {
            table.environment.refresh();
            return prepare(_extentTree, table.extents, table.extents);
        }

        private function prepare(tree:RowTree, points:Points, sizes:Extents):RowTree
        {
            if (!_isUpdated)
            {
                throw new IllegalOperationError("nothing to ask about yet: call update(agents) of this AgentQueries or SeenAgents, or update() of the "
                        + "DetectionBlocks, before the first question, and then once a frame. That of the Collision does not count");
            }
            if (tree.isStale)
            {
                tree.build(table.listed.rows.values, table.listed.rows.count, points, sizes);
            }
            if (callbackDepth == 0)
            {
                // the set of breeds of a question under way may lack a breed that its accepts has made
                tree.learnBreeds(table.listed.agentsByRow);
            }
            return tree;
        }

        private function requireOutsideFilter(what:String):void
        {
            if (callbackDepth > 0)
            {
                throw new IllegalOperationError(what + " must not be called from a filter's accepts");
            }
        }
    }
}
