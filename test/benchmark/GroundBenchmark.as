package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentQueries;
    import starlogo.terrain.Terrain;

    /**
     * Frames of BinCollider with 10,000 unit spheres near a ground of 1,000 by 1,000 cells, beside the same frames without handlers for the
     * ground; a mound of 100 by 100 cells; and rays across the ground.
     */
    public class GroundBenchmark
    {
        private static const CELLS:int = 1000;
        private static const AGENTS:int = 10000;
        private static const RAYS:int = 100;
        private static const ROUNDS:int = 9;

        private var _random:SeededRandom = new SeededRandom(38);
        private var _terrain:Terrain = new Terrain(CELLS + 1, CELLS + 1, 1, -CELLS / 2, -CELLS / 2);
        private var _greatLand:GreatLand = new GreatLand();

        /** The table. */
        public function run():String
        {
            _greatLand.addModel(BuiltInModel.sphere());
            var heights:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < (CELLS + 1) * (CELLS + 1); i++)
            {
                heights.push(3 * Math.sin(i % (CELLS + 1) / 17) + 2 * Math.cos(int(i / (CELLS + 1)) / 11));
            }
            _terrain.setHeights(0, 0, CELLS + 1, CELLS + 1, heights);
            var frames:Table = new Table("10,000 spheres", "without ground, ms", "with, ms", "ratio", "on the ground");
            addFrames(frames, 100, 0);
            addFrames(frames, 100, 0.1);
            addFrames(frames, CELLS - 2, 0);
            addFrames(frames, CELLS - 2, 0.1);
            return frames + "\n" + others();
        }

        private function addFrames(table:Table, width:Number, step:Number):void
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < AGENTS; i++)
            {
                var agent:Agent = new Agent("sphere");
                var x:Number = _random.between(-width / 2, width / 2);
                var y:Number = _random.between(-width / 2, width / 2);
                agent.moveTo(x, y, _terrain.heightAt(x, y) + _random.between(-0.1, 0.4));
                agents.push(agent);
            }
            var touches:int = 0;
            var without:Collision = collisionFor(null, null);
            var onGround:Collision = collisionFor(_terrain, function(a:Agent, b:Agent):void
                {
                    touches++;
                });
            var all:Vector.<Measurement> = new <Measurement>[frame(without, agents, step), frame(onGround, agents, step)];
            Measurement.runAll(all, ROUNDS);
            touches = 0;
            onGround.update(agents);
            table.add(width + " patches wide, " + (step == 0 ? "none moved" : "all moved"), all[0].ms, all[1].ms, all[1].timesAsLongAs(all[0]).toFixed(2), touches);
        }

        private function collisionFor(terrain:Terrain, handler:Function):Collision
        {
            var collision:Collision = new Collision(new BinCollider(_greatLand));
            collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent):void
                {
                });
            collision.terrain = terrain;
            if (handler != null)
            {
                collision.onCollision("turtles", Collision.TERRAIN, handler);
            }
            return collision;
        }

        // A frame in which all agents go a step, to and fro.
        private static function frame(collision:Collision, agents:Vector.<Agent>, step:Number):Measurement
        {
            var way:Number = step;
            return new Measurement("frame", function():void
                {
                    for (var i:int = 0; i < agents.length && step > 0; i++)
                    {
                        var agent:Agent = agents[i];
                        agent.moveTo(agent.x + way, agent.y, agent.z);
                    }
                    way = -way;
                    collision.update(agents);
                }, 1);
        }

        private function others():Table
        {
            var queries:AgentQueries = new AgentQueries(new BinCollider(_greatLand));
            queries.terrain = _terrain;
            queries.update(new Vector.<Agent>());
            var raising:Number = 0.001;
            var all:Vector.<Measurement> = new <Measurement>[new Measurement("a mound of 100 by 100 cells", function():void
                    {
                        _terrain.raiseMound(0, 0, 100, raising);
                        raising = -raising;
                    }, 1)];
            for each (var height:Number in [7, 4.5, 2])
            {
                all.push(rays(queries, height));
            }
            Measurement.runAll(all, ROUNDS);
            var table:Table = new Table("the ground", "microseconds");
            for each (var measurement:Measurement in all)
            {
                table.add(measurement.name, (measurement.nanoseconds / 1000).toFixed(1));
            }
            return table;
        }

        private function rays(queries:AgentQueries, height:Number):Measurement
        {
            var origins:Vector.<Vector3D> = new Vector.<Vector3D>();
            var directions:Vector.<Vector3D> = new Vector.<Vector3D>();
            for (var i:int = 0; i < RAYS; i++)
            {
                origins.push(new Vector3D(1 - CELLS / 2, _random.between(-480, 480), height));
                directions.push(new Vector3D(1, _random.between(-0.5, 0.5), _random.between(-0.0005, 0.0005)));
            }
            return new Measurement("a ray from height " + height, function():void
                {
                    for (var j:int = 0; j < RAYS; j++)
                    {
                        queries.cast(origins[j], directions[j], 2 * CELLS);
                    }
                }, RAYS);
        }
    }
}
