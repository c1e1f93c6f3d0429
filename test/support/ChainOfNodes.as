package support
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.VarInt;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.finish;

    use namespace engine;

    /** Trees as deep as the number of their items, as a forged file may say that they are. */
    public final class ChainOfNodes
    {
        /** A division below the thesis's leaves. */
        public static const BELOW:int = 3;

        /** A division of the thesis's tree. */
        public static const OF_THE_THESIS:int = 0;

        /**
         * Reads a tree in which each node divides one item from all others.
         *
         * @param count of items, in a row along x
         * @param maxDepth the depth limit of the thesis's tree
         * @param division of all nodes: BELOW or OF_THE_THESIS
         * @param areTriangles whether the items are triangles, else they are vertices
         * @return not made if the tree is refused
         */
        public static function read(count:int, maxDepth:int, division:int, areTriangles:Boolean):BoxTree
        {
            var bytes:ByteArray = CookedFile.newBytes();
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = areTriangles ? new Vector.<uint>() : null;
            var width:int = CookedTree.widthFor(count);
            for (var i:int = 0; i < count; i++)
            {
                vertices.push(i, 0, 0);
                if (areTriangles)
                {
                    triangles.push(i, i, i);
                }
                for (var bits:int = 0; bits < 8 * width; bits += 8)
                {
                    bytes.writeByte(i >> bits);
                }
            }
            for (i = 1; i < count; i++)
            {
                // one item on the low side of x, which is not divided
                VarInt.write(1 + division + 6, bytes);
                VarInt.write(0, bytes);
            }
            VarInt.write(0, bytes);
            bytes.position = 0;
            var tree:BoxTree = new BoxTree(vertices, triangles);
            finish(new CookedTree(bytes, tree, maxDepth));
            return tree;
        }
    }
}
