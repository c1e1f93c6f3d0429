package starlogo.hierarchy
{
    import starlogo.data.zeroedNumbers;
    import starlogo.steps.StepSequence;

    /**
     * Gives all nodes of a tree boxes around the places where the vertices are now, in steps. The division of the primitives stays. The boxes are those
     * that a BoxTreeBuilder gives to this division, to the last bit. Cost: linear in the number of primitives.
     *
     * @private
     */
    public final class BoxRefit extends StepSequence
    {
        private static const NODES_PER_STEP:int = 300;

        private var _tree:BoxTree;

        // The extents of the parts of all nodes: minX, maxX, minY, maxY, minZ, maxZ of each.
        private var _extents:Vector.<Number>;

        /** @param tree its nodes are made. */
        public function BoxRefit(tree:BoxTree)
        {
            _tree = tree;
            var count:int = tree.left.length;
            _extents = zeroedNumbers(6 * count);
            slices(count, NODES_PER_STEP, measure).call(measureRadius).slices(count, NODES_PER_STEP, enclose);
        }

        // Measures the parts of some nodes. The nodes are counted from the last one, because children come after their parents.
        private function measure(from:int, to:int):void
        {
            var tree:BoxTree = _tree;
            var extents:Vector.<Number> = _extents;
            var count:int = tree.left.length;
            for (var node:int = count - 1 - from; node >= count - to; node--)
            {
                var at:int = 6 * node;
                var child:int = 6 * tree.left[node];
                if (child == 0)
                {
                    tree.readExtents(tree.firstPrimitive[node], tree.endPrimitive[node], extents, at);
                    continue;
                }
                for (var i:int = 0; i < 6; i += 2)
                {
                    var a:Number = extents[int(child + i)];
                    var b:Number = extents[int(child + 6 + i)];
                    extents[int(at + i)] = b < a ? b : a;
                    a = extents[int(child + 1 + i)];
                    b = extents[int(child + 7 + i)];
                    extents[int(at + 1 + i)] = b > a ? b : a;
                }
            }
        }

        private function measureRadius():void
        {
            _tree.measureRadiusAboutOrigin(_extents);
        }

        private function enclose(from:int, to:int):void
        {
            for (var node:int = from; node < to; node++)
            {
                _tree.enclose(node, _extents, 6 * node);
            }
        }
    }
}
