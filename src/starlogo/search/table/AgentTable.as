// This folder reads the agents of a list into rows. Read this file first, then ListedAgents. readBodies() reads the agents' bodies, readPlaces() their
// places. EnvironmentRows reads the ground and the edges of the world.
package starlogo.search.table
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.EnvironmentAgent;

    use namespace engine;

    /**
     * The table in which a collider stores its agents: a row for each agent, and a column of numbers for each property. ListedAgents says which
     * agent has which row. The table has columns because with thousands of agents reading memory takes most of the time. Each row has a body for
     * tests.
     *
     * <p>A row stays as the last search has read it, even if the agent has changed since: its place, its rotation and its shape. docs/state.md
     * lists the changes that make a part of a row stale.</p>
     *
     * @private
     */
    public final class AgentTable
    {
        // In place of the revision at which a row was read: no search has seen the agent with its model, so no motion begins at its place. It is less
        // than the revision of any jump.
        private static const UNSEEN:int = -1;

        /** The list that was read last, and the row of each agent. */
        public var listed:ListedAgents;

        /** By row: the number of the agent's breed. */
        engine var breeds:Vector.<int> = new Vector.<int>();

        /** By row: the shape of the agent's model. It is null while the model is loading, and for a row without an agent or with a new one. */
        engine var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        /** By row: where the last search saw the agent. */
        engine var places:Points = new Points();

        /** By row: the agent's revision at which the row was read, or UNSEEN. */
        engine var revisions:Vector.<int> = new Vector.<int>();

        /** By row: the extents of the row's body at that place, copied for the bins. */
        engine var extents:Extents = new Extents();

        /** The number of rows read last whose models are still loading. */
        engine var loadingCount:int = 0;

        /** What the last list has changed. */
        engine var changes:ListChanges = new ListChanges();

        /** The rows of the ground and the edges of the world. */
        engine var environment:EnvironmentRows;

        // Chooses the shapes of the agents. It may have other tables too.
        private var _choice:BaseShapeChoice;

        // Whether the places are those of a snapshot. All rows are read with the next list then.
        private var _arePlacesRestored:Boolean = false;

        // By row: the body, and the agent's bodyRevision at which it was read.
        private var _bodies:Vector.<Body> = new Vector.<Body>();
        private var _bodyRevisions:Vector.<int> = new Vector.<int>();

        // The shapes that the agents whose bodies have changed (changes.reshaped) have now. A shape is null while its model is loading.
        private var _newShapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        /**
         * @param choice chooses the shapes
         * @param listed the list and the rows of a table that this one replaces; null to begin without agents
         */
        public function AgentTable(choice:BaseShapeChoice, listed:ListedAgents = null)
        {
            _choice = choice;
            this.listed = listed || new ListedAgents();
            environment = new EnvironmentRows(this);
            makeRoom();
        }

        /** Reads a list of agents, with the place and the shape that each of them has now. @throws Error as <code>readBodies()</code> does */
        public function read(agents:Vector.<Agent>):void
        {
            readBodies(agents);
            readPlaces();
        }

        /**
         * Takes a list of agents, and reads the bodies that have changed. From now on the rows of agents that have left are empty, and no motion begins
         * where an agent had another model. The places stay as the last search has read them, until <code>readPlaces()</code>: motions begin there.
         *
         * @throws ArgumentError if an agent is null or listed twice, or its model is unknown or lacks data that is needed. All rows that are
         *     listed are then unchanged
         * @throws RangeError if a structure is out of the world. All rows that are listed are then unchanged
         */
        public function readBodies(agents:Vector.<Agent>):void
        {
            _choice.forgetReplaced();
            listed.leftOrReordered.count = 0;
            var isOtherList:Boolean = agents.length != listed.rows.count || !tryFindChanges(agents, listed.rows, changes);
            if (isOtherList)
            {
                listed.propose(agents);
                makeRoom();
                tryFindChanges(agents, listed.proposed, changes);
            }
            findNewShapes(agents);
            // from here on nothing is refused
            if (isOtherList)
            {
                listed.accept(agents);
                emptyLeftRows();
            }
            writeNewShapes();
        }

        /** Reads the places and the breeds of the rows that have changed. Throws nothing. */
        public function readPlaces():void
        {
            for (var i:int = 0; i < changes.rows.count; i++)
            {
                var row:int = changes.rows.values[i];
                var agent:Agent = listed.agentsByRow[row];
                breeds[row] = agent.breedNumber;
                writePlace(row, agent);
                extents.assignLevel(row);
            }
            _arePlacesRestored = false;
        }

        /**
         * Reads the agent of one row as it is now, except for its breed. Call it in a table without searches, where motions mean nothing.
         *
         * @throws ArgumentError if its model is unknown or lacks data that is needed. The row is then unchanged
         * @throws RangeError if its structure is out of the world. The row is then unchanged
         */
        public function readRow(row:int):void
        {
            _choice.forgetReplaced();
            var agent:Agent = listed.agentsByRow[row];
            if (!isBodyCurrent(row))
            {
                writeShape(row, _choice.shapeOf(agent));
            }
            writePlace(row, agent);
        }

        /**
         * Writes the place of a row that was just read, as if the last search had seen the agent there. Call it for all rows.
         *
         * @param hasMotion whether the agent's next motion begins there
         */
        public function writeLastPlace(row:int, x:Number, y:Number, z:Number, hasMotion:Boolean):void
        {
            places.x[row] = x;
            places.y[row] = y;
            places.z[row] = z;
            if (!hasMotion)
            {
                revisions[row] = UNSEEN;
            }
            _arePlacesRestored = true;
        }

        /** Whether a motion of a row's agent may begin at its place: the last search has seen the agent there, and it has not jumped since. */
        public function isMotionStart(row:int):Boolean
        {
            return listed.agentsByRow[row].jumpRevision <= revisions[row];
        }

        /** Lets no motion of any agent begin at its place, as if the last search had not seen it. */
        public function forgetMotionStarts():void
        {
            for (var row:int = ListedAgents.FIRST_LISTED; row < revisions.length; row++)
            {
                revisions[row] = UNSEEN;
            }
        }

        /**
         * The body of an agent as it is now. Its shape is null while the agent's model is loading.
         *
         * @param spare becomes this body if the agent has changed since it was read, or has no row. Otherwise the body is that of its row
         */
        public function currentBodyOf(agent:Agent, spare:Body):Body
        {
            _choice.forgetReplaced();
            var row:int = listed.rowOf(agent);
            if (isSeen(row) && agent.revision == revisions[row] && isBodyCurrent(row))
            {
                return bodyOf(row);
            }
            var environmentAgent:EnvironmentAgent = agent as EnvironmentAgent;
            spare.setToAgent(agent, environmentAgent == null ? _choice.shapeOf(agent) : environmentAgent.requireSurface());
            spare.orderKey = listed.orderKeyOf(agent, row);
            return spare;
        }

        /** Whether the last search has seen the agent of a row, as the row has it. Pass the answer of <code>ListedAgents.rowOf()</code>. */
        public function isSeen(row:int):Boolean
        {
            return row >= 0 && shapes[row] != null && revisions[row] != UNSEEN && !_arePlacesRestored;
        }

        /** Gives the body of a row that is seen the extents of its model's present pose. */
        public function followPose(row:int):void
        {
            _choice.forgetReplaced();
            if (shapes[row].isStale)
            {
                _bodies[row].followPose();
            }
        }

        /**
         * The body of a row whose model is not loading, as the last search has read it. Only here it moves to the row's place, because most bodies of a
         * frame are not tested.
         */
        public function bodyOf(row:int):Body
        {
            var body:Body = _bodies[row];
            body.orderKey = listed.listIndices[row];
            body.moveToRow(row, places);
            return body;
        }

        // Whether a row's body is as its agent is now, except for the place.
        private function isBodyCurrent(row:int):Boolean
        {
            return shapes[row] != null && !shapes[row].isStale && listed.agentsByRow[row].bodyRevision == _bodyRevisions[row];
        }

        // Finds what has changed since the last search. Returns false if a row has another agent. It compares them in the same loop, because a second one
        // makes still frames slower.
        private function tryFindChanges(agents:Vector.<Agent>, rowList:IntList, out:ListChanges):Boolean
        {
            var rows:Vector.<int> = rowList.values;
            var byRow:Vector.<Agent> = listed.agentsByRow;
            var seen:Vector.<int> = revisions;
            var bodiesSeen:Vector.<int> = _bodyRevisions;
            var shapesSeen:Vector.<ModelShape> = shapes;
            var end:int = agents.length;
            var readsAll:Boolean = _arePlacesRestored;
            var isSweeping:Boolean = false;
            out.rows.count = out.reshaped.count = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = rows[i];
                var agent:Agent = agents[i];
                // the row of a new agent is empty
                if (byRow[row] !== agent && byRow[row] != null)
                {
                    return false;
                }
                isSweeping = isSweeping || agent.isSweeping;
                // isBodyCurrent(), written out for the loop
                var isShapeStale:Boolean = shapesSeen[row] == null || shapesSeen[row].isStale;
                if (isShapeStale || readsAll || agent.revision != seen[row])
                {
                    if (isShapeStale || agent.bodyRevision != bodiesSeen[row])
                    {
                        out.reshaped.add(i);
                    }
                    out.rows.add(row);
                }
            }
            out.anySweeps = isSweeping;
            return true;
        }

        // Empties the rows of agents that have left. So a new agent finds an empty row.
        private function emptyLeftRows():void
        {
            var left:IntList = listed.leftOrReordered;
            for (var i:int = 0; i < left.count; i++)
            {
                var row:int = left.values[i];
                if (listed.agentsByRow[row] == null)
                {
                    shapes[row] = null;
                    extents.levelIndices[row] = 0;
                }
            }
        }

        // Makes room for the rows of the list.
        private function makeRoom():void
        {
            var row:int = shapes.length;
            var length:int = listed.rowCapacity;
            if (length == row)
            {
                return;
            }
            shapes.length = _bodies.length = length;
            breeds.length = revisions.length = _bodyRevisions.length = length;
            places.grow(length);
            extents.grow(length);
            for (; row < length; row++)
            {
                _bodies[row] = new Body();
            }
        }

        // Finds the shapes of the agents whose bodies have changed. One may be refused.
        private function findNewShapes(agents:Vector.<Agent>):void
        {
            for (var i:int = 0; i < changes.reshaped.count; i++)
            {
                _newShapes[i] = _choice.shapeOf(agents[changes.reshaped.values[i]]);
            }
        }

        // Writes the place of one agent as it is now.
        private function writePlace(row:int, agent:Agent):void
        {
            revisions[row] = agent.revision;
            places.x[row] = agent.placement.x;
            places.y[row] = agent.placement.y;
            places.z[row] = agent.placement.z;
            extents.follow(places, row);
        }

        // Copies the extents of a row's body, which has another shape, turn or size than before.
        private function writeExtents(row:int, body:Body):void
        {
            extents.offsets.x[row] = body.offsetX;
            extents.offsets.y[row] = body.offsetY;
            extents.offsets.z[row] = body.offsetZ;
            extents.halfX[row] = body.halfX;
            extents.halfY[row] = body.halfY;
            extents.halfZ[row] = body.halfZ;
            extents.radiusXY[row] = body.radiusXY;
            extents.follow(places, row);
            extents.assignLevel(row);
        }

        // Gives rows their new shapes, and reads their bodies. No motion begins where a row had the shape of another model, or none. Rows whose models are
        // loading are read again in every search.
        private function writeNewShapes():void
        {
            loadingCount = 0;
            for (var i:int = 0; i < changes.reshaped.count; i++)
            {
                var row:int = listed.rows.values[changes.reshaped.values[i]];
                var before:ModelShape = shapes[row];
                var next:ModelShape = _newShapes[i];
                // a replaced model must not be kept
                _newShapes[i] = null;
                if (before == null || next == null || next.modelName != before.modelName)
                {
                    revisions[row] = UNSEEN;
                }
                loadingCount += int(next == null);
                writeShape(row, next);
            }
        }

        /** Gives a row its shape, and reads the body with it, and the extents of the body. The shape is null while the model is loading. */
        internal function writeShape(row:int, shape:ModelShape):void
        {
            shapes[row] = shape;
            if (shape == null)
            {
                return;
            }
            var agent:Agent = listed.agentsByRow[row];
            var body:Body = _bodies[row];
            body.setToAgent(agent, shape);
            writeExtents(row, body);
            _bodyRevisions[row] = agent.bodyRevision;
        }
    }
}
