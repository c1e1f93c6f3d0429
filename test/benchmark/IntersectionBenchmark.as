package benchmark
{
    import evaluation.Measurement;
    import evaluation.pairs.LiteralPairLoops;
    import evaluation.pairs.PairLoops;
    import evaluation.pairs.PairSet;
    import starlogo.bounding.BoundingStructure;

    /**
     * Times the pair tests on random pairs of which 40 % meet, and on pairs that all meet, as multiples of the
     * sphere-sphere test in the same run; beside them the thesis's own algorithms, and the dispatch of
     * <code>intersects</code>.
     */
    public final class IntersectionBenchmark
    {
        private static const ROUNDS:int = 15;
        private static const SEED:uint = 31;
        private static const NAMES:Array = [
                "sphereSphere", "sphereCapsule", "sphereBox", "capsuleCapsule", "capsuleBox", "boxBox"];
        private static const KINDS:Array = [
                [BoundingStructure.SPHERE, BoundingStructure.SPHERE],
                [BoundingStructure.SPHERE, BoundingStructure.CAPSULE],
                [BoundingStructure.SPHERE, BoundingStructure.BOX],
                [BoundingStructure.CAPSULE, BoundingStructure.CAPSULE],
                [BoundingStructure.CAPSULE, BoundingStructure.BOX],
                [BoundingStructure.BOX, BoundingStructure.BOX]];
        // at most, as multiples of sphereSphere: 40 % of the pairs meet, all meet
        private static const TARGETS:Array = [[1, 1], [3, 4], [4, 5], [6, 8], [9, 12], [8, 12]];

        private var _all:Vector.<Measurement> = new Vector.<Measurement>();
        private var _byName:Object = {};

        public function IntersectionBenchmark()
        {
        }

        /** Measures, and returns the table. */
        public function run():String
        {
            for (var i:int = 0; i < NAMES.length; i++)
            {
                addPair(NAMES[i], "some", new PairSet(KINDS[i][0], KINDS[i][1], 0.4, SEED + i));
                addPair(NAMES[i], "all", new PairSet(KINDS[i][0], KINDS[i][1], 1, SEED + i));
            }
            Measurement.runAll(_all, ROUNDS);
            return table();
        }

        private function addPair(pair:String, hits:String, pairs:PairSet):void
        {
            var loops:PairLoops = new PairLoops(pairs);
            add(pair + " " + hits, loops[pair + "Pairs"]);
            add(pair + " dispatched " + hits, loops.intersectsPairs);
            var literal:LiteralPairLoops = new LiteralPairLoops(pairs);
            if (pair + "Pairs" in literal)
            {
                add(pair + " literal " + hits, literal[pair + "Pairs"]);
            }
        }

        private function add(name:String, method:Function):void
        {
            var measurement:Measurement = new Measurement(name, method, PairSet.COUNT);
            _byName[name] = measurement;
            _all.push(measurement);
        }

        private function table():String
        {
            var lines:Array = ["ns a test (multiple of sphereSphere): 40 % hit | all hit; at most | through intersects() | the thesis's"];
            for (var i:int = 0; i < NAMES.length; i++)
            {
                var pair:String = NAMES[i];
                var targets:String = "<= " + TARGETS[i].join(", ");
                lines.push(column(pair, 16) + figures(pair) + " | " + column(targets, 8) + " | " + figures(pair + " dispatched")
                        + (has(pair + " literal") ? " | " + figures(pair + " literal") : ""));
            }
            return lines.join("\n");
        }

        private function has(name:String):Boolean
        {
            return _byName.hasOwnProperty(name + " all");
        }

        private function figures(name:String):String
        {
            return column(figure(name, "some"), 15) + column(figure(name, "all"), 15);
        }

        private function figure(name:String, hits:String):String
        {
            var measurement:Measurement = _byName[name + " " + hits];
            var base:Measurement = _byName["sphereSphere " + hits];
            return measurement.nanoseconds.toFixed(0) + " (" + measurement.timesAsLongAs(base).toFixed(1) + ")";
        }

        private static function column(text:String, width:int):String
        {
            while (text.length < width)
            {
                text += " ";
            }
            return text;
        }
    }
}
