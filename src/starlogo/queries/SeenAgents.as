package starlogo.queries
{
    import flash.errors.IllegalOperationError;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.search.AgentTable;
    import starlogo.search.ModelShapes;
    import starlogo.search.ShapeStrategy;

    use namespace engine;

    /**
     * What questions see of the agents of a list, as a collision system sees them: a table of their own, with trees of the places and of the
     * extents, which are made when a question first needs them.
     *
     * <p>Within questions agents are numbers of the list, called members: <code>table.rows</code> has their rows.</p>
     *
     * @private
     */
    public final class SeenAgents
    {
        // After so many moves for each agent the trees are made anew: their boxes have grown.
        private static const MOVES:Number = 0.5;

        /** The agents; read-only for questions. */
        public var table:AgentTable;

        /** Says how rows look and which touch: the collision system's own, with its settings. */
        public var strategy:ShapeStrategy;

        /** Counts the lists and the moves: while it stays, all is as it was. */
        public var revision:int = 0;

        /** Counts questions under way whose filters are being asked: the list may not change. */
        public var asking:int = 0;

        private var _source:Object;
        private var _system:Object;
        private var _places:PlaceTree = new PlaceTree();
        private var _extents:ExtentsTree = new ExtentsTree();
        private var _placesAreStale:Boolean = true;
        private var _extentsAreStale:Boolean = true;
        private var _moves:int = 0;

        // By row: its number in the list of this number.
        private var _members:Vector.<int> = new Vector.<int>();
        private var _listNumber:int = -1;

        /**
         * @param source a Collision, or one of the engine's colliders
         * @throws ArgumentError if it is neither, or a Collision of another system
         */
        public function SeenAgents(source:Object)
        {
            _source = source;
            var collider:Collider = findCollider();
            strategy = collider.strategy;
            table = tableFor(collider);
            _system = collider;
        }

        /** How many agents there are. */
        public function get count():int
        {
            return table.count;
        }

        /** As AgentQueries.update. */
        public function update(agents:Vector.<Agent>):void
        {
            if (agents == null)
            {
                throw new ArgumentError("agents must not be null");
            }
            if (asking > 0)
            {
                throw new IllegalOperationError("update must not be called from a filter's accepts");
            }
            var collider:Collider = findCollider();
            var next:AgentTable = table;
            if (collider !== _system)
            {
                next = tableFor(collider);
            }
            next.check(agents);
            next.read(agents);
            if (next !== table || next.listNumber != _listNumber)
            {
                numberMembers(next);
            }
            table = next;
            strategy = collider.strategy;
            _system = collider;
            _placesAreStale = _extentsAreStale = true;
            revision++;
        }

        /** As AgentQueries.moved. */
        public function moved(agent:Agent):void
        {
            requireAgent(agent);
            var row:int = table.rowOf(agent);
            if (row < 0)
            {
                throw new ArgumentError(agent + " is not in the list of the last update");
            }
            table.readRow(row);
            revision++;
            _moves++;
            if (_placesAreStale || _moves > MOVES * count)
            {
                _placesAreStale = _extentsAreStale = true;
                return;
            }
            _places.x = table.x[row];
            _places.y = table.y[row];
            _places.z = table.z[row];
            _places.move(_members[row]);
            if (!_extentsAreStale)
            {
                _extents.move(_members[row]);
            }
        }

        /** The agent that has a number in the list. */
        public function agentOf(member:int):Agent
        {
            return table.agents[table.rows[member]];
        }

        /** The number in the list of an agent; -1 if it is not in it. */
        public function memberOf(agent:Agent):int
        {
            var row:int = table.rowOf(agent);
            return row < 0 ? -1 : _members[row];
        }

        /** The tree of the places, up to date. No row is skipped in it. */
        public function get places():PlaceTree
        {
            if (_placesAreStale)
            {
                _places.build(table.x, table.y, table.z, table.rows, table.count);
                _placesAreStale = false;
                _moves = 0;
            }
            _places.skipped = -1;
            return _places;
        }

        /** The tree of the places, for a question of an agent: about where it is now, without it. */
        public function placesAbout(asker:Agent):PlaceTree
        {
            requireAgent(asker);
            var tree:PlaceTree = places;
            var placement:Placement = asker.placement;
            tree.x = placement.x;
            tree.y = placement.y;
            tree.z = placement.z;
            tree.skipped = memberOf(asker);
            return tree;
        }

        /** The tree of the extents, up to date. */
        public function get extents():ExtentsTree
        {
            if (_extentsAreStale)
            {
                _extents.build(places, table);
                _extentsAreStale = false;
            }
            return _extents;
        }

        /**
         * A row of an agent as it is now: its own if that is so, else a guest's. Its shape is null while its model is loading.
         * <code>table.endGuests()</code> has to follow.
         *
         * @param guest the row for a guest, 0 or 1
         * @throws ArgumentError if its model is unknown, or what is needed of it was not loaded
         */
        public function rowOfNow(asker:Agent, guest:int = 0):int
        {
            requireAgent(asker);
            var row:int = table.rowOf(asker);
            if (row >= 0 && table.isOfNow(row))
            {
                return row;
            }
            table.readGuest(guest, asker);
            return guest;
        }

        private function numberMembers(of:AgentTable):void
        {
            for (var i:int = 0; i < of.count; i++)
            {
                var row:int = of.rows[i];
                if (row >= _members.length)
                {
                    _members.length = row + 1 + (row >> 3);
                }
                _members[row] = i;
            }
            _listNumber = of.listNumber;
        }

        private function findCollider():Collider
        {
            var collision:Collision = _source as Collision;
            var system:Object = collision == null ? _source : collision.collisionSystem;
            var collider:Collider = system as Collider;
            if (collider == null)
            {
                throw new ArgumentError("questions need a Collision or one of the engine's collision systems, which say what agents look like, not "
                        + system);
            }
            return collider;
        }

        private static function tableFor(collider:Collider):AgentTable
        {
            return new AgentTable(collider.strategy, new ModelShapes(collider.greatLand, collider.strategy), null);
        }

        private static function requireAgent(agent:Agent):void
        {
            if (agent == null)
            {
                throw new ArgumentError("an agent is needed, not null");
            }
        }
    }
}
