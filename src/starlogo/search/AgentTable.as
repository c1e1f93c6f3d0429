package starlogo.search
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.broadphase.Bins;
    import starlogo.engine;
    import starlogo.geometry.Placement;

    use namespace engine;

    /**
     * The table in which a collider stores its agents: a row for each agent, and a column of numbers for each property. RowList says which agent
     * has which row. It has columns because with thousands of agents reading memory takes most of the time.
     *
     * <p>A row stays as the last search has read it, even if the agent has changed since: its place, its rotation and its shape. docs/state.md
     * lists the changes that make a part of a row void. The rows of guests are for agents that a question has to see as they are now.</p>
     *
     * @private
     */
    public final class AgentTable extends ShapedRows
    {
        // In place of a number of changed rows: the rows belong to other agents.
        private static const OTHERS:int = -1;

        // The rows of the agents, in the order of the list.
        engine var rows:Vector.<int>;

        /** See RowList.ranks. */
        public var ranks:Vector.<int>;

        // By row: the agent's place in the search before the last one.
        internal var lastX:Vector.<Number> = new Vector.<Number>();
        internal var lastY:Vector.<Number> = new Vector.<Number>();
        internal var lastZ:Vector.<Number> = new Vector.<Number>();

        private var _lastRevisions:Vector.<int> = new Vector.<int>();

        // By row: the place that is being read, and the agent's revision. They take effect only after the whole list has turned out to be valid.
        private var _nextX:Vector.<Number> = new Vector.<Number>();
        private var _nextY:Vector.<Number> = new Vector.<Number>();
        private var _nextZ:Vector.<Number> = new Vector.<Number>();
        private var _nextRevisions:Vector.<int> = new Vector.<int>();

        private var _list:RowList;
        private var _bins:Bins;

        // The number of the list after which rows were last freed.
        private var _freedList:int = 0;

        /**
         * @param shapes has the shape of each model
         * @param bins has the levels of extents; null if no levels are needed
         */
        public function AgentTable(shapes:ModelShapes, bins:Bins)
        {
            var list:RowList = new RowList();
            super(list.agents, shapes);
            _list = list;
            _bins = bins;
            rows = list.rows;
            ranks = list.ranks;
            makeRows();
        }

        /** The number of agents in the list; 0 after a list that was refused. */
        public function get count():int
        {
            return _list.count;
        }

        /** See RowList.isOf. */
        public function isListed(list:Vector.<Agent>):Boolean
        {
            return _list.isOf(list);
        }

        /** See RowList.rowOf. */
        public function rowOf(agent:Agent):int
        {
            if (!Breeds.isReserved(agent.breedNumber))
            {
                return _list.rowOf(agent);
            }
            var row:int = RowList.GROUND + agent.breedNumber;
            return agents[row] === agent ? row : -1;
        }

        /**
         * Reads a list of agents, with the place and the shape that each of them has now.
         *
         * @throws ArgumentError if an agent is null or listed twice, or its model is unknown or lacks data that is needed. The positions and
         *     motions of the last search are then unchanged
         */
        public function read(list:Vector.<Agent>):void
        {
            forgetReplaced();
            changedCount = count == list.length ? readPositions(list) : OTHERS;
            if (changedCount == OTHERS)
            {
                _list.read(list);
                addRows();
                changedCount = readPositions(list);
            }
            findShapes();
            takeShapes();
            takePositions();
            if (_freedList != _list.number)
            {
                freeRows();
                _freedList = _list.number;
            }
            moveAllExtents();
            fitChanged();
        }

        /**
         * Throws the errors that <code>read()</code> would throw, and changes nothing. So a list can be refused before anything is lost.
         *
         * @throws ArgumentError as read does
         */
        public function check(list:Vector.<Agent>):void
        {
            if (_list.isOf(list))
            {
                // read() finds all new shapes before it changes a row
                return;
            }
            forgetReplaced();
            _list.check(list);
            for (var i:int = 0; i < list.length; i++)
            {
                var row:int = rowOf(list[i]);
                if (row < 0 || needsShape(row))
                {
                    modelShapes.shapeOf(list[i]);
                }
            }
        }

        /**
         * Reads the agent of one row as it is now. The other rows stay as they are.
         *
         * @throws ArgumentError if its model is unknown or lacks data that is needed. The row is then unchanged
         */
        public function readRow(row:int):void
        {
            forgetReplaced();
            var agent:Agent = agents[row];
            changedCount = 0;
            if (agent.placement.extentsRevision != extentsRevisions[row])
            {
                changed[0] = row;
                changedCount = 1;
                findShapes();
                takeShapes();
            }
            revisions[row] = agent.revision;
            x[row] = agent.placement.x;
            y[row] = agent.placement.y;
            z[row] = agent.placement.z;
            moveExtents(row);
        }

        /**
         * Reads an agent as it is now into a row that is no row of the list: of a guest, of the ground or of the edges of the world. The
         * agent's own row, if it has one, does not change. Call <code>endGuests()</code> after a question. The ground and the edges are read
         * before the list, and stay.
         *
         * @param guest the row: 0 or 1, RowList.GROUND or RowList.EDGES. Its shape is null while the agent's model is loading
         * @param agent the agent; null to empty the row
         * @param shape the shape; null for the shape of the agent's model
         * @throws ArgumentError as readRow does
         */
        public function readGuest(guest:int, agent:Agent, shape:ModelShape = null):void
        {
            if (agents[guest] !== agent || shape != null)
            {
                agents[guest] = agent;
                shapes[guest] = null;
                extentsRevisions[guest] = STALE;
            }
            if (shape != null)
            {
                setShape(guest, shape);
            }
            if (agent != null)
            {
                readRow(guest);
            }
        }

        /** Lets go of the guests. */
        public function endGuests():void
        {
            agents[0] = agents[1] = null;
            shapes[0] = shapes[1] = null;
        }

        /**
         * Writes the place of each agent in the last search, and whether its motion begins there.
         *
         * @param list the list of the last search, or an empty list
         * @param keepsMotions false to write that no agent has a motion
         */
        public function writePositions(list:Vector.<Agent>, bytes:ByteArray, keepsMotions:Boolean):void
        {
            for (var i:int = 0; i < list.length; i++)
            {
                var row:int = rows[i];
                bytes.writeBoolean(keepsMotions && shapes[row] != null && agents[row].jumpRevision <= revisions[row]);
                bytes.writeDouble(x[row]);
                bytes.writeDouble(y[row]);
                bytes.writeDouble(z[row]);
            }
        }

        /**
         * Reads a list of agents as if the last search had seen them at the places that writePositions has written.
         *
         * @param bytes written for the same number of agents
         * @throws ArgumentError as <code>read()</code> does
         */
        public function restorePositions(list:Vector.<Agent>, bytes:ByteArray):void
        {
            read(list);
            for (var i:int = 0; i < count; i++)
            {
                var row:int = rows[i];
                var seen:int = bytes.readBoolean() ? revisions[row] : NOT_SEEN;
                var seenX:Number = bytes.readDouble();
                var seenY:Number = bytes.readDouble();
                var seenZ:Number = bytes.readDouble();
                if (x[row] != seenX || y[row] != seenY || z[row] != seenZ)
                {
                    // the agent has moved since. One more revision makes this a motion, even if the game has put the agent there by a jump
                    agents[row].revision++;
                    x[row] = seenX;
                    y[row] = seenY;
                    z[row] = seenZ;
                    moveExtents(row);
                }
                revisions[row] = seen;
                placedRevisions[row] = STALE;
            }
        }

        /** Lets no agent have a motion from its position in the last search. */
        public function forgetMotions():void
        {
            for (var row:int = 0; row < revisions.length; row++)
            {
                revisions[row] = NOT_SEEN;
                placedRevisions[row] = STALE;
            }
        }

        /** Whether the agent of a row has a motion between the last two searches: it was in both of them, and has not jumped. */
        public function hasMotion(row:int):Boolean
        {
            return agents[row].jumpRevision <= _lastRevisions[row];
        }

        // Lets the numbers that were read take effect. The oldest columns are used for the next reading.
        private function takePositions():void
        {
            var spare:Vector.<Number> = lastX;
            lastX = x;
            x = _nextX;
            _nextX = spare;
            spare = lastY;
            lastY = y;
            y = _nextY;
            _nextY = spare;
            spare = lastZ;
            lastZ = z;
            z = _nextZ;
            _nextZ = spare;
            var spareRevisions:Vector.<int> = _lastRevisions;
            _lastRevisions = revisions;
            revisions = _nextRevisions;
            _nextRevisions = spareRevisions;
            // the ground and the edges of the world were read before the list
            for (var row:int = 0; row < RowList.GUESTS; row++)
            {
                x[row] = lastX[row];
                y[row] = lastY[row];
                z[row] = lastZ[row];
                revisions[row] = _lastRevisions[row];
            }
        }

        // Reads the places of the agents, and lists the rows with changes in more than the place. Returns the number of these rows, or OTHERS if
        // the rows do not belong to the agents.
        private function readPositions(list:Vector.<Agent>):int
        {
            var listed:Vector.<Agent> = agents;
            var listedRows:Vector.<int> = rows;
            var knownRevisions:Vector.<int> = extentsRevisions;
            var read:Vector.<int> = _nextRevisions;
            var readX:Vector.<Number> = _nextX;
            var readY:Vector.<Number> = _nextY;
            var readZ:Vector.<Number> = _nextZ;
            var end:int = count;
            var found:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = listedRows[i];
                var agent:Agent = list[i];
                if (listed[row] !== agent)
                {
                    return OTHERS;
                }
                var placement:Placement = agent.placement;
                if (placement.extentsRevision != knownRevisions[row])
                {
                    changed[found] = row;
                    found++;
                }
                read[row] = agent.revision;
                readX[row] = placement.x;
                readY[row] = placement.y;
                readZ[row] = placement.z;
            }
            return found;
        }

        private function moveAllExtents():void
        {
            var listedRows:Vector.<int> = rows;
            var xs:Vector.<Number> = x;
            var ys:Vector.<Number> = y;
            var zs:Vector.<Number> = z;
            var fromX:Vector.<Number> = offsetX;
            var fromY:Vector.<Number> = offsetY;
            var fromZ:Vector.<Number> = offsetZ;
            var middleX:Vector.<Number> = extents.x;
            var middleY:Vector.<Number> = extents.y;
            var middleZ:Vector.<Number> = extents.z;
            var reachSquared:Number = _bins == null ? Infinity : _bins.levels.reachSquared;
            var end:int = count;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = listedRows[i];
                var atX:Number = xs[row] + fromX[row];
                var atY:Number = ys[row] + fromY[row];
                var atZ:Number = zs[row] + fromZ[row];
                middleX[row] = atX;
                middleY[row] = atY;
                middleZ[row] = atZ;
                if (atX * atX + atY * atY + atZ * atZ >= reachSquared)
                {
                    fit(row);
                }
            }
        }

        // Finds the levels of rows whose extents have changed.
        private function fitChanged():void
        {
            for (var i:int = 0; i < changedCount; i++)
            {
                fit(changed[i]);
            }
        }

        private function fit(row:int):void
        {
            if (_bins != null && shapes[row] != null && _bins.levels.fit(extents, row))
            {
                // the row needs a finer level when its agent comes back, so every search computes its extents until then
                extentsRevisions[row] = STALE;
            }
        }

        private function addRows():void
        {
            makeRows();
            for (var i:int = 0; i < _list.addedCount; i++)
            {
                var row:int = _list.added[i];
                extentsRevisions[row] = STALE;
            }
        }

        private function freeRows():void
        {
            var first:int = _list.freeCount;
            _list.freeOthers();
            for (var i:int = first; i < _list.freeCount; i++)
            {
                shapes[_list.free[i]] = null;
            }
        }

        override protected function makeRows():void
        {
            super.makeRows();
            var length:int = agents.length;
            if (length > lastX.length)
            {
                lastX.length = lastY.length = lastZ.length = _nextX.length = _nextY.length = _nextZ.length = length;
                _lastRevisions.length = _nextRevisions.length = length;
            }
        }
    }
}
