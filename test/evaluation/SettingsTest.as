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
            var types:Object = {"game.Reds": NaiveSphereFitter, "game.Discs": EveryPairSystem, "game.Bins": BinCollider, "game.Boxes": Named};
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
            assertThrows(ArgumentError, /-Dfitters: game.Bins is not a Fitter/, create, Settings, {fitters: "game.Bins"}, find);
            assertThrows(ArgumentError, /-Dfitters: game.Boxes is not a Fitter/, create, Settings, {fitters: "game.Boxes"}, find);
            assertThrows(ArgumentError, /-Dcolliders: game.Boxes is not a CollisionSystem/, create, Settings, {colliders: "game.Boxes"}, find);
            assertThrows(ArgumentError, /-Dcolliders: there is no class "BinColider"/, create, Settings, {colliders: "BinColider"});
        }

        [Test]
        public function whatWasLeftOutIsMeasuredAlone():void
        {
            var entries:Array = ["tests / boxBox / engine", "crowds / 20 bears / BinCollider, literal", "scattered / 100 mix, as dense / BinCollider", "experiments / §7.4 factor 3 / with"];
            var settings:Settings = new Settings({entries: entries.map(encoded).join(";")});
            assertEquals("20", settings.crowds.join());
            assertEquals("100", settings.games.join());
            assertTrue(settings.isWanted("tests", "boxBox"));
            assertFalse(settings.isWanted("tests", "boxHull"));
            assertTrue(settings.isWanted("crowds", "20 bears", "BinCollider"));
            assertFalse(settings.isWanted("crowds", "20 bears", "TightestFitCollider"));
            assertFalse(settings.isWanted("scattered", "100 mix", "BinCollider"));
            assertTrue(settings.isWanted("experiments", "§7.4 factor 3"));
            assertTrue("all without entries", new Settings({}).isWanted("crowds", "10 bears", "BinCollider"));
        }

        [Test]
        public function aReportHasThem():void
        {
            var described:Object = new Settings({figures: "tests", agents: "", repetitions: "7"}).described;
            assertEquals("false 7 7 10,100 false", [described.full, described.repetitions, described.longRepetitions, described.crowds, described.refused].join(" "));
            assertEquals("{\"figures\":\"tests\",\"repetitions\":\"7\"}", JSON.stringify(described.options).replace(/(.*)("rep.*"),("fig.*")\}/, "{$3,$2}"));
        }

        private static function encoded(text:String, index:int, all:Array):String
        {
            return encodeURIComponent(text);
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

class Named
{
    public var name:String;

    public function Named(name:String)
    {
        this.name = name;
    }
}
