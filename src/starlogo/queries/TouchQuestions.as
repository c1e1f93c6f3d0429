package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.geometry.Placement;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.search.AgentTable;
    import starlogo.search.MovedRow;
    import starlogo.search.RowList;
    import starlogo.terrain.WorldBounds;

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
        private var _structure:AskedStructure = null;
        private var _moved:MovedRow = new MovedRow();
        private var _place:Vector3D = new Vector3D();

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
            findTouching(agent, filter, mostFor(filter));
            return isAnyAccepted(filter);
        }

        /** See AgentQueries.overlapsAgent. */
        public function overlapsAgent(agent:Agent, x:Number, y:Number, z:Number, filter:AgentFilter):Boolean
        {
            var table:AgentTable = _seen.table;
            var row:int = beginRow(agent, filter, mostFor(filter));
            if (table.shapes[row] != null)
            {
                _moved.take(table, row);
                _place.setTo(x, y, z);
                _moved.put(_place, 0);
                collectNear(row, x, y, z);
                _moved.giveBack();
            }
            table.endGuests();
            return isAnyAccepted(filter);
        }

        /** See AgentQueries.overlapping. */
        public function overlapping(structure:BoundingStructure, filter:AgentFilter, out:Vector.<Agent>):Vector.<Agent>
        {
            var table:AgentTable = _seen.table;
            _structure ||= new AskedStructure();
            _structure.setTo(structure);
            _found.begin(FoundRows.ALL, Infinity, -1, filter);
            var row:int = _structure.readInto(table);
            collectNear(row, table.x[row], table.y[row], table.z[row]);
            table.endGuests();
            return _found.list(out);
        }

        /** See AgentQueries.touchesEdge. */
        public function touchesEdge(agent:Agent, bounds:WorldBounds):Boolean
        {
            if (bounds == null)
            {
                throw new ArgumentError("bounds must not be null");
            }
            var table:AgentTable = _seen.table;
            var row:int = _seen.rowOfNow(agent);
            table.readGuest(1, bounds.agent);
            var touches:Boolean = table.shapes[row] != null && _seen.pairs.areTouching(table, row, 1);
            table.endGuests();
            return touches;
        }

        private function findTouching(agent:Agent, filter:AgentFilter, most:int):void
        {
            var row:int = beginRow(agent, filter, most);
            if (_seen.table.shapes[row] != null)
            {
                var at:Placement = agent.placement;
                collectNear(row, at.x, at.y, at.z);
            }
            _seen.table.endGuests();
        }

        private function beginRow(agent:Agent, filter:AgentFilter, most:int):int
        {
            var row:int = _seen.rowOfNow(agent);
            _found.begin(most, Infinity, row < RowList.GUESTS ? _seen.rowOf(agent) : row, filter);
            return row;
        }

        // How many rows must be found to know whether there is one. If accepts has to be called, all must be found.
        private static function mostFor(filter:AgentFilter):int
        {
            return filter == null || filter.accepts == null ? 1 : FoundRows.ALL;
        }

        private function isAnyAccepted(filter:AgentFilter):Boolean
        {
            if (filter == null || filter.accepts == null)
            {
                return _found.count > 0;
            }
            _found.sort();
            return _found.keepAccepted(0, 1).length > 0;
        }

        // Collects the rows that count and touch a row. Each gets its distance from a place.
        private function collectNear(row:int, x:Number, y:Number, z:Number):void
        {
            var table:AgentTable = _seen.table;
            var found:FoundRows = _found;
            _seen.beginWay(_search, row);
            for (var other:int = _search.next(); other >= 0 && found.count < found.most; other = _search.next())
            {
                if (table.shapes[other] != null && found.wants(other) && _seen.pairs.areTouching(table, row, other))
                {
                    var toX:Number = table.x[other] - x;
                    var toY:Number = table.y[other] - y;
                    var toZ:Number = table.z[other] - z;
                    // the ground has no place, so it comes last
                    found.add(other, other == RowList.GROUND ? Infinity : toX * toX + toY * toY + toZ * toZ);
                }
            }
        }
    }
}
