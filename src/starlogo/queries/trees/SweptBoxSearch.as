package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Finds the rows of a tree whose boxes a moving box meets, and that a Collector wants. It returns one row at a time. If the box moves, nearer nodes come
     * first. The rows of a leaf come in no order. A ray is a moving box without size. A box that stands still has a motion without length.
     *
     * @private
     */
    public final class SweptBoxSearch
    {
        private var _tree:RowTree = null;

        // Whether the row of the ground has not been returned yet.
        private var _isGroundLeft:Boolean = false;

        private var _isMoving:Boolean = false;

        // The way by axis, if the box moves; the box where the way begins; and the box around the whole way. The boxes are like those of a RowTree.
        private var _along:Vector.<Number> = new Vector.<Number>(3, true);
        private var _box:Vector.<Number> = new Vector.<Number>(RowTree.PER_BOX, true);
        private var _around:Vector.<Number> = new Vector.<Number>(RowTree.PER_BOX, true);

        // What waits, a stack: the number of a node, or -1 - slot for a row; and where on the way the box meets it.
        private var _stack:Vector.<int> = new Vector.<int>();
        private var _entries:Vector.<Number> = new Vector.<Number>();
        private var _waiting:int = 0;

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
        public function setTo(tree:RowTree, x:Number, y:Number, z:Number, halfX:Number = 0, halfY:Number = 0, halfZ:Number = 0, offset:Number = 0):void
        {
            var slack:Number = RowTree.slackOf(x, y, z, halfX + halfY + halfZ, offset);
            _tree = tree;
            _isGroundLeft = true;
            _isMoving = false;
            _around[0] = x - halfX - slack;
            _around[1] = y - halfY - slack;
            _around[2] = z - halfZ - slack;
            _around[3] = x + halfX + slack;
            _around[4] = y + halfY + slack;
            _around[5] = z + halfZ + slack;
            _stack[0] = RowTree.ROOT;
            _entries[0] = 0;
            _waiting = tree.count > 0 ? 1 : 0;
        }

        /**
         * Begins with the extents of a body. The ground and the edges of the world are near all rows.
         *
         * @param tree has the extents of rows
         */
        public function setAround(tree:RowTree, body:Body):void
        {
            setTo(tree, body.middleX, body.middleY, body.middleZ, body.halfX, body.halfY, body.halfZ, body.distanceFromPlace);
            if (body.isEnvironment)
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
            _isMoving = true;
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
         * The next row that a collector wants and that has a shape; -1 if there are no more. The last one is the row of the ground, which is in no tree,
         * because it is near every row.
         *
         * @param collector has the filter. Its limit says how much of a motion is still searched, as a multiple of its vector
         */
        public function next(collector:Collector):int
        {
            var breedSet:int = collector.filter.breedSet;
            for (var row:int = nextInTree(breedSet, collector.limit); row >= 0; row = nextInTree(breedSet, collector.limit))
            {
                if (collector.mayWant(row))
                {
                    return row;
                }
                _tree.excludedCount++;
            }
            var isGround:Boolean = _isGroundLeft && collector.mayWant(ListedAgents.GROUND_ROW);
            _isGroundLeft = false;
            return isGround ? ListedAgents.GROUND_ROW : -1;
        }

        /**
         * The next row of the tree that the box meets, or -1 if there are no more.
         *
         * @param breedSet the breeds that count, see RowTree. Nodes without them are skipped, but single rows may have others
         * @param limit if the box moves: how much of the motion is still searched, as a multiple of its vector. It may become less during the search
         */
        public function nextInTree(breedSet:int, limit:Number):int
        {
            while (_waiting > 0)
            {
                _waiting--;
                var next:int = _stack[_waiting];
                if (_isMoving && _entries[_waiting] > limit)
                {
                    continue;
                }
                if (next < 0)
                {
                    return _tree.rows[-1 - next];
                }
                if (!_tree.mayHave(next, breedSet))
                {
                    continue;
                }
                if (next < _tree.firstLeaf)
                {
                    push(_tree.nodeBoxes, next << 1, (next << 1) + 2, false, limit);
                }
                else
                {
                    push(_tree.rowBoxes, _tree.startOf(next), _tree.startOf(next + 1), true, limit);
                }
            }
            return -1;
        }

        // Lets those of some boxes wait that the box meets on its way. Of two, the nearer one comes next.
        private function push(boxes:Vector.<Number>, first:int, end:int, areSlots:Boolean, limit:Number):void
        {
            var minX:Number = _around[0];
            var minY:Number = _around[1];
            var minZ:Number = _around[2];
            var maxX:Number = _around[3];
            var maxY:Number = _around[4];
            var maxZ:Number = _around[5];
            var count:int = _waiting;
            for (var i:int = first; i < end; i++)
            {
                var box:int = RowTree.PER_BOX * i;
                if (boxes[box] > maxX || boxes[int(box + 3)] < minX || boxes[int(box + 1)] > maxY || boxes[int(box + 4)] < minY
                        || boxes[int(box + 2)] > maxZ || boxes[int(box + 5)] < minZ)
                {
                    continue;
                }
                if (!_isMoving || findEntry(boxes, box, limit, _entries, count))
                {
                    _stack[count] = areSlots ? -1 - i : i;
                    count++;
                }
            }
            if (_isMoving && count == _waiting + 2 && _entries[_waiting] < _entries[int(_waiting + 1)])
            {
                var nearer:int = _stack[_waiting];
                _stack[_waiting] = _stack[int(_waiting + 1)];
                _stack[int(_waiting + 1)] = nearer;
                var entry:Number = _entries[_waiting];
                _entries[_waiting] = _entries[int(_waiting + 1)];
                _entries[int(_waiting + 1)] = entry;
            }
            _waiting = count;
        }

        // Finds where on the way the box meets another (the method of slabs: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986). A list receives it, because
        // V8 would box a Number that is returned. Returns whether it is within the limit.
        private function findEntry(boxes:Vector.<Number>, box:int, limit:Number, out:Vector.<Number>, index:int):Boolean
        {
            var enters:Number = 0;
            var leaves:Number = limit;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var along:Number = _along[axis];
                if (along == 0)
                {
                    // along this axis the box around the way is the box itself, which was tested before
                    continue;
                }
                var toLeast:Number = (boxes[int(box + axis)] - _box[int(axis + 3)]) / along;
                var toGreatest:Number = (boxes[int(box + 3 + axis)] - _box[axis]) / along;
                var near:Number = along > 0 ? toLeast : toGreatest;
                var far:Number = along > 0 ? toGreatest : toLeast;
                enters = near > enters ? near : enters;
                leaves = far < leaves ? far : leaves;
            }
            out[index] = enters;
            return enters <= leaves;
        }
    }
}
