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

        private var _found:FirstTouch;

        /** @param counts counts the pairs of triangles that are tested */
        public function TrianglePairSweep(counts:TreeCounts)
        {
            _triangles = new MovedTriangles(counts);
        }

        /**
         * Begins with two models that have triangles. The pose must relate them already. Returns this.
         *
         * @param found receives the triangles that touch first; kept
         */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose, motion:RelativeMotion, found:FirstTouch):NodePairSearch
        {
            _found = found;
            _triangles.begin(a, b, pose, motion);
            _triangles.meshA.preparePlanes();
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
                    _found.b = treeB.first[b] + k;
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
                if (!_triangles.mayTouch(i, index, motion))
                {
                    continue;
                }
                _triangles.setFirst(i);
                _triangles.pair.findTime(_triangles.b, _triangles.a, motion);
                if (motion.time <= motion.latest && motion.time < bounds.current)
                {
                    bounds.current = motion.latest = motion.time;
                    _found.a = i;
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
            _triangles.setPair(touch.a, touch.b);
            _triangles.pair.findContact(_triangles.b, _triangles.a, motion, out);
        }
    }
}
