package starlogo.solid
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
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
        private var _latest:Number = 1;

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
            _latest = motion.latest;
            return this;
        }

        /** @inheritDoc */
        override public function findBest(treeA:BoxTree, a:int, treeB:BoxTree, b:int, bounds:NodePairBounds):void
        {
            var motion:RelativeMotion = _motion;
            var first:int = treeA.first[a];
            var end:int = treeA.end[a];
            motion.latest = bounds.least < _latest ? bounds.least : _latest;
            // Of triangles that touch at the same time, those of the nodes that are tested last count.
            bounds.current = RelativeMotion.NEVER;
            // Higher indices come first, as in the traversal.
            for (var k:int = _triangles.move(treeB, b) - 1; k >= 0 && bounds.current > 0; k--)
            {
                _triangles.setSecond(k, motion);
                for (var i:int = end - 1; i >= first && bounds.current > 0; i--)
                {
                    if (_triangles.findTime(i, motion) && motion.time < bounds.current)
                    {
                        bounds.current = motion.latest = motion.time;
                        bounds.slotA = i;
                        bounds.slotB = treeB.first[b] + k;
                    }
                }
            }
        }

        /**
         * Finds the contact of two triangles that touch, in the first model's space. The models are those of the last <code>begin()</code>.
         *
         * @param best has the triangles
         * @param motion of the second model, which is where it is at the motion's time
         * @param out receives the contact, with a normal from the first model to the second
         */
        public function findContact(best:NodePairBounds, motion:RelativeMotion, out:ContactPoint):void
        {
            _triangles.findContact(best.slotA, best.slotB, motion, out);
        }
    }
}
