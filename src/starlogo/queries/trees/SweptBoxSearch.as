package starlogo.queries.trees
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.data.SortableIntList;
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

        // A stack of the nodes that are still to be visited, and when the box meets each.
        private var _stack:SortableIntList = new SortableIntList();

        // The slots that are left of the leaf that is visited.
        private var _slot:int = 0;
        private var _endSlot:int = 0;

        /**
         * Begins with a point that stands still: a box without size. Call <code>inflate()</code> or <code>moveAlong()</code> afterwards if needed.
         *
         * @param tree has the rows
         */
        public function setTo(tree:RowTree, place:Vector3D):void
        {
            _box[0] = _box[3] = place.x;
            _box[1] = _box[4] = place.y;
            _box[2] = _box[5] = place.z;
            begin(tree, RowTree.slackOf(place.x, place.y, place.z, 0, 0));
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
            _slot = _endSlot = 0;
            _stack.count = 0;
            if (tree.count > 0)
            {
                _stack.add(RowTree.ROOT, 0);
            }
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
        public function moveAlong(motion:Vector3D):void
        {
            _inverse[0] = motion.x == 0 ? 0 : 1 / motion.x;
            _inverse[1] = motion.y == 0 ? 0 : 1 / motion.y;
            _inverse[2] = motion.z == 0 ? 0 : 1 / motion.z;
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
            while (_slot < _endSlot || _stack.count > 0)
            {
                if (_slot == _endSlot)
                {
                    visitNode(collector.filter.breedSet, collector.limit);
                    continue;
                }
                var slot:int = _slot++;
                if (findEntry(_tree.rowBoxes, RowTree.PER_BOX * slot, collector.limit))
                {
                    var row:int = _tree.rows[slot];
                    if (collector.mayWant(row))
                    {
                        return row;
                    }
                    _tree.excludedCount++;
                }
            }
            var isGround:Boolean = _isGroundLeft && collector.mayWant(ListedAgents.GROUND_ROW);
            _isGroundLeft = false;
            return isGround ? ListedAgents.GROUND_ROW : -1;
        }

        // Takes a node from the stack. The slots of a leaf come next. The children whose boxes the moving box meets are pushed, the nearer one last.
        private function visitNode(breedSet:int, limit:Number):void
        {
            _stack.count--;
            var first:int = _stack.count;
            var node:int = _stack.values[first];
            if (_stack.keys[first] > limit || !_tree.mayHave(node, breedSet))
            {
                return;
            }
            if (node >= _tree.firstLeaf)
            {
                _slot = _tree.startOf(node);
                _endSlot = _tree.startOf(node + 1);
                return;
            }
            for (var child:int = node << 1; child <= (node << 1) + 1; child++)
            {
                if (findEntry(_tree.nodeBoxes, RowTree.PER_BOX * child, limit))
                {
                    _stack.values[_stack.count] = child;
                    _stack.count++;
                }
            }
            putNearestLast(_stack, first);
        }

        // Finds where on the way the box meets another (the method of slabs: Kay and Kajiya, "Ray Tracing Complex Scenes", 1986). It becomes the next key of the
        // stack, because V8 would box a Number that is returned. Returns whether it is within the limit.
        private function findEntry(boxes:Vector.<Number>, box:int, limit:Number):Boolean
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
            _stack.keys[_stack.count] = enters;
            return true;
        }
    }
}
