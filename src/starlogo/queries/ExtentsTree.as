// This file is long because its loops are written out.
package starlogo.queries
{
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * Boxes around the extents of a table's rows, in the order of a tree of their places: finds the rows whose extents overlap a box, and those
     * that a ray meets, the nearest first. The boxes are wider than the extents by more than rounding comes to.
     *
     * <p>Rows are given as numbers of the list. One whose model is loading is in no box.</p>
     *
     * @private
     */
    public final class ExtentsTree
    {
        private static const PER_BOX:int = PlaceTree.PER_BOX;

        /** The box that a search is about. */
        public var minX:Number = 0;

        /** @copy #minX */
        public var minY:Number = 0;

        /** @copy #minX */
        public var minZ:Number = 0;

        /** @copy #minX */
        public var maxX:Number = 0;

        /** @copy #minX */
        public var maxY:Number = 0;

        /** @copy #minX */
        public var maxZ:Number = 0;

        /** The origin of the ray that a search is about. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** The direction of the ray, of any length: distances along the ray are multiples of it. */
        public var directionX:Number = 0;

        /** @copy #directionX */
        public var directionY:Number = 0;

        /** @copy #directionX */
        public var directionZ:Number = 0;

        /** How far along the ray boxes count; may be made smaller during the search. */
        public var limit:Number = Infinity;

        /** How far along the ray the box is of the row that was last found; 0 if the ray's origin is in it. */
        public var entry:Number = 0;

        /** What findOverlapping has found. */
        public var found:Vector.<int> = new Vector.<int>();

        private var _places:PlaceTree;
        private var _table:AgentTable;

        // The least x, y, z, then the greatest: of the nodes, as in PlaceTree, and of the rows in the order of the leaves.
        private var _nodeBoxes:Vector.<Number> = new Vector.<Number>();
        private var _rowBoxes:Vector.<Number> = new Vector.<Number>();

        // Nodes that are to be visited yet, and how far along the ray they are; the rows of the leaf under way.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _entries:Vector.<Number> = new Vector.<Number>();
        private var _waiting:int = 0;
        private var _at:int = 0;
        private var _end:int = 0;

        // How far a box may be missed by a ray from its origin, because of rounding.
        private var _slack:Number = 0;

        /** An empty tree. */
        public function ExtentsTree()
        {
        }

        /**
         * Makes the boxes anew.
         *
         * @param places a tree that was made of the places of the same rows
         * @param table has the rows and their extents
         */
        public function build(places:PlaceTree, table:AgentTable):void
        {
            _places = places;
            _table = table;
            var count:int = places.count;
            var leaves:int = places.firstLeaf;
            if (_rowBoxes.length < PER_BOX * count)
            {
                _rowBoxes.length = PER_BOX * count;
                found.length = count;
            }
            if (_nodeBoxes.length < 2 * leaves * PER_BOX)
            {
                _nodeBoxes.length = 2 * leaves * PER_BOX;
            }
            for (var node:int = leaves; node < 2 * leaves; node++)
            {
                var box:int = PER_BOX * node;
                empty(_nodeBoxes, box);
                var end:int = places.startOf(node + 1);
                for (var at:int = places.startOf(node); at < end; at++)
                {
                    boundRow(at);
                    widen(box, _rowBoxes, PER_BOX * at);
                }
            }
            for (node = leaves - 1; node > 0; node--)
            {
                box = PER_BOX * node;
                empty(_nodeBoxes, box);
                widen(box, _nodeBoxes, 2 * box);
                widen(box, _nodeBoxes, 2 * box + PER_BOX);
            }
        }

        /** Takes the extents of one row anew; the boxes about it grow. */
        public function move(member:int):void
        {
            var at:int = _places.orderOf(member);
            boundRow(at);
            for (var node:int = _places.leafOf(at); node > 0; node >>= 1)
            {
                widen(PER_BOX * node, _rowBoxes, PER_BOX * at);
            }
        }

        /** Makes the box that a search is about those of extents as BoundingStructure.extentsInto writes them, wider by what rounding comes to. */
        public function setBoxTo(extents:Vector.<Number>):void
        {
            var slack:Number = Tolerances.EXTENTS * (extents[1] - extents[0] + extents[3] - extents[2] + extents[5] - extents[4])
                + Tolerances.EXTENTS_GAPS * (Tolerances.PLACES * (Math.abs(extents[0]) + Math.abs(extents[2]) + Math.abs(extents[4])));
            minX = extents[0] - slack;
            maxX = extents[1] + slack;
            minY = extents[2] - slack;
            maxY = extents[3] + slack;
            minZ = extents[4] - slack;
            maxZ = extents[5] + slack;
        }

        /** Makes the box that a search is about the extents of a row, wider by what rounding comes to. */
        public function setBox(row:int):void
        {
            var extents:Extents = _table.extents;
            var atX:Number = extents.x[row];
            var atY:Number = extents.y[row];
            var atZ:Number = extents.z[row];
            var halfX:Number = extents.halfX[row];
            var halfY:Number = extents.halfY[row];
            var halfZ:Number = extents.halfZ[row];
            var slack:Number = Tolerances.EXTENTS * (halfX + halfY + halfZ) + Tolerances.EXTENTS_GAPS * Tolerances.PLACES * (Math.abs(atX) + Math.abs(atY) + Math.abs(atZ));
            minX = atX - halfX - slack;
            minY = atY - halfY - slack;
            minZ = atZ - halfZ - slack;
            maxX = atX + halfX + slack;
            maxY = atY + halfY + slack;
            maxZ = atZ + halfZ + slack;
        }

        /** Makes the box reach as far as it does when it is moved along the direction, by all of it, and still to where it is. */
        public function extendBox():void
        {
            if (directionX < 0)
            {
                minX += directionX;
            }
            else
            {
                maxX += directionX;
            }
            if (directionY < 0)
            {
                minY += directionY;
            }
            else
            {
                maxY += directionY;
            }
            if (directionZ < 0)
            {
                minZ += directionZ;
            }
            else
            {
                maxZ += directionZ;
            }
        }

        /**
         * Finds all rows whose extents overlap the box, or nearly so: <code>found</code>, in no order.
         *
         * @return how many
         */
        public function findOverlapping():int
        {
            var length:int = 0;
            var waiting:int = begin();
            while (waiting > 0)
            {
                waiting--;
                var node:int = _nodes[waiting];
                if (!overlaps(_nodeBoxes, PER_BOX * node))
                {
                    continue;
                }
                if (node < _places.firstLeaf)
                {
                    _nodes[waiting] = (node << 1) + 1;
                    _nodes[waiting + 1] = node << 1;
                    waiting += 2;
                    continue;
                }
                var end:int = _places.startOf(node + 1);
                for (var at:int = _places.startOf(node); at < end; at++)
                {
                    if (overlaps(_rowBoxes, PER_BOX * at))
                    {
                        found[length] = _places.members[at];
                        length++;
                    }
                }
            }
            return length;
        }

        /** Begins a search along the ray: <code>nextOnRay()</code> then finds one row after the other. */
        public function beginRay():void
        {
            // as in setBox
            _slack = Tolerances.EXTENTS_GAPS * Tolerances.PLACES * (Math.abs(x) + Math.abs(y) + Math.abs(z));
            _at = _end = 0;
            _waiting = begin();
        }

        /**
         * The next row whose box the ray meets within the limit: nearly the nearest first, by leaves.
         *
         * @return its number in the list, with its distance in <code>entry</code>; -1 if there is none any more
         */
        public function nextOnRay():int
        {
            while (true)
            {
                while (_at < _end)
                {
                    var isMet:Boolean = meets(_rowBoxes, PER_BOX * _at);
                    _at++;
                    if (isMet)
                    {
                        return _places.members[_at - 1];
                    }
                }
                if (_waiting == 0)
                {
                    return -1;
                }
                _waiting--;
                if (_entries[_waiting] <= limit)
                {
                    visit(_nodes[_waiting]);
                }
            }
            return -1;
        }

        private function begin():int
        {
            _nodes[0] = 1;
            _entries[0] = 0;
            return _places != null && _places.count > 0 ? 1 : 0;
        }

        // Begins with a leaf, or has the children of a node wait that the ray meets, the nearer to be the next.
        private function visit(node:int):void
        {
            if (node >= _places.firstLeaf)
            {
                _at = _places.startOf(node);
                _end = _places.startOf(node + 1);
                return;
            }
            var child:int = node << 1;
            if (meets(_nodeBoxes, PER_BOX * child))
            {
                _nodes[_waiting] = child;
                _entries[_waiting] = entry;
                _waiting++;
            }
            child++;
            if (meets(_nodeBoxes, PER_BOX * child))
            {
                _nodes[_waiting] = child;
                _entries[_waiting] = entry;
                _waiting++;
                if (_waiting > 1 && _nodes[_waiting - 2] == child - 1 && _entries[_waiting - 2] < entry)
                {
                    _nodes[_waiting - 1] = child - 1;
                    _nodes[_waiting - 2] = child;
                    _entries[_waiting - 1] = _entries[_waiting - 2];
                    _entries[_waiting - 2] = entry;
                }
            }
        }

        private function overlaps(boxes:Vector.<Number>, box:int):Boolean
        {
            return boxes[box] <= maxX && boxes[int(box + 3)] >= minX && boxes[int(box + 1)] <= maxY && boxes[int(box + 4)] >= minY
                && boxes[int(box + 2)] <= maxZ && boxes[int(box + 5)] >= minZ;
        }

        // Whether the ray meets a box within the limit; entry says where (the method of slabs: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986).
        private function meets(boxes:Vector.<Number>, box:int):Boolean
        {
            var enters:Number = 0;
            var leaves:Number = limit;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var from:Number = x;
                var along:Number = directionX;
                if (axis > 0)
                {
                    from = axis == 1 ? y : z;
                    along = axis == 1 ? directionY : directionZ;
                }
                var least:Number = boxes[int(box + axis)] - _slack - from;
                var greatest:Number = boxes[int(box + 3 + axis)] + _slack - from;
                if (along == 0 || least > greatest)
                {
                    if (least > 0 || greatest < 0)
                    {
                        return false;
                    }
                    continue;
                }
                var near:Number = least / along;
                var far:Number = greatest / along;
                if (near > far)
                {
                    var swapped:Number = near;
                    near = far;
                    far = swapped;
                }
                if (near > enters)
                {
                    enters = near;
                }
                if (far < leaves)
                {
                    leaves = far;
                }
            }
            entry = enters;
            return enters <= leaves;
        }

        // The box of a row: for one whose model is loading one that nothing overlaps.
        private function boundRow(at:int):void
        {
            var row:int = _table.rows[_places.members[at]];
            var box:int = PER_BOX * at;
            if (_table.shapes[row] == null)
            {
                empty(_rowBoxes, box);
                return;
            }
            setBox(row);
            _rowBoxes[box] = minX;
            _rowBoxes[int(box + 1)] = minY;
            _rowBoxes[int(box + 2)] = minZ;
            _rowBoxes[int(box + 3)] = maxX;
            _rowBoxes[int(box + 4)] = maxY;
            _rowBoxes[int(box + 5)] = maxZ;
        }

        private static function empty(boxes:Vector.<Number>, box:int):void
        {
            boxes[box] = boxes[int(box + 1)] = boxes[int(box + 2)] = Infinity;
            boxes[int(box + 3)] = boxes[int(box + 4)] = boxes[int(box + 5)] = -Infinity;
        }

        // Makes a node's box contain another.
        private function widen(box:int, others:Vector.<Number>, other:int):void
        {
            var boxes:Vector.<Number> = _nodeBoxes;
            for (var i:int = 0; i < 3; i++)
            {
                var least:Number = others[int(other + i)];
                if (least < boxes[int(box + i)])
                {
                    boxes[int(box + i)] = least;
                }
                var greatest:Number = others[int(other + 3 + i)];
                if (greatest > boxes[int(box + 3 + i)])
                {
                    boxes[int(box + 3 + i)] = greatest;
                }
            }
        }
    }
}
