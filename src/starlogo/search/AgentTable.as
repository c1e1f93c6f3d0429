package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.touchingMargin;

    use namespace engine;

    /**
     * What a collider sees of its agents: a row for each agent listed, in columns of numbers, because with thousands of agents memory
     * is what takes time. An agent keeps its row while it is listed; the same list has the same rows.
     *
     * <p>What a row says is of the last search, whatever has become of the agent since: where the agent was, how it was turned, and
     * what stood for it. docs/state.md tells what voids it.</p>
     *
     * <p>This file is long because all that reads agents in every frame is in it, and its loops are written out.</p>
     *
     * @private
     */
    public final class AgentTable
    {
        /** In place of a breed's number, of a row that is new. */
        public static const UNKNOWN_BREED:int = -2;

        // the middle, then half the lengths
        private static var sExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The rows of the agents, in the order of the list; so many at the beginning as <code>count</code> says. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** How many agents are listed. */
        public var count:int = 0;

        /** How many of them have a model that is loading. */
        public var loadingCount:int = 0;

        /** By row: the agent, or null. */
        public var agents:Vector.<Agent> = new Vector.<Agent>();

        /** By row: what stands for its model; null while that is loading. */
        public var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        /** By row: the extents in the world. */
        public var extents:Extents = new Extents();

        /** By row: where the agent is. */
        public var x:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var y:Vector.<Number> = new Vector.<Number>();

        /** @copy #x */
        public var z:Vector.<Number> = new Vector.<Number>();

        /** By row: where the agent was in the search before; what a search that fails has read already. */
        public var lastX:Vector.<Number> = new Vector.<Number>();

        /** @copy #lastX */
        public var lastY:Vector.<Number> = new Vector.<Number>();

        /** @copy #lastX */
        public var lastZ:Vector.<Number> = new Vector.<Number>();

        /** By row: the agent's revision that the place is of. */
        public var revisions:Vector.<int> = new Vector.<int>();

        /** By row: the revision that its structure was placed for; see place. */
        public var placedRevisions:Vector.<int> = new Vector.<int>();

        /** By row: its structure in the world if that is a box which decides alone, else null: spares the costliest frequent test its casts. */
        public var boxes:Vector.<Box> = new Vector.<Box>();

        /** By row: the number of its breed, see BreedNumbers. */
        public var breeds:Vector.<int> = new Vector.<int>();

        /** By row: the agent's own limit to the levels that are visited of its hierarchy, or 0. */
        public var depths:Vector.<int> = new Vector.<int>();

        private var _strategy:ShapeStrategy;
        private var _shapes:ModelShapes;
        private var _bins:Bins;

        // By row: the agent's revision in the search before; those that its extents and its shape are of, -1 for none.
        private var _lastRevisions:Vector.<int> = new Vector.<int>();
        private var _extentsRevisions:Vector.<int> = new Vector.<int>();
        private var _shapeRevisions:Vector.<int> = new Vector.<int>();

        // By row: from the place to the middle of the extents, and how the agent was turned and scaled.
        private var _offsetX:Vector.<Number> = new Vector.<Number>();
        private var _offsetY:Vector.<Number> = new Vector.<Number>();
        private var _offsetZ:Vector.<Number> = new Vector.<Number>();
        private var _headings:Vector.<Number> = new Vector.<Number>();
        private var _pitches:Vector.<Number> = new Vector.<Number>();
        private var _rolls:Vector.<Number> = new Vector.<Number>();
        private var _sizes:Vector.<Number> = new Vector.<Number>();

        // By row: the structure in the world.
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
        private var _outer:Vector.<OuterStructures> = new Vector.<OuterStructures>();

        // By row: the number of the search that saw the agent first, or with another model.
        private var _firstSearches:Vector.<int> = new Vector.<int>();
        private var _search:int = 0;

        // By row: the list that had the agent last, counted where lists change.
        private var _lists:Vector.<int> = new Vector.<int>();
        private var _list:int = 0;

        private var _rowsById:IdTable = new IdTable();
        private var _freeRows:Vector.<int> = new Vector.<int>();
        private var _freeCount:int = 0;
        private var _rowCount:int = 0;

        // Rows of the list at hand, from where it differs from the one before.
        private var _nextRows:Vector.<int> = new Vector.<int>();

        // Rows whose agents are not in the list at hand: they are free once a search has not failed.
        private var _leaving:Vector.<int> = new Vector.<int>();
        private var _leavingCount:int = 0;

        // Rows whose extents are to be found anew; of those, the ones that something else is to stand for, and what.
        private var _changed:Vector.<int> = new Vector.<int>();
        private var _changedCount:int = 0;
        private var _bound:Vector.<int> = new Vector.<int>();
        private var _boundShapes:Vector.<ModelShape> = new Vector.<ModelShape>();
        private var _boundCount:int = 0;

        private var _scratch:Placement = new Placement();

        /**
         * @param strategy says what stands for an agent
         * @param shapes has that of each model
         * @param bins find the level of extents; null where none are asked for
         */
        public function AgentTable(strategy:ShapeStrategy, shapes:ModelShapes, bins:Bins)
        {
            _strategy = strategy;
            _shapes = shapes;
            _bins = bins;
        }

        /**
         * Makes the rows those of a list of agents, where they are now, with what stands for each.
         *
         * @throws ArgumentError if an agent is null or listed twice, its model is unknown, or what is needed of it was not loaded; places
         *     and motions are then still those of the last search
         */
        public function read(agents:Vector.<Agent>):void
        {
            if (_shapes.forgetReplaced())
            {
                forgetVoidShapes();
            }
            _changedCount = 0;
            var same:int = readPlaces(agents, 0);
            if (same < count || same < agents.length)
            {
                listFrom(same, agents);
                readPlaces(agents, same);
            }
            bindChanged();
            freeLeaving();
            takePlaces();
        }

        /** Counts the changes of the list: while it stays, the rows are of the same agents. */
        public function get listNumber():int
        {
            return _list;
        }

        /** The row of an agent that is listed, or -1. */
        public function rowOf(agent:Agent):int
        {
            return _rowsById.valueOf(agent.id);
        }

        /** Has two rows, 0 and 1: of the two agents of a question, where they are now. */
        public function readPair(pair:Vector.<Agent>):void
        {
            _shapes.forgetReplaced();
            makeRows(2);
            count = 2;
            for (var row:int = 0; row < count; row++)
            {
                rows[row] = row;
                agents[row] = pair[row];
                // a question that threw may have left one
                shapes[row] = null;
                _extentsRevisions[row] = -1;
            }
            _changedCount = 0;
            readPlaces(pair, 0);
            bindChanged();
            takePlaces();
        }

        /** Lets go of the agents of a question. */
        public function endPair():void
        {
            agents[0] = agents[1] = null;
            shapes[0] = shapes[1] = null;
        }

        /** Whether an agent has moved from where the search before saw it to where it is: it was not seen first now, and has not jumped. */
        public function hasMotion(row:int):Boolean
        {
            return _firstSearches[row] != _search && agents[row].jumpRevision <= _lastRevisions[row];
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
            scratch.setRotation(_headings[row], _pitches[row], _rolls[row]);
            return scratch;
        }

        /** The structure of a row in the world, as much wider as touching asks for. */
        public function structureOf(row:int):BoundingStructure
        {
            if (placedRevisions[row] != revisions[row])
            {
                place(row);
            }
            return _placed[row];
        }

        /** What is tried before the structure, in the world, where there is something of the kind. */
        public function outerOf(row:int):OuterStructures
        {
            if (placedRevisions[row] != revisions[row])
            {
                place(row);
            }
            return _outer[row];
        }

        /** Puts the structure of a row where its agent is. Not before a test asks for it: of thousands of agents few have others near them. */
        public function place(row:int):void
        {
            var shape:ModelShape = shapes[row];
            var structure:BoundingStructure = shape.structure;
            var placement:Placement = placementOf(row, _scratch);
            var margin:Number = touchingMargin(x[row], y[row], z[row]);
            structure.place(placement, _placed[row]);
            _placed[row].widen(margin);
            if (shape.outerSphere != null)
            {
                _outer[row] ||= new OuterStructures();
                _outer[row].place(shape, placement, margin);
            }
            placedRevisions[row] = revisions[row];
        }

        // Reads where agents are from one of the list on, as long as they have the rows that they had, and notes which have changed in more
        // than their places. Returns the first that has not. The places are written beside those of the last search.
        private function readPlaces(list:Vector.<Agent>, first:int):int
        {
            var listed:Vector.<Agent> = agents;
            var listedRows:Vector.<int> = rows;
            var extentsRevisions:Vector.<int> = _extentsRevisions;
            var read:Vector.<int> = _lastRevisions;
            var placeX:Vector.<Number> = lastX;
            var placeY:Vector.<Number> = lastY;
            var placeZ:Vector.<Number> = lastZ;
            var end:int = count < list.length ? count : list.length;
            for (var i:int = first; i < end; i++)
            {
                var row:int = listedRows[i];
                var agent:Agent = list[i];
                if (listed[row] !== agent)
                {
                    return i;
                }
                var placement:Placement = agent.placement;
                if (placement.extentsRevision != extentsRevisions[row])
                {
                    _changed[_changedCount] = row;
                    _changedCount++;
                }
                read[row] = agent.revision;
                placeX[row] = placement.x;
                placeY[row] = placement.y;
                placeZ[row] = placement.z;
            }
            return end;
        }

        // What was read counts from now on.
        private function takePlaces():void
        {
            var placeX:Vector.<Number> = lastX;
            var placeY:Vector.<Number> = lastY;
            var placeZ:Vector.<Number> = lastZ;
            lastX = x;
            lastY = y;
            lastZ = z;
            x = placeX;
            y = placeY;
            z = placeZ;
            var read:Vector.<int> = _lastRevisions;
            _lastRevisions = revisions;
            revisions = read;
            _search++;
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
                var atX:Number = placeX[row] + offsetX[row];
                var atY:Number = placeY[row] + offsetY[row];
                var atZ:Number = placeZ[row] + offsetZ[row];
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
                if (shapes[_changed[i]] != null)
                {
                    fit(_changed[i]);
                }
            }
        }

        // From there on, one by one; none may come twice. Nothing changes before all are known to be right.
        private function listFrom(first:int, agents:Vector.<Agent>):void
        {
            var list:int = ++_list;
            var lists:Vector.<int> = _lists;
            makeRows(agents.length);
            for (var i:int = 0; i < first; i++)
            {
                lists[rows[i]] = list;
            }
            for (i = first; i < agents.length; i++)
            {
                var agent:Agent = agents[i];
                if (agent == null)
                {
                    freeUnlisted(first, i);
                    throw new ArgumentError("agents[" + i + "] is null");
                }
                var row:int = _rowsById.valueOf(agent.serial);
                if (row >= 0 && lists[row] == list)
                {
                    freeUnlisted(first, i);
                    throw new ArgumentError(agent + " is listed twice: agents[" + agents.indexOf(agent) + "] and agents[" + i + "]");
                }
                if (row < 0)
                {
                    row = takeRow(agent);
                }
                lists[row] = list;
                _nextRows[i - first] = row;
            }
            for (i = first; i < count; i++)
            {
                row = rows[i];
                if (lists[row] != list)
                {
                    _leaving[_leavingCount] = row;
                    _leavingCount++;
                }
            }
            count = agents.length;
            for (i = first; i < count; i++)
            {
                rows[i] = _nextRows[i - first];
            }
        }

        // Those that a list that is refused has brought.
        private function freeUnlisted(first:int, end:int):void
        {
            for (var i:int = first; i < count; i++)
            {
                _lists[rows[i]] = 0;
            }
            for (i = 0; i < end - first; i++)
            {
                var row:int = _nextRows[i];
                if (_lists[row] == _list && shapes[row] == null)
                {
                    freeRow(row);
                }
            }
        }

        // Those of agents that this list has not, and no list that failed since the last search that did not.
        private function freeLeaving():void
        {
            for (var i:int = 0; i < _leavingCount; i++)
            {
                if (_lists[_leaving[i]] != _list)
                {
                    freeRow(_leaving[i]);
                }
            }
            _leavingCount = 0;
        }

        private function takeRow(agent:Agent):int
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
            breeds[row] = UNKNOWN_BREED;
            _extentsRevisions[row] = -1;
            _rowsById.set (agent.id, row);
            return row;
        }

        private function freeRow(row:int):void
        {
            _rowsById.remove(agents[row].id);
            agents[row] = null;
            shapes[row] = null;
            _freeRows[_freeCount] = row;
            _freeCount++;
        }

        // Some more than are asked for: a column that grows by one row at a time is copied again and again.
        private function makeRows(least:int):void
        {
            if (least <= _lists.length)
            {
                return;
            }
            var length:int = least + (_lists.length >> 3);
            agents.length = shapes.length = boxes.length = _placed.length = _outer.length = length;
            x.length = y.length = z.length = lastX.length = lastY.length = lastZ.length = length;
            _offsetX.length = _offsetY.length = _offsetZ.length = length;
            _headings.length = _pitches.length = _rolls.length = _sizes.length = length;
            revisions.length = _lastRevisions.length = _extentsRevisions.length = _shapeRevisions.length = placedRevisions.length = length;
            breeds.length = depths.length = _firstSearches.length = _lists.length = length;
            extents.grow(length);
        }

        private function forgetVoidShapes():void
        {
            for (var i:int = 0; i < count; i++)
            {
                var shape:ModelShape = shapes[rows[i]];
                if (shape != null && shape.isVoid)
                {
                    _extentsRevisions[rows[i]] = -1;
                }
            }
        }

        // Finds what stands for the agents that have changed, all before any row changes, and its extents.
        private function bindChanged():void
        {
            _boundCount = 0;
            for (var i:int = 0; i < _changedCount; i++)
            {
                var row:int = _changed[i];
                var shape:ModelShape = shapes[row];
                if (shape == null || shape.isVoid || agents[row].shapeRevision != _shapeRevisions[row])
                {
                    _bound[_boundCount] = row;
                    _boundShapes[_boundCount] = _shapes.shapeOf(agents[row]);
                    _boundCount++;
                }
            }
            loadingCount = 0;
            for (i = 0; i < _boundCount; i++)
            {
                bind(_bound[i], _boundShapes[i]);
                _boundShapes[i] = null;
            }
            for (i = 0; i < _changedCount; i++)
            {
                if (shapes[_changed[i]] != null)
                {
                    takeExtents(_changed[i]);
                }
            }
        }

        private function bind(row:int, shape:ModelShape):void
        {
            var before:ModelShape = shapes[row];
            if (before == null || shape == null || shape.model != before.model)
            {
                // seen first in the search that is under way
                _firstSearches[row] = _search + 1;
            }
            shapes[row] = shape;
            boxes[row] = null;
            _shapeRevisions[row] = agents[row].shapeRevision;
            if (shape == null)
            {
                // asked again in the next search
                _extentsRevisions[row] = -1;
                loadingCount++;
            }
            else if (shape.decides)
            {
                if (_placed[row] == null || _placed[row].kind != shape.structure.kind)
                {
                    _placed[row] = shape.structure.clone();
                }
                if (shape.outerSphere == null)
                {
                    boxes[row] = _placed[row] as Box;
                }
            }
        }

        private function takeExtents(row:int):void
        {
            var agent:Agent = agents[row];
            var shape:ModelShape = shapes[row];
            var placement:Placement = agent.placement;
            var found:Vector.<Number> = sExtents;
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
            _headings[row] = placement.heading;
            _pitches[row] = placement.pitch;
            _rolls[row] = placement.roll;
            _sizes[row] = placement.size;
            depths[row] = agent.depthLimit;
            placedRevisions[row] = -1;
            _extentsRevisions[row] = placement.extentsRevision;
        }

        private function fit(row:int):void
        {
            if (_bins != null && _bins.fit(extents, row))
            {
                // it needs a finer level once it comes back: looked at in every search until then
                _extentsRevisions[row] = -1;
            }
        }
    }
}
