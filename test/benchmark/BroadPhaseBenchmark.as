package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.pairs.SeededRandom;
    import headless.Host;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.models.BuiltInModel;

    /**
     * Frames of BinCollider with unit spheres that are scattered over the ground, against AgentCells, the floor, with the same agents
     * in turn. In a frame all of them walk on, 0.3 patches each, and come in on the other side where the ground ends; what
     * moves them, one call of moveTo each, is part of what is timed on both sides. In the frames of "none moved" nothing is.
     */
    public class BroadPhaseBenchmark
    {
        private static const COUNTS:Array = [10000, 30000, 100000];

        // more get a larger ground, on which they are as dense as 10,000 on SpaceLand's
        private static const MOST_ON_SPACELAND:int = 30000;
        private static const HALF_WIDTH:Number = 50;
        private static const ROUNDS:int = 9;
        private static const STEPS:int = 8;
        private static const STEP:Number = 0.3;

        private var _greatLand:GreatLand = new GreatLand();
        private var _collider:BinCollider;
        private var _floor:AgentCells;
        private var _agents:Vector.<Agent>;
        private var _found:Vector.<Agent> = new Vector.<Agent>();
        private var _foundByFloor:Vector.<Agent> = new Vector.<Agent>();

        // where all agents are in each of some frames: x, y, x, y, ...; they are played to and fro
        private var _places:Vector.<Vector.<Number>>;
        private var _frame:int = 0;

        /** The table. */
        public function run():String
        {
            _greatLand.addModel(BuiltInModel.sphere());
            var table:Table = new Table("agents", "engine, ms", "floor, ms", "engine / floor", "pairs found by both");
            for each (var count:int in COUNTS)
            {
                if (count <= MOST_ON_SPACELAND)
                {
                    scatter(count, HALF_WIDTH);
                    addRows(table, String(count));
                }
                else if (Host.player.indexOf("Ruffle") < 0)
                {
                    // Ruffle would take a minute
                    scatter(count, HALF_WIDTH * Math.sqrt(count / 10000));
                    addRows(table, count + " as dense as 10000");
                }
            }
            return String(table);
        }

        private function addRows(table:Table, name:String):void
        {
            var moved:Measurement = new Measurement("all moved", moveAndFind, 1);
            var movedFloor:Measurement = new Measurement("all moved, floor", moveAndFindFloor, 1);
            var unmoved:Measurement = new Measurement("none moved", find, 1);
            var unmovedFloor:Measurement = new Measurement("none moved, floor", findFloor, 1);
            Measurement.runAll(new <Measurement>[moved, movedFloor], ROUNDS);
            Measurement.runAll(new <Measurement>[unmoved, unmovedFloor], ROUNDS);
            addRow(table, name + ", all moved", moved, movedFloor);
            addRow(table, name + ", none moved", unmoved, unmovedFloor);
        }

        private function addRow(table:Table, name:String, engine:Measurement, floor:Measurement):void
        {
            table.add(name, engine.ms, floor.ms, engine.timesAsLongAs(floor).toFixed(2), samePairs());
        }

        private function scatter(count:int, halfWidth:Number):void
        {
            var random:SeededRandom = new SeededRandom(count);
            _collider = new BinCollider(_greatLand);
            _floor = new AgentCells(halfWidth, count);
            _agents = new Vector.<Agent>();
            _places = new Vector.<Vector.<Number>>();
            for (var step:int = 0; step < STEPS; step++)
            {
                _places.push(new Vector.<Number>(2 * count, true));
            }
            for (var i:int = 0; i < count; i++)
            {
                _agents.push(new Agent("sphere"));
                var x:Number = random.between(-halfWidth, halfWidth);
                var y:Number = random.between(-halfWidth, halfWidth);
                var heading:Number = random.between(0, 2 * Math.PI);
                for (step = 0; step < STEPS; step++)
                {
                    _places[step][2 * i] = x;
                    _places[step][2 * i + 1] = y;
                    x = wrap(x + STEP * Math.cos(heading), halfWidth);
                    y = wrap(y + STEP * Math.sin(heading), halfWidth);
                }
            }
            move();
        }

        private static function wrap(coordinate:Number, halfWidth:Number):Number
        {
            if (coordinate > halfWidth)
            {
                return coordinate - 2 * halfWidth;
            }
            return coordinate < -halfWidth ? coordinate + 2 * halfWidth : coordinate;
        }

        private function move():void
        {
            var round:int = _frame % (2 * STEPS - 2);
            var places:Vector.<Number> = _places[round < STEPS ? round : 2 * STEPS - 2 - round];
            var agents:Vector.<Agent> = _agents;
            var count:int = agents.length;
            for (var i:int = 0; i < count; i++)
            {
                agents[i].moveTo(places[2 * i], places[2 * i + 1], 0);
            }
            _frame++;
        }

        private function find():void
        {
            _collider.findCollisions(_agents, _found);
        }

        private function findFloor():void
        {
            _floor.find(_agents, _foundByFloor);
        }

        private function moveAndFind():void
        {
            move();
            find();
        }

        private function moveAndFindFloor():void
        {
            move();
            findFloor();
        }

        // The floor has its own order: sums that tell pairs apart. In the first frame, which is the same in every player.
        private function samePairs():String
        {
            _frame = 0;
            move();
            find();
            findFloor();
            if (_found.length != _foundByFloor.length || sumOf(_found) != sumOf(_foundByFloor))
            {
                return "DIFFER: " + _found.length / 2 + ", " + _foundByFloor.length / 2;
            }
            return String(_found.length / 2);
        }

        private static function sumOf(pairs:Vector.<Agent>):Number
        {
            var sum:Number = 0;
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                var a:int = pairs[i].id;
                var b:int = pairs[i + 1].id;
                // the remainder keeps the sum exact
                sum += (a * 31 + b * 31 + a * b) % 1000003;
            }
            return sum;
        }
    }
}
