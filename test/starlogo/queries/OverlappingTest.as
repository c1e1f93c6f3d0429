package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.intersection.intersects;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.EachCollider;
    import support.Effort;
    import support.Fixtures;
    import support.PlainDistance;
    import support.SolidAngles;
    import support.TransformedStructure;
    import support.assertThrows;

    /** Which agents overlap a structure: against other ways to find out, for each collision system. */
    public class OverlappingTest
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/kelp.obj"];

        private static const SHAPES:Array = ["sphere", "cube", "bear", "kelp"];
        private static const AGENTS:int = 8;

        private static var sGreatLand:GreatLand;
        private static var sModels:Object;

        private var _random:SeededRandom = new SeededRandom(2203);
        private var _agents:Vector.<Agent>;
        private var _hits:int = 0;
        private var _misses:int = 0;

        [BeforeClass]
        public static function load():void
        {
            sGreatLand = new GreatLand();
            sModels = {"sphere": BuiltInModel.sphere(), "cube": BuiltInModel.cube()};
            for each (var name:String in ["bear", "kelp"])
            {
                sModels[name] = new ObjModel(name, Fixtures.text("/assets/" + name + ".obj"));
            }
            for each (var model:Model in sModels)
            {
                sGreatLand.addModel(model);
            }
        }

        [Test(timeout="600000")]
        public function structuresMeetStructures():void
        {
            for (var i:int = 0; i < Effort.choose(60, 3000); i++)
            {
                makeAgents(i);
                var structure:BoundingStructure = anyStructure();
                assertFinds("spheres " + i, new BinCollider(sGreatLand), structure, function(agent:Agent):Boolean
                    {
                        var sphere:Sphere = new Sphere(new Vector3D(agent.x, agent.y, agent.z + agent.size / 2), agent.size / 2);
                        return intersects(sphere, structure);
                    });
                assertFinds("fits " + i, new TightestFitCollider(sGreatLand), structure, function(agent:Agent):Boolean
                    {
                        return intersects(TransformedStructure.of(sGreatLand.boundingStructures.tightestFit(agent.shape), agent), structure);
                    });
            }
            assertMixed();
        }

        [Test(timeout="600000")]
        public function ballsMeetEachTriangle():void
        {
            var system:Collider = EachCollider.make("triangles", sGreatLand);
            for (var i:int = 0; i < Effort.choose(24, 600); i++)
            {
                makeAgents(i);
                var structure:BoundingStructure = i % 2 == 0 ? anySphere() : anyCapsule();
                assertFinds("balls " + i, system, structure, function(agent:Agent):Boolean
                    {
                        return isTriangleNear(agent, structure);
                    });
            }
            assertMixed();
        }

        [Test]
        public function refusesWhatIsNoStructure():void
        {
            var queries:AgentQueries = new AgentQueries(new BinCollider(sGreatLand));
            assertThrows(ArgumentError, /not null/, queries.overlapping, null);
            assertThrows(ArgumentError, /not /, queries.overlapping, new Cylinder(new Vector3D(), new Vector3D(0, 0, 1), 1));
            var sphere:Sphere = new Sphere(new Vector3D(), 1);
            sphere.radius = NaN;
            assertThrows(RangeError, /finite/, queries.overlapping, sphere);
        }

        // Every third world is far out.
        private function makeAgents(world:int):void
        {
            _agents = new Vector.<Agent>();
            for (var i:int = 0; i < AGENTS; i++)
            {
                _agents.push(anyAgent(world));
            }
        }

        private function anyAgent(world:int):Agent
        {
            var agent:Agent = new Agent(_random.pick(SHAPES));
            var middle:Number = world % 3 == 0 ? 3e5 : 0;
            agent.moveTo(middle + _random.normal(), _random.normal() - middle, _random.normal());
            agent.size = _random.logBetween(0.2, 4);
            agent.heading = _random.between(-180, 180);
            if (_random.chance(0.5))
            {
                agent.pitch = _random.between(-90, 90);
                agent.roll = _random.between(-90, 90);
            }
            return agent;
        }

        private function anyPoint():Vector3D
        {
            var near:Agent = _agents[_random.integer(0, AGENTS - 1)];
            return new Vector3D(near.x + _random.normal(), near.y + _random.normal(), near.z + _random.normal());
        }

        private function anyStructure():BoundingStructure
        {
            if (_random.chance(0.3))
            {
                return anySphere();
            }
            if (_random.chance(0.5))
            {
                return anyCapsule();
            }
            var agent:Agent = _agents[0];
            var box:Box = new Box(anyPoint(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, _random.logBetween(0.01, 2),
                    _random.logBetween(0.01, 2), _random.logBetween(0.01, 2));
            var turned:Agent = anyAgent(1);
            var center:Vector3D = box.center;
            box.center = new Vector3D();
            turned.moveTo(center.x, center.y, center.z);
            turned.size = agent.size;
            return TransformedStructure.of(box, turned);
        }

        private function anySphere():Sphere
        {
            return new Sphere(anyPoint(), _random.chance(0.1) ? 0 : _random.logBetween(0.01, 2));
        }

        private function anyCapsule():Capsule
        {
            return new Capsule(anyPoint(), anyPoint(), _random.logBetween(0.01, 2));
        }

        private function find(system:Collider, structure:BoundingStructure):Vector.<Agent>
        {
            var queries:AgentQueries = new AgentQueries(system);
            queries.update(_agents);
            return queries.overlapping(structure);
        }

        private function assertFinds(message:String, system:Collider, structure:BoundingStructure, isExpected:Function):void
        {
            var found:Vector.<Agent> = find(system, structure);
            for each (var agent:Agent in _agents)
            {
                var isHit:Boolean = isExpected(agent);
                isHit ? _hits++ : _misses++;
                assertEquals(message + ": " + structure + " and " + agent, isHit, found.indexOf(agent) >= 0);
            }
        }

        private function assertMixed():void
        {
            assertTrue(_hits + " hits, " + _misses + " misses", _hits > 20 && _misses > 20);
        }

        private static function isTriangleNear(agent:Agent, structure:BoundingStructure):Boolean
        {
            var capsule:Capsule = structure as Capsule;
            var start:Vector3D = capsule == null ? Sphere(structure).center : capsule.start;
            var end:Vector3D = capsule == null ? start : capsule.end;
            var radius:Number = capsule == null ? Sphere(structure).radius : capsule.radius;
            // in the model's space
            var back:Agent = agent;
            var model:Model = sModels[agent.shape];
            var from:Array = inModel(back, start);
            var to:Array = inModel(back, end);
            var core:Array = from.concat(to, to);
            for (var i:int = 0; i < model.triangles.length; i += 3)
            {
                var corners:Array = [];
                for (var k:int = 0; k < 3; k++)
                {
                    var at:int = 3 * model.triangles[i + k];
                    corners.push(model.vertices[at], model.vertices[at + 1], model.vertices[at + 2]);
                }
                if (PlainDistance.between(corners, core) <= radius / agent.size)
                {
                    return true;
                }
            }
            // the leaves of kelp enclose nothing, the parts of a bear do
            return agent.shape != "kelp" && Math.abs(SolidAngles.windingAround(model, from[0], from[1], from[2])) > 0.5;
        }

        private static function inModel(agent:Agent, point:Vector3D):Array
        {
            var to:Vector3D = new Vector3D(point.x - agent.x, point.y - agent.y, point.z - agent.z);
            var numbers:Array = [];
            for each (var axis:Vector3D in [Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS])
            {
                // columns of the transform, of the length of the size
                numbers.push(agent.transform.deltaTransformVector(axis).dotProduct(to) / (agent.size * agent.size));
            }
            return numbers;
        }
    }
}
