package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.engine;

    use namespace engine;

    /**
     * The table in which a collider stores its agents: a row for each agent, and a column of numbers for each property. The base classes
     * say which agent has which row, and where it is. It has columns because with thousands of agents reading memory takes most of the time. Each row has a body for tests.
     *
     * <p>A row stays as the last search has read it, even if the agent has changed since: its place, its rotation and its shape. docs/state.md
     * lists the changes that make a part of a row void.</p>
     *
     * @private
     */
    public final class AgentTable extends PlacedRows
    {
        // By row: the shape of the agent's model, which is null while the model is loading; the shape's form; and the body, which is as old as its
        // revision.
        engine var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();
        engine var forms:Vector.<int> = new Vector.<int>();
        private var _bodies:Vector.<Body> = new Vector.<Body>();

        /** By row: the extents of the shape. */
        engine var extents:Extents = new Extents();

        // By row: the way from the agent's place to the middle of its extents.
        private var _offsets:Points = new Points();

        // By row: the agent's shapeRevision at which its shape was read.
        private var _shapeRevisions:Vector.<int> = new Vector.<int>();

        // By row: the structure of the body if it is a box that is tested alone, and else null; and the revision at which it was placed. This
        // column is typed, so the most frequent slow test needs no casts.
        internal var boxes:Vector.<Box> = new Vector.<Box>();
        internal var placedRevisions:Vector.<int> = new Vector.<int>();

        // The number of rows read last whose models are still loading.
        engine var loadingCount:int = 0;

        // The new shapes of changed rows whose shape has changed.
        private var _changedShapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        private var _modelShapes:ModelShapes;
        private var _bins:Bins;

        /**
         * @param shapes has the shape of each model
         * @param bins has the levels of extents; null if no levels are needed
         */
        public function AgentTable(shapes:ModelShapes, bins:Bins)
        {
            _modelShapes = shapes;
            _bins = bins;
            grow(LISTED);
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
            departed.count = 0;
            var isOther:Boolean = !isAccepted || list.length != count || !readChanged(list, rows);
            if (isOther)
            {
                propose(list);
                readChanged(list, proposed);
            }
            findShapes();
            if (isOther)
            {
                accept(list.length);
            }
            takeShapes();
            exchangePlaces();
            moveExtentsOfMoved();
            for (var i:int = 0; i < changed.count; i++)
            {
                assignLevel(changed.numbers[i]);
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
            changed.count = 0;
            if (agent.placement.extentsRevision != extentsRevisions[row])
            {
                changed.add(row);
                findShapes();
                takeShapes();
            }
            now.put(row, agent);
            last.put(row, agent);
            moveExtents(row);
        }

        /** Reads the agent of the ground or of the edges of the world into its row, or empties the row. */
        public function readWorldAgent(row:int, agent:Agent):void
        {
            if (agents[row] !== agent)
            {
                agents[row] = agent;
                shapes[row] = null;
                if (agent != null)
                {
                    setShape(row, ModelShapes.newShapeOfFixture(WorldAgent(agent)));
                    findExtents(row);
                    now.put(row, agent);
                    last.put(row, agent);
                }
            }
        }

        /**
         * The body of an agent as it is now: that of its row, if the agent has not changed since, and else a body that is made. Its shape is null
         * while the agent's model is loading. A row of the ground or of the edges may be held (HeldWorld), and is not of now then.
         */
        public function bodyOfNow(agent:Agent, made:Body):Body
        {
            forgetReplaced();
            var row:int = rowOf(agent);
            var isOfNow:Boolean = row >= LISTED || row >= 0 && shapes[row].fixture === agent;
            if (isOfNow && agent.revision == now.revisions[row] && agent.placement.extentsRevision == extentsRevisions[row])
            {
                return bodyOf(row);
            }
            made.readAgent(agent, _modelShapes.shapeOf(agent));
            if (row >= 0)
            {
                made.order = ranks[row];
            }
            return made;
        }

        /** The body of a row whose model is not loading, as the last search has read it. */
        public function bodyOf(row:int):Body
        {
            var body:Body = _bodies[row];
            if (!body.isOf(agents[row], now.revisions[row]))
            {
                body.follow(agents[row], now, row);
            }
            return body;
        }

        /** Puts the box of a row to its place. A test does this only when it needs the box, because few of thousands of agents have others near. */
        internal function placeBox(row:int):void
        {
            bodyOf(row).structure();
            placedRevisions[row] = now.revisions[row];
        }

        private function moveExtentsOfMoved():void
        {
            var movedRows:Vector.<int> = moved.numbers;
            var xs:Vector.<Number> = now.x;
            var ys:Vector.<Number> = now.y;
            var zs:Vector.<Number> = now.z;
            var fromX:Vector.<Number> = _offsets.x;
            var fromY:Vector.<Number> = _offsets.y;
            var fromZ:Vector.<Number> = _offsets.z;
            var middleX:Vector.<Number> = extents.x;
            var middleY:Vector.<Number> = extents.y;
            var middleZ:Vector.<Number> = extents.z;
            var reachSquared:Number = _bins == null ? Infinity : _bins.levels.reachSquared;
            var end:int = moved.count;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = movedRows[i];
                var atX:Number = xs[row] + fromX[row];
                var atY:Number = ys[row] + fromY[row];
                var atZ:Number = zs[row] + fromZ[row];
                middleX[row] = atX;
                middleY[row] = atY;
                middleZ[row] = atZ;
                if (atX * atX + atY * atY + atZ * atZ >= reachSquared)
                {
                    assignLevel(row);
                }
            }
        }

        private function assignLevel(row:int):void
        {
            if (_bins != null && shapes[row] != null && _bins.levels.assignLevel(extents, row))
            {
                // the row needs a finer level when its agent comes back, so every search computes its extents until then
                extentsRevisions[row] = STALE;
            }
        }

        /** @inheritDoc */
        override protected function grow(length:int):void
        {
            super.grow(length);
            shapes.length = boxes.length = _bodies.length = length;
            forms.length = _shapeRevisions.length = placedRevisions.length = length;
            _offsets.grow(length);
            extents.grow(length);
        }

        /** @inheritDoc */
        override protected function accept(length:int):void
        {
            super.accept(length);
            for (var i:int = 0; i < length; i++)
            {
                var body:Body = _bodies[rows[i]];
                if (body != null)
                {
                    body.order = i;
                }
            }
        }

        /** @inheritDoc */
        override protected function free(row:int):void
        {
            super.free(row);
            shapes[row] = null;
        }

        private function forgetReplaced():void
        {
            if (!_modelShapes.forgetReplaced())
            {
                return;
            }
            for (var row:int = 0; row < shapes.length; row++)
            {
                if (shapes[row] != null && shapes[row].isVoid)
                {
                    extentsRevisions[row] = STALE;
                }
            }
        }

        /** Finds the extents of a row again after its place has changed. */
        internal function moveExtents(row:int):void
        {
            extents.x[row] = now.x[row] + _offsets.x[row];
            extents.y[row] = now.y[row] + _offsets.y[row];
            extents.z[row] = now.z[row] + _offsets.z[row];
        }

        // Finds the shapes of agents that have changed. All shapes are found before any row changes, because an error must change no row.
        private function findShapes():void
        {
            if (changed.count > _changedShapes.length)
            {
                _changedShapes.length = changed.count;
            }
            for (var i:int = 0; i < changed.count; i++)
            {
                var row:int = changed.numbers[i];
                if (needsShape(row))
                {
                    _changedShapes[i] = _modelShapes.shapeOf(agents[row]);
                }
            }
        }

        // Gives the changed rows the shapes that findShapes has found, and finds their extents.
        private function takeShapes():void
        {
            loadingCount = 0;
            for (var i:int = 0; i < changed.count; i++)
            {
                var row:int = changed.numbers[i];
                if (needsShape(row))
                {
                    setShape(row, _changedShapes[i]);
                    _changedShapes[i] = null;
                }
                if (shapes[row] == null)
                {
                    // a row whose model is loading is read again in every search
                    loadingCount++;
                }
                else
                {
                    findExtents(row);
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
                now.revisions[row] = RowPlaces.NOT_SEEN;
            }
            shapes[row] = shape;
            boxes[row] = null;
            _shapeRevisions[row] = agents[row].shapeRevision;
            if (shape == null)
            {
                // it is read again in the next search
                extentsRevisions[row] = STALE;
                return;
            }
            forms[row] = shape.form;
        }

        private function findExtents(row:int):void
        {
            var agent:Agent = agents[row];
            var shape:ModelShape = shapes[row];
            var body:Body = _bodies[row];
            if (body == null)
            {
                body = _bodies[row] = new Body();
            }
            body.readShape(agent, shape);
            body.order = ranks[row];
            _offsets.x[row] = body.offsetX;
            _offsets.y[row] = body.offsetY;
            _offsets.z[row] = body.offsetZ;
            extents.halfX[row] = body.halfX;
            extents.halfY[row] = body.halfY;
            extents.halfZ[row] = body.halfZ;
            extents.radius[row] = body.radius;
            if (shape.form == BoundingStructure.BOX && boxes[row] == null)
            {
                boxes[row] = Box(body.structure());
            }
            extentsRevisions[row] = agent.placement.extentsRevision;
            setStale(row);
        }

        /** Lets a row's body be placed again. */
        internal function setStale(row:int):void
        {
            placedRevisions[row] = STALE;
            if (_bodies[row] != null)
            {
                _bodies[row].revision = STALE;
            }
        }
    }
}
