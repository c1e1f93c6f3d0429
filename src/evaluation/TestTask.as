package evaluation
{
    import evaluation.pairs.LiteralPairLoops;
    import evaluation.pairs.PairLoops;
    import evaluation.pairs.PairSet;
    import starlogo.bounding.BoundingStructure;

    /** Figure 6-4: the time of an intersection test, on pairs of which 40 % intersect, and on pairs that all intersect. */
    public final class TestTask extends MeasuringTask
    {
        private static const SEED:uint = 31;
        private static const KINDS:Object = {
                sphereSphere: [BoundingStructure.SPHERE, BoundingStructure.SPHERE],
                sphereCapsule: [BoundingStructure.SPHERE, BoundingStructure.CAPSULE],
                sphereBox: [BoundingStructure.SPHERE, BoundingStructure.BOX],
                capsuleCapsule: [BoundingStructure.CAPSULE, BoundingStructure.CAPSULE],
                capsuleBox: [BoundingStructure.CAPSULE, BoundingStructure.BOX],
                boxBox: [BoundingStructure.BOX, BoundingStructure.BOX],
                boxHull: [BoundingStructure.BOX, BoundingStructure.HULL],
                hullHull: [BoundingStructure.HULL, BoundingStructure.HULL]};

        /** The names of the tests. */
        public static const TESTS:Array = ["sphereSphere", "sphereCapsule", "sphereBox", "capsuleCapsule", "capsuleBox",
                "boxBox", "boxHull", "hullHull"];

        private var _test:String;
        private var _byVariant:Object = {};

        /**
         * @param test one of TESTS
         * @param settings says how often
         * @param results takes the times
         */
        public function TestTask(test:String, settings:Settings, results:Results)
        {
            super("the test " + test, settings.repetitions * 160, settings, results);
            _test = test;
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            addPairs("", 0.4);
            addPairs(", all hit", 1);
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            for each (var variant:String in ["engine", "literal", "engine, all hit", "literal, all hit"])
            {
                if (_byVariant.hasOwnProperty(variant))
                {
                    _results.addTime("tests", _test, variant, _byVariant[variant], _base,
                            variant == "engine" ? Thesis.TEST_MS[_test] : undefined);
                }
            }
            return true;
        }

        private function addPairs(suffix:String, hits:Number):void
        {
            var pairs:PairSet = new PairSet(KINDS[_test][0], KINDS[_test][1], hits, SEED);
            var loop:String = _test + "Pairs";
            var loops:PairLoops = new PairLoops(pairs);
            // the sphere-sphere test is the base itself, on the same pairs. Hulls have no function for each pair
            _byVariant["engine" + suffix] = _test == "sphereSphere" && suffix == "" ? _base
                : measure(_test, loop in loops ? loops[loop] : loops.intersectsPairs, PairSet.COUNT);
            var literal:LiteralPairLoops = new LiteralPairLoops(pairs);
            if (loop in literal)
            {
                _byVariant["literal" + suffix] = measure("literal " + _test, literal[loop], PairSet.COUNT);
            }
        }
    }
}
