package starlogo.hierarchy
{
    import flash.utils.ByteArray;
    import starlogo.engine;

    use namespace engine;

    /**
     * Writes down how a hierarchy divides its items; the boxes follow from that. See TreeReader.
     *
     * @private
     */
    public final class TreeWriter
    {
        /** All is static. */
        public function TreeWriter()
        {
        }

        /** How many bytes the number of an item takes among so many. */
        public static function widthFor(count:int):int
        {
            if (count <= 0x100)
            {
                return 1;
            }
            return count <= 0x10000 ? 2 : 4;
        }

        /**
         * Writes the order of the items, each in as few bytes as their number needs, then the nodes from the root down, left
         * before right: 0 for a leaf, else 1 more than the axis and three times the number of items that go left, seven bits a byte,
         * the lowest first, the eighth bit telling that more follow.
         *
         * @param hierarchy of boxes, spheres or capsules
         * @param out takes the bytes at its position
         */
        public static function write(hierarchy:Hierarchy, out:ByteArray):void
        {
            writeOrder(hierarchy.order, out);
            var stack:Vector.<HierarchyNode> = new <HierarchyNode>[hierarchy.root];
            while (stack.length > 0)
            {
                var node:HierarchyNode = stack.pop();
                if (node.isLeaf)
                {
                    out.writeByte(0);
                    continue;
                }
                writeNumber(1 + node.splitAxis + 3 * (node.left.end - node.first), out);
                stack.push(node.right, node.left);
            }
        }

        private static function writeOrder(order:Vector.<int>, out:ByteArray):void
        {
            var width:int = widthFor(order.length);
            for each (var item:int in order)
            {
                switch (width)
                {
                    case 1:
                        out.writeByte(item);
                        break;
                    case 2:
                        out.writeShort(item);
                        break;
                    default:
                        out.writeInt(item);
                        break;
                }
            }
        }

        private static function writeNumber(value:int, out:ByteArray):void
        {
            while (value > 0x7F)
            {
                out.writeByte(value & 0x7F | 0x80);
                value >>>= 7;
            }
            out.writeByte(value);
        }
    }
}
