package starlogo.queries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.terrain.WorldBounds;
    import support.EachCollider;
    import support.PointSets;
    import support.agentAt;
    import support.assertThrows;
    import support.landOf;

    /** AgentQueries.distance: of when the agents are, and what is refused. */
    public class AgentDistanceTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere());

        [Test]
        public function theAskerIsOfNowTheOtherAsSeen():void
        {
            for each (var collider:Collider in colliders())
            {
                var queries:AgentQueries = new AgentQueries(collider);
                var a:Agent = new Agent("sphere");
                var b:Agent = new Agent("sphere");
                b.moveTo(4, 0, 0);
                queries.update(new <Agent>[a, b]);
                var apart:Number = queries.distance(a, b);
                assertTrue(collider + ": " + apart, apart > 2.5 && apart <= 3 + 1e-12);
                b.moveTo(20, 0, 0);
                b.size = 3;
                assertEquals(collider + ": the other as it was", apart, queries.distance(a, b));
                a.moveTo(-1, 0, 0);
                assertNear(collider + ": the asker as it is", apart + 1, queries.distance(a, b));
                var stranger:Agent = new Agent("sphere");
                stranger.moveTo(-6, 0, 0);
                assertNear(collider + ": a stranger asks", apart + 6, queries.distance(stranger, b));
                assertNear(collider + ": about a stranger", apart + 1, queries.distance(a, stranger));
                stranger.moveTo(-7, 0, 0);
                assertNear(collider + ": a stranger is of now", apart + 2, queries.distance(a, stranger));
                queries.moved(b);
                assertFalse(collider + ": moved", apart == queries.distance(a, b));
            }
        }

        /** Far from the origin boxes are widened by the rounding error of places, which brings their corners nearer. */
        [Test]
        public function aGreaterDepthIsNeverNearerFarFromTheOrigin():void
        {
            var collider:HierarchicalCollider = new HierarchicalCollider(landOf(BuiltInModel.cube()));
            var a:Agent = agentAt("cube", 1e5 + 0.467, 0.5, -1e5);
            var b:Agent = agentAt("cube", 1e5 - 0.5, -1, -1e5 - 0.6443);
            var before:Number = 0;
            a.size = 0.5;
            for each (var depth:int in [1, 3, 5, 8])
            {
                collider.maxDepth = depth;
                var queries:AgentQueries = new AgentQueries(collider);
                queries.update(new <Agent>[a, b]);
                var distance:Number = queries.distance(a, b);
                assertTrue(depth + ": " + distance + " after " + before, distance >= before);
                before = distance;
            }
        }

        /** There the boxes' places have rounding errors, however small the model is. */
        [Test]
        public function aGreaterDepthIsNeverNearerIfAModelIsFarFromItsOwnOrigin():void
        {
            var far:Number = 11000;
            var cube:Model = BuiltInModel.cube();
            var land:GreatLand = landOf(new Model("far", PointSets.placed(cube.vertices, 1, far), cube.triangles, Model.AS_GIVEN), cube);
            var random:SeededRandom = new SeededRandom(22);
            for (var i:int = 0; i < 60; i++)
            {
                var collider:HierarchicalCollider = new HierarchicalCollider(land);
                var heading:Number = random.between(0, 360);
                var a:Agent = agentAt("far", -far * Math.cos(heading * Math.PI / 180), -far * Math.sin(heading * Math.PI / 180), 0);
                var b:Agent = agentAt("cube", random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
                a.heading = heading;
                b.heading = random.between(0, 360);
                b.pitch = random.between(0, 90);
                var before:Number = 0;
                for each (var depth:int in [1, 2, 3, 4, 6, 10])
                {
                    collider.maxDepth = depth;
                    var queries:AgentQueries = new AgentQueries(collider);
                    queries.update(new <Agent>[a, b]);
                    var distance:Number = queries.distance(a, b);
                    assertTrue(i + ", depth " + depth + ": " + distance + " after " + before, distance >= before);
                    before = distance;
                }
            }
        }

        [Test]
        public function eachPointMayBeAskedForAlone():void
        {
            for each (var collider:Collider in colliders())
            {
                for each (var distance:Number in [0.3, 4])
                {
                    var queries:AgentQueries = new AgentQueries(collider);
                    var a:Agent = new Agent("sphere");
                    var b:Agent = agentAt("sphere", distance, 0.2, 0.1);
                    queries.update(new <Agent>[a, b]);
                    var pointA:Vector3D = new Vector3D();
                    var pointB:Vector3D = new Vector3D();
                    assertEquals(collider + " at " + distance, distance < 1, queries.distance(a, b, pointA, pointB) == 0);
                    var alone:Vector3D = new Vector3D(7, 8, 9);
                    queries.distance(a, b, alone);
                    assertEquals(collider + " at " + distance + ": the first", pointA + "", alone + "");
                    // another question between the two, so that nothing is left of the first answer
                    queries.distanceToPoint(a, new Vector3D(30, 20, 10), alone);
                    queries.distance(a, b, null, alone);
                    assertEquals(collider + " at " + distance + ": the second", pointB + "", alone + "");
                }
            }
        }

        // The margins of their trees' boxes are much smaller than the least size of a structure.
        [Test]
        public function pointsVeryCloseToTheirOriginsAreApart():void
        {
            for each (var size:Number in [1e-50, 1e-62, 1e-200])
            {
                var land:GreatLand = landOf(new Model("point", new <Number>[size, 2 * size, -size], null, Model.AS_GIVEN));
                for each (var name:String in EachCollider.ALL_NAMES)
                {
                    var agents:Vector.<Agent> = new <Agent>[agentAt("point", 0, 0, 0), agentAt("point", 3, 0, 0)];
                    agents[1].heading = 30;
                    agents[1].hierarchical = true;
                    var queries:AgentQueries = new AgentQueries(EachCollider.make(name, land));
                    queries.update(agents);
                    assertTrue(name, Math.abs(queries.distance(agents[0], agents[1]) - 3) <= 1 + 1e-9);
                    assertEquals(name, 1, queries.slide(agents[0], 0, 5, 0));
                }
            }
        }

        [Test]
        public function refusals():void
        {
            var queries:AgentQueries = new AgentQueries(new TightestFitCollider(_greatLand));
            var agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), agentAt("sphere", 3, 0, 0)];
            queries.update(agents);
            var before:Number = queries.distance(agents[0], agents[1]);
            var unknown:Agent = new Agent("unknown");
            for each (var pair:Array in [[null, agents[1]], [agents[0], null], [agents[0], agents[0]], [agents[0], unknown], [unknown, agents[0]]])
            {
                assertThrows(ArgumentError, /agents are needed|must be an Agent|unknown/, queries.distance, pair[0], pair[1]);
            }
            assertEquals("as before", before, queries.distance(agents[0], agents[1]));
        }

        [Test]
        public function aWorldWithoutEdgesIsInfinitelyFarAndHasNoPoint():void
        {
            var bounds:WorldBounds = new WorldBounds(-Infinity, -Infinity, -Infinity, Infinity, Infinity, Infinity);
            for each (var collider:Collider in colliders())
            {
                var queries:AgentQueries = new AgentQueries(collider);
                var agent:Agent = agentAt("sphere", 4, 2, 1);
                queries.update(new <Agent>[agent]);
                var pointA:Vector3D = new Vector3D(7, 8, 9);
                var pointB:Vector3D = new Vector3D(6, 5, 4);
                for each (var isReversed:Boolean in [false, true])
                {
                    assertEquals(Infinity, queries.distance(isReversed ? bounds.agent : agent, isReversed ? agent : bounds.agent, pointA, pointB));
                    assertEquals("Vector3D(7, 8, 9) Vector3D(6, 5, 4)", pointA + " " + pointB);
                }
                bounds.setTo(-Infinity, -Infinity, -Infinity, Infinity, 20, Infinity);
                assertTrue(Math.abs(queries.distance(agent, bounds.agent, pointA, pointB) - 17.5) < 0.2);
                assertEquals(20, pointB.y);
                assertTrue(pointA + " " + pointB, Vector3D.distance(pointA, pointB) < 18);
                bounds.setTo(-Infinity, -Infinity, -Infinity, Infinity, Infinity, Infinity);
            }
        }

        private static function assertNear(what:String, expected:Number, actual:Number):void
        {
            assertTrue(what + ": " + actual + " is not " + expected, Math.abs(actual - expected) <= 1e-11);
        }

        private function colliders():Array
        {
            return EachCollider.NAMES.map(function(name:String, index:int, all:Array):Collider
                {
                    return EachCollider.make(name, _greatLand);
                });
        }
    }
}
