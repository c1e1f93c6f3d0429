package starlogo.solid
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.FirstTouch;
    import starlogo.hierarchy.NodePairBounds;
    import starlogo.hierarchy.NodePairSearch;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Decides by triangles when two nodes first touch, for models that move. */
    internal final class TrianglePairSweep extends NodePairSearch
    {
        private var _triangles:MovedTriangles;
        private var _motion:RelativeMotion = new RelativeMotion();

        /** @param counts counts the pairs of triangles that are tested */
        public function TrianglePairSweep(counts:TreeCounts)
        {
            _triangles = new MovedTriangles(counts);
        }

        /** Begins with two models that have triangles. The pose must relate them already, and the motion is the second one's. Returns this. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose, motion:RelativeMotion):NodePairSearch
        {
            _triangles.begin(a, b, pose, motion);
            _motion.copyVector(motion);
            return this;
        }

        /** @inheritDoc */
        override public function findBest(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):void
        {
            var count:int = _triangles.move(treeB, b);
            _motion.latest = bounds.least < 1 ? bounds.least : 1;
            // of nodes that touch at the same time the last ones count
            bounds.current = RelativeMotion.NEVER;
            // Higher indices come first, as in the traversal.
            for (var k:int = count - 1; k >= 0 && bounds.current > 0; k--)
            {
                if (keepEarlier(k, treeA.first[a], treeA.end[a], bounds))
                {
                    bounds.bestB = treeB.first[b] + k;
                }
            }
        }

        // If a triangle of the second model's node touches one of the first model's in a range of slots until the motion's latest time, and earlier than those of this
        // pair of nodes before, keeps the time as the current one of the bounds, and as the latest one. Returns whether it does.
        private function keepEarlier(index:int, first:int, end:int, bounds:NodePairBounds):Boolean
        {
            var motion:RelativeMotion = _motion;
            var isEarlier:Boolean = false;
            _triangles.setSecond(index, motion);
            for (var i:int = end - 1; i >= first && bounds.current > 0; i--)
            {
                if (_triangles.findTime(i, motion) && motion.time < bounds.current)
                {
                    bounds.current = motion.latest = motion.time;
                    bounds.bestA = i;
                    isEarlier = true;
                }
            }
            return isEarlier;
        }

        /**
         * Finds the contact of two triangles that touch, in the first model's space. The models are those of the last <code>begin()</code>.
         *
         * @param touch has the triangles
         * @param motion of the second model, which is where it is at the motion's time
         * @param out receives the contact, with a normal from the first model to the second
         */
        public function findContact(touch:FirstTouch, motion:RelativeMotion, out:ContactPoint):void
        {
            _triangles.findContact(touch.a, touch.b, motion, out);
        }
    }
}
