package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import headless.Host;
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

        private static const COUNTS:Array = [1, 10];
        private static const SYSTEMS:Array = [BinCollider, TightestFitCollider, HierarchicalCollider, CombinationCollider];
        private static const ROUNDS:int = 25;
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
                addRow(table, count + " bears, scattered", count, Scenes.scattered, "bears");
            }
            return String(table);
        }

        private function addRow(table:Table, name:String, count:int, sceneOf:Function, cast:String):void
        {
            var scene:Scene = sceneOf(count, cast);
            var methods:Array = [];
            for each (var system:Class in SYSTEMS)
            {
                methods.push(find(scene, new system(_greatLand)));
            }
            methods.push(update(scene));
            methods.push((function():void
                    {
                        for (var i:int = 0; i < FRAMES; i++)
                        {
                            scene.step();
                        }
                    }));
            var cells:Array = [name];
            var best:Array = [1e9, 1e9, 1e9, 1e9, 1e9, 1e9];
            for (var round:int = 0; round < 120; round++)
            {
                for (var m:int = 0; m < 6; m++)
                {
                    var start:Number = Host.now;
                    var method:Function = methods[m];
                    for (var k:int = 0; k < 10; k++)
                    {
                        method();
                    }
                    best[m] = Math.min(best[m], (Host.now - start) / 10 / FRAMES);
                }
            }
            for each (var ms:Number in best)
            {
                cells.push((ms * 1000).toFixed(2));
            }
            table.add.apply(table, cells);
        }

        private static function find(scene:Scene, system:CollisionSystem):Function
        {
            var found:Vector.<Agent> = new Vector.<Agent>();
            return (function():void
                {
                    for (var i:int = 0; i < FRAMES; i++)
                    {
                        scene.step();
                        system.findCollisions(scene.agents, found);
                    }
                });
        }

        private function update(scene:Scene):Function
        {
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent):void
                {
                    a.color++;
                });
            return (function():void
                {
                    for (var i:int = 0; i < FRAMES; i++)
                    {
                        scene.step();
                        collision.update(scene.agents);
                    }
                });
        }
    }
}
