package evaluation.scenes
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.collision.BinCollider;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.ObjModel;
    import support.CollisionHash;
    import support.Fixtures;
    import support.assertThrows;

    public class ScenesTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/dragon.dae"];

        private static const FRAMES:int = 12;
        private static const CROWD:int = 12;
        private static const SCATTERED:int = 800;
        private static const COLLIDERS:Array = [BinCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider];

        // of spheres, bears and the mix: what collides, over all frames, in the order of the list; in a crowd all do
        private static const CROWD_HASHES:Array = [
                "f3e1b885 f3e1b885 f3e1b885",
                "f3e1b885 f3e1b885 f3e1b885",
                "f3e1b885 f3e1b885 f3e1b885",
                "f3e1b885 f3e1b885 f3e1b885"];
        private static const SCATTERED_HASHES:Array = [
                "242fec25 242fec25 242fec25",
                "242fec25 2a65ed5a 64ee9c8a",
                "5acd9d2b 3399eac5 52b90f4c",
                "7a725d07 714d0f2d fb0989df"];

        private static var sGreatLand:GreatLand;

        [BeforeClass]
        public static function load():void
        {
            sGreatLand = new GreatLand();
            sGreatLand.addModel(BuiltInModel.sphere());
            sGreatLand.addModel(BuiltInModel.cube());
            sGreatLand.addModel(new ObjModel("bear", Fixtures.text("/assets/bear.obj")));
            sGreatLand.addModel(new ColladaModel("dragon", Fixtures.text("/assets/dragon.dae")));
        }

        [Test]
        public function collisionsOfACrowdAreTheSameOnEveryRun():void
        {
            assertEquals(CROWD_HASHES.join("\n"), hashes(Scenes.crowd, CROWD).join("\n"));
        }

        [Test]
        public function collisionsOfAScatteredGameAreTheSameOnEveryRun():void
        {
            assertEquals(SCATTERED_HASHES.join("\n"), hashes(Scenes.scattered, SCATTERED).join("\n"));
        }

        [Test]
        public function scenesDiffer():void
        {
            var collider:BinCollider = new BinCollider(sGreatLand);
            var scattered:CollisionHash = new CollisionHash(Scenes.scattered(SCATTERED, "spheres"), collider, FRAMES);
            var other:CollisionHash = new CollisionHash(Scenes.scattered(SCATTERED + 1, "spheres"), collider, FRAMES);
            var crowd:CollisionHash = new CollisionHash(Scenes.crowd(CROWD, "spheres"), collider, FRAMES);
            var later:CollisionHash = new CollisionHash(Scenes.scattered(SCATTERED, "spheres"), collider, FRAMES + 1);
            assertFalse("a scattered game and one of more agents", String(scattered) == String(other));
            assertFalse("a scattered game and a crowd", String(scattered) == String(crowd));
            assertFalse("a longer game", String(scattered) == String(later));
        }

        [Test]
        public function inACrowdEveryPairCollidesInEveryFrame():void
        {
            for each (var collider:Class in COLLIDERS)
            {
                for each (var cast:String in Scenes.CROWD_CASTS)
                {
                    var hash:CollisionHash = new CollisionHash(Scenes.crowd(CROWD, cast), new collider(sGreatLand), FRAMES);
                    assertEquals(collider + ", " + cast, FRAMES * CROWD * (CROWD - 1) / 2, hash.collisions);
                }
            }
        }

        [Test]
        public function inAScatteredGameSomeCollide():void
        {
            var hash:CollisionHash = new CollisionHash(Scenes.scattered(SCATTERED, "mix"), new TightestFitCollider(sGreatLand), FRAMES);
            assertTrue(String(hash.collisions), hash.collisions > 100 * FRAMES / 3 && hash.collisions < 1000 * FRAMES);
        }

        [Test]
        public function aCastThatIsNotThereIsRefused():void
        {
            assertThrows(ArgumentError, /not "wolves"/, Scenes.crowd, 3, "wolves");
        }

        private static function hashes(scene:Function, count:int):Array
        {
            var lines:Array = [];
            for each (var type:Class in COLLIDERS)
            {
                var line:Array = [];
                for each (var cast:String in Scenes.CASTS)
                {
                    var played:Scene = scene(count, cast);
                    for (var i:int = 0; i < count; i += 3)
                    {
                        played.agents[i].hierarchical = true;
                    }
                    var collider:CollisionSystem = new type(sGreatLand);
                    line.push(new CollisionHash(played, collider, FRAMES));
                }
                lines.push(line.join(" "));
            }
            return lines;
        }
    }
}
