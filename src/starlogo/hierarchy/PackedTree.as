package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * The boxes of a hierarchy of triangles, packed for visits of one ray or box. Such a visit sees a small part of a large tree, so it
     * mostly waits for memory. The boxes are a little larger than the nodes', because they are rounded to a grid.
     *
     * <p>It is packed in steps. Only a hierarchy whose leaves have few triangles can be packed: see HierarchyRefiner.</p>
     *
     * @private
     */
    public final class PackedTree implements Steps
    {
        private static const PAIRS_PER_STEP:int = 500;

        // The number of bits that have the number of a leaf's triangles. The bits above have its first triangle.
        private static const COUNT_BITS:int = 4;

        // Half of the grid's largest extent, in steps. It is less than the 2 ^ 30 up to which all JavaScript engines keep integers in an
        // object itself.
        private static const GRID_STEPS:Number = 1 << 28;

        // How many steps a box is larger on each side, because its numbers are rounded.
        private static const MARGIN:int = 3;

        /** The grid's middle, and the number of its steps in a unit. */
        internal var x:Number;
        internal var y:Number;
        internal var z:Number;
        internal var scale:Number;

        /** The root's pair, or null if the root is a leaf; then the leaf. */
        internal var root:BoxPair = null;
        internal var rootLeaf:int = 0;

        // The nodes whose children are still to be packed, and their pairs.
        private var _nodes:Vector.<HierarchyNode> = new Vector.<HierarchyNode>();
        private var _pairs:Vector.<BoxPair> = new Vector.<BoxPair>();

        /** @param node the hierarchy's root */
        public function PackedTree(node:HierarchyNode)
        {
            var largest:Number = Math.max(node.halfX, Math.max(node.halfY, node.halfZ));
            x = node.x;
            y = node.y;
            z = node.z;
            scale = largest > 0 ? GRID_STEPS / largest : 1;
            root = pairOf(node);
            rootLeaf = leafOf(node);
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            for (var left:int = PAIRS_PER_STEP; left > 0 && _nodes.length > 0; left--)
            {
                pack(_nodes.pop(), _pairs.pop());
            }
            return _nodes.length > 0;
        }

        /** The first triangle of a packed leaf. */
        internal static function firstOf(leaf:int):int
        {
            return leaf >> COUNT_BITS;
        }

        /** The number after the last triangle of a packed leaf. */
        internal static function endOf(leaf:int):int
        {
            return (leaf >> COUNT_BITS) + (leaf & (1 << COUNT_BITS) - 1);
        }

        private static function leafOf(node:HierarchyNode):int
        {
            return node.low == null ? node.first << COUNT_BITS | node.end - node.first : 0;
        }

        // Returns a pair that is packed later, or null for a leaf.
        private function pairOf(node:HierarchyNode):BoxPair
        {
            if (node.low == null)
            {
                return null;
            }
            var pair:BoxPair = new BoxPair();
            _nodes.push(node);
            _pairs.push(pair);
            return pair;
        }

        private function pack(node:HierarchyNode, pair:BoxPair):void
        {
            var child:HierarchyNode = node.low;
            pair.lowX = scale * (child.x - x);
            pair.lowY = scale * (child.y - y);
            pair.lowZ = scale * (child.z - z);
            pair.lowHalfX = scale * child.halfX + MARGIN;
            pair.lowHalfY = scale * child.halfY + MARGIN;
            pair.lowHalfZ = scale * child.halfZ + MARGIN;
            pair.lowLeaf = leafOf(child);
            child = node.high;
            pair.highX = scale * (child.x - x);
            pair.highY = scale * (child.y - y);
            pair.highZ = scale * (child.z - z);
            pair.highHalfX = scale * child.halfX + MARGIN;
            pair.highHalfY = scale * child.halfY + MARGIN;
            pair.highHalfZ = scale * child.halfZ + MARGIN;
            pair.highLeaf = leafOf(child);
            pair.high = pairOf(child);
            pair.low = pairOf(node.low);
        }
    }
}
