package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collision;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import support.agentAt;
    import support.assertClose;
    import support.assertThrows;
    import support.landOf;

    /** A LevelCollider finds what a CombinationCollider finds, whose agents collide as the same shapes. */
    public class LevelColliderTest
    {
        private static const SHAPES:Array = ["cube", "sphere", "cylinder"];

        private var _land:GreatLand;
        private var _shapes:LevelShapes;

        [Before]
        public function makeShapes():void
        {
            _land = landOf(BuiltInModel.cube(), BuiltInModel.sphere(), BuiltInModel.cylinder());
            _shapes = new LevelShapes();
            _shapes.addModel(BuiltInModel.cube());
            _shapes.addStructure("sphere", _land.boundingStructures.tightestFit("sphere"));
            _shapes.addStructure("cylinder", _land.boundingStructures.tightestFit("cylinder"));
        }

        [Test]
        public function itsFramesAreThoseOfACombinationCollider():void
        {
            var calls:int = 0;
            var random:SeededRandom = new SeededRandom(9301);
            for each (var isExact:Boolean in [false, true])
            {
                var combination:CombinationCollider = new CombinationCollider(_land);
                combination.exact = _shapes.exact = isExact;
                combination.maxDepth = _shapes.maxDepth = 3;
                var expected:Array = [];
                var found:Array = [];
                var others:Array = [];
                var game:Collision = listenTo(new Collision(combination), expected);
                var level:Collision = listenTo(new Collision(new LevelCollider(_shapes)), found);
                var sharing:Collision = listenTo(new Collision(new LevelCollider(_shapes)), others);
                var agents:Vector.<Agent> = randomAgents(random);
                for (var frame:int = 0; frame < 20; frame++)
                {
                    for each (var agent:Agent in agents)
                    {
                        agent.moveTo(agent.x + random.between(-0.5, 0.5), agent.y + random.between(-0.5, 0.5), agent.z);
                        agent.pitch += random.between(0, 20);
                    }
                    game.update(agents);
                    level.update(agents);
                    sharing.update(agents);
                    assertEquals("frame " + frame, expected.join("\n"), found.join("\n"));
                    assertEquals("with the same shapes, frame " + frame, found.join("\n"), others.join("\n"));
                }
                calls += expected.length;
            }
            assertTrue(calls + " calls", calls > 500);
        }

        private static function randomAgents(random:SeededRandom):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 40; i++)
            {
                var agent:Agent = agentAt(SHAPES[i % 3], random.between(-4, 4), random.between(-4, 4), random.between(-1, 1));
                agent.hierarchical = agent.shape == "cube";
                agent.sweeps = i % 4 == 0;
                agents.push(agent);
            }
            return agents;
        }

        private static function listenTo(collision:Collision, said:Array):Collision
        {
            collision.onCollision("turtles", "turtles", function(a:Agent, b:Agent, contact:Contact):void
                {
                    said.push([a.id, b.id, contact]);
                });
            return collision;
        }

        [Test]
        public function questionsAboutItsGameSeeTheSameShapes():void
        {
            var collision:Collision = new Collision(new LevelCollider(_shapes));
            var seen:SeenAgents = new SeenAgents(collision);
            var box:Agent = new Agent("cube");
            seen.update(new <Agent>[box]);
            assertStrictlyEquals(box, new AgentRays(seen).cast(new Vector3D(-3, 0, 0.5), new Vector3D(1, 0, 0)).agent);
            var queries:AgentQueries = new AgentQueries(collision);
            queries.update(new <Agent>[box]);
            assertClose(1.5, queries.distance(agentAt("sphere", 2.5, 0, 0), box), 1e-9);
        }

        [Test]
        public function itsSnapshotsAreOfAKindOfTheirOwn():void
        {
            var agents:Vector.<Agent> = new <Agent>[new Agent("cube")];
            var level:Collision = new Collision(new LevelCollider(_shapes));
            var combination:Collision = new Collision(new CombinationCollider(_land));
            level.update(agents);
            combination.update(agents);
            level.restore(level.snapshot(), agents);
            assertThrows(ArgumentError, /with a CombinationCollider: that one had a LevelCollider/, combination.restore, level.snapshot(), agents);
            assertThrows(ArgumentError, /with a LevelCollider: that one had a CombinationCollider/, level.restore, combination.snapshot(), agents);
        }

        [Test]
        public function aShapeThatIsReplacedCountsFromTheNextFrameOn():void
        {
            var collider:LevelCollider = new LevelCollider(_shapes);
            var agents:Vector.<Agent> = new <Agent>[agentAt("cube", 0, 0, 0), agentAt("sphere", 3, 0, 0)];
            assertEquals(0, collider.findCollisions(agents).length);
            _shapes.addStructure("sphere", new Sphere(new Vector3D(), 2.6));
            assertEquals(2, collider.findCollisions(agents).length);
        }

        [Test]
        public function itRefusesAgentsWithoutShapes():void
        {
            assertThrows(ArgumentError, "shapes", function():void
                {
                    new LevelCollider(null);
                });
            var collider:LevelCollider = new LevelCollider(_shapes);
            assertThrows(ArgumentError, "add it to the LevelShapes first", collider.findCollisions, new <Agent>[new Agent("wolf"), new Agent("cube")]);
        }
    }
}
