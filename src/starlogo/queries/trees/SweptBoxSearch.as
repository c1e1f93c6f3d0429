package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Finds the rows of a tree whose boxes a moving box meets. It returns one row at a time. If the box moves, nearer nodes come first. The rows
     * of a leaf come in no order. A ray is a moving box without size. A box that stands still has a motion without length.
     *
     * @private
     */
    public final class SweptBoxSearch
    {
        /** The tree of the present search. Read only. */
        public var tree:RowTree = null;

        // How much of the motion is still searched, as a multiple of its vector.
        private var _limit:Number = 1;

        private var _moves:Boolean = false;

        // The way by axis, if the box moves; the box where the way begins; and the box around the whole way. The boxes are like those of a RowTree.
        private var _along:Vector.<Number> = new Vector.<Number>(3, true);
        private var _box:Vector.<Number> = new Vector.<Number>(RowTree.PER_BOX, true);
        private var _around:Vector.<Number> = new Vector.<Number>(RowTree.PER_BOX, true);

        // The nodes that wait for a visit, and where on the way the box meets them.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _entries:Vector.<Number> = new Vector.<Number>();
        private var _waiting:int = 0;

        // The slots of the current leaf whose boxes overlap the box around the way, and how many of them are left.
        private var _slots:Vector.<int> = new Vector.<int>();
        private var _slotsLeft:int = 0;

        /**
         * Begins with a box that stands still. Call <code>widen()</code> or <code>moveAlong()</code> afterwards if needed.
         *
         * @param tree has the rows
         * @param x the box's middle
         * @param y the box's middle
         * @param z the box's middle
         * @param halfX half of its length along x
         * @param halfY half of its length along y
         * @param halfZ half of its length along z
         * @param offset how far the middle is from the place that it was computed from
         */
        public function begin(tree:RowTree, x:Number, y:Number, z:Number, halfX:Number = 0, halfY:Number = 0, halfZ:Number = 0, offset:Number = 0):void
        {
            var slack:Number = RowTree.slackOf(x, y, z, halfX + halfY + halfZ, offset);
            this.tree = tree;
            _moves = false;
            _around[0] = x - halfX - slack;
            _around[1] = y - halfY - slack;
            _around[2] = z - halfZ - slack;
            _around[3] = x + halfX + slack;
            _around[4] = y + halfY + slack;
            _around[5] = z + halfZ + slack;
            _slotsLeft = 0;
            _nodes[0] = RowTree.ROOT;
            _entries[0] = 0;
            _waiting = tree.count > 0 ? 1 : 0;
        }

        /**
         * Begins with the extents of a body. The ground and the edges of the world are near all rows.
         *
         * @param tree has the extents of rows
         */
        public function beginAround(tree:RowTree, body:Body):void
        {
            begin(tree, body.x, body.y, body.z, body.halfX, body.halfY, body.halfZ, body.offset);
            if (body.isOfWorld)
            {
                widen(4 * Agent.LARGEST_COORDINATE);
            }
        }

        /**
         * Makes the box larger. The box must stand still.
         *
         * @param by how far on all sides
         * @param up how much farther upwards
         * @param down how much farther downwards
         */
        public function widen(by:Number, up:Number = 0, down:Number = 0):void
        {
            _around[0] -= by;
            _around[1] -= by;
            _around[2] -= by + down;
            _around[3] += by;
            _around[4] += by;
            _around[5] += by + up;
        }

        /**
         * Lets the box move.
         *
         * @param dx the way along x
         * @param dy the way along y
         * @param dz the way along z
         * @param limit how much of the motion is searched, as a multiple of its vector
         */
        public function moveAlong(dx:Number, dy:Number, dz:Number, limit:Number):void
        {
            _moves = true;
            _along[0] = dx;
            _along[1] = dy;
            _along[2] = dz;
            for (var axis:int = 0; axis < 3; axis++)
            {
                _box[axis] = _around[axis];
                _box[axis + 3] = _around[axis + 3];
                // 0 times Infinity is not a number
                if (_along[axis] < 0)
                {
                    _around[axis] += limit * _along[axis];
                }
                if (_along[axis] > 0)
                {
                    _around[axis + 3] += limit * _along[axis];
                }
            }
        }

        /**
         * The next row, or -1 if there are no more.
         *
         * @param breedSet the breeds that count, see RowTree. Nodes without them are skipped, but single rows may have others
         * @param limit if the box moves: how much of the motion is still searched, as a multiple of its vector. It may become less during the search
         */
        public function next(breedSet:int, limit:Number):int
        {
            _limit = limit;
            while (_slotsLeft > 0 || _waiting > 0)
            {
                if (_slotsLeft > 0)
                {
                    _slotsLeft--;
                    var slot:int = _slots[_slotsLeft];
                    // its entry is written behind those of the nodes that wait, and not used
                    if (!_moves || findEntry(tree.rowBoxes, RowTree.PER_BOX * slot, _entries, _waiting))
                    {
                        return tree.rows[slot];
                    }
                    continue;
                }
                _waiting--;
                if (!_moves || _entries[_waiting] <= limit)
                {
                    visit(_nodes[_waiting], breedSet);
                }
            }
            return -1;
        }

        // Finds the rows of a leaf, or puts the children of a node on the waiting list.
        private function visit(node:int, breedSet:int):void
        {
            if (!tree.mayHave(node, breedSet))
            {
                return;
            }
            if (node >= tree.firstLeaf)
            {
                _slotsLeft = findOverlapping(tree.rowBoxes, tree.startOf(node), tree.startOf(node + 1), _slots, 0);
                return;
            }
            var first:int = _waiting;
            _waiting = findOverlapping(tree.nodeBoxes, node << 1, (node << 1) + 2, _nodes, first);
            if (_moves)
            {
                keepOnWay(first);
            }
        }

        // Finds the boxes that overlap the box around the way. It appends their numbers to the first entries of a list, and returns the new
        // number of entries.
        private function findOverlapping(boxes:Vector.<Number>, first:int, end:int, out:Vector.<int>, count:int):int
        {
            var minX:Number = _around[0];
            var minY:Number = _around[1];
            var minZ:Number = _around[2];
            var maxX:Number = _around[3];
            var maxY:Number = _around[4];
            var maxZ:Number = _around[5];
            for (var i:int = first; i < end; i++)
            {
                var box:int = RowTree.PER_BOX * i;
                if (boxes[box] > maxX)
                {
                    continue;
                }
                if (boxes[int(box + 3)] < minX)
                {
                    continue;
                }
                if (boxes[int(box + 1)] > maxY)
                {
                    continue;
                }
                if (boxes[int(box + 4)] < minY)
                {
                    continue;
                }
                if (boxes[int(box + 2)] > maxZ)
                {
                    continue;
                }
                if (boxes[int(box + 5)] < minZ)
                {
                    continue;
                }
                out[count] = i;
                count++;
            }
            return count;
        }

        // Of the last two nodes on the waiting list, it keeps only nodes that the box meets on its way. The nearer one will be visited next.
        private function keepOnWay(first:int):void
        {
            var kept:int = first;
            for (var i:int = first; i < _waiting; i++)
            {
                if (findEntry(tree.nodeBoxes, RowTree.PER_BOX * _nodes[i], _entries, kept))
                {
                    _nodes[kept] = _nodes[i];
                    kept++;
                }
            }
            _waiting = kept;
            var second:int = first + 1;
            if (kept > second && _entries[first] < _entries[second])
            {
                var nearer:int = _nodes[first];
                _nodes[first] = _nodes[second];
                _nodes[second] = nearer;
                var entry:Number = _entries[first];
                _entries[first] = _entries[second];
                _entries[second] = entry;
            }
        }

        // Finds where on the way the box meets another (the method of slabs: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986). A list receives it, because
        // V8 would box a Number that is returned. Returns whether it is within the limit.
        private function findEntry(boxes:Vector.<Number>, box:int, out:Vector.<Number>, index:int):Boolean
        {
            var enters:Number = 0;
            var leaves:Number = _limit;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var along:Number = _along[axis];
                if (along == 0)
                {
                    // along this axis the box around the way is the box itself, which was tested before
                    continue;
                }
                var near:Number = (boxes[int(box + axis)] - _box[int(axis + 3)]) / along;
                var far:Number = (boxes[int(box + 3 + axis)] - _box[axis]) / along;
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
            out[index] = enters;
            return enters <= leaves;
        }
    }
}
