package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.hierarchy.Items;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Builds the tree in which rays look for a solid's triangles, in steps. Parts are divided as the hierarchy's are, halfway along the longest axis
     * of their extents; those whose triangles all have one centre, by number.
     */
    internal final class RayTreeBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 1000;
        private static const PER_EXTENTS:int = 6;

        // About how many triangles take as long as making a node.
        private static const TRIANGLES_PER_NODE:int = 4;

        private var _hierarchy:SolidHierarchy;
        private var _items:Items;
        private var _tree:RayTree = new RayTree();
        private var _margin:Number;

        // Parts that are to be divided yet: their first and last triangles, where they go among the children, and their extents.
        private var _first:Vector.<int> = new Vector.<int>();
        private var _end:Vector.<int> = new Vector.<int>();
        private var _child:Vector.<int> = new Vector.<int>();
        private var _extents:Vector.<Number> = new Vector.<Number>();
        private var _waiting:int = 0;

        // Whether the last of them is being divided, and no longer along its longest axis.
        private var _isDividing:Boolean = false;
        private var _isBySpread:Boolean = false;

        /**
         * @param hierarchy has a solid, and gets the tree
         */
        public function RayTreeBuilder(hierarchy:SolidHierarchy)
        {
            _hierarchy = hierarchy;
            _items = new Items(null, hierarchy.triangles, hierarchy.solid.extents);
            _tree.reach = reachOf(hierarchy.root);
            _margin = _tree.reach * (Tolerances.SURFACES + Tolerances.NESTING * Tolerances.NESTED_LEVELS);
            slices(_items.count, TRIANGLES_PER_STEP, _items.measure).call(beginRoot).repeat(divideSome).call(conclude);
        }

        // The radius of a sphere about the model's origin around all: rounding goes with that, and the margins of a hierarchy.
        private static function reachOf(root:HierarchyNode):Number
        {
            var reach:Number = Math.max(Math.abs(root.x) + root.halfX, Math.abs(root.y) + root.halfY);
            return Math.sqrt(3) * Math.max(reach, Math.abs(root.z) + root.halfZ);
        }

        private function beginRoot():void
        {
            addHalf(0, _items.count, -1, _items.extents);
        }

        private function conclude():void
        {
            _tree.order = _items.order;
            _hierarchy.setRays(_tree);
        }

        private function divideSome():Boolean
        {
            var left:int = TRIANGLES_PER_STEP;
            while (left > 0 && _waiting > 0)
            {
                var last:int = _waiting - 1;
                var count:int = _end[last] - _first[last];
                if (count <= RayTree.LEAF_SIZE)
                {
                    _waiting--;
                    setChild(_child[last], ~(RayTree.LEAF_SIZE * _first[last] + count - 1));
                    left--;
                    continue;
                }
                if (!_isDividing)
                {
                    beginDivision(last);
                }
                _isDividing = _items.divideSome(TRIANGLES_PER_STEP) || !finishDivision(last);
                left -= Math.min(count, TRIANGLES_PER_STEP) + TRIANGLES_PER_NODE;
            }
            return _waiting > 0;
        }

        private function beginDivision(part:int):void
        {
            var at:int = PER_EXTENTS * part;
            var axis:int = 0;
            var longest:Number = -1;
            for (var i:int = 0; i < 3; i++)
            {
                var length:Number = _extents[int(at + i + 3)] - _extents[int(at + i)];
                if (length > longest)
                {
                    longest = length;
                    axis = i;
                }
            }
            _isBySpread = false;
            _items.beginDivision(_first[part], _end[part], axis, _extents[int(at + axis)] + _extents[int(at + axis + 3)]);
        }

        // Makes a node of the part and its two halves, if there are triangles on both sides; if not, begins anew with their centres alone.
        private function finishDivision(part:int):Boolean
        {
            var first:int = _first[part];
            var middle:int = _items.middle;
            var end:int = _end[part];
            var left:Vector.<Number> = _items.leftExtents;
            var right:Vector.<Number> = _items.rightExtents;
            if (middle == first || middle == end)
            {
                if (!_isBySpread)
                {
                    _isBySpread = true;
                    _items.beginWhereCentresSpread(first, end);
                    return false;
                }
                left = right = middle == first ? right : left;
                middle = (first + end) >> 1;
            }
            var node:int = _tree.children.length >> 1;
            _tree.children.push(0, 0);
            addBox(left);
            addBox(right);
            setChild(_child[part], node);
            _waiting--;
            addHalf(middle, end, 2 * node + 1, right);
            addHalf(first, middle, 2 * node, left);
            return true;
        }

        private function setChild(child:int, value:int):void
        {
            if (child < 0)
            {
                _tree.root = value;
            }
            else
            {
                _tree.children[child] = value;
            }
        }

        private function addBox(extents:Vector.<Number>):void
        {
            _tree.boxes.push(extents[0] - _margin, extents[1] - _margin, extents[2] - _margin, extents[3] + _margin, extents[4] + _margin,
                    extents[5] + _margin);
        }

        private function addHalf(first:int, end:int, child:int, extents:Vector.<Number>):void
        {
            _first[_waiting] = first;
            _end[_waiting] = end;
            _child[_waiting] = child;
            for (var i:int = 0; i < PER_EXTENTS; i++)
            {
                _extents[int(PER_EXTENTS * _waiting + i)] = extents[i];
            }
            _waiting++;
        }
    }
}
