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
     * Stores the shape of each agent: its place, its extents, and its structure in the world. Each agent has a row, and each property a column
     * of numbers. It has columns because with thousands of agents reading memory takes most of the time. An AgentTable says which agent has
     * which row.
     *
     * @private
     */
    public class ShapedRows
    {
        // Values in place of a revision. NOT_SEEN says that the agent has no motion. It is less than the revision of any jump. STALE says that
        // the value has to be computed again.
        protected static const NOT_SEEN:int = -2;
        protected static const STALE:int = -1;

        // A value in place of a revision: the row is at another place for a while.
        private static const DISPLACED:int = -3;

        private static const ROTATION_SIZE:int = 9;

        // By row: the agent, or null.
        engine var agents:Vector.<Agent>;

        // By row: the shape of the agent's model, which is null while the model is loading; the shape's form; and the agent's own limit for the
        // levels of its tree, or 0.
        engine var shapes:Vector.<ModelShape> = new Vector.<ModelShape>();
        engine var forms:Vector.<int> = new Vector.<int>();
        internal var depths:Vector.<int> = new Vector.<int>();

        // By row: the agent's place, the agent's revision at that place, and the extents of its shape.
        engine var x:Vector.<Number> = new Vector.<Number>();
        engine var y:Vector.<Number> = new Vector.<Number>();
        engine var z:Vector.<Number> = new Vector.<Number>();
        engine var revisions:Vector.<int> = new Vector.<int>();
        engine var extents:Extents = new Extents();

        // By row: the agent's revisions at which its extents and its shape were read.
        protected var extentsRevisions:Vector.<int> = new Vector.<int>();
        private var _shapeRevisions:Vector.<int> = new Vector.<int>();

        // By row: the way from the agent's place to the middle of its extents, and the rotation and the scale of the shape.
        internal var offsetX:Vector.<Number> = new Vector.<Number>();
        internal var offsetY:Vector.<Number> = new Vector.<Number>();
        internal var offsetZ:Vector.<Number> = new Vector.<Number>();
        private var _rotations:Vector.<Number> = new Vector.<Number>();
        internal var sizes:Vector.<Number> = new Vector.<Number>();

        // By row: the structure in the world, the revision at which it was placed, and the structures that are tested before it, or null. The
        // column boxes has the structure once more if it is a box that is tested alone, and else null. This column is typed, so the most
        // frequent slow test needs no casts.
        private var _placed:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
        internal var placedRevisions:Vector.<int> = new Vector.<int>();
        internal var outer:Vector.<OuterStructures> = new Vector.<OuterStructures>();
        internal var boxes:Vector.<Box> = new Vector.<Box>();

        // By kind: the structures that no row uses at present.
        private var _spares:Vector.<Vector.<BoundingStructure>> = new <Vector.<BoundingStructure>>[new Vector.<BoundingStructure>(), new Vector.<BoundingStructure>(),
                new Vector.<BoundingStructure>()];

        // The number of rows read last whose models are still loading.
        engine var loadingCount:int = 0;

        // The rows whose extents have to be computed again, and the new shapes of rows whose shape has changed.
        protected var changed:Vector.<int> = new Vector.<int>();
        protected var changedCount:int = 0;
        private var _changedShapes:Vector.<ModelShape> = new Vector.<ModelShape>();

        protected var modelShapes:ModelShapes;

        // The middle and half of the lengths of extents; a placement without rotation.
        private var _foundExtents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _upright:Placement = new Placement();
        private var _scratch:Placement = new Placement();

        /**
         * For AgentTable only.
         *
         * @param agents the agent of each row; the list grows
         * @param shapes has the shape of each model
         */
        public function ShapedRows(agents:Vector.<Agent>, shapes:ModelShapes)
        {
            this.agents = agents;
            modelShapes = shapes;
        }

        /** Whether a row still has the state of its agent and of the agent's model, and the model is not loading. */
        public function isOfNow(row:int):Boolean
        {
            forgetReplaced();
            var agent:Agent = agents[row];
            return agent.revision == revisions[row] && agent.placement.extentsRevision == extentsRevisions[row];
        }

        /**
         * The placement of a row's shape: the place of its agent in the last search, and the rotation of its shape.
         *
         * @param scratch receives the placement if it differs from the agent's own placement
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

        /** The structure of a row in the world, widened by the margin within which shapes touch. */
        public function structureOf(row:int):BoundingStructure
        {
            if (placedRevisions[row] != revisions[row])
            {
                place(row);
            }
            return _placed[row];
        }

        /** Sets an axis-aligned box to a row's extents, with a margin larger than rounding errors. */
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

        /** Copies the eight numbers of a row that are proportional to its size. */
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

        /** Writes these eight numbers back to a row, each times a factor. */
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

        /** Call this after x, y, z of a row were set to another place. Tests then see the row there. */
        public function displace(row:int):void
        {
            moveExtents(row);
            revisions[row] = DISPLACED;
            placedRevisions[row] = STALE;
        }

        /**
         * Puts the structure of a row to the place of its agent. This is done only when a test needs it, because few of thousands of agents have
         * others near them.
         */
        public function place(row:int):void
        {
            var shape:ModelShape = shapes[row];
            var placement:Placement = placementOf(row, _scratch);
            // the same as marginOf, because V8 would make an object for that method's result
            var margin:Number = Tolerances.PLACES * (Math.abs(x[row]) + Math.abs(y[row]) + Math.abs(z[row]));
            if (shape.form == BoundingStructure.SPHERE)
            {
                // the test of two placed spheres has no tolerance of its own, so the sphere is widened by it. Tests of a sphere and another
                // structure have one
                margin += (Tolerances.TOUCHING - 1) * extents.halfX[row];
            }
            takeStructure(row, shape);
            shape.structure.place(placement, _placed[row]);
            _placed[row].widen(margin);
            if (shape.outer != null)
            {
                outer[row] ||= new OuterStructures(shape.structure);
                // the corners of a box that is wider by a margin are farther out by its diagonal
                outer[row].place(shape.outer, placement, 2 * margin);
            }
            placedRevisions[row] = revisions[row];
        }

        // Makes as many rows as there are agents.
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

        // Finds the shapes of agents that have changed. All shapes are found before any row changes, because an error must change no row.
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
        }

        // Gives the changed rows the shapes that findShapes has found, and finds their extents.
        protected function takeShapes():void
        {
            loadingCount = 0;
            for (var i:int = 0; i < changedCount; i++)
            {
                var row:int = changed[i];
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
                // it is read again in the next search
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

        // Gives a row a structure of its shape's kind. The structure that it had is kept for another row.
        private function takeStructure(row:int, shape:ModelShape):void
        {
            var before:BoundingStructure = _placed[row];
            if (before != null)
            {
                if (before.kind == shape.form)
                {
                    return;
                }
                _spares[before.kind].push(before);
            }
            _placed[row] = _spares[shape.form].pop() || shape.structure.clone();
        }

        private function findExtents(row:int):void
        {
            var agent:Agent = agents[row];
            var shape:ModelShape = shapes[row];
            var placement:Placement = _upright;
            if (shape.isUpright)
            {
                // the structures of the ground and of the edges are not scaled
                placement.size = shape.form >= ModelShape.GROUND ? 1 : agent.placement.size;
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
