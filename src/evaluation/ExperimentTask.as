package evaluation
{
    import evaluation.pairs.LiteralPairLoops;
    import evaluation.pairs.ModelPairs;
    import evaluation.pairs.PairLoops;
    import evaluation.pairs.PairSet;
    import evaluation.pairs.PreliminaryLoops;
    import starlogo.bounding.BoundingStructure;

    /** A question of the thesis (§3.6.4, §7.4, §7.5, §7.7): the time of a test with what it proposes and without, and how many more pairs collide. */
    public final class ExperimentTask extends MeasuringTask
    {
        private static const SEED:uint = 31;
        private static const HITS:Number = 0.4;
        private static const BOX:int = BoundingStructure.BOX;
        private static const CAPSULE:int = BoundingStructure.CAPSULE;

        /** The questions. */
        public static const QUESTIONS:Array = ["§3.6.4 box-box, faces alone", "§7.4 factor 1.5", "§7.4 factor 3", "§7.5 box-box, spheres first",
                "§7.5 capsule-box, spheres first", "§7.5 capsule-capsule, spheres first", "§7.5 box-box, capsules first",
                "§7.5 capsule-box, capsules first", "§7.7 trees of spheres", "§7.7 trees of capsules"];

        private var _question:String;
        private var _models:Array;
        private var _plain:Function;
        private var _proposed:Function;
        private var _count:int = PairSet.COUNT;
        private var _plainTime:Measurement;
        private var _proposedTime:Measurement;

        /**
         * @param question one of QUESTIONS
         * @param models the models of §7.4 and §7.7
         * @param settings says how often
         * @param results takes the times
         */
        public function ExperimentTask(question:String, models:Array, settings:Settings, results:Results)
        {
            super("the question of " + question, settings.repetitions * 200, settings, results);
            _question = question;
            _models = models;
        }

        /** @inheritDoc */
        override protected function prepare():void
        {
            var words:Array = _question.split(" ");
            switch (words[0])
            {
                case "§3.6.4":
                    var boxes:PairSet = new PairSet(BOX, BOX, HITS, SEED);
                    _plain = new LiteralPairLoops(boxes).boxBoxPairs;
                    _proposed = new PreliminaryLoops(boxes).facesPairs;
                    break;
                case "§7.5":
                    var kinds:Array = words[1].split("-");
                    var pairs:PairSet = new PairSet(kinds[0] == "box" ? BOX : CAPSULE, kinds[1] == "box," ? BOX : CAPSULE, HITS, SEED);
                    var first:PreliminaryLoops = new PreliminaryLoops(pairs);
                    _plain = new PairLoops(pairs).intersectsPairs;
                    _proposed = words[2] == "spheres" ? first.spheresFirstPairs : first.capsulesFirstPairs;
                    break;
                default:
                    prepareModels(words);
                    break;
            }
            _plainTime = measure("without", _plain, _count);
            _proposedTime = measure("with", _proposed, _count);
        }

        /** @inheritDoc */
        override protected function conclude():Boolean
        {
            var hits:int = _plain();
            _results.addTime("experiments", _question, "without", _plainTime, _base);
            _results.addTime("experiments", _question, "with", _proposedTime, _base);
            _results.addNumber("experiments", _question, "more", 100 * (_proposed() - hits) / hits, "%");
            return true;
        }

        private function prepareModels(words:Array):void
        {
            var pairs:ModelPairs = new ModelPairs(_models);
            var isOfTrees:Boolean = words[1] == "trees";
            _count = ModelPairs.COUNT;
            _plain = isOfTrees ? pairs.trees(BOX) : pairs.structures(1);
            _proposed = isOfTrees ? pairs.trees(words[3] == "spheres" ? BoundingStructure.SPHERE : CAPSULE) : pairs.structures(Number(words[2]));
        }
    }
}
