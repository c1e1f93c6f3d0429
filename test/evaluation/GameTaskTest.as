package evaluation
{
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.collision.BinCollider;
    import starlogo.models.BuiltInModel;

    public class GameTaskTest
    {
        private static const AGENTS:int = 5;

        [Test]
        public function whoCollidesIsShownOnce():void
        {
            var task:GameTask = played(Scenes.crowd(AGENTS, "spheres"));
            assertEquals(AGENTS, task.colliding.length);
            for (var i:int = 0; i < AGENTS; i++)
            {
                assertTrue(task.colliding[i] === task.scene.agents[i]);
            }
        }

        [Test]
        public function whoIsAloneIsNot():void
        {
            assertEquals(0, played(Scenes.crowd(1, "spheres")).colliding.length);
        }

        /** However many frames the noise has had measured, so that the collisions of colliders can be compared. */
        [Test]
        public function theCollisionsAreThoseOfAFixedFrame():void
        {
            assertEquals(collisionsAfter("1"), collisionsAfter("4"));
        }

        private static function collisionsAfter(repetitions:String):int
        {
            var results:Results = new Results();
            played(Scenes.scattered(400, "spheres"), results, repetitions);
            return JSON.parse(results.toText()).entries[0].collisions;
        }

        private static function played(scene:Scene, results:Results = null, repetitions:String = "1"):GameTask
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.addModel(BuiltInModel.sphere());
            results ||= new Results();
            var task:GameTask = new GameTask("crowds", "a few", "BinCollider", scene, new BinCollider(greatLand), null, undefined, new Settings({repetitions: repetitions}), results);
            assertEquals(0, task.colliding.length);
            var steps:int = 0;
            while (!task.work())
            {
                steps++;
            }
            assertTrue(steps > 0);
            assertEquals(0, results.failures);
            return task;
        }
    }
}
