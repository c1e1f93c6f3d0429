package starlogo.libraries.cooked
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.models.cooked.VarInt;

    use namespace engine;

    /**
     * Writes how a tree divides its items. A TreeReader computes the boxes from that.
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
         * root down, left before right. A node without children is 0. Any other node is the sum of: 1; its axis; 3 if the node is a leaf of
         * the thesis's tree or below one; 6 times the number of items on its low side.
         *
         * @param tree the tree
         * @param out takes the bytes, at its position; little-endian
         */
        public static function write(tree:BoxTree, out:ByteArray):void
        {
            var width:int = widthFor(tree.order.length);
            for each (var item:int in tree.order)
            {
                for (var bits:int = 0; bits < 8 * width; bits += 8)
                {
                    out.writeByte(item >> bits);
                }
            }
            var waiting:Vector.<int> = new <int>[0];
            while (waiting.length > 0)
            {
                var node:int = waiting.pop();
                var left:int = tree.left[node];
                if (left == 0)
                {
                    VarInt.write(0, out);
                    continue;
                }
                VarInt.write(1 + tree.axisOf(node) + (tree.stop[node] >= BoxTree.LARGEST_DEPTH ? 3 : 0) + 6 * (tree.end[left] - tree.first[left]), out);
                waiting.push(left + 1, left);
            }
        }
    }
}
