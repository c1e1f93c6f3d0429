// This file is long because all that reads agents in every frame is in it, and its loops are written out.
package starlogo.search
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * What a collider sees of its agents: a row for each agent listed, in columns of numbers, because with thousands of agents memory
     * is what takes time. An agent keeps its row while it is listed; the same list has the same rows.
     *
     * <p>The first two rows are of no list: they are for guests, agents as they are now that a question is about.</p>
     *
     * <p>A row is as of the last search, however the agent has changed since: where the agent was, how it was turned, and what its shape was.
     * docs/state.md tells what voids it.</p>
     *
     * @private
     */
    public final class AgentTable
    {
        // In place of a revision: for an agent that has no motion, less than any jump's; and for what has to be computed again.
        private static const NOT_SEEN:int = -2;
        private static const STALE:int = -1;

        // In place of an agent's revision: for a row that is somewhere else for a while.
        private static const DISPLACED:int = -3;

        private static const ROTATION_SIZE:int = 9;

        // How many rows are for guests.
        private static const GUESTS:int = 2;

        // The rows of the agents, in the order of the list; how many there are, none after a list that was refused, and how many of them have a
        // model that is loading. The list's number counts its changes: while it stays, the rows are of the same agents.
        engine var rows:Vector.<int> = new Vector.<int>();
        engine var count:int = 0;
        engine var loadingCount:int = 0;
        engine var listNumber:int = 0;

        // By row: the agent, or null; the shape of its model, null while that is loading; its own limit to the
        // levels that are visited of its hierarchy, or 0; its extents in the world.
        engine var agents:Vector.<Agent> = new Vector.<Agent>();
        engine var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();
        internal var depths:Vector.<int> = new Vector.<int>();
        engine var extents:Extents = new Extents();

        // By row: where the agent is, and of which of its revisions that is; the same of the search before; a search that fails leaves there what
        // it has read.
        engine var x:Vector.<Number> = new Vector.<Number>();
        engine var y:Vector.<Number> = new Vector.<Number>();
        engine var z:Vector.<Number> = new Vector.<Number>();
        engine var revisions:Vector.<int> = new Vector.<int>();
        internal var lastX:Vector.<Number> = new Vector.<Number>();
        internal var lastY:Vector.<Number> = new Vector.<Number>();
        internal var lastZ:Vector.<Number> = new Vector.<Number>();
        private var _lastRevisions:Vector.<int> = new Vector.<int>();

        // By row: its structure in the world, for which revision it was placed, and what is tried before it, or null. Of these the boxes that
        // decide alone are listed a second time, typed, else null: that spares the most frequent costly test its casts.
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
        internal var placedRevisions:Vector.<int> = new Vector.<int>();
        internal var outer:Vector.<OuterStructures> = new Vector.<OuterStructures>();
        internal var boxes:Vector.<Box> = new Vector.<Box>();

        private var _strategy:ShapeStrategy;
        private var _shapes:ModelShapes;
        private var _bins:Bins;

        // By row: the agent's revisions that its extents and its shape are of.
        private var _extentsRevisions:Vector.<int> = new Vector.<int>();
        private var _shapeRevisions:Vector.<int> = new Vector.<int>();

        // By row: from the position to the middle of the extents, and how the agent was turned and scaled.
        private var _offsetX:Vector.<Number> = new Vector.<Number>();
        private var _offsetY:Vector.<Number> = new Vector.<Number>();
        private var _offsetZ:Vector.<Number> = new Vector.<Number>();
        private var _rotations:Vector.<Number> = new Vector.<Number>();
        private var _sizes:Vector.<Number> = new Vector.<Number>();

        /** The columns of what grows with a row: from the position to the middle of the extents, half of these, the radius around them, the size. */
        internal var sizing:Vector.<Vector.<Number>>;

        // By row: the number of the last list that had the agent.
        private var _lists:Vector.<int> = new Vector.<int>();

        // Rows below _rowCount are in use, or free.
        private var _rowsById:IdTable = new IdTable();
        private var _rowCount:int = GUESTS;
        private var _freeRows:Vector.<int> = new Vector.<int>();
        private var _freeCount:int = 0;

        // The list after which the rows of all others were freed.
        private var _freedList:int = 0;

        // Rows whose extents have to be computed again, and the new shapes of those whose shape has changed.
        private var _changed:Vector.<int> = new Vector.<int>();
        private var _changedShapes:Vector.<ModelShape> = new Vector.<ModelShape>();
        private var _changedCount:int = 0;

        // The middle, then half the lengths.
        private var _foundExtents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _scratch:Placement = new Placement();

        // Of a list that is checked: the agents' places in it.
        private var _checked:IdTable = new IdTable();

        /**
         * @param strategy finds the shapes of agents
         * @param shapes has the shape of each model
         * @param bins find the levels of extents; null if levels are not needed
         */
        public function AgentTable(strategy:ShapeStrategy, shapes:ModelShapes, bins:Bins)
        {
            _strategy = strategy;
            _shapes = shapes;
            _bins = bins;
            sizing = new <Vector.<Number>>[_offsetX, _offsetY, _offsetZ, extents.halfX, extents.halfY, extents.halfZ, extents.radius, _sizes];
            makeRows(GUESTS);
        }

        /**
         * Makes the rows those of a list of agents, where they are now, with the shape of each.
         *
         * @throws ArgumentError if an agent is null or listed twice, its model is unknown, or what is needed of it was not loaded; positions
         *     and motions are then still those of the last search
         */
        public function read(agents:Vector.<Agent>):void
        {
            forgetReplaced();
            if (count != agents.length || !readPositions(agents))
            {
                readList(agents);
                readPositions(agents);
            }
            findShapes();
            countLoading();
            if (_freedList != listNumber)
            {
                freeRows(false);
                _freedList = listNumber;
            }
            swapPositions();
        }

        /**
         * Throws what <code>read</code> would throw, and changes nothing, so that a list can be refused before anything is lost.
         *
         * @throws ArgumentError as read does
         */
        public function check(list:Vector.<Agent>):void
        {
            if (isListed(list))
            {
                // read() finds new shapes before it changes a row
                return;
            }
            forgetReplaced();
            _checked.clear();
            for (var i:int = 0; i < list.length; i++)
            {
                var agent:Agent = list[i];
                if (!(agent is Agent))
                {
                    throw isNoAgent(i, agent);
                }
                var before:int = _checked.valueOf(agent.number);
                if (before >= 0)
                {
                    throw listedTwice(agent, before, i);
                }
                _checked.set (agent.number, i);
                var row:int = rowOf(agent);
                if (row < 0 || needsShape(row))
                {
                    _shapes.shapeOf(agent);
                }
            }
        }

        /**
         * Makes one row as its agent is now; the others stay as they are.
         *
         * @throws ArgumentError if its model is unknown, or what is needed of it was not loaded; the row is then as it was
         */
        public function readRow(row:int):void
        {
            forgetReplaced();
            var agent:Agent = agents[row];
            _changedCount = 0;
            if (agent.placement.extentsRevision != _extentsRevisions[row])
            {
                _changed[0] = row;
                _changedCount = 1;
                findShapes();
            }
            revisions[row] = agent.revision;
            x[row] = agent.placement.x;
            y[row] = agent.placement.y;
            z[row] = agent.placement.z;
            moveExtents(row);
        }

        /** Whether a row is as its agent is now. */
        public function isOfNow(row:int):Boolean
        {
            return agents[row].revision == revisions[row] && shapes[row] != null;
        }

        /**
         * Makes the row of a guest that of an agent as it is now, beside the row that the agent may have. <code>endGuests()</code> has to follow.
         *
         * @param guest the row, 0 or 1; its shape is null while the agent's model is loading
         * @throws ArgumentError as readRow does
         */
        public function readGuest(guest:int, agent:Agent):void
        {
            agents[guest] = agent;
            // a question that threw may have left a shape
            shapes[guest] = null;
            _extentsRevisions[guest] = STALE;
            readRow(guest);
        }

        /** Lets go of the guests. */
        public function endGuests():void
        {
            agents[0] = agents[1] = null;
            shapes[0] = shapes[1] = null;
        }

        /** Makes a box along the world's axes that of a row's extents, wider by more than rounding comes to. */
        internal function readExtents(row:int, box:Box):void
        {
            var margin:Number = Tolerances.EXTENTS_GAPS * Tolerances.PLACES * (Math.abs(x[row]) + Math.abs(y[row]) + Math.abs(z[row]));
            box.center.x = extents.x[row];
            box.center.y = extents.y[row];
            box.center.z = extents.z[row];
            box.halfX = extents.halfX[row] * Tolerances.OUTER + margin;
            box.halfY = extents.halfY[row] * Tolerances.OUTER + margin;
            box.halfZ = extents.halfZ[row] * Tolerances.OUTER + margin;
        }

        /**
         * Writes where the last search saw its agents: of each whether it has a motion from there, and the place.
         *
         * @param keepsMotions false: none has
         * @return of each row, the place of its agent in the list
         */
        public function writePositions(bytes:ByteArray, keepsMotions:Boolean):Vector.<int>
        {
            var places:Vector.<int> = new Vector.<int>(agents.length);
            for (var i:int = 0; i < count; i++)
            {
                var row:int = rows[i];
                places[row] = i;
                bytes.writeBoolean(keepsMotions && shapes[row] != null && agents[row].jumpRevision <= revisions[row]);
                bytes.writeDouble(x[row]);
                bytes.writeDouble(y[row]);
                bytes.writeDouble(z[row]);
            }
            return places;
        }

        /**
         * Reads a list of agents as if the last search had seen them where bytes say.
         *
         * @param bytes what writePositions has written, of as many agents
         * @throws ArgumentError as <code>read()</code>
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
                    // it has moved since: in one step more, if the game has put it there by a jump
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

        /** The row of an agent that is listed, or -1. */
        public function rowOf(agent:Agent):int
        {
            return _rowsById.valueOf(agent.number);
        }

        /** Whether an agent has moved from where the search before saw it to where it is: it was in that search, and has not jumped. */
        public function hasMotion(row:int):Boolean
        {
            return agents[row].jumpRevision <= _lastRevisions[row];
        }

        /**
         * Where a row's agent was in the last search.
         *
         * @param scratch takes it if the agent has changed since
         * @return the agent's own placement, or scratch
         */
        public function placementOf(row:int, scratch:Placement):Placement
        {
            var agent:Agent = agents[row];
            if (agent.revision == revisions[row])
            {
                return agent.placement;
            }
            scratch.x = x[row];
            scratch.y = y[row];
            scratch.z = z[row];
            scratch.size = _sizes[row];
            if (shapes[row].structure != null)
            {
                scratch.readRotation(_rotations, ROTATION_SIZE * row);
            }
            return scratch;
        }

        /** The structure of a row in the world, wider by the margin within which shapes touch. */
        public function structureOf(row:int):BoundingStructure
        {
            if (placedRevisions[row] != revisions[row])
            {
                place(row);
            }
            return _placed[row];
        }

        /** A row is somewhere else, where x, y, z have been set to, so that questions can be asked about it there, until <code>putBack()</code>. */
        public function displace(row:int):void
        {
            putBack(row, DISPLACED);
        }

        /** A row is back where it was, where x, y, z have been set to, with the revision that it had. */
        public function putBack(row:int, revision:int):void
        {
            moveExtents(row);
            revisions[row] = revision;
            placedRevisions[row] = STALE;
        }

        /** Puts the structure of a row where its agent is. Not before a test asks for it: of thousands of agents few have others near them. */
        public function place(row:int):void
        {
            var shape:ModelShape = shapes[row];
            var placement:Placement = placementOf(row, _scratch);
            // its part of the gap
            var atX:Number = x[row];
            var atY:Number = y[row];
            var atZ:Number = z[row];
            atX = atX < 0 ? -atX : atX;
            atY = atY < 0 ? -atY : atY;
            atZ = atZ < 0 ? -atZ : atZ;
            var margin:Number = Tolerances.PLACES * (atX + atY + atZ);
            shape.structure.place(placement, _placed[row]);
            _placed[row].widen(margin);
            if (shape.outer != null)
            {
                outer[row] ||= new OuterStructures();
                outer[row].place(shape.outer, placement, margin);
            }
            placedRevisions[row] = revisions[row];
        }

        private function moveExtents(row:int):void
        {
            extents.x[row] = x[row] + _offsetX[row];
            extents.y[row] = y[row] + _offsetY[row];
            extents.z[row] = z[row] + _offsetZ[row];
        }

        // Reads where agents are, and notes which have changed in more than their positions: false if the rows are not theirs. The positions are
        // written beside those of the last search.
        private function readPositions(list:Vector.<Agent>):Boolean
        {
            var listed:Vector.<Agent> = agents;
            var listedRows:Vector.<int> = rows;
            var extentsRevisions:Vector.<int> = _extentsRevisions;
            var read:Vector.<int> = _lastRevisions;
            var readX:Vector.<Number> = lastX;
            var readY:Vector.<Number> = lastY;
            var readZ:Vector.<Number> = lastZ;
            var end:int = count;
            var changed:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = listedRows[i];
                var agent:Agent = list[i];
                if (listed[row] !== agent)
                {
                    return false;
                }
                var placement:Placement = agent.placement;
                if (placement.extentsRevision != extentsRevisions[row])
                {
                    _changed[changed] = row;
                    changed++;
                }
                read[row] = agent.revision;
                readX[row] = placement.x;
                readY[row] = placement.y;
                readZ[row] = placement.z;
            }
            _changedCount = changed;
            return true;
        }

        // What was read counts from now on.
        private function swapPositions():void
        {
            var readX:Vector.<Number> = lastX;
            var readY:Vector.<Number> = lastY;
            var readZ:Vector.<Number> = lastZ;
            var read:Vector.<int> = _lastRevisions;
            lastX = x;
            lastY = y;
            lastZ = z;
            _lastRevisions = revisions;
            x = readX;
            y = readY;
            z = readZ;
            revisions = read;
            var listedRows:Vector.<int> = rows;
            var offsetX:Vector.<Number> = _offsetX;
            var offsetY:Vector.<Number> = _offsetY;
            var offsetZ:Vector.<Number> = _offsetZ;
            var middleX:Vector.<Number> = extents.x;
            var middleY:Vector.<Number> = extents.y;
            var middleZ:Vector.<Number> = extents.z;
            var reachSquared:Number = _bins == null ? Infinity : _bins.reachSquared;
            var end:int = count;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = listedRows[i];
                var atX:Number = readX[row] + offsetX[row];
                var atY:Number = readY[row] + offsetY[row];
                var atZ:Number = readZ[row] + offsetZ[row];
                middleX[row] = atX;
                middleY[row] = atY;
                middleZ[row] = atZ;
                if (atX * atX + atY * atY + atZ * atZ >= reachSquared)
                {
                    fit(row);
                }
            }
            for (i = 0; i < _changedCount; i++)
            {
                fit(_changed[i]);
            }
        }

        private function fit(row:int):void
        {
            if (_bins != null && shapes[row] != null && _bins.fit(extents, row))
            {
                // it needs a finer level once it comes back: so its extents are computed in every search until then
                _extentsRevisions[row] = STALE;
            }
        }

        // Mostly agents have the rows that they had. A list that is refused leaves no row.
        private function readList(list:Vector.<Agent>):void
        {
            var known:int = count;
            count = 0;
            listNumber++;
            for (var i:int = 0; i < list.length; i++)
            {
                var agent:Agent = list[i];
                var row:int = i < known ? rows[i] : -1;
                if (row < 0 || agents[row] !== agent)
                {
                    // where there are no types, it may be anything
                    if (!(agent is Agent))
                    {
                        refuseList(isNoAgent(i, agent));
                    }
                    row = rowOf(agent);
                }
                if (row < 0)
                {
                    row = addRow(agent);
                }
                else if (_lists[row] == listNumber)
                {
                    refuseList(listedTwice(agent, list.indexOf(agent), i));
                }
                _lists[row] = listNumber;
                rows[i] = row;
            }
            count = list.length;
        }

        private function refuseList(error:Error):void
        {
            freeRows(true);
            listNumber++;
            throw error;
        }

        engine function isListed(list:Vector.<Agent>):Boolean
        {
            var i:int = 0;
            if (list.length == count)
            {
                while (i < count && agents[rows[i]] === list[i])
                {
                    i++;
                }
            }
            return i == count && list.length == count;
        }

        private static function isNoAgent(place:int, agent:Agent):Error
        {
            var problem:String = agent == null ? "is null" : "must be an Agent, not " + textOf(agent, "an Agent");
            return new ArgumentError("agents[" + place + "] " + problem);
        }

        private static function listedTwice(agent:Agent, first:int, second:int):Error
        {
            return new ArgumentError(agent + " is listed twice: agents[" + first + "] and agents[" + second + "]");
        }

        private function forgetReplaced():void
        {
            if (_shapes.forgetReplaced())
            {
                markVoidShapes();
            }
        }

        private function addRow(agent:Agent):int
        {
            var row:int = _rowCount;
            if (_freeCount > 0)
            {
                _freeCount--;
                row = _freeRows[_freeCount];
            }
            else
            {
                _rowCount++;
                makeRows(_rowCount);
            }
            agents[row] = agent;
            _extentsRevisions[row] = STALE;
            _rowsById.set (agent.number, row);
            return row;
        }

        // Some more rows than are asked for: a column that grows by one row at a time is copied again and again.
        private function makeRows(least:int):void
        {
            if (least <= _lists.length)
            {
                return;
            }
            var length:int = least + (_lists.length >> 3);
            agents.length = shapes.length = boxes.length = _placed.length = outer.length = length;
            x.length = y.length = z.length = lastX.length = lastY.length = lastZ.length = length;
            _offsetX.length = _offsetY.length = _offsetZ.length = length;
            _sizes.length = length;
            revisions.length = _lastRevisions.length = _extentsRevisions.length = _shapeRevisions.length = placedRevisions.length = length;
            depths.length = _lists.length = length;
            extents.grow(length);
        }

        // Frees the rows of agents that are not in the list; or, of a list that is refused, the rows that it has added.
        private function freeRows(isRefused:Boolean):void
        {
            for (var row:int = GUESTS; row < _rowCount; row++)
            {
                var isToGo:Boolean = isRefused ? shapes[row] == null : _lists[row] != listNumber;
                if (isToGo && agents[row] != null)
                {
                    _rowsById.remove(agents[row].number);
                    agents[row] = null;
                    shapes[row] = null;
                    _freeRows[_freeCount] = row;
                    _freeCount++;
                }
            }
        }

        private function markVoidShapes():void
        {
            for (var row:int = 0; row < _rowCount; row++)
            {
                if (shapes[row] != null && shapes[row].isVoid)
                {
                    _extentsRevisions[row] = STALE;
                }
            }
        }

        // Finds the shapes of the agents that have changed, all before any row changes, and then their extents.
        private function findShapes():void
        {
            if (_changedCount > _changedShapes.length)
            {
                _changedShapes.length = _changedCount;
            }
            for (var i:int = 0; i < _changedCount; i++)
            {
                var row:int = _changed[i];
                if (needsShape(row))
                {
                    _changedShapes[i] = _shapes.shapeOf(agents[row]);
                }
            }
            for (i = 0; i < _changedCount; i++)
            {
                row = _changed[i];
                if (needsShape(row))
                {
                    setShape(row, _changedShapes[i]);
                    _changedShapes[i] = null;
                }
                if (shapes[row] != null)
                {
                    findExtents(row);
                }
            }
        }

        // A row whose model is loading changes in every search.
        private function countLoading():void
        {
            loadingCount = 0;
            for (var i:int = 0; i < _changedCount; i++)
            {
                if (shapes[_changed[i]] == null)
                {
                    loadingCount++;
                }
            }
        }

        private function needsShape(row:int):Boolean
        {
            var shape:ModelShape = shapes[row];
            return shape == null || shape.isVoid || agents[row].shapeRevision != _shapeRevisions[row];
        }

        private function setShape(row:int, shape:ModelShape):void
        {
            var before:ModelShape = shapes[row];
            if (before == null || shape == null || shape.model != before.model)
            {
                revisions[row] = NOT_SEEN;
            }
            shapes[row] = shape;
            boxes[row] = null;
            _shapeRevisions[row] = agents[row].shapeRevision;
            if (shape == null)
            {
                // asked again in the next search
                _extentsRevisions[row] = STALE;
            }
            else if (shape.decides)
            {
                if (_placed[row] == null || _placed[row].kind != shape.structure.kind)
                {
                    _placed[row] = shape.structure.clone();
                }
                if (shape.outer == null)
                {
                    boxes[row] = _strategy.boxOf(_placed[row]);
                }
            }
        }

        private function findExtents(row:int):void
        {
            var agent:Agent = agents[row];
            var shape:ModelShape = shapes[row];
            var placement:Placement = agent.placement;
            var found:Vector.<Number> = _foundExtents;
            _strategy.findExtents(shape, agent, found);
            _offsetX[row] = found[0];
            _offsetY[row] = found[1];
            _offsetZ[row] = found[2];
            var halfX:Number = found[3];
            var halfY:Number = found[4];
            var radius:Number = halfX;
            if (!shape.isSphere)
            {
                radius = Math.sqrt(halfX * halfX + halfY * halfY);
            }
            extents.halfX[row] = halfX;
            extents.halfY[row] = halfY;
            extents.halfZ[row] = found[5];
            extents.radius[row] = radius;
            if (shape.structure != null)
            {
                keepRotation(row);
            }
            _sizes[row] = placement.size;
            depths[row] = agent.depthLimit;
            placedRevisions[row] = STALE;
            _extentsRevisions[row] = placement.extentsRevision;
        }

        // Unit spheres have none.
        private function keepRotation(row:int):void
        {
            if (_rotations.length <= ROTATION_SIZE * row)
            {
                _rotations.length = ROTATION_SIZE * agents.length;
            }
            agents[row].worldPlacement().writeRotation(_rotations, ROTATION_SIZE * row);
        }
    }
}
