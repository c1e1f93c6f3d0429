package starlogo.solid
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.FirstTouch;
    import starlogo.hierarchy.NodePairSearch;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.SweptBoxTraversal;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.intersection.PairTable;

    use namespace engine;

    /**
     * Finds when and where two models first touch while the first one moves, relative to the second. The second one is a tree, or a structure stands
     * for it.
     *
     * @private
     */
    public final class TreeImpactQuery extends ImpactQuery
    {
        private var _overlaps:TreeOverlapQuery;
        private var _pair:TreePair;

        // Where the first model's motion has brought it at a time, and the second model's pose as seen from there. Every question begins with them.
        private var _placed:Placement = new Placement();
        private var _pose:RelativePose = new RelativePose();

        // The second model's motion in the first model's space, from its pose on.
        private var _motion:RelativeMotion = new RelativeMotion();

        // The nodes or triangles that touch first.
        private var _touch:FirstTouch = new FirstTouch();

        private var _traversal:SweptBoxTraversal;

        // What decides about nodes if triangles do.
        private var _trianglePairSweep:TrianglePairSweep;

        // For contacts: nodes.
        private var _boxA:Box = BoxTree.newBox();
        private var _boxB:Box = BoxTree.newBox();

        /**
         * @param pair the two models; whoever made it sets it before each question
         * @param overlaps tests the two where they stand, and finds when a structure first touches a tree
         * @param counts counts what the query does
         */
        public function TreeImpactQuery(pair:TreePair, overlaps:TreeOverlapQuery, counts:TreeCounts)
        {
            _pair = pair;
            _overlaps = overlaps;
            _traversal = new SweptBoxTraversal(counts);
            _trianglePairSweep = new TrianglePairSweep(counts);
        }

        /** @inheritDoc */
        override public function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            placeFirst(motion, time);
            return _overlaps.areOverlappingAt(_pair, _placed);
        }

        /** @inheritDoc */
        override public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            findTouch(motion, 0);
            motion.time = _motion.time = _touch.time;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                findContactOfTouch(out);
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
            findTouch(motion, motion.time);
            _motion.time = 0;
            if (_touch.time == 0)
            {
                findContactOfTouch(out);
            }
            else
            {
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
            _pose.relate(placementA, placementB);
            PairTable.findContact(_pose.place(b), a, RelativeMotion.NONE, out);
            moveToWorld(out, placementA, RelativeMotion.NONE);
        }

        private function placeFirst(motion:RelativeMotion, time:Number):void
        {
            _placed.copyFrom(_pair.placementA);
            _placed.x += motion.startX + time * motion.x;
            _placed.y += motion.startY + time * motion.y;
            _placed.z += motion.startZ + time * motion.z;
        }

        // Finds the triangles or nodes that touch first, and when, while the first model moves on from where it is at a time. That is time 0 of the
        // search.
        private function findTouch(motion:RelativeMotion, from:Number):void
        {
            var pair:TreePair = _pair;
            var a:ModelTree = pair.a;
            var b:ModelTree = pair.b;
            placeFirst(motion, from);
            _pose.relate(_placed, pair.placementB);
            RelativePose.relateMotion(_placed, motion, _motion);
            if (b == null)
            {
                _overlaps.findStructureTouch(pair, _pose, _motion, _touch);
                return;
            }
            var decider:NodePairSearch = pair.isExact ? _trianglePairSweep.begin(a, b, _pose, _motion) : null;
            _traversal.findTouch(_pose, _motion, a.boxTree, pair.depthA, b.boxTree, pair.depthB, decider, _touch);
        }

        // The contact of the two that findTouch() has found, at the time of the second model's motion, in the first model's space.
        private function findContactOfTouch(out:ContactPoint):void
        {
            if (!_pair.isExact)
            {
                findContactOfNodes(_touch.a, _touch.b, out);
            }
            else if (_pair.b == null)
            {
                _overlaps.findTriangleContact(_touch.a, _motion, out);
            }
            else
            {
                _trianglePairSweep.findContact(_touch, _motion, out);
            }
        }

        // The contact of two nodes, or of a node and the structure that stands for the second model.
        private function findContactOfNodes(a:int, b:int, out:ContactPoint):void
        {
            var structureB:BoundingStructure = _pair.b == null ? _pair.structureB : _pair.b.boxTree.writeBox(b, _boxB);
            PairTable.findContact(_pose.place(structureB), _pair.a.boxTree.writeBox(a, _boxA), _motion, out);
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
