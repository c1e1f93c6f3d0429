package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.Footing;
    import starlogo.queries.RayHit;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.Fixtures;
    import support.landOf;

    /**
     * What slide and moveUntilTouch take, of agents that go about: microseconds a question, and how many times as long as to ask whom the agent
     * touches. A ray along the same way is beside them. On a floor, walk is beside them too; the slide goes down there, so that it stays on it.
     */
    public class MoveBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/fortress.obj"];

        private static const ROUNDS:int = 7;
        private static const MOVERS:int = 100;
        private static const DOWN:Number = -0.05;

        private var _random:SeededRandom = new SeededRandom(2260);
        private var _queries:AgentQueries;
        private var _agents:Vector.<Agent>;
        private var _length:Number = 1;
        private var _down:Number = 0;
        private var _footing:Footing = new Footing();
        private var _homes:Vector.<Vector3D> = new Vector.<Vector3D>();
        private var _filters:Vector.<AgentFilter> = new Vector.<AgentFilter>();
        private var _round:int = 0;
        private var _met:int = 0;
        private var _from:Vector3D = new Vector3D();
        private var _way:Vector3D = new Vector3D();
        private var _hit:RayHit = new RayHit();
        private var _touched:Vector.<Agent> = new Vector.<Agent>();

        /** The table. */
        public function run():String
        {
            var greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube(), new ObjModel("fortress", Fixtures.text(FIXTURES[0])));
            var table:Table = new Table("agents", "system", "question", "microseconds", "of touching", "met %");
            addRows(table, "spheres in a crowd", "bins", greatLand, crowd("sphere", 1.02));
            addRows(table, "a maze of boxes", "tightest fits", greatLand, crowd("cube", 1.45));
            addRows(table, "a maze of boxes", "hierarchies", greatLand, crowd("cube", 1.45));
            addRows(table, "in a fortress", "hierarchies", greatLand, inFortress(greatLand));
            addRows(table, "in a fortress", "triangles", greatLand, inFortress(greatLand));
            _length = 0.12;
            _down = DOWN;
            var hills:Terrain = makeHills();
            addRows(table, "spheres on hills", "tightest fits", greatLand, onHills(hills, "sphere", "tightest fits", greatLand), hills);
            addRows(table, "cubes on hills", "triangles", greatLand, onHills(hills, "cube", "triangles", greatLand), hills);
            addRows(table, "cubes on cubes", "tightest fits", greatLand, onTiles());
            addRows(table, "cubes on cubes", "triangles", greatLand, onTiles());
            return String(table);
        }

        private function addRows(table:Table, name:String, system:String, greatLand:GreatLand, agents:Vector.<Agent>,
                terrain:Terrain = null):void
        {
            _agents = agents;
            _queries = new AgentQueries(EachCollider.make(system, greatLand));
            _queries.terrain = terrain;
            _queries.update(agents);
            _filters.length = _homes.length = 0;
            for (var i:int = 0; i < MOVERS; i++)
            {
                var others:AgentFilter = new AgentFilter();
                others.except = new <Agent>[agents[i]];
                _filters.push(others);
                _homes.push(new Vector3D(agents[i].x, agents[i].y, agents[i].z));
            }
            var measurements:Vector.<Measurement> = new <Measurement>[
                    new Measurement("slide", slide, 1), new Measurement("moveUntilTouch", moveUntilTouch, 1), new Measurement("cast", cast, 1),
                    new Measurement("touching", askTouching, 1)];
            if (_down < 0)
            {
                measurements.unshift(new Measurement("walk", walk, 1));
            }
            Measurement.runAll(measurements, ROUNDS);
            var last:Measurement = measurements[measurements.length - 1];
            _met = 0;
            for (_round = 0; _round < 49; )
            {
                slide();
            }
            for each (var measurement:Measurement in measurements)
            {
                table.add(name, system, measurement.name, (measurement.nanoseconds / 1000 / MOVERS).toFixed(2), measurement.timesAsLongAs(last).toFixed(2),
                        measurement.name == "slide" ? (100 * _met / 49 / MOVERS).toFixed(0) : "");
            }
        }

        private function slide():void
        {
            begin();
            for (var i:int = 0; i < MOVERS; i++)
            {
                aim(i);
                _met += _queries.slide(_agents[i], _way.x, _way.y, _down) < 1 ? 1 : 0;
            }
        }

        private function walk():void
        {
            begin();
            for (var i:int = 0; i < MOVERS; i++)
            {
                aim(i);
                _queries.walk(_agents[i], _way.x, _way.y, null, _footing);
            }
        }

        private function moveUntilTouch():void
        {
            begin();
            for (var i:int = 0; i < MOVERS; i++)
            {
                aim(i);
                _met += _queries.moveUntilTouch(_agents[i], _way.x, _way.y, 0) < 1 ? 1 : 0;
            }
        }

        private function cast():void
        {
            for (var i:int = 0; i < MOVERS; i++)
            {
                aim(i);
                _from.setTo(_agents[i].x, _agents[i].y, _agents[i].z + 0.2);
                _queries.cast(_from, _way, _length, _filters[i], _hit);
            }
        }

        private function askTouching():void
        {
            for (var i:int = 0; i < MOVERS; i++)
            {
                _queries.touching(_agents[i], null, _touched);
            }
        }

        // They would leave the crowd in the end.
        private function begin():void
        {
            _round++;
            if (_round % 50 == 0)
            {
                for (var i:int = 0; i < MOVERS; i++)
                {
                    _agents[i].moveTo(_homes[i].x, _homes[i].y, _homes[i].z);
                }
                _queries.update(_agents);
            }
        }

        // The way of an agent, each time in another direction, so that it stays about where it is.
        private function aim(i:int):void
        {
            var angle:Number = i + 2.4 * _round;
            _way.setTo(_length * Math.cos(angle), _length * Math.sin(angle), 0);
        }

        private function makeHills():Terrain
        {
            var hills:Terrain = new Terrain(60, 60, 1, -30, -30);
            for (var i:int = 0; i < 60; i++)
            {
                hills.raiseMound(_random.between(-28, 28), _random.between(-28, 28), _random.between(4, 9), _random.between(0.2, 0.8));
            }
            return hills;
        }

        private function onHills(hills:Terrain, shape:String, system:String, greatLand:GreatLand):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < MOVERS; i++)
            {
                agents.push(walkerAt(shape, _random.between(-25, 25), _random.between(-25, 25), 20));
            }
            var queries:AgentQueries = new AgentQueries(EachCollider.make(system, greatLand));
            queries.terrain = hills;
            queries.update(agents);
            for each (var agent:Agent in agents)
            {
                queries.slide(agent, 0, 0, -40);
            }
            return agents;
        }

        private function onTiles():Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < MOVERS; i++)
            {
                agents.push(walkerAt("cube", i % 10 * 2.5 - 12, int(i / 10) * 2.5 - 12, 0.001));
            }
            for (var x:int = -16; x <= 16; x++)
            {
                for (var y:int = -16; y <= 16; y++)
                {
                    var tile:Agent = new Agent("cube");
                    tile.moveTo(x, y, -1);
                    agents.push(tile);
                }
            }
            return agents;
        }

        private static function walkerAt(shape:String, x:Number, y:Number, z:Number):Agent
        {
            var agent:Agent = new Agent(shape);
            agent.size = 0.5;
            agent.moveTo(x, y, z);
            return agent;
        }

        // Agents all over a square, of which no two touch.
        private function crowd(shape:String, apart:Number):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            while (agents.length < 1000)
            {
                var agent:Agent = new Agent(shape);
                agent.moveTo(_random.between(-32, 32), _random.between(-32, 32), 0);
                agent.heading = _random.between(0, 360);
                var isFree:Boolean = true;
                for (var i:int = 0; i < agents.length && isFree; i++)
                {
                    var x:Number = agents[i].x - agent.x;
                    var y:Number = agents[i].y - agent.y;
                    isFree = x * x + y * y > apart * apart;
                }
                if (isFree)
                {
                    agents.push(agent);
                }
            }
            return agents;
        }

        // Cubes in the rooms of a fortress, touching nothing of it.
        private function inFortress(greatLand:GreatLand):Vector.<Agent>
        {
            var exact:Collider = EachCollider.make("triangles", greatLand);
            var fortress:Agent = new Agent("fortress");
            fortress.size = 40;
            var agents:Vector.<Agent> = new Vector.<Agent>();
            while (agents.length < MOVERS)
            {
                var agent:Agent = new Agent("cube");
                agent.size = 0.5;
                agent.heading = _random.between(0, 360);
                agent.moveTo(_random.between(-20, 20), _random.between(-20, 20), _random.between(0, 5));
                if (!exact.areColliding(agent, fortress))
                {
                    agents.push(agent);
                }
            }
            agents.push(fortress);
            return agents;
        }
    }
}
