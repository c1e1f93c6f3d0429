package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.NodePairTest;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.hierarchy.NodeStructureTest;
    import starlogo.hierarchy.SweptBoxTraversal;
    import starlogo.intersection.PairTable;

    use namespace engine;

    /**
     * Finds when and where two models first touch while one of them moves. The second one is a tree, or a structure stands for it.
     *
     * <p>To get inside of a closed surface from outside, a part of a model has to cross it, and its nodes have to touch. So the nodes
     * or triangles are tested over time, and the standing test is made only at the beginning and the end.</p>
     *
     * @private
     */
    public final class TreeImpactQuery
    {
        private var _overlaps:TreeOverlapQuery;

        // Where the first model's motion has brought it at a time, and the second model's pose as seen from there.
        private var _placed:Placement = new Placement();
        private var _displaced:TreePair = new TreePair();
        private var _pose:RelativePose = new RelativePose();

        // The second model's motion in the first model's space, from its pose on; and the time at which the two first touch.
        private var _motion:RelativeMotion = new RelativeMotion();

        private var _boxes:SweptBoxTraversal;

        // What decides about nodes.
        private var _trianglePairs:TrianglePairSweep;
        private var _nodes:NodeStructureTest;
        private var _triangles:TriangleStructureTest;

        // For contacts: nodes.
        private var _boxA:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);
        private var _boxB:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /**
         * @param overlaps tests the two where they stand
         * @param counts counts what the query does
         */
        public function TreeImpactQuery(overlaps:TreeOverlapQuery, counts:TreeCounts)
        {
            _overlaps = overlaps;
            _boxes = new SweptBoxTraversal(counts);
            _trianglePairs = new TrianglePairSweep(counts);
            _nodes = new NodeStructureTest(counts);
            _triangles = new TriangleStructureTest(counts);
        }

        /**
         * Finds the first moment at which the two overlap, and the contact then. Rounding can miss a touch at the end of the motion. So if
         * nothing is found before, the standing test is made at time 1 too.
         *
         * @param motion of the first model, relative to the second; receives the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, in the world; null if only the time is needed
         */
        public function findFirst(pair:TreePair, motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = 0;
            if (!overlapAt(pair, motion, 0))
            {
                findImpact(pair, motion, out);
                if (motion.time != RelativeMotion.NEVER)
                {
                    return;
                }
                time = overlapAt(pair, motion, 1) ? 1 : RelativeMotion.NEVER;
            }
            motion.time = time;
            if (out != null && time != RelativeMotion.NEVER)
            {
                findContact(pair, motion, out);
            }
        }

        /**
         * Finds when and where the two first touch. They must not touch at the beginning.
         *
         * @param motion of the first model, relative to the second; receives the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, in the world; null if only the time is needed
         */
        public function findImpact(pair:TreePair, motion:RelativeMotion, out:ContactPoint):void
        {
            findFirstParts(pair, motion);
            motion.time = _motion.time;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                findContactOfParts(pair, motion, out);
            }
        }

        /**
         * Finds the contact of two models that overlap. It is the contact of the first two triangles that touch, or of the first two nodes
         * that decide. If one model is inside of the other, it is the contact of the boxes of their roots.
         *
         * @param motion of the first model, relative to the second; its time is the time of impact
         * @param out receives the contact, in the world
         */
        public function findContact(pair:TreePair, motion:RelativeMotion, out:ContactPoint):void
        {
            findFirstParts(pair, motion);
            var isSame:Boolean = _motion.time <= motion.time + Tolerances.SAME_TIME;
            _motion.time = motion.time;
            if (isSame)
            {
                findContactOfParts(pair, motion, out);
            }
            else
            {
                var b:BoundingStructure = pair.b == null ? pair.structureB : pair.b.tree.writeBox(0, _boxB);
                findContactOf(pair.a.tree.writeBox(0, _boxA), pair.placementA, b, motion, out);
            }
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
            _pose.relate(placementA, placementB);
            RelativePose.relateMotion(placementA, RelativeMotion.NONE, _motion);
            findContactOf(a, placementA, b, RelativeMotion.NONE, out);
        }

        private function overlapAt(pair:TreePair, motion:RelativeMotion, time:Number):Boolean
        {
            placeFirst(pair, motion, time);
            _displaced.copyFrom(pair);
            _displaced.placementA = _placed;
            return _overlaps.areOverlapping(_displaced);
        }

        private function placeFirst(pair:TreePair, motion:RelativeMotion, time:Number):void
        {
            _placed.copyFrom(pair.placementA);
            _placed.x += motion.startX + time * motion.x;
            _placed.y += motion.startY + time * motion.y;
            _placed.z += motion.startZ + time * motion.z;
        }

        // Finds the first two triangles or nodes that touch while the first model moves, and their time.
        private function findFirstParts(pair:TreePair, motion:RelativeMotion):void
        {
            var a:ModelTree = pair.a;
            var b:ModelTree = pair.b;
            var isExact:Boolean = pair.isExact;
            placeFirst(pair, motion, 0);
            _pose.relate(_placed, pair.placementB);
            RelativePose.relateMotion(pair.placementA, motion, _motion);
            if (b != null)
            {
                var decider:NodePairTest = isExact ? _trianglePairs.begin(a, b, _pose, _motion) : null;
                _boxes.findTime(_pose, _motion, a.tree, pair.depthA, b.tree, pair.depthB, decider);
            }
            else if (isExact)
            {
                _triangles.findTime(a, pair.structureB, _pose, _motion);
            }
            else
            {
                _nodes.findTime(a.tree, pair.depthA, pair.structureB, _pose, _motion);
            }
        }

        // The contact of the two that findFirstParts has found, at the motion's time.
        private function findContactOfParts(pair:TreePair, motion:RelativeMotion, out:ContactPoint):void
        {
            if (!pair.isExact)
            {
                var a:int = pair.b == null ? _nodes.firstNode : _boxes.bestA;
                var b:BoundingStructure = pair.b == null ? pair.structureB : pair.b.tree.writeBox(_boxes.bestB, _boxB);
                findContactOf(pair.a.tree.writeBox(a, _boxA), pair.placementA, b, motion, out);
                return;
            }
            if (pair.b == null)
            {
                _triangles.findContact(_motion, out);
            }
            else
            {
                _trianglePairs.findContact(_motion, out);
            }
            moveToWorld(out, pair.placementA, motion);
        }

        // The contact of two structures in their models' spaces, at the motion's time.
        private function findContactOf(a:BoundingStructure, placementA:Placement, b:BoundingStructure, motion:RelativeMotion,
                out:ContactPoint):void
        {
            PairTable.findContact(_pose.place(b), a, _motion, out);
            moveToWorld(out, placementA, motion);
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
