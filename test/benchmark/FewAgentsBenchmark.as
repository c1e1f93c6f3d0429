package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.Fixtures;

    /** Frames of few agents, all moved in each: what a frame costs besides its pairs. Crowds, in which all pairs collide, and scattered. */
    public class FewAgentsBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const COUNTS:Array = [1, 10, 100];
        private static const SYSTEMS:Array = [BinCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider];
        private static const ROUNDS:int = 9;
        private static const FRAMES:int = 20;

        private var _greatLand:GreatLand = new GreatLand();

        /** The table. */
        public function run():String
        {
            _greatLand.addModel(new ObjModel("bear", Fixtures.text("/assets/bear.obj")));
            _greatLand.addModel(BuiltInModel.sphere());
            var table:Table = new Table("us a frame", "Bin", "TightestFit", "Hierarchical", "Combination", "Bin and handlers", "moves alone");
            for each (var count:int in COUNTS)
            {
                addRow(table, count + " bears, a crowd", count, Scenes.crowd, "bears");
                addRow(table, count + " spheres, a crowd", count, Scenes.crowd, "spheres");
                addRow(table, count + " bears, scattered", count, Scenes.scattered, "bears");
            }
            return String(table);
        }

        private function addRow(table:Table, name:String, count:int, sceneOf:Function, cast:String):void
        {
            var scene:Scene = sceneOf(count, cast);
            var measurements:Vector.<Measurement> = new Vector.<Measurement>();
            for each (var system:Class in SYSTEMS)
            {
                measurements.push(find(scene, new system(_greatLand)));
            }
            measurements.push(update(scene));
            measurements.push(new Measurement("moves", function():void
                    {
                        for (var i:int = 0; i < FRAMES; i++)
                        {
                            scene.step();
                        }
                    }, FRAMES));
            Measurement.runAll(measurements, ROUNDS);
            var cells:Array = [name];
            for each (var measurement:Measurement in measurements)
            {
                cells.push((measurement.samples.low / 1000).toFixed(2));
            }
            table.add.apply(table, cells);
        }

        private static function find(scene:Scene, system:CollisionSystem):Measurement
        {
            var found:Vector.<Agent> = new Vector.<Agent>();
            return new Measurement("find", function():void
                {
                    for (var i:int = 0; i < FRAMES; i++)
                    {
                        scene.step();
                        system.findCollisions(scene.agents, found);
                    }
                }, FRAMES);
        }

        private function update(scene:Scene):Measurement
        {
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent):void
                {
                    a.color++;
                });
            return new Measurement("update", function():void
                {
                    for (var i:int = 0; i < FRAMES; i++)
                    {
                        scene.step();
                        collision.update(scene.agents);
                    }
                }, FRAMES);
        }
    }
}
