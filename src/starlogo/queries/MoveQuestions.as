package starlogo.queries
{
    import flash.geom.Vector3D;
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
        /** The motion of the next question. It is a field because V8 makes an object for each Number that is passed. */
        public var way:Vector3D = new Vector3D();

        private var _seen:SeenAgents;
        private var _mover:Mover = null;

        // The rows near the way, all with the distance 0; and their agents, without those that accepts refuses.
        private var _search:WaySearch = new WaySearch();
        private var _found:FoundRows;
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        /** @param seen the agents that questions are about */
        public function MoveQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new FoundRows(seen);
        }

        /**
         * Moves an agent by the motion that was set. See AgentQueries.moveUntilTouch and AgentQueries.slide.
         *
         * @param contact receives the contact; or null
         * @param slides whether the agent slides along what it meets
         * @return the free part of the motion
         */
        public function move(agent:Agent, filter:AgentFilter, contact:Contact, slides:Boolean):Number
        {
            var dx:Number = way.x;
            var dy:Number = way.y;
            var dz:Number = way.z;
            if (!isFinite(dx) || !isFinite(dy) || !isFinite(dz))
            {
                throw new RangeError("a motion must be finite: (" + dx + ", " + dy + ", " + dz + ")");
            }
            findNear(agent, filter, slides);
            // the filter may have asked of motions too
            way.setTo(dx, dy, dz);
            if (_mover == null || _mover.pairs !== _seen.pairs)
            {
                _mover = new Mover(_seen.pairs);
            }
            var table:AgentTable = _seen.table;
            var row:int = _seen.rowOfNow(agent);
            var isSeen:Boolean = table.shapes[row] != null;
            if (isSeen)
            {
                _mover.move(table, row, _agents, way, slides);
            }
            table.endGuests();
            if (contact != null && isSeen)
            {
                _mover.writeContact(contact);
            }
            if (dx == 0 && dy == 0 && dz == 0)
            {
                return 1;
            }
            if (isSeen)
            {
                if (_mover.at.x != agent.x || _mover.at.y != agent.y || _mover.at.z != agent.z)
                {
                    agent.moveTo(_mover.at.x, _mover.at.y, _mover.at.z);
                }
            }
            else
            {
                agent.moveTo(agent.x + dx, agent.y + dy, agent.z + dz);
            }
            if (table.rowOf(agent) >= 0)
            {
                _seen.moved(agent);
            }
            return isSeen ? _mover.part : 1;
        }

        // The agents that count and whose extents are near the way; where it may go anywhere, near where it may end.
        private function findNear(agent:Agent, filter:AgentFilter, isAnywhere:Boolean):void
        {
            var row:int = _seen.rowOfNow(agent);
            var table:AgentTable = _seen.table;
            _found.begin(FoundRows.ALL, Infinity, _seen.rowOf(agent), filter);
            if (table.shapes[row] != null)
            {
                _seen.beginWay(_search, row);
                if (isAnywhere)
                {
                    _search.widen(way.length);
                }
                else
                {
                    _search.moveAlong(way.x, way.y, way.z, 1);
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
            _found.list(_agents);
        }
    }
}
