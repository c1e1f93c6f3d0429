package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.models.Model;
    import starlogo.models.ModelLoader;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.PlainDistance;
    import support.RandomWorlds;
    import support.SolidModels;
    import support.assertThrows;

    /** How far points are from agents, against balls that overlap them; and which triangle a ray meets. */
    public class PointDistanceTest
    {
        private static const SHAPES:Array = ["sphere", "cube", "hollow", "crossed", "apart", "open cube", "doll"];
        private static const NEAR:Number = 1e-9;
        // matrices of players have single precision
        private static const NEAR_BY_MATRIX:Number = 1e-5;

        private var _greatLand:GreatLand = new GreatLand();
        private var _models:Object = {};
        private var _random:SeededRandom = new SeededRandom(3807);
        private var _wrong:Complaints = new Complaints();

        [Before]
        public function begin():void
        {
            for each (var model:Model in SolidModels.all())
            {
                _models[model.name] = model;
                _greatLand.addModel(model);
            }
        }

        [Test]
        public function aBallAsWideAsTheDistanceTouches():void
        {
            var inside:int = 0;
            var outside:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _greatLand));
                for (var i:int = Effort.choose(120, 10000); i > 0; i--)
                {
                    var agent:Agent = RandomWorlds.mixed(1, SHAPES, 0, _random)[0];
                    queries.update(new <Agent>[agent]);
                    var point:Vector3D = new Vector3D(_random.between(-1.2, 1.2), _random.between(-1.2, 1.2), _random.between(-0.5, 1.5));
                    var out:Vector3D = new Vector3D(NaN, NaN, NaN);
                    var distance:Number = queries.distanceToPoint(agent, point, out);
                    var message:String = distance + " from " + point + " to " + out + ", " + agent;
                    var same:Vector3D = point.clone();
                    _wrong.addIf(queries.distanceToPoint(agent, same, same) != distance || !same.equals(out), name + ": another into the point itself", message);
                    _wrong.addIf(distance == 0 && !same.equals(point), name + ": not the point itself", message);
                    _wrong.addIf(distance != queries.distanceToPoint(agent, point), name + ": another without a point", message);
                    _wrong.addIf(distance == 0 != queries.overlapping(new Sphere(point, 0)).length > 0 || Math.abs(Vector3D.distance(point, out) - distance) > NEAR,
                            name + ": 0, or the point", message);
                    distance == 0 ? inside++ : outside++;
                    if (distance > NEAR && queries.overlapping(new Sphere(point, distance * (1 - NEAR) - 1e-12)).length > 0
                            || queries.overlapping(new Sphere(point, distance * (1 + NEAR) + NEAR)).length == 0)
                    {
                        _wrong.add(name + ": not as far", message);
                    }
                    _wrong.addIf(!(queries.distanceToPoint(agent, out) < NEAR), name + ": not of the agent", message);
                }
            }
            _wrong.assertNone();
            assertTrue(inside + " inside, " + outside + " outside", inside > 60 && outside > 100);
        }

        [Test]
        public function whatIsRefusedAndWhatIsLoading():void
        {
            var queries:AgentQueries = new AgentQueries(EachCollider.make("triangles", _greatLand));
            var cube:Agent = new Agent("cube");
            var point:Vector3D = new Vector3D(3, 0, 0.5);
            assertThrows(ArgumentError, /agent (is needed|must)/, queries.distanceToPoint, null, point);
            assertThrows(ArgumentError, /point (is needed|must)/, queries.distanceToPoint, cube, null);
            assertThrows(RangeError, /NaN/, queries.distanceToPoint, cube, new Vector3D(0, NaN, 0));
            assertThrows(ArgumentError, /unicorn/, queries.distanceToPoint, new Agent("unicorn"), point);
            assertEquals("of now, in no list", 2.5, queries.distanceToPoint(cube, point));
            cube.x = 1;
            assertEquals(1.5, queries.distanceToPoint(cube, point));
            var loader:ModelLoader = new ModelLoader(_greatLand);
            loader.load("late", "late.obj");
            var late:Agent = new Agent("late");
            queries.update(new <Agent>[late, cube]);
            assertEquals(Infinity, queries.distanceToPoint(late, point, point));
            assertEquals(3, point.x);
            assertTrue("a loading agent touches nothing", queries.castAgent(late, 1, 0, 0) == null && !queries.overlapsAgent(late, 1, 0, 0));
            assertEquals(0, queries.castAgentAll(late, 1, 0, 0).length);
            loader.cancel("late");
        }

        [Test]
        public function raysTellTheirTriangle():void
        {
            var met:int = 0;
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var queries:AgentQueries = new AgentQueries(EachCollider.make(name, _greatLand));
                for (var i:int = Effort.choose(100, 5000); i > 0; i--)
                {
                    var agent:Agent = RandomWorlds.mixed(1, SHAPES, 0, _random)[0];
                    agent.hierarchical = true;
                    queries.update(new <Agent>[agent]);
                    var from:Vector3D = new Vector3D(_random.between(-4, 4), _random.between(-4, 4), _random.between(-4, 4));
                    var hit:RayHit = queries.cast(from, new Vector3D(-from.x, -from.y, 0.5 - from.z));
                    if (hit == null)
                    {
                        continue;
                    }
                    if (name.indexOf("triangles") < 0 && name.indexOf("exact") < 0 || hit.distance == 0)
                    {
                        assertEquals(name, -1, hit.triangle);
                        continue;
                    }
                    met++;
                    var at:Array = [hit.point.x, hit.point.y, hit.point.z];
                    assertTrue(name, PlainDistance.between(cornersOf(agent, hit.triangle), at.concat(at, at)) < NEAR_BY_MATRIX);
                    assertEquals(name, hit.triangle, queries.castAll(from, new Vector3D(-from.x, -from.y, 0.5 - from.z))[0].triangle);
                }
            }
            assertTrue(String(met), met > 60);
        }

        private function cornersOf(agent:Agent, triangle:int):Array
        {
            var model:Model = _models[agent.shape];
            var corners:Array = [];
            for (var i:int = 3 * triangle; i < 3 * triangle + 3; i++)
            {
                var at:int = 3 * model.triangles[i];
                var corner:Vector3D = agent.transform.transformVector(new Vector3D(model.vertices[at], model.vertices[at + 1], model.vertices[at + 2]));
                corners.push(corner.x, corner.y, corner.z);
            }
            return corners;
        }
    }
}
