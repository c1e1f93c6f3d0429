package starlogo.search.pairs
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.PairTable;
    import starlogo.intersection.ray.ConvexRay;
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
        // The number of tests since takeCounts(), by the kinds of the first and the second structure.
        private var _testCounts:Vector.<int> = new Vector.<int>(BoundingStructure.KIND_COUNT * BoundingStructure.KIND_COUNT, true);
        private var _apart:ApartContact = new ApartContact();

        /** Gives these tests to a narrow phase that does not have them. So a game of spheres alone does not load their code. */
        public static function addTo(narrowPhase:NarrowPhase):void
        {
            SpherePairTests.addTo(narrowPhase);
            narrowPhase.structureTests ||= new StructurePairTests();
            narrowPhase.convexRay ||= new ConvexRay();
        }

        /** Writes the numbers of tests, and sets them to 0. */
        public function takeCounts(out:SearchCounts):void
        {
            out.sphereCapsuleTests = countOf(BoundingStructure.SPHERE, BoundingStructure.CAPSULE);
            out.sphereBoxTests = countOf(BoundingStructure.SPHERE, BoundingStructure.BOX);
            out.capsuleCapsuleTests = countOf(BoundingStructure.CAPSULE, BoundingStructure.CAPSULE);
            out.capsuleBoxTests = countOf(BoundingStructure.CAPSULE, BoundingStructure.BOX);
            out.boxBoxTests = countOf(BoundingStructure.BOX, BoundingStructure.BOX);
            out.hullTests = 0;
            for (var kind:int = 0; kind < BoundingStructure.KIND_COUNT; kind++)
            {
                out.hullTests += countOf(kind, BoundingStructure.HULL);
            }
            for (var i:int = 0; i < _testCounts.length; i++)
            {
                _testCounts[i] = 0;
            }
        }

        // The number of tests of two kinds, in either order.
        private function countOf(a:int, b:int):int
        {
            var count:int = _testCounts[BoundingStructure.KIND_COUNT * a + b];
            return a == b ? count : count + _testCounts[BoundingStructure.KIND_COUNT * b + a];
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            var structureA:BoundingStructure = a.worldStructure();
            var structureB:BoundingStructure = b.worldStructure();
            _testCounts[BoundingStructure.KIND_COUNT * a.form + b.form]++;
            return PairTable.areTouching(structureA, structureB);
        }

        /** @inheritDoc */
        override protected function findTime(a:Body, b:Body, motion:RelativeMotion):void
        {
            var structureA:BoundingStructure = a.worldStructure();
            var structureB:BoundingStructure = b.worldStructure();
            _testCounts[BoundingStructure.KIND_COUNT * a.form + b.form]++;
            PairTable.findTime(structureA, structureB, motion);
            // rounding can miss a touch at the end of the motion
            if (motion.time == RelativeMotion.NEVER && PairTable.areTouching(structureA, structureB))
            {
                motion.time = 1;
            }
        }

        /** @inheritDoc */
        override public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            PairTable.findContact(a.worldStructure(), b.worldStructure(), motion, out);
        }

        /** @inheritDoc */
        override public function separateApart(a:Body, b:Body, out:ContactPoint):void
        {
            _apart.find(this, a, b, out);
        }

        /** @inheritDoc */
        override public function findClosest(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            PairTable.findClosest(a.worldStructure(), b.worldStructure(), out);
            out.correct(areTouching);
        }
    }
}
