package starlogo.collision
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.capsuleCapsule;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereSphere;

    /**
     * How a collider tests the structures of two agents: by the exact test of their kinds (thesis §3.6), after cheaper ones if
     * those are wanted. May be changed at any time; what is found changes with <code>boxFacesOnly</code> alone.
     */
    public final class StructureTests
    {
        /**
         * Whether two structures that are not both spheres are tested only if spheres around them meet (thesis §7.5). Counts for
         * models that were added with loadAllBoundingStructures.
         */
        public var spheresFirst:Boolean = true;

        /**
         * Whether a box and another box or a capsule are tested only if capsules around them meet (thesis §7.5), after the
         * spheres. It pays where many boxes are long, thin and near each other. Counts for models that were added with
         * loadAllBoundingStructures.
         */
        public var capsulesFirst:Boolean = false;

        /**
         * Whether two boxes are taken to collide if none of their faces separates them (thesis §3.6.4). This is conservative: no
         * collision is missed, but boxes that pass each other edge to edge are said to collide, by the thesis's estimate in 7.5 % of
         * the tests. It saves about a third of the time of boxes that meet.
         */
        public var boxFacesOnly:Boolean = false;

        // How often each test was made in this search, by the kinds of the structures; two boxes apart.
        private var _tests:Vector.<int> = new Vector.<int>(16, true);
        private var _boxBoxTests:int = 0;

        /** The exact tests, with spheres first where they are at hand. */
        public function StructureTests()
        {
        }

        /** Whether the structures of two shapes overlap. */
        internal function overlaps(a:WorldShape, b:WorldShape):Boolean
        {
            if (a.worldOuterSphere != null && b.worldOuterSphere != null)
            {
                if (!passPreliminaryTests(a, b))
                {
                    return false;
                }
            }
            var boxA:Box = a.worldBox;
            var boxB:Box = b.worldBox;
            if (boxA != null && boxB != null)
            {
                _boxBoxTests++;
                return boxBox(boxA, boxB, boxFacesOnly);
            }
            _tests[a.worldStructure.kind << 2 | b.worldStructure.kind]++;
            return intersects(a.worldStructure, b.worldStructure);
        }

        /** Begins to count. */
        internal function resetCounts():void
        {
            _boxBoxTests = 0;
            for (var i:int = 0; i < _tests.length; i++)
            {
                _tests[i] = 0;
            }
        }

        /** Adds the tests that were made to their kinds. */
        internal function countInto(statistics:CollisionStatistics):void
        {
            statistics.sphereSphereTests += testsOf(BoundingStructure.SPHERE, BoundingStructure.SPHERE);
            statistics.sphereCapsuleTests += testsOf(BoundingStructure.SPHERE, BoundingStructure.CAPSULE);
            statistics.sphereBoxTests += testsOf(BoundingStructure.SPHERE, BoundingStructure.BOX);
            statistics.capsuleCapsuleTests += testsOf(BoundingStructure.CAPSULE, BoundingStructure.CAPSULE);
            statistics.capsuleBoxTests += testsOf(BoundingStructure.CAPSULE, BoundingStructure.BOX);
            statistics.boxBoxTests += _boxBoxTests;
        }

        private function passPreliminaryTests(a:WorldShape, b:WorldShape):Boolean
        {
            if (spheresFirst)
            {
                _tests[BoundingStructure.SPHERE << 2 | BoundingStructure.SPHERE]++;
                if (!sphereSphere(a.worldOuterSphere, b.worldOuterSphere))
                {
                    return false;
                }
            }
            if (capsulesFirst && (a.worldBox != null || b.worldBox != null))
            {
                _tests[BoundingStructure.CAPSULE << 2 | BoundingStructure.CAPSULE]++;
                return capsuleCapsule(a.worldOuterCapsule, b.worldOuterCapsule);
            }
            return true;
        }

        private function testsOf(kind:int, otherKind:int):int
        {
            var count:int = _tests[kind << 2 | otherKind];
            return kind == otherKind ? count : count + _tests[otherKind << 2 | kind];
        }
    }
}
