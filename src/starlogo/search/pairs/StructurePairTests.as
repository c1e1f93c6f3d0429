package starlogo.search.pairs
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.StructurePairs;
    import starlogo.intersection.ray.ConvexSpanFinder;
    import starlogo.search.Body;
    import starlogo.search.NarrowPhase;
    import starlogo.search.SearchCounts;

    use namespace engine;

    /**
     * Tests two bodies that are structures, but not both spheres: whether they touch, when, and how (thesis §3.6).
     *
     * @private
     */
    public final class StructurePairTests extends PairTests
    {
        private var _counts:SearchCounts;

        /** @param counts counts the tests */
        public function StructurePairTests(counts:SearchCounts)
        {
            _counts = counts;
        }

        /** Gives these tests to a narrow phase that does not have them. So a game of spheres alone does not load their code. */
        public static function addTo(narrowPhase:NarrowPhase):void
        {
            SpherePairTests.addTo(narrowPhase);
            narrowPhase.structureTests ||= new StructurePairTests(narrowPhase.counts);
            narrowPhase.convexSpans ||= new ConvexSpanFinder();
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            var structureA:BoundingStructure = a.worldStructure();
            var structureB:BoundingStructure = b.worldStructure();
            _counts.structures[BoundingStructure.KIND_COUNT * a.kind + b.kind]++;
            return StructurePairs.areTouching(structureA, structureB);
        }

        /** @inheritDoc */
        override public function findFirstTouch(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            var structureA:BoundingStructure = a.worldStructure();
            var structureB:BoundingStructure = b.worldStructure();
            _counts.structures[BoundingStructure.KIND_COUNT * a.kind + b.kind]++;
            StructurePairs.findTimeOfImpact(structureA, structureB, motion);
            // rounding can miss a touch at the end of a motion that is far shorter than the two
            if (motion.time == RelativeMotion.NEVER && StructurePairs.areTouching(structureA, structureB))
            {
                motion.time = 1;
            }
            findContactIfNeeded(a, b, motion, out);
        }

        /** @inheritDoc */
        override public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            StructurePairs.findContact(a.worldStructure(), b.worldStructure(), motion, out);
        }

        /** @inheritDoc */
        override protected function findClosestInOrder(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            StructurePairs.findClosest(a.worldStructure(), b.worldStructure(), out);
            out.correct(areTouching);
        }
    }
}
