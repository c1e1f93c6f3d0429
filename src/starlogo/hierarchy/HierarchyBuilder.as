package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Builds a hierarchy from the root down (thesis §4.4).
     *
     * <p>What is divided are items: triangles, or vertices where there are none. See NodeDivider for how.</p>
     *
     * <p>The work is done in steps, a millisecond or two each for thousands of items. For the engine; a client has the
     * HierarchiesLibrary.</p>
     *
     * @private
     */
    public final class HierarchyBuilder implements Steps
    {
        // About how much a step does, and how many items making a node takes as long as.
        private static const ITEMS_A_STEP:int = 1000;
        private static const ITEMS_A_NODE:int = 10;

        private static const BEGINNING:int = 0;
        private static const READING:int = 1;
        private static const MEASURING:int = 2;
        private static const ROOTING:int = 3;
        private static const DIVIDING:int = 4;
        private static const ENCLOSING:int = 5;
        private static const COVERING:int = 6;
        private static const PREPARING:int = 7;
        private static const DONE:int = 8;

        private var _minVerticesToSplit:int;
        private var _maxDepth:int;
        private var _splitByMean:Boolean;
        private var _boundsKind:int;
        private var _preparesExact:Boolean;

        // The build under way.
        private var _hierarchy:Hierarchy;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _items:Items;
        private var _tree:StoredTree = null;
        private var _maker:NodeMaker;
        private var _divider:NodeDivider;
        private var _isDividing:Boolean = false;
        private var _nodes:Vector.<HierarchyNode>;
        private var _structures:NodeStructures;
        private var _solid:SolidBuilder;
        private var _phase:int;
        private var _next:int;

        /**
         * @param minVerticesToSplit a node of no more vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         * @param boundsKind which structures the nodes have
         * @param preparesExact whether to prepare what exact tests need of triangles, rather than leave it to the first of them
         */
        public function HierarchyBuilder(minVerticesToSplit:int, maxDepth:int, splitByMean:Boolean, boundsKind:int,
                preparesExact:Boolean = false)
        {
            _minVerticesToSplit = minVerticesToSplit;
            _maxDepth = maxDepth;
            _splitByMean = splitByMean;
            _boundsKind = boundsKind;
            _preparesExact = preparesExact;
        }

        /** Begins a hierarchy of triangles, or of vertices where triangles is null. It keeps both lists. */
        public function begin(vertices:Vector.<Number>, triangles:Vector.<uint>):void
        {
            _hierarchy = new Hierarchy(vertices, triangles);
            _hierarchy.boundsKind = _boundsKind;
            _vertices = vertices;
            _triangles = triangles;
            _phase = BEGINNING;
        }

        /**
         * Spares most of the work, if what is given is true; what turns out not to be is done anyhow. To be called between
         * <code>begin()</code> and the first step.
         *
         * @param tree how the items were divided, not begun
         * @param notes what was noted of the surface; null for nothing
         */
        public function take(tree:StoredTree, notes:SurfaceNotes):void
        {
            _tree = tree;
            _hierarchy.notes = notes;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the model's extent is not finite
         */
        public function step():Boolean
        {
            switch (_phase)
            {
                case BEGINNING:
                    beginItems();
                    break;
                case READING:
                    if (!_tree.step())
                    {
                        takeNodes();
                    }
                    break;
                case MEASURING:
                    measureSome();
                    break;
                case ROOTING:
                    makeRoot();
                    break;
                case DIVIDING:
                    divideSome();
                    break;
                case ENCLOSING:
                    encloseSome();
                    break;
                case COVERING:
                    coverSome();
                    break;
                case PREPARING:
                    if (!_solid.step())
                    {
                        _hierarchy.takeSolid(_solid);
                        _phase = DONE;
                    }
                    break;
            }
            return _phase != DONE;
        }

        /** The hierarchy, when no step is left. */
        public function get hierarchy():Hierarchy
        {
            return _hierarchy;
        }

        /** Whether no step is left. */
        public function get isDone():Boolean
        {
            return _phase == DONE;
        }

        /** The hierarchy; what is left to do of it is done now. */
        public function get finished():Hierarchy
        {
            if (_phase != DONE)
            {
                finish(this);
            }
            return _hierarchy;
        }

        /** Whether it makes what is known again, rather than divide the items: until that turns out not to be true. */
        public function get isTaken():Boolean
        {
            return _tree != null;
        }

        private function beginItems():void
        {
            _items = new Items(_vertices, _triangles);
            _hierarchy.order = _items.order;
            _phase = MEASURING;
            _next = 0;
            if (_tree != null)
            {
                _tree.start(_hierarchy, _vertices, _triangles, _maxDepth);
                _phase = READING;
            }
        }

        private function takeNodes():void
        {
            _nodes = _tree.nodes;
            _maker = _tree.maker;
            if (_nodes == null)
            {
                _tree = null;
                _phase = MEASURING;
                return;
            }
            encloseNodes();
        }

        private function measureSome():void
        {
            var end:int = Math.min(_next + ITEMS_A_STEP, _items.count);
            _items.measure(_next, end);
            _next = end;
            if (end == _items.count)
            {
                _phase = ROOTING;
                _next = 0;
            }
        }

        private function makeRoot():void
        {
            var extents:Vector.<Number> = _items.extents;
            _maker = new NodeMaker(_hierarchy, extents);
            _divider = new NodeDivider(_hierarchy, _items, _maker, _minVerticesToSplit, _splitByMean);
            var root:HierarchyNode = _maker.make(1, 0, _items.count, extents);
            if (root.radius - root.radius != 0)
            {
                throw new ArgumentError("the coordinates are too large: the model's extent is not a finite number");
            }
            _hierarchy.root = root;
            _nodes = new <HierarchyNode>[root];
            _phase = DIVIDING;
        }

        private function divideSome():void
        {
            var left:int = ITEMS_A_STEP;
            // children are appended while their parents are divided
            while (left > 0 && _next < _nodes.length)
            {
                var node:HierarchyNode = _nodes[_next];
                if (!_isDividing)
                {
                    _isDividing = node.level < _maxDepth && _divider.begin(node);
                    left -= ITEMS_A_NODE;
                }
                if (_isDividing)
                {
                    _isDividing = _divider.goOn(ITEMS_A_STEP);
                    left -= node.end - node.first;
                }
                if (!_isDividing)
                {
                    _next++;
                    if (!node.isLeaf)
                    {
                        _nodes.push(node.left, node.right);
                    }
                }
            }
            if (_next == _nodes.length)
            {
                encloseNodes();
            }
        }

        private function encloseNodes():void
        {
            if (_boundsKind == BoundingStructure.BOX)
            {
                finishNodes();
                return;
            }
            _structures = new NodeStructures(_boundsKind, _items, 2 * _maker.marginOf(1));
            _phase = ENCLOSING;
            _next = 0;
        }

        private function encloseSome():void
        {
            var items:int = 0;
            while (_next < _nodes.length)
            {
                var node:HierarchyNode = _nodes[_next++];
                _structures.enclose(node);
                items += node.end - node.first + ITEMS_A_NODE;
                if (items >= ITEMS_A_STEP)
                {
                    return;
                }
            }
            _phase = COVERING;
        }

        // From the last node up: children come after their parents.
        private function coverSome():void
        {
            var last:int = Math.max(0, _next - ITEMS_A_STEP / ITEMS_A_NODE);
            while (_next > last)
            {
                var node:HierarchyNode = _nodes[--_next];
                if (!node.isLeaf)
                {
                    _structures.cover(node);
                }
            }
            if (_next == 0)
            {
                finishNodes();
            }
        }

        private function finishNodes():void
        {
            _phase = DONE;
            if (_preparesExact && _hierarchy.hasTriangles)
            {
                _solid = _hierarchy.beginSolid();
                _phase = PREPARING;
            }
        }
    }
}
