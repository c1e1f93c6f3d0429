package evaluation
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import support.assertThrows;

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
            assertEquals(quick.repetitions, quick.longRepetitions);
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
        public function whatIsNotThereIsRefused():void
        {
            assertThrows(ArgumentError, /-Dfigures.*"test".*tests/, function():void
                {
                    new Settings({figures: "test"});
                });
            assertThrows(ArgumentError, /-Dagents.*"many"/, function():void
                {
                    new Settings({agents: "10,many"});
                });
            assertThrows(ArgumentError, /-Drepetitions.*"0"/, function():void
                {
                    new Settings({repetitions: "0"});
                });
        }
    }
}
