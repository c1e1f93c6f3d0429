package starlogo.intersection
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import support.ConvexReference;
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;

    /** Random pairs against a reference that works in another way and proves its answers. */
    public class RandomPairsTest
    {
        private static const PAIRS:int = 400;
        private static const PRECISION:Number = 1e-7;

        [Test]
        public function sphereSphere():void
        {
            check(BoundingStructure.SPHERE, BoundingStructure.SPHERE, 0.8);
        }

        [Test]
        public function sphereCapsule():void
        {
            check(BoundingStructure.SPHERE, BoundingStructure.CAPSULE, 0.8);
        }

        [Test]
        public function sphereBox():void
        {
            check(BoundingStructure.SPHERE, BoundingStructure.BOX, 0.9);
        }

        [Test]
        public function capsuleCapsule():void
        {
            check(BoundingStructure.CAPSULE, BoundingStructure.CAPSULE, 0.7);
        }

        [Test]
        public function capsuleBox():void
        {
            check(BoundingStructure.CAPSULE, BoundingStructure.BOX, 0.9);
        }

        [Test]
        public function boxBox():void
        {
            check(BoundingStructure.BOX, BoundingStructure.BOX, 1);
        }

        private static function check(kindA:int, kindB:int, spread:Number):void
        {
            var random:SeededRandom = new SeededRandom(1000 + 10 * kindA + kindB);
            var structures:RandomStructures = new RandomStructures(random);
            var reference:ConvexReference = new ConvexReference();
            var hits:int = 0;
            var undecided:int = 0;
            for (var i:int = 0; i < PAIRS; i++)
            {
                var size:Number = random.logBetween(1e-4, 1e4);
                var a:BoundingStructure = structures.ofKind(kindA, size, spread * size);
                var b:BoundingStructure = structures.ofKind(kindB, size, spread * size);
                reference.compare(a, b, PRECISION * size);
                if (reference.lowerBound <= 0 && reference.upperBound > PRECISION * size)
                {
                    undecided++;
                    continue;
                }
                var isHit:Boolean = reference.lowerBound <= 0;
                hits += isHit ? 1 : 0;
                assertEquals("pair " + i, isHit, intersects(a, b));
                assertEquals("pair " + i + " swapped", isHit, intersects(b, a));
            }
            assertTrue("undecided: " + undecided, undecided <= PAIRS / 100);
            assertTrue("hits: " + hits, hits > 0.25 * PAIRS && hits < 0.75 * PAIRS);
        }
    }
}
