package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.AgentTable;
    import starlogo.search.RowList;

    use namespace engine;

    /**
     * Answers which agents touch an agent or a structure.
     *
     * @private
     */
    public final class TouchQuestions
    {
        private var _seen:SeenAgents;
        private var _search:WaySearch = new WaySearch();
        private var _found:FoundRows;
        private var _structure:AskedStructure = new AskedStructure();

        /** @param seen the agents that questions are about */
        public function TouchQuestions(seen:SeenAgents)
        {
            _seen = seen;
            _found = new FoundRows(seen);
        }

        /** See AgentQueries.touching. */
        public function touching(agent:Agent, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            findTouching(agent, filter, FoundRows.ALL);
            return _found.list(out);
        }

        /** See AgentQueries.touchesAny. */
        public function touchesAny(agent:Agent, filter:AgentFilter):Boolean
        {
            if (filter == null || filter.accepts == null)
            {
                findTouching(agent, filter, 1);
                return _found.count > 0;
            }
            findTouching(agent, filter, FoundRows.ALL);
            _found.sort();
            return _found.keepAccepted(0, 1).length > 0;
        }

        /** See AgentQueries.overlapping. */
        public function overlapping(structure:BoundingStructure, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            _structure.setTo(structure);
            var of:Vector.<Number> = _structure.extents;
            _found.begin(FoundRows.ALL, Infinity, -1, filter);
            _search.begin(_seen.findExtents(), of[0], of[1], of[2], of[3], of[4], of[5]);
            collect(-1, of[0], of[1], of[2]);
            return _found.list(out);
        }

        private function findTouching(agent:Agent, filter:AgentFilter, most:int):void
        {
            var row:int = _seen.rowOfNow(agent);
            _found.begin(most, Infinity, row < RowList.GUESTS ? _seen.rowOf(agent) : row, filter);
            if (_seen.table.shapes[row] != null)
            {
                _seen.beginWay(_search, row);
                collect(row, agent.placement.x, agent.placement.y, agent.placement.z);
            }
            _seen.table.endGuests();
        }

        // Takes the rows that count and touch a row, or the structure if it is -1, with their distances from a place.
        private function collect(row:int, x:Number, y:Number, z:Number):void
        {
            var table:AgentTable = _seen.table;
            var found:FoundRows = _found;
            for (var other:int = _search.next(); other >= 0 && found.count < found.most; other = _search.next())
            {
                if (table.shapes[other] == null || !found.wants(other))
                {
                    continue;
                }
                if (row < 0 ? _structure.touches(table, other, _seen.pairs.trees) : _seen.pairs.areTouching(table, row, other))
                {
                    var toX:Number = table.x[other] - x;
                    var toY:Number = table.y[other] - y;
                    var toZ:Number = table.z[other] - z;
                    found.add(other, toX * toX + toY * toY + toZ * toZ);
                }
            }
        }
    }
}
