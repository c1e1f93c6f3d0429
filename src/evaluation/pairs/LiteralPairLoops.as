package evaluation.pairs
{
    import evaluation.literal.boxBox;
    import evaluation.literal.capsuleBox;
    import evaluation.literal.capsuleCapsule;
    import evaluation.literal.sphereBox;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /** Runs the thesis's own pair tests over a set of pairs. Each method returns the number of hits. */
    public final class LiteralPairLoops
    {
        private var _set:PairSet;

        /** Creates loops over a set. Call only the methods for the set's kinds. */
        public function LiteralPairLoops(pairs:PairSet)
        {
            _set = pairs;
        }

        /** Tests box against box. */
        public function boxBoxPairs():int
        {
            var hits:int = 0;
            var a:Vector.<Box> = _set.boxesA;
            var b:Vector.<Box> = _set.boxesB;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                if (boxBox(a[i], b[i]))
                {
                    hits++;
                }
            }
            return hits;
        }

        /** Tests capsule against box. */
        public function capsuleBoxPairs():int
        {
            var hits:int = 0;
            var a:Vector.<Capsule> = _set.capsulesA;
            var b:Vector.<Box> = _set.boxesB;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                if (capsuleBox(a[i], b[i]))
                {
                    hits++;
                }
            }
            return hits;
        }

        /** Tests capsule against capsule. */
        public function capsuleCapsulePairs():int
        {
            var hits:int = 0;
            var a:Vector.<Capsule> = _set.capsulesA;
            var b:Vector.<Capsule> = _set.capsulesB;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                if (capsuleCapsule(a[i], b[i]))
                {
                    hits++;
                }
            }
            return hits;
        }

        /** Tests sphere against box. */
        public function sphereBoxPairs():int
        {
            var hits:int = 0;
            var a:Vector.<Sphere> = _set.spheresA;
            var b:Vector.<Box> = _set.boxesB;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                if (sphereBox(a[i], b[i]))
                {
                    hits++;
                }
            }
            return hits;
        }
    }
}
