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

        // The box where its motion begins, like those of a RowTree; and by axis, 1 divided by the motion, or 0 if it does not move along the axis.
        private var _box:Vector.<Number> = new Vector.<Number>(RowTree.PER_BOX, true);
        private var _inverse:Vector.<Number> = new Vector.<Number>(3, true);

        // A stack of what is still to be visited: the number of a node, or -1 - slot for a row; and when the box meets it.
        private var _stack:Vector.<int> = new Vector.<int>();
        private var _entries:Vector.<Number> = new Vector.<Number>();
        private var _waiting:int = 0;

        /**
         * Begins with a point that stands still: a box without size. Call <code>inflate()</code> or <code>moveAlong()</code> afterwards if needed.
         *
         * @param tree has the rows
         */
        public function setTo(tree:RowTree, x:Number, y:Number, z:Number):void
        {
            _box[0] = _box[3] = x;
            _box[1] = _box[4] = y;
            _box[2] = _box[5] = z;
            begin(tree, RowTree.slackOf(x, y, z, 0, 0));
        }

        /**
         * Begins with the extents of a body. The ground and the edges of the world are near all rows.
         *
         * @param tree has the extents of rows
         */
        public function setAround(tree:RowTree, body:Body):void
        {
            _box[0] = body.middleX - body.halfX;
            _box[1] = body.middleY - body.halfY;
            _box[2] = body.middleZ - body.halfZ;
            _box[3] = body.middleX + body.halfX;
            _box[4] = body.middleY + body.halfY;
            _box[5] = body.middleZ + body.halfZ;
            begin(tree, RowTree.slackOf(body.middleX, body.middleY, body.middleZ, body.halfX + body.halfY + body.halfZ, body.distanceFromPlace));
            if (body.isEnvironment)
            {
                inflate(4 * Agent.LARGEST_COORDINATE);
            }
        }

        // Begins with the box, made larger by its slack.
        private function begin(tree:RowTree, slack:Number):void
        {
            _tree = tree;
            _isGroundLeft = true;
            _inverse[0] = _inverse[1] = _inverse[2] = 0;
            _stack[0] = RowTree.ROOT;
            _entries[0] = 0;
            _waiting = tree.count > 0 ? 1 : 0;
            inflate(slack);
        }

        /**
         * Makes the box larger.
         *
         * @param by how far on all sides
         * @param up how much farther upwards
         * @param down how much farther downwards
         */
        public function inflate(by:Number, up:Number = 0, down:Number = 0):void
        {
            _box[0] -= by;
            _box[1] -= by;
            _box[2] -= by + down;
            _box[3] += by;
            _box[4] += by;
            _box[5] += by + up;
        }

        /** Lets the box move. */
        public function moveAlong(dx:Number, dy:Number, dz:Number):void
        {
            _inverse[0] = dx == 0 ? 0 : 1 / dx;
            _inverse[1] = dy == 0 ? 0 : 1 / dy;
            _inverse[2] = dz == 0 ? 0 : 1 / dz;
        }

        /**
         * The next row that a collector wants and that has a shape; -1 if there are no more. The last one is the row of the ground, which is in no tree,
         * because it is near every row.
         *
         * @param collector has the filter. Its limit says how much of the motion is still searched, as a multiple of its vector. It may become less during
         *     the search
         */
        public function next(collector:Collector):int
        {
            while (_waiting > 0)
            {
                _waiting--;
                var popped:int = _stack[_waiting];
                var limit:Number = collector.limit;
                if (_entries[_waiting] > limit || (popped >= 0 && !_tree.mayHave(popped, collector.filter.breedSet)))
                {
                    continue;
                }
                if (popped < 0)
                {
                    var row:int = _tree.rows[-1 - popped];
                    if (collector.mayWant(row))
                    {
                        return row;
                    }
                    _tree.excludedCount++;
                }
                else if (popped < _tree.firstLeaf)
                {
                    push(_tree.nodeBoxes, popped << 1, (popped << 1) + 2, false, limit);
                }
                else
                {
                    push(_tree.rowBoxes, _tree.startOf(popped), _tree.startOf(popped + 1), true, limit);
                }
            }
            var isGround:Boolean = _isGroundLeft && collector.mayWant(ListedAgents.GROUND_ROW);
            _isGroundLeft = false;
            return isGround ? ListedAgents.GROUND_ROW : -1;
        }

        // Pushes the nodes or slots on the stack whose boxes the moving box meets. Of two, the nearer one is popped first.
        private function push(boxes:Vector.<Number>, first:int, end:int, areSlots:Boolean, limit:Number):void
        {
            var count:int = _waiting;
            for (var i:int = first; i < end; i++)
            {
                if (findEntry(boxes, RowTree.PER_BOX * i, limit, _entries, count))
                {
                    _stack[count] = areSlots ? -1 - i : i;
                    count++;
                }
            }
            if (count == _waiting + 2 && _entries[_waiting] < _entries[int(_waiting + 1)])
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
                var inverse:Number = _inverse[axis];
                var toLeast:Number = boxes[int(box + axis)] - _box[int(axis + 3)];
                var toGreatest:Number = boxes[int(box + 3 + axis)] - _box[axis];
                if (inverse == 0)
                {
                    if (toLeast > 0 || toGreatest < 0)
                    {
                        return false;
                    }
                    continue;
                }
                toLeast *= inverse;
                toGreatest *= inverse;
                var near:Number = inverse > 0 ? toLeast : toGreatest;
                var far:Number = inverse > 0 ? toGreatest : toLeast;
                enters = near > enters ? near : enters;
                leaves = far < leaves ? far : leaves;
                if (enters > leaves)
                {
                    return false;
                }
            }
            out[index] = enters;
            return true;
        }
    }
}
