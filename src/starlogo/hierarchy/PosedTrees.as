package starlogo.hierarchy
{
    /**
     * Two trees that a traversal visits, as a record: the trees, to which depth each is visited, and the pose of the second one in the space of the
     * first.
     *
     * @private
     */
    public final class PosedTrees
    {
        /** The first tree, and how many of its levels are visited (see BoxTree). */
        public var a:BoxTree = null;
        public var depthA:int = 0;

        /** The second tree, and how many of its levels are visited. */
        public var b:BoxTree = null;
        public var depthB:int = 0;

        /** The pose of the second tree's nodes in the first tree's space. */
        public var pose:RelativePose = new RelativePose();

        /** Whether the sphere around the box of a node of the first tree is at least as large as the one around the box of a node of the second. */
        public function isFirstLarger(nodeA:int, nodeB:int):Boolean
        {
            var boxesA:Vector.<Number> = a.boxes;
            var boxesB:Vector.<Number> = b.boxes;
            var scale:Number = pose.placement.size;
            var aX:Number = boxesA[int(6 * nodeA + 3)];
            var aY:Number = boxesA[int(6 * nodeA + 4)];
            var aZ:Number = boxesA[int(6 * nodeA + 5)];
            var bX:Number = boxesB[int(6 * nodeB + 3)];
            var bY:Number = boxesB[int(6 * nodeB + 4)];
            var bZ:Number = boxesB[int(6 * nodeB + 5)];
            return aX * aX + aY * aY + aZ * aZ >= scale * scale * (bX * bX + bY * bY + bZ * bZ);
        }
    }
}
