package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import starlogo.solid.ModelTree;
    import starlogo.solid.OverlapTraversal;
    import starlogo.solid.RelativePose;
    import starlogo.solid.TreePair;
    import starlogo.solid.TreeStructureQuery;
    import starlogo.solid.TreeTreeQuery;
    import support.Fixtures;

    use namespace engine;

    /**
     * What a pair of hierarchies, or a hierarchy and a structure, costs: bears and spheres near each other, standing and swept, by the kinds
     * of their nodes and by triangles, and one inside of the other. The last column is a hash of all answers, contacts with them: two
     * versions that answer alike have the same.
     */
    public class TraversalBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const ROUNDS:int = 31;
        private static const PAIRS:int = 400;
        private static const DEPTH:int = 5;

        private var _counts:TreeCounts = new TreeCounts();
        private var _twoTrees:TreeTreeQuery = new TreeTreeQuery(_counts);
        private var _treeAndStructure:TreeStructureQuery = new TreeStructureQuery(_counts);
        private var _trees:TreePair = new TreePair();
        private var _random:SeededRandom = new SeededRandom(2101);
        private var _ball:ModelTree;
        private var _all:Vector.<Measurement> = new Vector.<Measurement>();
        private var _hashes:Array = [];
        private var _hits:Array = [];
        private var _visits:Array = [];

        /** The table. */
        public function run():String
        {
            var bear:Model = new ObjModel("bear", Fixtures.text(FIXTURES[0]));
            var boxes:ModelTree = built(bear);
            _ball = built(BuiltInModel.sphere());
            _trees.pose = new RelativePose();
            add("boxes, upright, far into each other", boxes, boxes, 0.4, 1, true, false);
            add("boxes, upright, near", boxes, boxes, 1.3, 1, true, false);
            add("boxes, leaning, far into each other", boxes, boxes, 0.4, 1, false, false);
            add("boxes, leaning, near", boxes, boxes, 1.3, 1, false, false);
            add("exact, near", boxes, boxes, 1.3, 1, false, true);
            add("small balls inside", boxes, _ball, 0.3, 0.02, false, false);
            addStructures("boxes and structures, near", boxes, false);
            addStructures("exact and structures, near", boxes, true);
            addSwept("swept boxes", boxes, boxes, false);
            addSwept("swept exact", boxes, boxes, true);
            addSweptStructures("swept boxes and structures", boxes, false);
            addSweptStructures("swept exact and structures", boxes, true);
            addTraversal("boxes, leaning, near, the traversal alone", boxes);
            add("boxes, upright, mostly apart", boxes, boxes, 2.6, 1, true, false);
            add("boxes, leaning, mostly apart", boxes, boxes, 2.6, 1, false, false);
            Measurement.runAll(_all, ROUNDS);
            var table:Table = new Table("a pair", "ns", "hits %", "visits", "hash");
            for (var i:int = 0; i < _all.length; i++)
            {
                table.add(_all[i].name, _all[i].samples.low.toFixed(0), _hits[i], _visits[i], _hashes[i]);
            }
            return String(table);
        }

        private function add(name:String, a:ModelTree, b:ModelTree, spread:Number, size:Number, isUpright:Boolean, exact:Boolean):void
        {
            var depth:int = exact ? BoxTree.EXACT : DEPTH;
            var first:Vector.<Placement> = places(spread, 1, isUpright);
            var second:Vector.<Placement> = places(spread, size, isUpright);
            measure(name, function(i:int, answers:ByteArray):void
                {
                    var answer:Boolean = _twoTrees.setTo(a, first[i], depth, b, second[i], depth).areTouching();
                    if (answers != null)
                    {
                        answers.writeDouble(answer ? 1 : 0);
                    }
                });
        }

        // Without what comes before and after the traversal.
        private function addTraversal(name:String, a:ModelTree):void
        {
            var traversal:OverlapTraversal = new OverlapTraversal(_counts);
            var first:Vector.<Placement> = places(1.3, 1, false);
            var second:Vector.<Placement> = places(1.3, 1, false);
            measure(name, function(i:int, answers:ByteArray):void
                {
                    _trees.a = _trees.b = a.boxTree;
                    _trees.depthA = _trees.depthB = DEPTH;
                    _trees.pose.setBetween(first[i], second[i], RelativeMotion.NONE, 0);
                    var answer:Boolean = traversal.find(_trees, null) == OverlapTraversal.OVERLAPPING;
                    if (answers != null)
                    {
                        answers.writeDouble(answer ? 1 : 0);
                    }
                });
        }

        private function addStructures(name:String, a:ModelTree, exact:Boolean):void
        {
            var depth:int = exact ? BoxTree.EXACT : DEPTH;
            var first:Vector.<Placement> = places(1.3, 1, true);
            var second:Vector.<Placement> = places(1.3, 1, true);
            var structures:Vector.<BoundingStructure> = randomStructures();
            measure(name, function(i:int, answers:ByteArray):void
                {
                    var answer:Boolean = _treeAndStructure.setTo(a, first[i], depth, structures[i], second[i]).areTouching();
                    if (answers != null)
                    {
                        answers.writeDouble(answer ? 1 : 0);
                    }
                });
        }

        private function addSwept(name:String, a:ModelTree, b:ModelTree, exact:Boolean):void
        {
            var depth:int = exact ? BoxTree.EXACT : DEPTH;
            var first:Vector.<Placement> = places(1.6, 1, false);
            var second:Vector.<Placement> = places(1.6, 1, false);
            var motions:Vector.<RelativeMotion> = randomMotions();
            var contact:ContactPoint = new ContactPoint();
            measure(name, function(i:int, answers:ByteArray):void
                {
                    _twoTrees.setTo(a, first[i], depth, b, second[i], depth);
                    _twoTrees.findFirstTouch(motions[i], null);
                    var time:Number = motions[i].time;
                    if (answers != null)
                    {
                        answers.writeDouble(time);
                        if (time <= 1)
                        {
                            _twoTrees.findContact(motions[i], contact);
                            writeContact(contact, answers);
                        }
                    }
                });
        }

        private function addSweptStructures(name:String, a:ModelTree, exact:Boolean):void
        {
            var depth:int = exact ? BoxTree.EXACT : DEPTH;
            var first:Vector.<Placement> = places(1.6, 1, false);
            var second:Vector.<Placement> = places(1.6, 1, false);
            var structures:Vector.<BoundingStructure> = randomStructures();
            var motions:Vector.<RelativeMotion> = randomMotions();
            var contact:ContactPoint = new ContactPoint();
            measure(name, function(i:int, answers:ByteArray):void
                {
                    _treeAndStructure.setTo(a, first[i], depth, structures[i], second[i]);
                    _treeAndStructure.findFirstTouch(motions[i], null);
                    var time:Number = motions[i].time;
                    if (answers != null)
                    {
                        answers.writeDouble(time);
                        if (time <= 1)
                        {
                            _treeAndStructure.findContact(motions[i], contact);
                            writeContact(contact, answers);
                        }
                    }
                });
        }

        private static function writeContact(contact:ContactPoint, out:ByteArray):void
        {
            for each (var number:Number in [contact.x, contact.y, contact.z, contact.normalX, contact.normalY, contact.normalZ, contact.depth])
            {
                out.writeDouble(number);
            }
        }

        // The pair's number and null, or where its answers are written.
        private function measure(name:String, pair:Function):void
        {
            var answers:ByteArray = new ByteArray();
            var hits:int = 0;
            _counts.nodeVisits = _counts.triangleTests = 0;
            for (var i:int = 0; i < PAIRS; i++)
            {
                var at:int = answers.position;
                pair(i, answers);
                var end:int = answers.position;
                answers.position = at;
                var first:Number = answers.readDouble();
                hits += end - at > 8 || first == 1 ? 1 : 0;
                answers.position = end;
            }
            _visits.push((_counts.nodeVisits / PAIRS).toFixed(2) + ", " + _counts.triangleTests);
            _hits.push((100 * hits / PAIRS).toFixed(0));
            answers.position = 0;
            var hash:int = 17;
            while (answers.bytesAvailable > 0)
            {
                hash = hash * 31 + answers.readInt() | 0;
                hash ^= hash >>> 13;
            }
            _hashes.push((hash >>> 0).toString(16));
            _all.push(new Measurement(name, function():void
                    {
                        for (var k:int = 0; k < PAIRS; k++)
                        {
                            pair(k, null);
                        }
                    }, PAIRS));
        }

        private function places(spread:Number, size:Number, isUpright:Boolean):Vector.<Placement>
        {
            var all:Vector.<Placement> = new Vector.<Placement>();
            for (var i:int = 0; i < PAIRS; i++)
            {
                var placement:Placement = new Placement();
                placement.size = size * _random.logBetween(0.7, 1.4);
                placement.x = _random.between(-spread, spread) / 2;
                placement.y = _random.between(-spread, spread) / 2;
                placement.z = _random.between(-spread, spread) / 2;
                placement.setRotation(_random.between(0, 360), isUpright ? 0 : _random.between(0, 360), isUpright ? 0 : _random.between(0, 360));
                all.push(placement);
            }
            return all;
        }

        private function randomStructures():Vector.<BoundingStructure>
        {
            var shapes:RandomStructures = new RandomStructures(_random);
            var all:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            for (var i:int = 0; i < PAIRS; i++)
            {
                all.push(shapes.ofKind(i % 3, 0.5, 0.5));
            }
            return all;
        }

        private function randomMotions():Vector.<RelativeMotion>
        {
            var all:Vector.<RelativeMotion> = new Vector.<RelativeMotion>();
            for (var i:int = 0; i < PAIRS; i++)
            {
                var motion:RelativeMotion = new RelativeMotion();
                motion.endAfter(_random.between(-1.5, 1.5), _random.between(-1.5, 1.5), _random.between(-1.5, 1.5));
                all.push(motion);
            }
            return all;
        }

        /** The tree of a model, with its triangles. */
        internal static function built(model:Model):ModelTree
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.prepareExact = true;
            library.add(model.name, model.vertices, model.triangles);
            return library.treeOf(model.name);
        }
    }
}
