package evaluation.pairs
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.intersects;

    /**
     * Random pairs of two kinds of structures, with a given share of hits. All sets of two kinds have the same distribution: sizes within a
     * factor of five, any orientation, and positions in a cube in which 40 % of the pairs touch.
     */
    public final class PairSet
    {
        /** The number of pairs in a set. */
        public static const COUNT:int = 1000;

        private static const NATURAL_HITS:Number = 0.4;

        // The pairs that are drawn to estimate the share of hits, and what is known, by kinds.
        private static const DRAWN:int = 200;
        private static const SEED:uint = 47;
        private static const SPREADS:Object = {};

        /** The first structures of the pairs, and the second. */
        public var a:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();

        /** @copy #a */
        public var b:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();

        /** The same structures by type. The vectors of other kinds are null. */
        public var spheresA:Vector.<Sphere>;

        /** @copy #spheresA */
        public var spheresB:Vector.<Sphere>;

        /** @copy #spheresA */
        public var capsulesA:Vector.<Capsule>;

        /** @copy #spheresA */
        public var capsulesB:Vector.<Capsule>;

        /** @copy #spheresA */
        public var boxesA:Vector.<Box>;

        /** @copy #spheresA */
        public var boxesB:Vector.<Box>;

        private var _structures:RandomStructures;

        /**
         * Draws a set.
         *
         * @param kindA the kind of the first structures: BoundingStructure.SPHERE, CAPSULE, BOX or HULL
         * @param kindB the kind of the second structures
         * @param hits the share of pairs that touch, 0 to 1
         * @param seed the same seed draws the same set
         */
        public function PairSet(kindA:int, kindB:int, hits:Number, seed:uint)
        {
            _structures = new RandomStructures(new SeededRandom(seed));
            fill(kindA, kindB, int(hits * COUNT), spreadOf(kindA, kindB));
            spheresA = kindA == BoundingStructure.SPHERE ? Vector.<Sphere>(a) : null;
            spheresB = kindB == BoundingStructure.SPHERE ? Vector.<Sphere>(b) : null;
            capsulesA = kindA == BoundingStructure.CAPSULE ? Vector.<Capsule>(a) : null;
            capsulesB = kindB == BoundingStructure.CAPSULE ? Vector.<Capsule>(b) : null;
            boxesA = kindA == BoundingStructure.BOX ? Vector.<Box>(a) : null;
            boxesB = kindB == BoundingStructure.BOX ? Vector.<Box>(b) : null;
        }

        private static function spreadOf(kindA:int, kindB:int):Number
        {
            var kinds:String = kindA + " " + kindB;
            if (!(kinds in SPREADS))
            {
                SPREADS[kinds] = naturalSpread(new RandomStructures(new SeededRandom(SEED)), kindA, kindB);
            }
            return SPREADS[kinds];
        }

        private static function naturalSpread(structures:RandomStructures, kindA:int, kindB:int):Number
        {
            var low:Number = 0.1;
            var high:Number = 10;
            while (high / low > 1.01)
            {
                var spread:Number = Math.sqrt(low * high);
                var hits:int = 0;
                for (var i:int = 0; i < DRAWN; i++)
                {
                    if (intersects(structures.ofKind(kindA, 1, spread), structures.ofKind(kindB, 1, spread)))
                    {
                        hits++;
                    }
                }
                if (hits > NATURAL_HITS * DRAWN)
                {
                    low = spread;
                }
                else
                {
                    high = spread;
                }
            }
            return low;
        }

        private function fill(kindA:int, kindB:int, hits:int, spread:Number):void
        {
            var misses:int = COUNT - hits;
            while (hits > 0 || misses > 0)
            {
                var first:BoundingStructure = _structures.ofKind(kindA, 1, spread);
                var second:BoundingStructure = _structures.ofKind(kindB, 1, spread);
                var isHit:Boolean = intersects(first, second);
                if (isHit ? hits > 0 : misses > 0)
                {
                    a.push(first);
                    b.push(second);
                    hits -= isHit ? 1 : 0;
                    misses -= isHit ? 0 : 1;
                }
            }
        }
    }
}
