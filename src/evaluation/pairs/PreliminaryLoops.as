package evaluation.pairs
{
    import evaluation.literal.boxFaces;
    import evaluation.literal.capsuleAround;
    import evaluation.literal.sphereAround;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.intersection.capsuleCapsule;
    import starlogo.intersection.intersects;
    import starlogo.intersection.sphereSphere;

    /** Runs the cheaper tests that the thesis proposes over a set of pairs. Each method returns the number of hits. */
    public final class PreliminaryLoops
    {
        private var _set:PairSet;
        private var _spheres:Vector.<Sphere> = new Vector.<Sphere>();
        private var _capsules:Vector.<Capsule> = new Vector.<Capsule>();

        /** Creates loops over a set of boxes and capsules. */
        public function PreliminaryLoops(pairs:PairSet)
        {
            _set = pairs;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                _spheres.push(sphereAround(pairs.a[i]), sphereAround(pairs.b[i]));
                _capsules.push(capsuleAround(pairs.a[i]), capsuleAround(pairs.b[i]));
            }
        }

        /** Tests the faces of two boxes alone (§3.6.4). */
        public function facesPairs():int
        {
            var hits:int = 0;
            var a:Vector.<Box> = _set.boxesA;
            var b:Vector.<Box> = _set.boxesB;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                if (boxFaces(a[i], b[i]))
                {
                    hits++;
                }
            }
            return hits;
        }

        /** Tests the spheres around two structures first, then the structures (§7.5). */
        public function spheresFirstPairs():int
        {
            var hits:int = 0;
            var a:Vector.<BoundingStructure> = _set.a;
            var b:Vector.<BoundingStructure> = _set.b;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                if (sphereSphere(_spheres[2 * i], _spheres[2 * i + 1]) && intersects(a[i], b[i]))
                {
                    hits++;
                }
            }
            return hits;
        }

        /** Tests the capsules around two structures first, then the structures (§7.5). */
        public function capsulesFirstPairs():int
        {
            var hits:int = 0;
            var a:Vector.<BoundingStructure> = _set.a;
            var b:Vector.<BoundingStructure> = _set.b;
            for (var i:int = 0; i < PairSet.COUNT; i++)
            {
                if (capsuleCapsule(_capsules[2 * i], _capsules[2 * i + 1]) && intersects(a[i], b[i]))
                {
                    hits++;
                }
            }
            return hits;
        }
    }
}
