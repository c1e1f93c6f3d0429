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
        private var _seen:SeenAgents;
        private var _rows:FilteredRows;
        private var _answers:Answers;
        private var _mover:Mover = null;

        // What is near the way: members, all with a squared distance of 0, and those that count as agents and as rows.
        private var _members:Vector.<int> = new Vector.<int>();
        private var _squares:Vector.<Number> = new Vector.<Number>();
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        /**
         * @param seen the agents that are asked about
         * @param rows applies filters to them
         * @param answers asks the rest of the filters
         */
        public function MoveQuestions(seen:SeenAgents, rows:FilteredRows, answers:Answers)
        {
            _seen = seen;
            _rows = rows;
            _answers = answers;
        }

        /** As AgentQueries.moveUntilTouch. */
        public function moveUntilTouch(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact):Number
        {
            return move(agent, dx, dy, dz, filter, contact, false);
        }

        /** As AgentQueries.slide. */
        public function slide(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter):Number
        {
            return move(agent, dx, dy, dz, filter, null, true);
        }

        private function move(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, contact:Contact, slides:Boolean):Number
        {
            if (!isFinite(dx) || !isFinite(dy) || !isFinite(dz))
            {
                throw new RangeError("a motion must be finite: (" + dx + ", " + dy + ", " + dz + ")");
            }
            findNear(agent, dx, dy, dz, filter, slides);
            if (_mover == null || _mover.strategy !== _seen.strategy)
            {
                _mover = new Mover(_seen.strategy);
            }
            var table:AgentTable = _seen.table;
            var row:int = _seen.rowOfNow(agent);
            var isSeen:Boolean = table.shapes[row] != null;
            var part:Number = 1;
            if (isSeen)
            {
                part = _mover.move(table, row, _agents, dx, dy, dz, slides);
            }
            _seen.endRowOfNow(agent, row);
            if (contact != null && isSeen)
            {
                _mover.writeContact(part, contact);
            }
            if (dx == 0 && dy == 0 && dz == 0)
            {
                return part;
            }
            if (isSeen)
            {
                agent.moveTo(_mover.x, _mover.y, _mover.z);
            }
            else
            {
                agent.moveTo(agent.x + dx, agent.y + dy, agent.z + dz);
            }
            if (table.rowOf(agent) >= 0)
            {
                _seen.moved(agent);
            }
            return part;
        }

        // The agents that count and whose extents are near the way; where it may go anywhere, near where it may end.
        private function findNear(agent:Agent, dx:Number, dy:Number, dz:Number, filter:AgentFilter, isAnywhere:Boolean):void
        {
            var row:int = _seen.rowOfNow(agent);
            var table:AgentTable = _seen.table;
            var count:int = 0;
            if (table.shapes[row] != null)
            {
                var tree:ExtentsTree = _seen.extents;
                var test:RowTest = _rows.of(filter);
                var own:int = _seen.memberOf(agent);
                tree.setBox(row);
                if (isAnywhere)
                {
                    var length:Number = Math.sqrt(dx * dx + dy * dy + dz * dz);
                    tree.extendBox(length, length, length);
                    tree.extendBox(-length, -length, -length);
                }
                else
                {
                    tree.extendBox(dx, dy, dz);
                }
                var near:int = tree.findOverlapping();
                for (var i:int = 0; i < near; i++)
                {
                    var member:int = tree.found[i];
                    if (member != own && (test == null || test.accepts(member)))
                    {
                        _members[count] = member;
                        _squares[count] = 0;
                        count++;
                    }
                }
            }
            _seen.endRowOfNow(agent, row);
            _answers.list(_members, _squares, count, filter, _agents);
        }
    }
}
