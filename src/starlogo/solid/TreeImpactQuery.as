package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BestPair;
    import starlogo.hierarchy.NodePairVisitor;
    import starlogo.hierarchy.NodeTouchVisitor;
    import starlogo.hierarchy.PosedTrees;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.ImpactTraversal;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.PairTable;

    /**
     * Finds when and where two models first touch while the first one moves, relative to the second. The second one is a tree, or a structure stands
     * for it.
     *
     * @private
     */
    public final class TreeImpactQuery extends ImpactQuery
    {
        private var _pair:TreePair;
        private var _overlaps:TreeOverlapQuery;

        // The second model's motion in the first model's space, from the pair's pose on.
        private var _motion:RelativeMotion = new RelativeMotion();

        private var _traversal:ImpactTraversal;

        // What decides about nodes.
        private var _trianglePairs:TrianglePairVisitor;
        private var _nodes:NodeTouchVisitor;
        private var _triangles:TriangleTouchVisitor;

        // For contacts: nodes.
        private var _boxA:Box = BoxTree.newBox();
        private var _boxB:Box = BoxTree.newBox();

        /**
         * @param pair the two models; whoever made it sets it before each question
         * @param overlaps tests the two where they are
         * @param counts counts what the query does
         */
        public function TreeImpactQuery(pair:TreePair, overlaps:TreeOverlapQuery, counts:TreeCounts)
        {
            _pair = pair;
            _overlaps = overlaps;
            _traversal = new ImpactTraversal(counts);
            _trianglePairs = new TrianglePairVisitor(counts);
            _nodes = new NodeTouchVisitor(counts);
            _triangles = new TriangleTouchVisitor(counts);
        }

        /** @inheritDoc */
        override public function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            _pair.relateAt(motion, time);
            return _overlaps.overlapInPose(_pair);
        }

        /** @inheritDoc */
        override public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            sweep(motion, 0, out);
            motion.time = _motion.time;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                moveToWorld(out, _pair.placementA, motion);
            }
        }

        /**
         * It is the contact of two triangles that touch there, or of two nodes that decide. If one model is inside of the other, it is the contact of
         * the boxes of their roots.
         *
         * @inheritDoc
         */
        override public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            sweep(motion, motion.time, out);
            if (_motion.time > 0)
            {
                // no surfaces touch now, so one model is inside of the other
                _motion.time = 0;
                findContactOfNodes(0, 0, out);
            }
            moveToWorld(out, _pair.placementA, motion);
        }

        /**
         * Finds the contact of the structures around two standing models.
         *
         * @param a the structure around the first model, in its space
         * @param placementA the first model's placement in the world
         * @param b the structure around the second model, in its space
         * @param placementB the second model's placement in the world
         * @param out receives the contact, in the world
         */
        public function findOuterContact(a:BoundingStructure, placementA:Placement, b:BoundingStructure, placementB:Placement,
                out:ContactPoint):void
        {
            _pair.trees.pose.relate(placementA, placementB);
            PairTable.findContact(_pair.trees.pose.place(b), a, RelativeMotion.NONE, out);
            moveToWorld(out, placementA, RelativeMotion.NONE);
        }

        // Sweeps the first model on from where its motion has brought it at a time, which is time 0 of the sweep. Sets the time of the second model's
        // motion to that of the first touch, and finds the contact then, in the first model's space.
        private function sweep(motion:RelativeMotion, from:Number, out:ContactPoint):void
        {
            var pair:TreePair = _pair;
            var trees:PosedTrees = pair.trees;
            pair.relateAt(motion, from);
            RelativePose.relateMotion(pair.placementA, motion, _motion);
            _motion.earliest = Math.max(0, _motion.earliest - from);
            if (out != null)
            {
                out.triangle = -1;
            }
            if (pair.b != null)
            {
                var visitor:NodePairVisitor = pair.isExact ? _trianglePairs.begin(pair, _motion) : null;
                var best:BestPair = _traversal.findTouch(trees, _motion, visitor);
                _motion.time = best.least;
                if (out != null && best.least <= 1)
                {
                    findContactOfBest(best, out);
                }
            }
            else if (pair.isExact)
            {
                var slot:int = _triangles.findTouch(pair.a, pair.structureB, trees.pose, _motion);
                if (slot >= 0 && out != null)
                {
                    _triangles.findContact(slot, _motion, out);
                    out.triangle = trees.a.items[slot];
                }
            }
            else
            {
                var node:int = _nodes.findTouch(trees.a, trees.depthA, pair.structureB, trees.pose, _motion);
                if (node >= 0 && out != null)
                {
                    findContactOfNodes(node, 0, out);
                }
            }
        }

        private function findContactOfBest(best:BestPair, out:ContactPoint):void
        {
            if (_pair.isExact)
            {
                _trianglePairs.findContact(best, _motion, out);
            }
            else
            {
                findContactOfNodes(best.a, best.b, out);
            }
        }

        // The contact of two nodes, or of a node and the structure that stands for the second model.
        private function findContactOfNodes(a:int, b:int, out:ContactPoint):void
        {
            var trees:PosedTrees = _pair.trees;
            var structureB:BoundingStructure = _pair.b == null ? _pair.structureB : trees.b.writeBox(b, _boxB);
            PairTable.findContact(trees.pose.place(structureB), trees.a.writeBox(a, _boxA), _motion, out);
        }

        // Turns the contact of the second model with the first, in the first one's space, into the contact of the first with the second, in the world.
        // The placement is where the first model stands without the motion; the contact is at the motion's time.
        private static function moveToWorld(contact:ContactPoint, a:Placement, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            var x:Number = contact.x * a.size;
            var y:Number = contact.y * a.size;
            var z:Number = contact.z * a.size;
            contact.x = a.r00 * x + a.r01 * y + a.r02 * z + a.x + motion.startX + time * motion.x;
            contact.y = a.r10 * x + a.r11 * y + a.r12 * z + a.y + motion.startY + time * motion.y;
            contact.z = a.r20 * x + a.r21 * y + a.r22 * z + a.z + motion.startZ + time * motion.z;
            x = -contact.normalX;
            y = -contact.normalY;
            z = -contact.normalZ;
            contact.setNormal(a.r00 * x + a.r01 * y + a.r02 * z, a.r10 * x + a.r11 * y + a.r12 * z, a.r20 * x + a.r21 * y + a.r22 * z);
            contact.depth *= a.size;
        }
    }
}
