package starlogo.search.pairs
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.boxBox;
    import starlogo.intersection.PairTable;
    import starlogo.intersection.ray.ConvexRay;
    import starlogo.search.Body;
    import starlogo.search.NarrowPhase;
    import starlogo.search.SearchCounts;
    import starlogo.search.table.AgentTable;

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

        private var _narrowPhase:NarrowPhase;

        /** @param narrowPhase tests pairs of a structure and a tree */
        public function StructurePairTests(narrowPhase:NarrowPhase)
        {
            _narrowPhase = narrowPhase;
        }

        /** Gives these tests to a narrow phase that does not have them. So a game of spheres alone does not load their code. */
        public static function addTo(narrowPhase:NarrowPhase):void
        {
            SpherePairTests.addTo(narrowPhase);
            narrowPhase.structureTests ||= new StructurePairTests(narrowPhase);
            narrowPhase.convexRay ||= new ConvexRay();
        }

        /**
         * @inheritDoc
         *
         * <p>The row is a structure, the others may have any shape. Two boxes are tested here, and all other pairs where they belong.</p>
         */
        override public function keepTouching(table:AgentTable, slack:Number, row:int, others:Vector.<int>, count:int):int
        {
            var spheres:SpherePairTests = _narrowPhase.sphereTests;
            var forms:Vector.<int> = table.forms;
            var isSphere:Boolean = forms[row] == BoundingStructure.SPHERE;
            var zs:Vector.<Number> = table.extents.z;
            var halfZs:Vector.<Number> = table.extents.halfZ;
            var boxes:Vector.<Box> = table.boxes;
            var placed:Vector.<int> = table.placedRevisions;
            var revisions:Vector.<int> = table.places.last.revisions;
            var atZ:Number = zs[row];
            var ownHalfZ:Number = halfZs[row] + slack;
            var box:Box = boxes[row];
            var body:Body = null;
            var boxTests:int = 0;
            var kept:int = 0;
            if (box != null && placed[row] != revisions[row])
            {
                table.placeBox(row);
            }
            for (var i:int = 0; i < count; i++)
            {
                // two boxes need no test of their extents, except for the heights
                var other:int = others[i];
                var distance:Number = zs[other] - atZ;
                var maxDistance:Number = ownHalfZ + halfZs[other];
                if (distance > maxDistance)
                {
                    continue;
                }
                if (distance < -maxDistance)
                {
                    continue;
                }
                var otherBox:Box = boxes[other];
                if (box != null && otherBox != null)
                {
                    boxTests++;
                    if (placed[other] != revisions[other])
                    {
                        table.placeBox(other);
                    }
                    if (!boxBox(box, otherBox))
                    {
                        continue;
                    }
                }
                else if (isSphere && forms[other] == BoundingStructure.SPHERE)
                {
                    if (!spheres.areRowsTouching(table, slack, row, other))
                    {
                        continue;
                    }
                }
                else if (!NarrowPhase.areNear(table.extents, slack, row, other) || !_narrowPhase.areTouching(body ||= table.bodyOf(row), table.bodyOf(other)))
                {
                    continue;
                }
                others[kept] = other;
                kept++;
            }
            _testCounts[BoundingStructure.KIND_COUNT * BoundingStructure.BOX + BoundingStructure.BOX] += boxTests;
            return kept;
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
        override public function findTime(a:Body, b:Body, motion:RelativeMotion):void
        {
            var structureA:BoundingStructure = a.worldStructure();
            var structureB:BoundingStructure = b.worldStructure();
            _testCounts[BoundingStructure.KIND_COUNT * a.form + b.form]++;
            PairTable.findTime(structureA, structureB, motion);
            // rounding can miss a touch at the end of the motion
            if (motion.time == RelativeMotion.NEVER && areTouching(a, b))
            {
                motion.time = 1;
            }
        }

        /** @inheritDoc */
        override public function findContact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            PairTable.findContact(a.worldStructure(), b.worldStructure(), motion, out);
        }
    }
}
