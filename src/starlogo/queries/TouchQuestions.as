package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * The questions about which agents touch an agent or a structure.
     *
     * @private
     */
    public final class TouchQuestions
    {
        private var _seen:SeenAgents;
        private var _rows:FilteredRows;
        private var _answers:Answers;
        private var _structure:AskedStructure = new AskedStructure();
        private var _found:Vector.<int> = new Vector.<int>();
        private var _squares:Vector.<Number> = new Vector.<Number>();

        /**
         * @param seen the agents that are asked about
         * @param rows applies filters to them
         * @param answers makes the lists
         */
        public function TouchQuestions(seen:SeenAgents, rows:FilteredRows, answers:Answers)
        {
            _seen = seen;
            _rows = rows;
            _answers = answers;
        }

        /** As AgentQueries.touching. */
        public function touching(agent:Agent, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            var row:int = _seen.rowOfNow(agent);
            var count:int = 0;
            if (_seen.table.shapes[row] != null)
            {
                count = findTouching(agent, row, _rows.of(filter));
            }
            _seen.table.endGuests();
            return _answers.list(_found, _squares, count, filter, out);
        }

        /** As AgentQueries.overlapping. */
        public function overlapping(structure:BoundingStructure, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            _structure.setTo(structure);
            var tree:ExtentsTree = _seen.extents;
            var places:PlaceTree = _seen.places;
            var test:RowTest = _rows.of(filter);
            var table:AgentTable = _seen.table;
            places.x = _structure.x;
            places.y = _structure.y;
            places.z = _structure.z;
            tree.setBoxTo(_structure.extents);
            var near:int = tree.findOverlapping();
            var count:int = 0;
            for (var i:int = 0; i < near; i++)
            {
                var member:int = tree.found[i];
                if ((test == null || test.accepts(member)) && _structure.touches(table, table.rows[member], _seen.strategy))
                {
                    _found[count] = member;
                    _squares[count] = places.squareOf(member);
                    count++;
                }
            }
            return _answers.list(_found, _squares, count, filter, out);
        }

        private function findTouching(agent:Agent, row:int, test:RowTest):int
        {
            var tree:ExtentsTree = _seen.extents;
            var places:PlaceTree = _seen.placesAbout(agent);
            var table:AgentTable = _seen.table;
            tree.setBox(row);
            var near:int = tree.findOverlapping();
            var count:int = 0;
            for (var i:int = 0; i < near; i++)
            {
                var member:int = tree.found[i];
                if (member == places.skipped || (test != null && !test.accepts(member)))
                {
                    continue;
                }
                var other:int = table.rows[member];
                if (_seen.strategy.areTouching(table, row, other))
                {
                    _found[count] = member;
                    _squares[count] = places.squareOf(member);
                    count++;
                }
            }
            return count;
        }
    }
}
