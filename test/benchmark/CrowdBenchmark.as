package benchmark
{
    import evaluation.Measurement;
    import evaluation.Table;
    import evaluation.literal.LiteralTightestFitCollider;
    import evaluation.scenes.Scene;
    import evaluation.scenes.Scenes;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.TightestFitCollider;
    import starlogo.intersection.boxBox;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ObjModel;
    import support.Fixtures;

    /**
     * The thesis's crowd (§6.1): 100 agents in one bin, all colliding, all moved in each frame. With bears, the
     * TightestFitCollider's frame against its box-box tests alone and against the thesis's collider; with spheres, against
     * the BinCollider.
     */
    public class CrowdBenchmark
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const ROUNDS:int = 9;
        private static const COUNT:int = 100;

        private var _scene:Scene;
        private var _collision:Collision;
        private var _tightest:TightestFitCollider;
        private var _literal:LiteralTightestFitCollider;
        private var _found:Vector.<Agent> = new Vector.<Agent>();
        private var _boxes:Vector.<Box> = new Vector.<Box>();

        /** The table. */
        public function run():String
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.addModel(new ObjModel("bear", Fixtures.text("/assets/bear.obj")));
            greatLand.addModel(BuiltInModel.sphere());
            _tightest = new TightestFitCollider(greatLand);
            _literal = new LiteralTightestFitCollider(greatLand.boundingStructures);
            var table:Table = new Table("100 agents, 4,950 pairs", "ms", "ratio", "to", "thesis ms");

            _scene = Scenes.crowd(COUNT, "bears");
            turnAll();
            placeBoxes(greatLand.boundingStructures.tightestFit("bear") as Box);
            var tests:Measurement = new Measurement("the box-box tests alone", testBoxes, 1);
            var frame:Measurement = new Measurement("TightestFitCollider", findTightest, 1);
            var literalFrame:Measurement = new Measurement("the thesis's collider", findLiteral, 1);
            var withHandlers:Measurement = frameOf(_tightest);
            Measurement.runAll(new <Measurement>[tests, frame, literalFrame, withHandlers], ROUNDS);
            table.add("bears: box-box tests alone", ms(tests), "", "", "");
            table.add("bears: find all collisions", ms(frame), ratio(frame, tests), "the tests alone", "1300");
            table.add("bears: and call 9,900 handlers", ms(withHandlers), ratio(withHandlers, tests), "the tests alone", "");
            table.add("bears: the literal thesis collider", ms(literalFrame), ratio(literalFrame, frame), "find all collisions", "1300");

            _scene = Scenes.crowd(COUNT, "spheres");
            var bins:BinCollider = new BinCollider(greatLand);
            var binFrame:Measurement = new Measurement("BinCollider", function():void
                {
                    _scene.step();
                    bins.findCollisions(_scene.agents, _found);
                }, 1);
            frame = new Measurement("TightestFitCollider", findTightest, 1);
            Measurement.runAll(new <Measurement>[binFrame, frame], ROUNDS);
            table.add("spheres: BinCollider", ms(binFrame), "", "", "30");
            table.add("spheres: TightestFitCollider", ms(frame), ratio(frame, binFrame), "BinCollider", "78");
            return String(table);
        }

        private function findTightest():void
        {
            _scene.step();
            _tightest.findCollisions(_scene.agents, _found);
            requireAll(_found.length / 2);
        }

        private function findLiteral():void
        {
            _scene.step();
            var agents:Vector.<Agent> = _scene.agents;
            var hits:int = 0;
            for (var i:int = 0; i < COUNT; i++)
            {
                for (var j:int = i + 1; j < COUNT; j++)
                {
                    if (_literal.areColliding(agents[i], agents[j]))
                    {
                        hits++;
                    }
                }
            }
            requireAll(hits);
        }

        private function frameOf(collider:TightestFitCollider):Measurement
        {
            _collision = new Collision(collider);
            _collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent):void
                {
                    a.color++;
                });
            return new Measurement("a frame", function():void
                {
                    _scene.step();
                    _collision.update(_scene.agents);
                }, 1);
        }

        // Each bear looks elsewhere: boxes in one place and of one direction would be an easy case.
        private function turnAll():void
        {
            for (var i:int = 0; i < COUNT; i++)
            {
                _scene.agents[i].heading = i * 137.5;
                _scene.agents[i].x += (i % 10) * 0.02;
            }
        }

        private function placeBoxes(box:Box):void
        {
            for (var i:int = 0; i < COUNT; i++)
            {
                var agent:Agent = _scene.agents[i];
                var placed:Box = box.clone() as Box;
                placed.rotate(turn(agent.heading));
                placed.translate(new Vector3D(agent.x, agent.y, agent.z));
                _boxes.push(placed);
            }
        }

        private static function turn(heading:Number):Matrix3D
        {
            var rotation:Matrix3D = new Matrix3D();
            rotation.appendRotation(heading, Vector3D.Z_AXIS);
            return rotation;
        }

        private function testBoxes():void
        {
            var hits:int = 0;
            for (var i:int = 0; i < COUNT; i++)
            {
                for (var j:int = i + 1; j < COUNT; j++)
                {
                    if (boxBox(_boxes[i], _boxes[j]))
                    {
                        hits++;
                    }
                }
            }
            requireAll(hits);
        }

        private static function requireAll(hits:int):void
        {
            if (hits != COUNT * (COUNT - 1) / 2)
            {
                throw new Error("all pairs must collide, but " + hits + " do");
            }
        }

        private static function ms(measurement:Measurement):String
        {
            return (measurement.nanoseconds / 1e6).toFixed(1);
        }

        private static function ratio(measurement:Measurement, to:Measurement):String
        {
            return (measurement.nanoseconds / to.nanoseconds).toFixed(2);
        }
    }
}
