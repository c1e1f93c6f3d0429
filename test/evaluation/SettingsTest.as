package evaluation
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.collision.BinCollider;
    import starlogo.fitting.NaiveSphereFitter;
    import support.assertThrows;
    import support.create;

    public class SettingsTest
    {
        [Test]
        public function emptyIsAll():void
        {
            var settings:Settings = new Settings({figures: "", colliders: "", models: "", agents: "", repetitions: "", full: "false"});
            assertEquals(Settings.FIGURES.join(), settings.figures.join());
            assertEquals(Settings.MODELS.join(), settings.models.join());
            assertEquals(4, settings.colliders.length);
            assertFalse(settings.isFull);
        }

        [Test]
        public function fullIsMore():void
        {
            var quick:Settings = new Settings({});
            var full:Settings = new Settings({full: "true"});
            assertTrue(full.isFull);
            assertTrue(full.repetitions > quick.repetitions);
            assertEquals(quick.repetitions, full.longRepetitions);
            assertTrue(quick.longRepetitions < quick.repetitions);
            assertEquals("10,100,300", full.crowds.join());
            assertEquals(10000, full.games[full.games.length - 1]);
        }

        [Test]
        public function listsAreTaken():void
        {
            var settings:Settings = new Settings({figures: "tests,crowds", agents: "20,50", repetitions: "3", models: "bear"});
            assertEquals("tests,crowds", settings.figures.join());
            assertEquals("20,50", settings.crowds.join());
            assertEquals("20,50", settings.games.join());
            assertEquals(3, settings.repetitions);
            assertEquals(3, settings.longRepetitions);
            assertEquals("bear", settings.models.join());
        }

        [Test]
        public function ownClassesAreMade():void
        {
            var types:Object = {"game.Reds": NaiveSphereFitter, "game.Discs": EveryPairSystem, "game.Bins": BinCollider};
            var find:Function = function(name:String):Object
            {
                return types[name];
            };
            var settings:Settings = new Settings({colliders: "TightestFitCollider,game.Discs,game.Bins", fitters: "game.Reds"}, find);
            assertEquals("TightestFitCollider,game.Discs,game.Bins", settings.colliders.join());
            assertTrue(settings.own.fitter("game.Reds") is NaiveSphereFitter);
            assertTrue(Colliders.make("game.Discs", new GreatLand(), settings.own) is EveryPairSystem);
            assertTrue(Colliders.make("game.Bins", new GreatLand(), settings.own) is BinCollider);
            assertThrows(ArgumentError, /-Dcolliders: there is no class "game.Blues"; -Dsources=/, create, Settings, {colliders: "game.Blues"}, find);
            assertThrows(ArgumentError, /-Dcolliders: game.Reds is not a CollisionSystem/, create, Settings, {colliders: "game.Reds"}, find);
            assertThrows(ArgumentError, /-Dfitters: game.Discs is not a Fitter/, create, Settings, {fitters: "game.Discs"}, find);
            assertThrows(ArgumentError, /-Dcolliders: there is no class "BinColider"/, create, Settings, {colliders: "BinColider"});
        }

        [Test]
        public function whatIsNotThereIsRefused():void
        {
            assertThrows(ArgumentError, /-Dfigures.*"test".*tests/, create, Settings, {figures: "test"});
            assertThrows(ArgumentError, /-Dagents.*"many"/, create, Settings, {agents: "10,many"});
            assertThrows(ArgumentError, /-Drepetitions.*"0"/, create, Settings, {repetitions: "0"});
        }
    }
}
