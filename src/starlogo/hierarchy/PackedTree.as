package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * The boxes of a hierarchy of triangles down to a few triangles each, packed for visits of one ray or box. Such a visit sees a small
     * part of a large tree, so it mostly waits for memory. The boxes are a little larger than the nodes', because they are rounded to a
     * grid.
     *
     * <p>Below the thesis's leaves there are no nodes until a visit of two trees goes there. Then they are made of the packed tree.</p>
     *
     * @private
     */
    public final class PackedTree
    {
        // A node with more triangles is divided.
        private static const LEAF_SIZE:int = 8;

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

        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        /**
         * Creates a tree without boxes.
         *
         * @param node the hierarchy's root
         */
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

        /** Whether a node has so many triangles that it is divided. */
        internal static function isLarge(node:HierarchyNode):Boolean
        {
            return node.end - node.first > LEAF_SIZE;
        }

        /**
         * Whether a node below the thesis's leaves is divided in the middle of its items, wherever they are. So these levels are few, even if a
         * division by place takes one item at a time.
         *
         * @param level the node's level
         */
        public static function isHalved(level:int):Boolean
        {
            return level >= Tolerances.NESTED_LEVELS;
        }

        /** Packs the boxes of a node's children. The node was the root, or a child of a packed node. */
        internal function pack(node:HierarchyNode):void
        {
            var pair:BoxPair = node.pair;
            pair.axis = node.splitAxis;
            var child:HierarchyNode = node.low;
            pair.low = pairOf(child);
            pair.lowLeaf = leafOf(child);
            pair.lowX = scale * (child.x - x);
            pair.lowY = scale * (child.y - y);
            pair.lowZ = scale * (child.z - z);
            pair.lowHalfX = scale * child.halfX + MARGIN;
            pair.lowHalfY = scale * child.halfY + MARGIN;
            pair.lowHalfZ = scale * child.halfZ + MARGIN;
            child = node.high;
            pair.high = pairOf(child);
            pair.highLeaf = leafOf(child);
            pair.highX = scale * (child.x - x);
            pair.highY = scale * (child.y - y);
            pair.highZ = scale * (child.z - z);
            pair.highHalfX = scale * child.halfX + MARGIN;
            pair.highHalfY = scale * child.halfY + MARGIN;
            pair.highHalfZ = scale * child.halfZ + MARGIN;
        }

        /** Makes the children of a node that has none, and whose children's boxes are packed. */
        internal function makeChildren(node:HierarchyNode):void
        {
            var pair:BoxPair = node.pair;
            var leaf:int = pair.highLeaf;
            for (var below:BoxPair = pair.high; below != null; below = below.low)
            {
                leaf = below.lowLeaf;
            }
            var middle:int = firstOf(leaf);
            node.divide(pair.axis, makeChild(node, node.first, middle, pair.low), makeChild(node, middle, node.end, pair.high),
                    HierarchyNode.LARGEST_DEPTH);
        }

        private function makeChild(parent:HierarchyNode, first:int, end:int, pair:BoxPair):HierarchyNode
        {
            TreeItems.writeBounds(parent.hierarchy, first, end, _extents);
            var child:HierarchyNode = parent.hierarchy.makeNode(parent.level + 1, first, end, _extents);
            child.pair = pair;
            child.stopDepth = pair == null ? int.MAX_VALUE : HierarchyNode.LARGEST_DEPTH;
            return child;
        }

        // Gives a node a pair for its children, which are packed later. A leaf has none.
        private static function pairOf(node:HierarchyNode):BoxPair
        {
            node.pair = node.low == null && !isLarge(node) ? null : new BoxPair();
            return node.pair;
        }

        private static function leafOf(node:HierarchyNode):int
        {
            return node.pair == null ? node.first << COUNT_BITS | node.end - node.first : 0;
        }
    }
}
