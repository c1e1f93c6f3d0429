package starlogo.solid
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BestPair;
    import starlogo.hierarchy.BestPairVisitor;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Decides by triangles when two nodes first touch, for models that move. */
    internal final class TrianglePairImpactVisitor extends BestPairVisitor
    {
        private var _triangles:MovedTriangles;
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _latest:Number = 1;

        /** @param counts counts the pairs of triangles that are tested */
        public function TrianglePairImpactVisitor(counts:TreeCounts)
        {
            _triangles = new MovedTriangles(counts);
        }

        /** Begins with two models that have triangles. The pose must relate them already, and the motion is the second one's. Returns this. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose, motion:RelativeMotion):BestPairVisitor
        {
            _triangles.begin(a, b, pose, motion);
            _motion.copyVector(motion);
            _latest = motion.latest;
            return this;
        }

        /** @inheritDoc */
        override public function findBest(treeA:BoxTree, a:int, treeB:BoxTree, b:int, best:BestPair):void
        {
            var motion:RelativeMotion = _motion;
            var first:int = treeA.first[a];
            var end:int = treeA.end[a];
            motion.latest = best.least < _latest ? best.least : _latest;
            // Of triangles that touch at the same time, those of the nodes that are tested last count.
            best.current = RelativeMotion.NEVER;
            // Higher indices come first, as in the traversal.
            for (var k:int = _triangles.move(treeB, b) - 1; k >= 0 && best.current > 0; k--)
            {
                _triangles.setSecond(k, motion);
                for (var i:int = end - 1; i >= first && best.current > 0; i--)
                {
                    if (_triangles.findTime(i, motion) && motion.time < best.current)
                    {
                        best.current = motion.latest = motion.time;
                        best.a = i;
                        best.b = treeB.first[b] + k;
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
        public function findContact(best:BestPair, motion:RelativeMotion, out:ContactPoint):void
        {
            _triangles.findContact(best.a, best.b, motion, out);
        }
    }
}
