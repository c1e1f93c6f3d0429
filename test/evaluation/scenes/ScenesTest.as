package evaluation.scenes
{
    import org.flexunit.asserts.assertEquals;
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
