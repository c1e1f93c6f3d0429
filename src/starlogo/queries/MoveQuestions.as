package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * The questions of how far an agent can go, which move it there.
     *
     * @private
     */
    public final class MoveQuestions
    {
        /** How much of the last motion was free. */
        public var part:Number = 1;

        private var _seen:SeenAgents;
        private var _filters:FilteredRows;
        private var _answers:Answers;
        private var _mover:Mover = null;

        private var _dx:Number = 0;
        private var _dy:Number = 0;
        private var _dz:Number = 0;

        // What is near the way, with a squared distance of 0, and of these the agents that count.
        private var _search:WaySearch = new WaySearch();
        private var _found:FoundRows;
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        /**
         * @param seen the agents that are asked about
         * @param filters applies filters to them
         * @param answers asks the rest of the filters
         */
        public function MoveQuestions(seen:SeenAgents, filters:FilteredRows, answers:Answers)
        {
            _seen = seen;
            _filters = filters;
            _answers = answers;
            _found = new FoundRows(seen);
        }

        /** Sets the motion of the next question: an object would be made of each Number that is given to a longer function. */
        public function aim(dx:Number, dy:Number, dz:Number):void
        {
            _dx = dx;
            _dy = dy;
            _dz = dz;
        }

        /**
         * As AgentQueries.moveUntilTouch, or slide, with the motion that was set: <code>part</code>.
         *
         * @param contact takes how it touches; or null
         * @param slides whether it goes on along what it meets
         */
        public function move(agent:Agent, filter:AgentFilter, contact:Contact, slides:Boolean):void
        {
            var dx:Number = _dx;
            var dy:Number = _dy;
            var dz:Number = _dz;
            if (!isFinite(dx) || !isFinite(dy) || !isFinite(dz))
            {
                throw new RangeError("a motion must be finite: (" + dx + ", " + dy + ", " + dz + ")");
            }
            // the filter may ask of motions too
            findNear(agent, filter, slides);
            if (_mover == null || _mover.strategy !== _seen.strategy)
            {
                _mover = new Mover(_seen.strategy);
            }
            var table:AgentTable = _seen.table;
            var row:int = _seen.rowOfNow(agent);
            var isSeen:Boolean = table.shapes[row] != null;
            part = 1;
            if (isSeen)
            {
                _mover.aim(dx, dy, dz);
                _mover.move(table, row, _agents, slides);
                part = _mover.part;
            }
            table.endGuests();
            if (contact != null && isSeen)
            {
                _mover.writeContact(contact);
            }
            if (dx == 0 && dy == 0 && dz == 0)
            {
                return;
            }
            if (!isSeen)
            {
                _mover.x = agent.x + dx;
                _mover.y = agent.y + dy;
                _mover.z = agent.z + dz;
            }
            _mover.place(agent);
            if (table.rowOf(agent) >= 0)
            {
                _seen.moved(agent);
            }
        }

        // The agents that count and whose extents are near the way; where it may go anywhere, near where it may end.
        private function findNear(agent:Agent, filter:AgentFilter, isAnywhere:Boolean):void
        {
            var row:int = _seen.rowOfNow(agent);
            var table:AgentTable = _seen.table;
            _found.begin(FoundRows.ALL, Infinity, _seen.rowOf(agent), _filters.of(filter));
            if (table.shapes[row] != null)
            {
                _seen.beginWay(_search, row);
                if (isAnywhere)
                {
                    _search.widen(Math.sqrt(_dx * _dx + _dy * _dy + _dz * _dz));
                }
                else
                {
                    _search.moveAlong(_dx, _dy, _dz, 1);
                }
                for (var other:int = _search.next(); other >= 0; other = _search.next())
                {
                    if (_found.wants(other))
                    {
                        _found.add(other, 0);
                    }
                }
            }
            table.endGuests();
            _answers.list(_found, filter, _agents);
        }
    }
}
