package starlogo.solid
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BestPair;
    import starlogo.hierarchy.BestPairVisitor;
    import starlogo.hierarchy.RelativePose;
    import starlogo.hierarchy.TreeCounts;

    use namespace engine;

    /** Finds the distance of the triangles of two nodes. It measures only pairs whose extents are nearer than the nearest pair so far. */
    internal final class TrianglePairDistanceVisitor extends BestPairVisitor
    {
        private var _triangles:MovedTriangles;

        /** @param counts counts the pairs of triangles that are measured */
        public function TrianglePairDistanceVisitor(counts:TreeCounts)
        {
            _triangles = new MovedTriangles(counts);
        }

        /** Begins with two models that have triangles. The pose must relate them already. Returns this. */
        public function begin(a:ModelTree, b:ModelTree, pose:RelativePose):BestPairVisitor
        {
            _triangles.begin(a, b, pose, RelativeMotion.NONE);
            return this;
        }

        /** @inheritDoc */
        override public function findBest(treeA:BoxTree, a:int, treeB:BoxTree, b:int, best:BestPair):void
        {
            var points:ClosestPoints = best.points;
            var count:int = _triangles.move(treeB, b);
            var end:int = treeA.end[a];
            for (var i:int = 0; i < count && points.distance > 0; i++)
            {
                _triangles.setSecond(i, RelativeMotion.NONE);
                for (var slot:int = treeA.first[a]; slot < end; slot++)
                {
                    _triangles.findCloser(slot, points);
                }
            }
            best.current = points.distance;
        }
    }
}
