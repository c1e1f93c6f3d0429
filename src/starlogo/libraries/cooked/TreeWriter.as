package starlogo.libraries.cooked
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.hierarchy.Hierarchy;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.cooked.VarInt;

    use namespace engine;

    /**
     * Writes how a hierarchy divides its items. A TreeReader computes the boxes from that.
     *
     * @private
     */
    public final class TreeWriter
    {
        /** The number of bytes for the index of an item. @param count the number of items */
        public static function widthFor(count:int):int
        {
            return count <= 0x100 ? 1 : (count <= 0x10000 ? 2 : 4);
        }

        /**
         * Writes the order of the items. Each index takes as few bytes as the number of items allows. Then it writes the nodes from the
         * root down, low before high. A node without children is 0. Any other node is the sum of: 1; its axis; 3 if the node is a leaf of
         * the thesis's tree or below one; 6 times the number of items on its low side.
         *
         * @param hierarchy the tree
         * @param out takes the bytes, at its position; little-endian
         */
        public static function write(hierarchy:Hierarchy, out:ByteArray):void
        {
            var width:int = widthFor(hierarchy.order.length);
            for each (var item:int in hierarchy.order)
            {
                for (var bits:int = 0; bits < 8 * width; bits += 8)
                {
                    out.writeByte(item >> bits);
                }
            }
            var stack:Vector.<HierarchyNode> = new <HierarchyNode>[hierarchy.root];
            while (stack.length > 0)
            {
                var node:HierarchyNode = stack.pop();
                if (!node.goesBelow(int.MAX_VALUE))
                {
                    VarInt.write(0, out);
                    continue;
                }
                VarInt.write(1 + node.splitAxis + (node.isLeaf ? 3 : 0) + 6 * (node.low.end - node.first), out);
                stack.push(node.high, node.low);
                node.forgetChildren();
            }
        }
    }
}
