package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    /** Games as large and as small as agents allow are like any other. */
    public class ExtremesTest
    {
        // Powers of two, so that scaled numbers round alike.
        private static const SCALES:Array = [Math.pow(2, 18), Math.pow(2, 10), Math.pow(2, -10), Math.pow(2, -18)];

        private var _greatLand:GreatLand;
        private var _colliders:Array;

        [Before]
        public function makeGame():void
        {
            _greatLand = new GreatLand();
            _greatLand.loadAllBoundingStructures = true;
            _greatLand.addModel(BuiltInModel.sphere());
            _greatLand.addModel(BuiltInModel.cube());
            _greatLand.addModel(new Model("pole", stretched(BuiltInModel.sphere().vertices), BuiltInModel.sphere().triangles));
            var exact:HierarchicalCollider = new HierarchicalCollider(_greatLand);
            exact.exact = true;
            _colliders = [new BinCollider(_greatLand), new TightestFitCollider(_greatLand), new HierarchicalCollider(_greatLand), exact, new CombinationCollider(_greatLand)];
        }

        [Test]
        public function aScaledGameHasTheSameCollisions():void
        {
            var random:SeededRandom = new SeededRandom(601);
            var hits:int = 0;
            for (var i:int = 0; i < 150; i++)
            {
                var agents:Vector.<Agent> = new Vector.<Agent>();
                for (var k:int = 0; k < 4; k++)
                {
                    var agent:Agent = new Agent(random.pick(["sphere", "cube", "pole", "pole"]));
                    agent.moveTo(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
                    agent.size = random.logBetween(0.5, 2);
                    agent.heading = random.between(0, 360);
                    agent.pitch = random.pick([0, random.between(0, 360)]);
                    agent.roll = random.pick([0, random.between(0, 360)]);
                    agent.hierarchical = random.chance(0.5);
                    agents.push(agent);
                }
                var expected:Array = answers(agents);
                hits += expected.join().split("1").length - 1;
                for each (var scale:Number in SCALES)
                {
                    resize(agents, scale);
                    assertEquals("game " + i + " times " + scale, expected.join("\n"), answers(agents).join("\n"));
                    resize(agents, 1 / scale);
                }
            }
            assertTrue(hits + " collisions", hits > 150 * 30 / 5 && hits < 150 * 30 * 4 / 5);
        }

        [Test]
        public function theLargestMeetTheSmallest():void
        {
            for each (var shape:String in ["sphere", "cube", "pole"])
            {
                for each (var otherShape:String in ["sphere", "cube", "pole"])
                {
                    var large:Agent = new Agent(shape);
                    large.size = Agent.LARGEST_SIZE;
                    var small:Agent = new Agent(otherShape);
                    small.size = Agent.SMALLEST_SIZE;
                    small.heading = 30;
                    for each (var hierarchical:Boolean in [false, true])
                    {
                        large.hierarchical = small.hierarchical = hierarchical;
                        assertHits(shape + " around " + otherShape, large, small, 0, 0, 0.5e6, true);
                        assertHits(shape + " beside " + otherShape, large, small, 0.7e6, 0.7e6, 0.5e6, false);
                        assertHits(shape + " below " + otherShape, large, small, 0, 0, -0.1e6, false);
                    }
                }
            }
        }

        private function assertHits(name:String, a:Agent, b:Agent, x:Number, y:Number, z:Number, expected:Boolean):void
        {
            b.moveTo(x, y, z);
            for (var i:int = 0; i < _colliders.length; i++)
            {
                assertEquals(name + ", collider " + i, expected, CollisionSystem(_colliders[i]).areColliding(a, b));
                assertEquals(name + ", collider " + i, expected, CollisionSystem(_colliders[i]).areColliding(b, a));
                assertEquals(name + ", collider " + i, expected ? 2 : 0, CollisionSystem(_colliders[i]).findCollisions(new <Agent>[a, b]).length);
            }
        }

        // Of each collider a string with a digit a pair.
        private function answers(agents:Vector.<Agent>):Array
        {
            var all:Array = [];
            for each (var collider:CollisionSystem in _colliders)
            {
                var answer:String = "";
                for (var i:int = 0; i < agents.length; i++)
                {
                    for (var j:int = i + 1; j < agents.length; j++)
                    {
                        answer += collider.areColliding(agents[i], agents[j]) ? "1" : "0";
                    }
                }
                all.push(answer + " " + collider.findCollisions(agents).length);
            }
            return all;
        }

        private static function resize(agents:Vector.<Agent>, factor:Number):void
        {
            for each (var agent:Agent in agents)
            {
                agent.moveTo(agent.x * factor, agent.y * factor, agent.z * factor);
                agent.size *= factor;
            }
        }

        private static function stretched(vertices:Vector.<Number>):Vector.<Number>
        {
            var longer:Vector.<Number> = vertices.concat();
            for (var i:int = 2; i < longer.length; i += 3)
            {
                longer[i] *= 3;
            }
            return longer;
        }
    }
}
