package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.models.Model;
    import support.Effort;
    import support.PlacementVectors;
    import support.RealModels;

    /**
     * The colliders against 6,954 pairs of real models whose surfaces are known to meet or not to: tightest fits miss nothing, nor do
     * hierarchies of triangles at any depth, and exact ones are right about all.
     */
    public class PlacementsTest
    {
        public static const FIXTURES:Array = PlacementVectors.FIXTURES.concat(RealModels.FIXTURES);

        private static const DEPTHS:Array = [1, 3, 5, 10];
        private static const FULL:int = 60;

        // The last models that were loaded, and how: the next test may want the same.
        private static var sLoaded:GreatLand = null;
        private static var sLoadedKey:String = "";

        private static var sVectors:PlacementVectors;
        private static var sModels:Vector.<Model>;

        [Test]
        public function tightestFitsMissNothing():void
        {
            readModels();
            var tally:Object = tallyOf("tightest fits", new TightestFitCollider(load(FULL, true)));
            assertEquals("missed", 0, tally.missed);
            assertTrue("enough meet, enough don't", tally.found > 2000 && tally.falseHits + tally.apart > 2000);
        }

        [Test]
        public function hierarchiesOfTrianglesMissNothing():void
        {
            readModels();
            var collider:HierarchicalCollider = new HierarchicalCollider(load(10));
            var falseHits:int = int.MAX_VALUE;
            for each (var depth:int in DEPTHS)
            {
                collider.maxDepth = depth;
                var tally:Object = tallyOf("triangles, depth " + depth, collider);
                assertEquals("missed at depth " + depth, 0, tally.missed);
                assertTrue("deeper is more precise", tally.falseHits <= falseHits);
                falseHits = tally.falseHits;
            }
        }

        [Test]
        public function exactHierarchiesAreTheModels():void
        {
            readModels();
            var collider:HierarchicalCollider = new HierarchicalCollider(load(FULL, true));
            collider.exact = true;
            var wrong:Array = [];
            var inside:int = 0;
            var every:int = Effort.choose(8, 1);
            for (var i:int = 0; i < sVectors.count; i += every)
            {
                sVectors.read(i);
                var isHit:Boolean = collider.areColliding(sVectors.a, sVectors.b);
                // the vectors' insides are also those of models that are not closed
                if (isHit != sVectors.surfacesMeet && !(isHit && sVectors.isInside))
                {
                    wrong.push(i + ": " + sVectors.a.shape + ", " + sVectors.b.shape + (isHit ? " false" : " missed"));
                }
                inside += isHit && sVectors.isInside ? 1 : 0;
            }
            trace("  exact: " + int(sVectors.count / every) + " pairs, " + wrong.length + " wrong, " + inside + " inside of a closed model");
            assertEquals(wrong.slice(0, 10).join("; "), 0, wrong.length);
            assertTrue("many are inside", inside > 500 / every);
        }

        // Once for all tests. Each may be the only one that is run.
        private static function readModels():void
        {
            RealModels.assume();
            if (sVectors == null)
            {
                sVectors = new PlacementVectors();
                sModels = new Vector.<Model>();
                for each (var name:String in sVectors.models)
                {
                    sModels.push(RealModels.read(name));
                }
            }
        }

        private static function load(maxDepth:int, loadTightestFit:Boolean = false):GreatLand
        {
            var key:String = [maxDepth, loadTightestFit].join();
            if (key == sLoadedKey)
            {
                return sLoaded;
            }
            var greatLand:GreatLand = new GreatLand();
            greatLand.loadTightestFit = loadTightestFit;
            greatLand.orientedBoxDegIncrement = 45;
            greatLand.hierarchies.maxDepth = maxDepth;
            for each (var model:Model in sModels)
            {
                greatLand.addModel(model);
            }
            sLoadedKey = key;
            sLoaded = greatLand;
            return greatLand;
        }

        private static function tallyOf(name:String, collider:CollisionSystem):Object
        {
            var tally:Object = {found: 0, missed: 0, falseHits: 0, apart: 0};
            for (var i:int = 0; i < sVectors.count; i++)
            {
                sVectors.read(i);
                // a model inside of another is a collision of solids: neither right nor wrong here
                if (!sVectors.isInside)
                {
                    var isHit:Boolean = collider.areColliding(sVectors.a, sVectors.b);
                    tally[sVectors.surfacesMeet ? (isHit ? "found" : "missed") : isHit ? "falseHits" : "apart"]++;
                }
            }
            trace("  " + name + ": " + tally.missed + " missed, " + tally.falseHits + " false");
            return tally;
        }
    }
}
