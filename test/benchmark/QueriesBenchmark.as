package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import support.landOf;

    /**
     * Questions of each of 10,000 agents, all of which move in every frame: microseconds for each agent, with the update. Counts of what is near
     * against cells that are made for that (PlaceCells), the same agents in turn.
     */
    public class QueriesBenchmark
    {
        private static const COUNT:int = 10000;
        private static const HALF_WIDTH:Number = 50;
        private static const RADIUS:Number = 5;
        private static const ROUNDS:int = 7;

        private var _random:SeededRandom = new SeededRandom(COUNT);
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _queries:AgentQueries;
        private var _cells:PlaceCells = new PlaceCells(HALF_WIDTH, RADIUS, COUNT);
        private var _filter:AgentFilter = AgentFilter.ofBreeds("turtles");
        private var _out:Vector.<Agent> = new Vector.<Agent>();
        private var _step:Number = 0.3;
        private var _sum:int = 0;
        private var _sumOfCells:int = 0;

        /** The table. */
        public function run():String
        {
            var greatLand:GreatLand = landOf(BuiltInModel.cube());
            _queries = new AgentQueries(new TightestFitCollider(greatLand));
            var table:Table = new Table("agents", "question", "microseconds", "of cells");
            addRows(table, "scattered", scattered);
            addRows(table, "in 20 crowds", crowded);
            addRows(table, "in space", inSpace);
            return String(table);
        }

        private function addRows(table:Table, name:String, place:Function):void
        {
            _agents.length = 0;
            for (var i:int = 0; i < COUNT; i++)
            {
                var agent:Agent = new Agent("cube", i % 2 == 0 ? "turtles" : "sheep");
                place(agent);
                _agents.push(agent);
            }
            var measurements:Vector.<Measurement> = new <Measurement>[
                    new Measurement("moves", move, 1), new Measurement("update", update, 1),
                    new Measurement("update, first question", askOnce, 1), new Measurement("nearest", askNearest, 1),
                    new Measurement("nearest of a breed", askNearestOfBreed, 1), new Measurement("countNear 5", askCounts, 1),
                    new Measurement("countNear 5, of a breed", askCountsOfBreed, 1), new Measurement("near 2", askNear, 1),
                    new Measurement("touching", askTouching, 1), new Measurement("moved", askMoved, 1), new Measurement("cells", countInCells, 1)];
            Measurement.runAll(measurements, ROUNDS);
            _sum = _sumOfCells = 0;
            askCounts();
            _sum += COUNT;
            _step = 0;
            countInCells();
            _step = 0.3;
            var last:Measurement = measurements[measurements.length - 1];
            for each (var measurement:Measurement in measurements)
            {
                var isCount:Boolean = measurement.name == "countNear 5";
                table.add(name, measurement.name, microseconds(measurement), isCount ? measurement.timesAsLongAs(last).toFixed(2) : "");
            }
            table.add(name, "counts are the same: " + (_sum == _sumOfCells), "", "");
        }

        private static function microseconds(measurement:Measurement):String
        {
            return (measurement.nanoseconds / 1000 / COUNT).toFixed(2);
        }

        private function scattered(agent:Agent):void
        {
            agent.moveTo(_random.between(-45, 45), _random.between(-45, 45), 0);
        }

        private function crowded(agent:Agent):void
        {
            var crowd:int = _random.integer(0, 19);
            agent.moveTo(crowd * 4 - 40 + _random.between(-1, 1), crowd % 5 * 15 - 30 + _random.between(-1, 1), 0);
        }

        private function inSpace(agent:Agent):void
        {
            agent.moveTo(_random.between(-45, 45), _random.between(-45, 45), _random.between(0, 90));
        }

        private function move():void
        {
            _step = -_step;
            for (var i:int = 0; i < COUNT; i++)
            {
                var agent:Agent = _agents[i];
                agent.moveTo(agent.x + (i % 7 - 3) * _step, agent.y + (i % 5 - 2) * _step, agent.z);
            }
        }

        private function update():void
        {
            move();
            _queries.update(_agents);
        }

        private function askOnce():void
        {
            update();
            _queries.nearest(_agents[0]);
        }

        private function askNearest():void
        {
            update();
            for (var i:int = 0; i < COUNT; i++)
            {
                _queries.nearest(_agents[i]);
            }
        }

        private function askNearestOfBreed():void
        {
            update();
            for (var i:int = 0; i < COUNT; i++)
            {
                _queries.nearest(_agents[i], Infinity, _filter);
            }
        }

        private function askCounts():void
        {
            update();
            for (var i:int = 0; i < COUNT; i++)
            {
                _sum += _queries.countNear(_agents[i], RADIUS);
            }
        }

        private function askCountsOfBreed():void
        {
            update();
            for (var i:int = 0; i < COUNT; i++)
            {
                _sum += _queries.countNear(_agents[i], RADIUS, _filter);
            }
        }

        private function askNear():void
        {
            update();
            for (var i:int = 0; i < COUNT; i++)
            {
                _queries.near(_agents[i], 2, null, _out);
            }
        }

        private function askTouching():void
        {
            update();
            for (var i:int = 0; i < COUNT; i++)
            {
                _queries.touching(_agents[i], null, _out);
            }
        }

        // each agent's place anew, one after the other, with a question in between
        private function askMoved():void
        {
            update();
            _queries.nearest(_agents[0]);
            move();
            for (var i:int = 0; i < COUNT; i++)
            {
                _queries.moved(_agents[i]);
            }
        }

        private function countInCells():void
        {
            move();
            _cells.update(_agents);
            for (var i:int = 0; i < COUNT; i++)
            {
                _sumOfCells += _cells.count(_agents[i]);
            }
        }
    }
}
