package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.findTimeOfImpact;

    use namespace engine;

    /**
     * Tests two bodies that are structures, but not both spheres: whether they touch, when, and how (thesis §3.6).
     *
     * @private
     */
    public final class StructurePairTests extends PairTests
    {
        /** The number of tests since <code>takeCounts()</code>. The index has a bit for the kind of each of the two structures. */
        public var tests:Vector.<int> = new Vector.<int>(8, true);

        private var _finder:ContactFinder = new ContactFinder();

        /** Writes the numbers of tests, and sets them to 0. */
        public function takeCounts(out:SearchCounts):void
        {
            out.sphereSphereTests = tests[1 << BoundingStructure.SPHERE];
            out.sphereCapsuleTests = tests[1 << BoundingStructure.SPHERE | 1 << BoundingStructure.CAPSULE];
            out.sphereBoxTests = tests[1 << BoundingStructure.SPHERE | 1 << BoundingStructure.BOX];
            out.capsuleCapsuleTests = tests[1 << BoundingStructure.CAPSULE];
            out.capsuleBoxTests = tests[1 << BoundingStructure.CAPSULE | 1 << BoundingStructure.BOX];
            out.boxBoxTests = tests[1 << BoundingStructure.BOX];
            for (var i:int = 0; i < tests.length; i++)
            {
                tests[i] = 0;
            }
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            var structureA:BoundingStructure = a.structure();
            var structureB:BoundingStructure = b.structure();
            tests[1 << a.form | 1 << b.form]++;
            return intersects(structureA, structureB);
        }

        /** @inheritDoc */
        override public function findTime(a:Body, b:Body, motion:RelativeMotion):void
        {
            var structureA:BoundingStructure = a.structure();
            var structureB:BoundingStructure = b.structure();
            tests[1 << a.form | 1 << b.form]++;
            findTimeOfImpact(structureA, structureB, motion);
            // rounding can miss a touch at the end of the motion
            if (motion.time == RelativeMotion.NEVER && areTouching(a, b))
            {
                motion.time = 1;
            }
        }

        /** @inheritDoc */
        override public function findContact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _finder.displacement.stopAt(motion);
            _finder.find(a.structure(), b.structure(), out);
        }

        /** @inheritDoc */
        override public function hasExactContact(a:Body, b:Body):Boolean
        {
            return true;
        }
    }
}
