package starlogo.solid
{
    import evaluation.pairs.RandomStructures;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.libraries.HierarchiesLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Effort;
    import support.Fixtures;
    import support.SolidModels;

    use namespace engine;

    /**
     * Models that pass each other: the time is the first at which the standing test says that they collide. That test is asked
     * at 65 moments of each way, shortly before the time, and shortly after.
     */
    public class SweptTreePairTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const KINDS:Array = [BoundingStructure.BOX, BoundingStructure.SPHERE, BoundingStructure.CAPSULE];
        private static const MOMENTS:int = 64;
        private static const SHORTLY:Number = 1e-9;

        private static var sHierarchies:Object;
        private static var sModels:Array;

        private var _pair:TreePairQuery = new TreePairQuery();
        private var _random:SeededRandom;
        private var _ways:int;
        private var _misses:int;
        private var _atStart:int;
        private var _later:int;
        private var _glimpses:int;

        [BeforeClass]
        public static function begin():void
        {
            sHierarchies = {};
            sModels = [BuiltInModel.cube(), BuiltInModel.sphere(), SolidModels.hollow(), SolidModels.apart(),
                    new ObjModel("bear", Fixtures.text(FIXTURES[0]))];
        }

        [Test]
        public function boxes():void
        {
            checkTrees(301, false);
        }

        [Test]
        public function triangles():void
        {
            checkTrees(303, true);
        }

        [Test]
        public function structures():void
        {
            begun(304);
            var shapes:RandomStructures = new RandomStructures(_random);
            var count:int = Effort.choose(150, 3000);
            for (var i:int = 0; i < count; i++)
            {
                var a:SolidHierarchy = hierarchyOf(randomModel());
                var structure:BoundingStructure = shapes.ofKind(_random.pick(KINDS), 0.5, 0.5);
                checkMotion("structure " + i, a, _random.integer(1, 7), null, 0, structure, false);
            }
            report("structures");
        }

        private function checkTrees(seed:int, exact:Boolean):void
        {
            begun(seed);
            var count:int = Effort.choose(exact ? 100 : 120, 3000);
            for (var i:int = 0; i < count; i++)
            {
                var a:SolidHierarchy = hierarchyOf(randomModel());
                var b:SolidHierarchy = hierarchyOf(randomModel());
                checkMotion("trees " + i, a, _random.integer(1, 7), b, _random.integer(1, 7), null, exact);
            }
            report(exact ? "trees, exact" : "trees");
        }

        private function begun(seed:int):void
        {
            _random = new SeededRandom(seed);
            _ways = _misses = _atStart = _later = _glimpses = 0;
        }

        private function report(name:String):void
        {
            trace("  " + name + ": " + _misses + " misses, " + _atStart + " at the start, " + _later + " later, of these seen between two moments only: "
                    + _glimpses);
            assertTrue("misses: " + _misses, _misses > _ways / 10);
            assertTrue("at the start: " + _atStart, _atStart > _ways / 30);
            assertTrue("later: " + _later, _later > _ways / 8);
        }

        // Either b or the structure is null.
        private function checkMotion(name:String, a:SolidHierarchy, depthA:int, b:SolidHierarchy, depthB:int, structure:BoundingStructure,
                exact:Boolean):void
        {
            _ways++;
            var placementA:Placement = placed(1);
            var placementB:Placement = placed(0.7);
            var length:Number = _random.logBetween(0.03, 30);
            var direction:Vector3D = new RandomStructures(_random).direction();
            var way:RelativeMotion = new RelativeMotion();
            way.endAfter(length * direction.x, length * direction.y, length * direction.z);
            // the middle of the way, or another point of it, is where they are near
            var share:Number = _random.between(-0.2, 1.2);
            placementA.x += share * way.x;
            placementA.y += share * way.y;
            placementA.z += share * way.z;
            var isInside:Boolean = b != null && _random.chance(0.15);
            if (isInside)
            {
                placementB.size *= 0.1;
            }
            _pair.setTo(a, placementA, depthA, b, structure, placementB, depthB, exact);
            _pair.findTime(way);
            var time:Number = way.time;
            var isSeen:Boolean = false;
            for (var i:int = 0; i <= MOMENTS && !isSeen; i++)
            {
                var moment:Number = i / MOMENTS;
                isSeen = collide(a, placementA, depthA, b, placementB, depthB, structure, exact, way, moment);
                if (isSeen)
                {
                    assertTrue(name + " collides at " + moment + " but is found at " + time, time <= moment + SHORTLY);
                }
                else
                {
                    assertTrue(name + " does not at " + moment + " but is found then", time != moment);
                }
            }
            if (time == RelativeMotion.NEVER)
            {
                _misses++;
                return;
            }
            if (time == 0)
            {
                _atStart++;
                return;
            }
            _later++;
            _glimpses += isSeen ? 0 : 1;
            // the touch may be shorter than that, but not often
            assertTrue(name + " is found at " + time + " too late",
                    !collide(a, placementA, depthA, b, placementB, depthB, structure, exact, way, time - SHORTLY));
            assertTrue(name + " is found at " + time + " too early",
                    collide(a, placementA, depthA, b, placementB, depthB, structure, exact, way, Math.min(1, time + SHORTLY)));
        }

        private function collide(a:SolidHierarchy, placementA:Placement, depthA:int, b:SolidHierarchy, placementB:Placement, depthB:int,
                structure:BoundingStructure, exact:Boolean, way:RelativeMotion, time:Number):Boolean
        {
            var x:Number = placementA.x;
            var y:Number = placementA.y;
            var z:Number = placementA.z;
            placementA.x += way.startX + time * way.x;
            placementA.y += way.startY + time * way.y;
            placementA.z += way.startZ + time * way.z;
            var answer:Boolean = _pair.areOverlapping(a, placementA, depthA, b, structure, placementB, depthB, exact);
            placementA.x = x;
            placementA.y = y;
            placementA.z = z;
            return answer;
        }

        private function placed(spread:Number):Placement
        {
            var placement:Placement = new Placement();
            placement.size = _random.logBetween(0.5, 2);
            placement.x = _random.between(-spread, spread);
            placement.y = _random.between(-spread, spread);
            placement.z = _random.between(-spread, spread);
            var isUpright:Boolean = _random.chance(0.4);
            placement.setRotation(_random.between(0, 360), isUpright ? 0 : _random.between(0, 360), isUpright ? 0 : _random.between(0, 360));
            return placement;
        }

        private function randomModel():Model
        {
            return _random.pick(sModels);
        }

        private static function hierarchyOf(model:Model):SolidHierarchy
        {
            sHierarchies[model.name] ||= built(model);
            return sHierarchies[model.name];
        }

        private static function built(model:Model):SolidHierarchy
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            library.add(model.name, model.vertices, model.triangles);
            return library.hierarchy(model.name);
        }
    }
}
