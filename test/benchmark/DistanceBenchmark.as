package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.models.ColladaModel;
    import starlogo.models.ObjModel;
    import starlogo.solid.ModelTree;
    import starlogo.solid.TreeStructureQuery;
    import starlogo.solid.TreeTreeQuery;
    import support.Fixtures;

    use namespace engine;

    /**
     * What the distance of two trees costs, of bears and of dragons that lean and are apart: their nodes at depth 5, those and a box, and their
     * triangles. PairBenchmark has the distances of structures.
     */
    public class DistanceBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae"];

        private static const ROUNDS:int = 15;
        private static const PAIRS:int = 100;
        private static const DEPTH:int = 5;

        private var _random:SeededRandom = new SeededRandom(2210);
        private var _counts:TreeCounts = new TreeCounts();
        private var _trees:TreeTreeQuery = new TreeTreeQuery(_counts);
        private var _treeAndBox:TreeStructureQuery = new TreeStructureQuery(_counts);
        private var _closest:ClosestPoints = new ClosestPoints();
        private var _all:Vector.<Measurement> = new Vector.<Measurement>();
        private var _visits:Array = [];

        /** The table. */
        public function run():String
        {
            var bear:ModelTree = TraversalBenchmark.built(new ObjModel("bear", Fixtures.text(FIXTURES[0])));
            var dragon:ModelTree = TraversalBenchmark.built(new ColladaModel("dragon", Fixtures.text(FIXTURES[1])));
            addTrees("bears", bear, 1.5);
            addTrees("bears far away", bear, 20);
            addTrees("dragons", dragon, 0.7);
            addTrees("dragons far away", dragon, 20);
            Measurement.runAll(_all, ROUNDS);
            var table:Table = new Table("a pair", "ns", "visits, triangles");
            for (var i:int = 0; i < _all.length; i++)
            {
                table.add(_all[i].name, _all[i].samples.low.toFixed(0), _visits[i]);
            }
            return String(table);
        }

        private function addTrees(name:String, tree:ModelTree, spread:Number):void
        {
            var firsts:Vector.<Placement> = new Vector.<Placement>();
            var seconds:Vector.<Placement> = new Vector.<Placement>();
            while (firsts.length < PAIRS)
            {
                var a:Placement = place(spread);
                var b:Placement = place(spread);
                if (!_trees.setTo(tree, a, DEPTH, tree, b, DEPTH).areTouching())
                {
                    firsts.push(a);
                    seconds.push(b);
                }
            }
            add(name + " at depth 5", function(i:int):void
                {
                    _trees.setTo(tree, firsts[i], DEPTH, tree, seconds[i], DEPTH).findClosest(false, _closest);
                });
            add("  by triangles", function(i:int):void
                {
                    _trees.setTo(tree, firsts[i], BoxTree.EXACT, tree, seconds[i], BoxTree.EXACT).findClosest(false, _closest);
                });
            add("  the other one a box", function(i:int):void
                {
                    _treeAndBox.setTo(tree, firsts[i], DEPTH, tree.root.bounds, seconds[i]).findClosest(false, _closest);
                });
            add("  whether they touch, by triangles", function(i:int):void
                {
                    _trees.setTo(tree, firsts[i], BoxTree.EXACT, tree, seconds[i], BoxTree.EXACT).areTouching();
                });
        }

        private function add(name:String, pair:Function):void
        {
            _counts.nodeVisits = _counts.triangleTests = 0;
            for (var i:int = 0; i < PAIRS; i++)
            {
                pair(i);
            }
            _visits.push((_counts.nodeVisits / PAIRS).toFixed(1) + ", " + (_counts.triangleTests / PAIRS).toFixed(1));
            _all.push(new Measurement(name, function():void
                    {
                        for (var k:int = 0; k < PAIRS; k++)
                        {
                            pair(k);
                        }
                    }, PAIRS));
        }

        private function place(spread:Number):Placement
        {
            var placement:Placement = new Placement();
            placement.size = _random.logBetween(0.7, 1.4);
            placement.x = spread * _random.between(-1, 1);
            placement.y = spread * _random.between(-1, 1);
            placement.z = spread * _random.between(-1, 1);
            placement.setRotation(_random.between(0, 360), _random.between(0, 360), _random.between(0, 360));
            return placement;
        }
    }
}
