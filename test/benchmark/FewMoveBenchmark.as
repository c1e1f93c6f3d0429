package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import headless.Host;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.terrain.Terrain;

    /**
     * Frames in which all agents move, some, or none: spheres of the BinCollider and turned cubes of the TightestFitCollider, one on each patch,
     * with a handler for all pairs, for the pairs of those that move, or for starts and ends of all pairs. The last row is a maze: 20,000 cubes on a ground, and 50 movers of which
     * 10 sweep, with handlers for touches, their starts and their ends. The times are those of <code>update()</code> and of the moves.
     */
    public class FewMoveBenchmark
    {
        private static const ROUNDS:int = 9;
        private static const SHARES:Array = [1, 0.1, 0.01, 0];
        private static const OF_ALL:String = "all pairs";
        private static const OF_MOVERS:String = "movers";
        private static const OF_TOUCHES:String = "starts and ends";
        private static const SPEED:Number = 0.03;
        private static const WALLS:int = 20000;
        private static const MOVERS:int = 50;
        private static const SWEEPERS:int = 10;

        private var _greatLand:GreatLand = new GreatLand();
        private var _calls:int = 0;

        /** The table. */
        public function run():String
        {
            _greatLand.addModel(BuiltInModel.sphere());
            _greatLand.addModel(BuiltInModel.cube());
            var table:Table = new Table("agents", "all move, ms", "1 of 10", "1 of 100", "none");
            var counts:Array = Host.player.indexOf("Ruffle") < 0 ? [1000, 10000, 100000] : [1000, 10000];
            for each (var count:int in counts)
            {
                for each (var shape:String in ["sphere", "cube"])
                {
                    for each (var handlers:String in [OF_ALL, OF_MOVERS, OF_TOUCHES])
                    {
                        addRow(table, count + " " + shape + "s, " + handlers, shape, count, handlers);
                    }
                }
            }
            var maze:Measurement = mazeFrame();
            Measurement.runAll(new <Measurement>[maze], ROUNDS);
            table.add("a maze of " + WALLS + " cubes", "", "", maze.ms, "");
            return String(table);
        }

        private function addRow(table:Table, name:String, shape:String, count:int, handlers:String):void
        {
            var all:Vector.<Measurement> = new Vector.<Measurement>();
            for each (var share:Number in SHARES)
            {
                all.push(frame(shape, count, share, handlers));
            }
            Measurement.runAll(all, ROUNDS);
            table.add(name, all[0].ms, all[1].ms, all[2].ms, all[3].ms);
        }

        private function frame(shape:String, count:int, share:Number, handlers:String):Measurement
        {
            var random:SeededRandom = new SeededRandom(count);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var movers:Vector.<Agent> = new Vector.<Agent>();
            var side:Number = Math.sqrt(count);
            for (var i:int = 0; i < count; i++)
            {
                var moves:Boolean = int((i + 1) * share) > int(i * share);
                agents.push(scattered(random, shape, handlers == OF_MOVERS && moves ? "movers" : "walls", side));
                if (moves)
                {
                    movers.push(agents[i]);
                }
            }
            var collision:Collision = new Collision(shape == "cube" ? new TightestFitCollider(_greatLand) : new BinCollider(_greatLand));
            if (handlers == OF_TOUCHES)
            {
                collision.onCollisionStart(Collision.ANY_BREED, Collision.ANY_BREED, call);
                collision.onCollisionEnd(Collision.ANY_BREED, Collision.ANY_BREED, call);
            }
            else
            {
                collision.onCollision(handlers == OF_MOVERS ? "movers" : Collision.ANY_BREED, Collision.ANY_BREED, call);
            }
            return measure(collision, agents, movers);
        }

        private function mazeFrame():Measurement
        {
            var random:SeededRandom = new SeededRandom(WALLS);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var side:Number = Math.sqrt(2 * WALLS);
            for (var i:int = 0; i < WALLS; i++)
            {
                agents.push(scattered(random, "cube", "walls", side));
            }
            var movers:Vector.<Agent> = new Vector.<Agent>();
            for (i = 0; i < MOVERS; i++)
            {
                var mover:Agent = scattered(random, "cube", "movers", side);
                mover.sweeps = i < SWEEPERS;
                movers.push(mover);
                agents.push(mover);
            }
            var collision:Collision = new Collision(new TightestFitCollider(_greatLand));
            var cells:int = Math.ceil(side) + 2;
            collision.terrain = new Terrain(cells, cells, 1, -side / 2, -side / 2);
            collision.onCollision("movers", "walls", call);
            collision.onCollision("movers", Collision.TERRAIN, call);
            collision.onCollisionStart("movers", Collision.ANY_BREED, call);
            collision.onCollisionEnd("movers", Collision.ANY_BREED, call);
            return measure(collision, agents, movers);
        }

        private static function scattered(random:SeededRandom, shape:String, breed:String, side:Number):Agent
        {
            var agent:Agent = new Agent(shape, breed);
            agent.moveTo((random.next() - 0.5) * side, (random.next() - 0.5) * side, 0);
            agent.heading = 360 * random.next();
            return agent;
        }

        // The movers go to and fro.
        private function measure(collision:Collision, agents:Vector.<Agent>, movers:Vector.<Agent>):Measurement
        {
            var frames:int = 0;
            return new Measurement("frame", function():void
                {
                    frames++;
                    var by:Number = (frames & 8) == 0 ? SPEED : -SPEED;
                    for each (var mover:Agent in movers)
                    {
                        mover.moveTo(mover.x + by, mover.y, mover.z);
                    }
                    collision.update(agents);
                }, 1);
        }

        private function call(collider:Agent, collidee:Agent):void
        {
            _calls++;
        }
    }
}
