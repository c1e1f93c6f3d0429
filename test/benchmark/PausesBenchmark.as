package benchmark
{
    import evaluation.Colliders;
    import evaluation.Settings;
    import evaluation.Table;
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import headless.Host;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.Fixtures;
    import support.landOf;

    /**
     * How evenly frames come: 1,000 scattered agents, all moving, over 1,000 frames of Collision.update, for each collider. What a
     * frame leaves for the collector shows as frames much longer than the others; the goal is that one in a hundred takes at most
     * twice the median. Of some runs the most even one is shown: what other programs take of the processor differs from run to run, what
     * the collector takes does not.
     */
    public class PausesBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const AGENTS:int = 1000;
        private static const FRAMES:int = 1000;
        private static const WARM_UP:int = 200;
        private static const RUNS:int = 3;

        /** The table. */
        public function run():String
        {
            var greatLand:GreatLand = landOf(new ObjModel("bear", Fixtures.text("/assets/bear.obj")), BuiltInModel.sphere(), BuiltInModel.cube());
            var table:Table = new Table("1,000 scattered agents, 1,000 frames", "median ms", "p99", "most", "p99 to median");
            for each (var name:String in Settings.COLLIDERS)
            {
                var times:Array = timesOf(new Collision(Colliders.make(name, greatLand)));
                for (var run:int = 1; run < RUNS; run++)
                {
                    var again:Array = timesOf(new Collision(Colliders.make(name, greatLand)));
                    times = late(again) < late(times) ? again : times;
                }
                var median:Number = times[FRAMES / 2];
                table.add(name, median.toFixed(3), late(times).toFixed(3), times[FRAMES - 1].toFixed(3), (late(times) / median).toFixed(2));
            }
            return String(table);
        }

        // of frames in order of their times: the one that 99 of 100 are faster than
        private static function late(times:Array):Number
        {
            return times[FRAMES * 99 / 100];
        }

        private static function timesOf(collision:Collision):Array
        {
            var scene:Scene = Scenes.scattered(AGENTS, "mix");
            var calls:int = 0;
            for (var i:int = 0; i < AGENTS; i += 10)
            {
                scene.agents[i].hierarchical = true;
            }
            collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(collider:Agent, collidee:Agent):void
                {
                    calls++;
                });
            var times:Array = [];
            for (i = -WARM_UP; i < FRAMES; i++)
            {
                scene.step();
                var start:Number = Host.now;
                collision.update(scene.agents);
                if (i >= 0)
                {
                    times.push(Host.now - start);
                }
            }
            return times.sort(Array.NUMERIC);
        }
    }
}
