package starlogo.hierarchy
{
    import starlogo.data.IntSet;
    import starlogo.geometry.Tolerances;
    import starlogo.steps.StepSequence;

    /**
     * Makes a tree of boxes from the root down (thesis §4.4): divides a node's primitives between two new nodes, and their primitives in turn.
     *
     * <p>In a tree of triangles it goes on below the leaves (see BoxTree), down to a few triangles each, for exact tests and rays.</p>
     *
     * <p>A primitive goes to the side of the split on which the centre of its extents is. The thesis splits halfway along the box's longest
     * axis, or at the mean. If that leaves all triangles on one side, the split is halfway along the axis on which their centres are spread
     * most. A node is a leaf if all its primitives have the same centre. Below the leaves such a node is divided by the number of its
     * primitives. So is every node there from level Tolerances.NESTED_LEVELS on. Models of many parallel needles would make trees as deep as the
     * number of their triangles otherwise.</p>
     *
     * <p>The thesis defines minVerticesToSplit in two ways: in §4.4 as the number of vertices up to which a node is not split, in §4.8 as
     * the smallest number that is split. A node with exactly that many vertices is a leaf here, as in §4.4, because §4.4 describes the
     * algorithm and §4.8 only lists its parameters.</p>
     *
     * <p>It works in steps, each of one or two milliseconds for thousands of primitives.</p>
     *
     * @private
     */
    public final class BoxTreeBuilder extends StepSequence
    {
        /** The most vertices of a leaf, and the levels of a tree, if a game does not say (thesis §4.4). */
        public static const DEFAULT_LEAF_VERTICES:int = 5;

        /** @copy #DEFAULT_LEAF_VERTICES */
        public static const DEFAULT_DEPTH:int = 10;

        // The most triangles of a node without children.
        private static const MAX_TRIANGLES:int = 8;

        // The approximate work of a step, in primitives. Making a node counts as PRIMITIVES_PER_NODE primitives.
        private static const PRIMITIVES_PER_STEP:int = 1000;
        private static const PRIMITIVES_PER_NODE:int = 10;

        private var _tree:BoxTree;
        private var _maxLeafVertices:int;
        private var _maxDepth:int;
        private var _splitByMean:Boolean;
        private var _partition:TreePartition;

        // For BoxTree.countVertices().
        private var _counted:IntSet = new IntSet();

        // The nodes still to visit, the next one last. Those below a node come before those beside it.
        private var _waiting:Vector.<int> = new <int>[0];

        // The level of the leaf that is visited, or below which nodes are visited; int.MAX_VALUE above the leaves.
        private var _leafLevel:int = int.MAX_VALUE;

        // Whether the next node is being divided.
        private var _isDividing:Boolean = false;

        /**
         * @param tree without nodes; receives them, and the order of its primitives
         * @param maxLeafVertices a node with at most this many vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean, down to the leaves
         */
        public function BoxTreeBuilder(tree:BoxTree, maxLeafVertices:int, maxDepth:int, splitByMean:Boolean)
        {
            _tree = tree;
            _maxLeafVertices = maxLeafVertices;
            _maxDepth = maxDepth;
            _splitByMean = splitByMean;
            call(takePrimitives);
        }

        /** Whether a node of a tree has so many triangles that it must be divided, below the leaves too. */
        public static function isLarge(tree:BoxTree, node:int):Boolean
        {
            return tree.hasTriangles && tree.endPrimitive[node] - tree.firstPrimitive[node] > MAX_TRIANGLES;
        }

        /**
         * Whether a node on a level below the leaves is divided in the middle of its primitives, wherever they are. So these levels are few, even if a
         * division by place takes one primitive at a time.
         */
        public static function isHalvedOnLevel(level:int):Boolean
        {
            return level >= Tolerances.NESTED_LEVELS;
        }

        private function takePrimitives():void
        {
            _partition = new TreePartition(_tree);
            slices(_tree.primitiveCount, PRIMITIVES_PER_STEP, _partition.measure).call(_partition.makeRoot).repeat(visitSome).call(_tree.completeNodes);
        }

        private function visitSome():Boolean
        {
            var rest:int = PRIMITIVES_PER_STEP;
            while (rest > 0 && _waiting.length > 0)
            {
                var node:int = _waiting[_waiting.length - 1];
                rest -= _isDividing ? _tree.endPrimitive[node] - _tree.firstPrimitive[node] : PRIMITIVES_PER_NODE;
                _isDividing = _isDividing ? advance(node) : beginNode(node);
                if (_isDividing)
                {
                    continue;
                }
                _waiting.pop();
                var child:int = _tree.left[node];
                if (child > 0)
                {
                    _waiting.push(child + 1, child);
                }
            }
            return _waiting.length > 0;
        }

        // Begins with a node. Returns whether it is to be divided.
        private function beginNode(node:int):Boolean
        {
            if (_tree.levelOf(node) <= _leafLevel)
            {
                _leafLevel = isSplit(node) ? int.MAX_VALUE : _tree.levelOf(node);
            }
            if (isLeafOrBelow(node) && !isLarge(_tree, node))
            {
                return false;
            }
            if (isLeafOrBelow(node) && isHalvedOnLevel(_tree.levelOf(node)))
            {
                _partition.halve(node);
            }
            else
            {
                _partition.begin(node, _splitByMean && !isLeafOrBelow(node));
            }
            return true;
        }

        // Whether the visited node is a leaf of the thesis, or below one.
        private function isLeafOrBelow(node:int):Boolean
        {
            return _tree.levelOf(node) >= _leafLevel;
        }

        // Whether the thesis splits a node.
        private function isSplit(node:int):Boolean
        {
            return _tree.levelOf(node) < _maxDepth && _tree.endPrimitive[node] - _tree.firstPrimitive[node] > 1
                && _tree.countVertices(node, _counted, _maxLeafVertices) > _maxLeafVertices;
        }

        // Continues with a node. Returns whether more remains to do.
        private function advance(node:int):Boolean
        {
            if (_partition.divideSome(PRIMITIVES_PER_STEP))
            {
                return true;
            }
            if (_partition.isOneSided)
            {
                return divideOtherwise(node);
            }
            if (_partition.measureSome(PRIMITIVES_PER_STEP))
            {
                return true;
            }
            _partition.makeChildren(isLeafOrBelow(node));
            return false;
        }

        // Divides a node again whose division has left a group without primitives. Returns whether there is a way.
        private function divideOtherwise(node:int):Boolean
        {
            if (_partition.beginWhereCentresSpread())
            {
                return true;
            }
            // All centres are in one place.
            _leafLevel = Math.min(_leafLevel, _tree.levelOf(node));
            if (!isLarge(_tree, node))
            {
                return false;
            }
            _partition.halve(node);
            return true;
        }
    }
}
