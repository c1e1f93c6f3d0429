package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.intersects;
    import starlogo.intersection.StructurePairs;

    /**
     * What two structures cost, for each pair of kinds: whether they touch, their time of impact, their contact, their distance.
     */
    public class PairBenchmark
    {
        private static const ROUNDS:int = 15;
        private static const STRUCTURES:int = 1000;
        private static const KINDS:Array = ["sphere", "capsule", "box", "hull"];

        private var _random:SeededRandom = new SeededRandom(2210);
        private var _all:Vector.<Measurement> = new Vector.<Measurement>();
        private var _contact:ContactPoint = new ContactPoint();
        private var _closest:ClosestPoints = new ClosestPoints();

        /** The table. */
        public function run():String
        {
            var names:Array = [];
            for (var a:int = 0; a < KINDS.length; a++)
            {
                for (var b:int = 0; b < KINDS.length; b++)
                {
                    names.push(KINDS[a] + " and " + KINDS[b]);
                    addPair(a, b);
                }
            }
            Measurement.runAll(_all, ROUNDS);
            var table:Table = new Table("a pair, ns", "touch", "impact", "contact", "distance");
            for (var i:int = 0; i < names.length; i++)
            {
                table.add(names[i], low(4 * i), low(4 * i + 1), low(4 * i + 2), low(4 * i + 3));
            }
            return String(table);
        }

        private function low(index:int):String
        {
            return _all[index].samples.low.toFixed(0);
        }

        private function addPair(kindA:int, kindB:int):void
        {
            var shapes:RandomStructures = new RandomStructures(_random);
            var firsts:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            var seconds:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            var motions:Vector.<RelativeMotion> = new Vector.<RelativeMotion>();
            for (var i:int = 0; i < STRUCTURES; i++)
            {
                firsts.push(shapes.ofKind(kindA, 1, 2));
                seconds.push(shapes.ofKind(kindB, 1, 2));
                var motion:RelativeMotion = new RelativeMotion();
                motion.endAfter(_random.between(-2, 2), _random.between(-2, 2), _random.between(-2, 2));
                motions.push(motion);
            }
            add(function(k:int):void
                {
                    intersects(firsts[k], seconds[k]);
                });
            add(function(k:int):void
                {
                    StructurePairs.findTimeOfImpact(firsts[k], seconds[k], motions[k]);
                });
            add(function(k:int):void
                {
                    StructurePairs.findContact(firsts[k], seconds[k], RelativeMotion.NONE, _contact);
                });
            add(function(k:int):void
                {
                    StructurePairs.findClosest(firsts[k], seconds[k], _closest);
                });
        }

        private function add(ask:Function):void
        {
            _all.push(new Measurement("", function():void
                    {
                        for (var k:int = 0; k < STRUCTURES; k++)
                        {
                            ask(k);
                        }
                    }, STRUCTURES));
        }
    }
}
