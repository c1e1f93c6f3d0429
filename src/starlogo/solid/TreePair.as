package starlogo.solid
{
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.hierarchy.BoxTree;
    import starlogo.intersection.boxes.BoxPair;

    /**
     * Two trees a and b that a traversal visits: the trees, to which depth each is visited, and the pose of b in the space of a. It reads pairs of their
     * nodes in that space.
     *
     * @private
     */
    public final class TreePair
    {
        /** One tree, and how many of its levels are visited (see BoxTree). */
        public var a:BoxTree = null;
        public var depthA:int = 0;

        /** The other tree, and how many of its levels are visited. */
        public var b:BoxTree = null;
        public var depthB:int = 0;

        /** The pose of b's nodes in the space of a. Whoever makes the object sets it. */
        public var pose:RelativePose = null;

        /** Whether the triangles of two leaves decide; otherwise their boxes do. */
        public function get isExact():Boolean
        {
            return depthA == BoxTree.EXACT && depthB == BoxTree.EXACT;
        }

        /**
         * Reads the boxes of a node of a and a node of b.
         *
         * @param out receives the half-extents of both, and the vector from the middle of a's node to that of b's
         */
        public function readBoxes(nodeA:int, nodeB:int, out:BoxPair):void
        {
            var relative:Placement = pose.placement;
            var boxes:Vector.<Number> = b.boxes;
            var at:int = 6 * nodeB;
            var scale:Number = relative.size;
            var x:Number = boxes[at] * scale;
            var y:Number = boxes[int(at + 1)] * scale;
            var z:Number = boxes[int(at + 2)] * scale;
            out.halvesB[0] = boxes[int(at + 3)] * scale;
            out.halvesB[1] = boxes[int(at + 4)] * scale;
            out.halvesB[2] = boxes[int(at + 5)] * scale;
            boxes = a.boxes;
            at = 6 * nodeA;
            out.offset[0] = relative.r00 * x + relative.r01 * y + relative.r02 * z + relative.x - boxes[at];
            out.offset[1] = relative.r10 * x + relative.r11 * y + relative.r12 * z + relative.y - boxes[int(at + 1)];
            out.offset[2] = relative.r20 * x + relative.r21 * y + relative.r22 * z + relative.z - boxes[int(at + 2)];
            out.halvesA[0] = boxes[int(at + 3)];
            out.halvesA[1] = boxes[int(at + 4)];
            out.halvesA[2] = boxes[int(at + 5)];
        }

        /** The largest distance at which triangles of the two touch: the pose's margin, and the margins of both surfaces. */
        public function get triangleMargin():Number
        {
            return pose.margin + Touching.marginOfSurface(a.boundingRadius + b.boundingRadius * pose.placement.size);
        }

        /**
         * Quick tests rule out two triangles that are farther apart. It is more than <code>triangleMargin</code>, because the kernel also lets the margin of
         * a motion and Tolerances.CORES of both triangles touch. Twice that margin is enough: it has SURFACES of the radii, which is more than the CORES.
         */
        public function cullDistance(motion:RelativeMotion):Number
        {
            return 2 * triangleMargin + Tolerances.EXTENTS * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
        }

        /**
         * Of two nodes that are not both leaves, says which to divide: the one that is none, or else the larger one, by the spheres around their boxes.
         *
         * @return whether it is the node of a
         */
        public function dividesA(nodeA:int, isLeafA:Boolean, nodeB:int, isLeafB:Boolean):Boolean
        {
            if (isLeafA || isLeafB)
            {
                return isLeafB;
            }
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
