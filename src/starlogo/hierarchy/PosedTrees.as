package starlogo.hierarchy
{
    import starlogo.geometry.Placement;
    import starlogo.intersection.boxes.BoxPair;

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

        /**
         * Reads the boxes of a node of the first tree and of one of the second.
         *
         * @param out receives the half-extents of both, and the vector from the middle of the first one to that of the second
         */
        public function readPair(nodeA:int, nodeB:int, out:BoxPair):void
        {
            var relative:Placement = pose.placement;
            var boxes:Vector.<Number> = b.boxes;
            var at:int = 6 * nodeB;
            var scale:Number = relative.size;
            var x:Number = boxes[at] * scale;
            var y:Number = boxes[int(at + 1)] * scale;
            var z:Number = boxes[int(at + 2)] * scale;
            out.bX = boxes[int(at + 3)] * scale;
            out.bY = boxes[int(at + 4)] * scale;
            out.bZ = boxes[int(at + 5)] * scale;
            boxes = a.boxes;
            at = 6 * nodeA;
            out.x = relative.r00 * x + relative.r01 * y + relative.r02 * z + relative.x - boxes[at];
            out.y = relative.r10 * x + relative.r11 * y + relative.r12 * z + relative.y - boxes[int(at + 1)];
            out.z = relative.r20 * x + relative.r21 * y + relative.r22 * z + relative.z - boxes[int(at + 2)];
            out.aX = boxes[int(at + 3)];
            out.aY = boxes[int(at + 4)];
            out.aZ = boxes[int(at + 5)];
        }

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
