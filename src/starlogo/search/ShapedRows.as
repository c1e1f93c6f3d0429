package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Rows of agents with their shapes, in columns of numbers, because with thousands of agents memory is what takes time: where each shape is, its
     * extents, its structure in the world. An AgentTable says which agents.
     *
     * @private
     */
    public class ShapedRows
    {
        // In place of a revision: for an agent that has no motion, less than any jump's; and for what has to be computed again.
        protected static const NOT_SEEN:int = -2;
        protected static const STALE:int = -1;

        // In place of an agent's revision: for a row that is somewhere else for a while.
        private static const DISPLACED:int = -3;

        private static const ROTATION_SIZE:int = 9;

        // By row: the agent, or null.
        engine var agents:Vector.<Agent>;

        // By row: the shape of the agent's model, null while that is loading, and the shape's form; the agent's own limit to the levels that are
        // visited of its tree, or 0.
        engine var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();
        engine var forms:Vector.<int> = new Vector.<int>();
        internal var depths:Vector.<int> = new Vector.<int>();

        // By row: where the agent is, and the agent's revision that this is of; the extents of its shape.
        engine var x:Vector.<Number> = new Vector.<Number>();
        engine var y:Vector.<Number> = new Vector.<Number>();
        engine var z:Vector.<Number> = new Vector.<Number>();
        engine var revisions:Vector.<int> = new Vector.<int>();
        engine var extents:Extents = new Extents();

        // By row: the agent's revisions that its extents and its shape are of.
        protected var extentsRevisions:Vector.<int> = new Vector.<int>();
        private var _shapeRevisions:Vector.<int> = new Vector.<int>();

        // By row: from the position to the middle of the extents, and how the shape is turned and scaled.
        internal var offsetX:Vector.<Number> = new Vector.<Number>();
        internal var offsetY:Vector.<Number> = new Vector.<Number>();
        internal var offsetZ:Vector.<Number> = new Vector.<Number>();
        private var _rotations:Vector.<Number> = new Vector.<Number>();
        internal var sizes:Vector.<Number> = new Vector.<Number>();

        // By row: its structure in the world, for which revision that was placed, and what is tried before it, or null. Of the structures the boxes
        // that decide alone are listed a second time, typed, else null: that spares the most frequent costly test its casts.
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
        internal var placedRevisions:Vector.<int> = new Vector.<int>();
        internal var outer:Vector.<OuterStructures> = new Vector.<OuterStructures>();
        internal var boxes:Vector.<Box> = new Vector.<Box>();

        // By kind: a structure that no row has at present, or null.
        private var _spares:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);

        // How many rows have a model that is loading, of those that were read last.
        engine var loadingCount:int = 0;

        // Rows whose extents have to be computed again, and the new shapes of those whose shape has changed.
        protected var changed:Vector.<int> = new Vector.<int>();
        protected var changedCount:int = 0;
        private var _changedShapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        protected var modelShapes:ModelShapes;

        // The middle, then half the lengths; an upright placement.
        private var _foundExtents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _upright:Placement = new Placement();
        private var _scratch:Placement = new Placement();

        /**
         * For AgentTable only.
         *
         * @param agents by row: the agents; grows
         * @param shapes has the shape of each model
         */
        public function ShapedRows(agents:Vector.<Agent>, shapes:ModelShapes)
        {
            this.agents = agents;
            modelShapes = shapes;
        }

        /** Whether a row is as its agent is now. */
        public function isOfNow(row:int):Boolean
        {
            return agents[row].revision == revisions[row] && shapes[row] != null;
        }

        /**
         * Where a row's agent was in the last search, as its shape is turned.
         *
         * @param scratch takes it if the agent has changed since
         * @return the agent's own placement, or scratch
         */
        public function placementOf(row:int, scratch:Placement):Placement
        {
            var agent:Agent = agents[row];
            if (agent.revision == revisions[row] && !shapes[row].isUpright)
            {
                return agent.placement;
            }
            scratch.x = x[row];
            scratch.y = y[row];
            scratch.z = z[row];
            scratch.size = sizes[row];
            if (shapes[row].isUpright)
            {
                scratch.copyRotation(_upright);
            }
            else
            {
                scratch.readRotation(_rotations, ROTATION_SIZE * row);
            }
            return scratch;
        }

        /** A row's part of the gap across which shapes touch. */
        public function marginOf(row:int):Number
        {
            return Tolerances.PLACES * (Math.abs(x[row]) + Math.abs(y[row]) + Math.abs(z[row]));
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

        /** Makes a box along the world's axes that of a row's extents, wider by more than rounding comes to. */
        internal function readExtents(row:int, box:Box):void
        {
            var margin:Number = Tolerances.EXTENTS_GAPS * marginOf(row);
            box.center.x = extents.x[row];
            box.center.y = extents.y[row];
            box.center.z = extents.z[row];
            box.halfX = extents.halfX[row] * Tolerances.OUTER + margin;
            box.halfY = extents.halfY[row] * Tolerances.OUTER + margin;
            box.halfZ = extents.halfZ[row] * Tolerances.OUTER + margin;
        }

        /** Copies what grows with a row into a list of eight. */
        internal function readSizing(row:int, out:Vector.<Number>):void
        {
            out[0] = offsetX[row];
            out[1] = offsetY[row];
            out[2] = offsetZ[row];
            out[3] = extents.halfX[row];
            out[4] = extents.halfY[row];
            out[5] = extents.halfZ[row];
            out[6] = extents.radius[row];
            out[7] = sizes[row];
        }

        /** Makes what grows with a row what such a list has, times a factor. */
        internal function writeSizing(row:int, from:Vector.<Number>, factor:Number):void
        {
            offsetX[row] = factor * from[0];
            offsetY[row] = factor * from[1];
            offsetZ[row] = factor * from[2];
            extents.halfX[row] = factor * from[3];
            extents.halfY[row] = factor * from[4];
            extents.halfZ[row] = factor * from[5];
            extents.radius[row] = factor * from[6];
            sizes[row] = factor * from[7];
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
            // marginOf, of whose result V8 would make an object
            var margin:Number = Tolerances.PLACES * (Math.abs(x[row]) + Math.abs(y[row]) + Math.abs(z[row]));
            if (shape.form == BoundingStructure.SPHERE)
            {
                // other structures are compared with it by tests that grant this, other spheres are not
                margin += (Tolerances.TOUCHING - 1) * extents.halfX[row];
            }
            takeStructure(row, shape);
            shape.structure.place(placement, _placed[row]);
            _placed[row].widen(margin);
            if (shape.outer != null)
            {
                outer[row] ||= new OuterStructures(shape.outer.sphere, shape.outer.capsule);
                outer[row].place(shape.outer, placement, margin);
            }
            placedRevisions[row] = revisions[row];
        }

        // As many as there are of agents.
        protected function makeRows():void
        {
            var length:int = agents.length;
            if (length <= shapes.length)
            {
                return;
            }
            shapes.length = boxes.length = _placed.length = outer.length = length;
            x.length = y.length = z.length = length;
            offsetX.length = offsetY.length = offsetZ.length = sizes.length = length;
            revisions.length = extentsRevisions.length = _shapeRevisions.length = placedRevisions.length = length;
            forms.length = depths.length = length;
            extents.grow(length);
        }

        protected function forgetReplaced():void
        {
            if (!modelShapes.forgetReplaced())
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

        protected function moveExtents(row:int):void
        {
            extents.x[row] = x[row] + offsetX[row];
            extents.y[row] = y[row] + offsetY[row];
            extents.z[row] = z[row] + offsetZ[row];
        }

        // Finds the shapes of the agents that have changed, all before any row changes, and then their extents.
        protected function findShapes():void
        {
            if (changedCount > _changedShapes.length)
            {
                _changedShapes.length = changedCount;
            }
            for (var i:int = 0; i < changedCount; i++)
            {
                var row:int = changed[i];
                if (needsShape(row))
                {
                    _changedShapes[i] = modelShapes.shapeOf(agents[row]);
                }
            }
            loadingCount = 0;
            for (i = 0; i < changedCount; i++)
            {
                row = changed[i];
                if (needsShape(row))
                {
                    setShape(row, _changedShapes[i]);
                    _changedShapes[i] = null;
                }
                if (shapes[row] == null)
                {
                    // a row whose model is loading changes in every search
                    loadingCount++;
                }
                else
                {
                    findExtents(row);
                }
            }
        }

        protected function needsShape(row:int):Boolean
        {
            var shape:ModelShape = shapes[row];
            return shape == null || shape.isVoid || agents[row].shapeRevision != _shapeRevisions[row];
        }

        protected function setShape(row:int, shape:ModelShape):void
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
                extentsRevisions[row] = STALE;
                return;
            }
            forms[row] = shape.form;
            if (shape.form == BoundingStructure.BOX && shape.outer == null)
            {
                takeStructure(row, shape);
                boxes[row] = Box(_placed[row]);
            }
        }

        // Gives a row a structure of its shape's kind; the one that it had is kept for another row.
        private function takeStructure(row:int, shape:ModelShape):void
        {
            var before:BoundingStructure = _placed[row];
            if (before != null)
            {
                if (before.kind == shape.form)
                {
                    return;
                }
                _spares[before.kind] = before;
            }
            var spare:BoundingStructure = _spares[shape.form];
            if (spare == null)
            {
                spare = shape.structure.clone();
            }
            _spares[shape.form] = null;
            _placed[row] = spare;
        }

        private function findExtents(row:int):void
        {
            var agent:Agent = agents[row];
            var shape:ModelShape = shapes[row];
            var placement:Placement = _upright;
            if (shape.isUpright)
            {
                // the ground has the size of its cells
                placement.size = shape.form == ModelShape.GROUND ? 1 : agent.placement.size;
            }
            else
            {
                placement = agent.worldPlacement();
                keepRotation(row, placement);
            }
            var found:Vector.<Number> = _foundExtents;
            shape.structure.turnedExtentsInto(placement, found);
            offsetX[row] = found[0];
            offsetY[row] = found[1];
            offsetZ[row] = found[2];
            var halfX:Number = found[3];
            var halfY:Number = found[4];
            extents.halfX[row] = halfX;
            extents.halfY[row] = halfY;
            extents.halfZ[row] = found[5];
            var radius:Number = halfX;
            if (shape.form != BoundingStructure.SPHERE)
            {
                radius = Math.sqrt(halfX * halfX + halfY * halfY);
            }
            extents.radius[row] = radius;
            sizes[row] = placement.size;
            depths[row] = agent.depthLimit;
            placedRevisions[row] = STALE;
            extentsRevisions[row] = agent.placement.extentsRevision;
        }

        private function keepRotation(row:int, placement:Placement):void
        {
            if (_rotations.length <= ROTATION_SIZE * row)
            {
                _rotations.length = ROTATION_SIZE * agents.length;
            }
            placement.writeRotation(_rotations, ROTATION_SIZE * row);
        }
    }
}
