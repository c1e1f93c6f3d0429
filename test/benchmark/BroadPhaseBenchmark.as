package benchmark
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.models.BuiltInModel;
    import evaluation.pairs.SeededRandom;
    import evaluation.Measurement;
    import evaluation.Table;

    /**
     * BinCollider.findCollisions with unit agents that are scattered over 100 by 100 patches and all have moved, against
     * FlatCells, the floor, on the same positions.
     */
    public class BroadPhaseBenchmark
    {
        private static const COUNTS:Array = [1000, 5000, 10000];
        private static const ROUNDS:int = 9;

        private var _collider:BinCollider;
        private var _floor:FlatCells = new FlatCells(51, 1);
        private var _agents:Vector.<Agent>;
        private var _found:Vector.<Agent> = new Vector.<Agent>();
        private var _x:Vector.<Number>;
        private var _y:Vector.<Number>;
        private var _z:Vector.<Number>;
        private var _radius:Vector.<Number>;

        /** The table. */
        public function run():String
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.addModel(BuiltInModel.sphere());
            _collider = new BinCollider(greatLand);
            var table:Table = new Table("agents", "all moved, ms", "none moved, ms", "floor, ms", "moved / floor", "unmoved / floor", "pairs found by both");
            var first:Number = 0;
            var growth:String = "";
            for each (var count:int in COUNTS)
            {
                scatter(count);
                var moving:Measurement = new Measurement("move and find", moveAndFind, 1);
                var moves:Measurement = new Measurement("move", move, 1);
                var finding:Measurement = new Measurement("find", find, 1);
                var floor:Measurement = new Measurement("floor", findFlat, 1);
                Measurement.runAll(new <Measurement>[moving, moves, finding, floor], ROUNDS);
                var moved:Number = moving.nanoseconds - moves.nanoseconds;
                var same:String = _found.length == _floor.length ? String(_found.length / 2) : "DIFFER: " + _found.length / 2 + ", " + _floor.length / 2;
                table.add(count, ms(moved), ms(finding.nanoseconds), ms(floor.nanoseconds), (moved / floor.nanoseconds).toFixed(2), (finding.nanoseconds / floor.nanoseconds).toFixed(2), same);
                first ||= moved;
                growth += "\n" + count + " agents take " + (moved / first).toFixed(1) + " times as long as " + COUNTS[0];
            }
            return table + growth;
        }

        private function scatter(count:int):void
        {
            var random:SeededRandom = new SeededRandom(count);
            _agents = new Vector.<Agent>();
            _x = new Vector.<Number>();
            _y = new Vector.<Number>();
            _z = new Vector.<Number>();
            _radius = new Vector.<Number>();
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = new Agent("sphere");
                agent.moveTo(random.between(-50, 50), random.between(-50, 50), 0);
                _agents.push(agent);
                _x.push(agent.x);
                _y.push(agent.y);
                _z.push(0.5);
                _radius.push(0.5);
            }
        }

        private function move():void
        {
            for (var i:int = 0; i < _agents.length; i++)
            {
                _agents[i].moveTo(_x[i], _y[i], 0);
            }
        }

        private function find():void
        {
            _collider.findCollisions(_agents, _found);
        }

        private function moveAndFind():void
        {
            move();
            find();
        }

        private function findFlat():void
        {
            _floor.find(_x, _y, _z, _radius);
        }

        private static function ms(nanoseconds:Number):String
        {
            return (nanoseconds / 1e6).toFixed(2);
        }
    }
}
