package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import org.flexunit.asserts.assertEquals;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    public class CollisionTest
    {
        private var _collision:Collision;
        private var _collider:BinCollider;
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _calls:Array = [];

        [Before]
        public function makeGame():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.sphere());
            _collider = new BinCollider(greatLand);
            _collision = new Collision(_collider);
        }

        [Test]
        public function callsTheHandlerWithColliderAndCollidee():void
        {
            var bear:Agent = add("bears", 0);
            var ball:Agent = add("paintballs", 0.5);
            add("paintballs", 5);
            _collision.onCollision("paintballs", "bears", note("hit"));
            _collision.update(_agents);
            assertCalls(["hit", ball, bear]);
        }

        [Test]
        public function eitherAgentOfOneBreedIsTheCollider():void
        {
            var a:Agent = add("bears", 0);
            var b:Agent = add("bears", 0.5);
            _collision.onCollision("bears", "bears", note("bump"));
            _collision.update(_agents);
            assertCalls(["bump", a, b], ["bump", b, a]);
        }

        [Test]
        public function bothBreedsMayHaveHandlers():void
        {
            var bear:Agent = add("bears", 0);
            var ball:Agent = add("paintballs", 0.5);
            _collision.onCollision("bears", "paintballs", note("bear"));
            _collision.onCollision("paintballs", "bears", note("ball"));
            _collision.onCollision("bears", "paintballs", note("bear again"));
            _collision.update(_agents);
            assertCalls(["bear", bear, ball], ["bear again", bear, ball], ["ball", ball, bear]);
        }

        [Test]
        public function testsOnlyPairsThatAHandlerCaresAbout():void
        {
            add("bears", 0);
            add("paintballs", 0.1);
            add("walls", 0.2);
            add("walls", 0.3);
            add("clouds", 0.4);
            _collision.onCollision("paintballs", "bears", note("hit"));
            _collision.onCollision("paintballs", "walls", note("splash"));
            _collision.update(_agents);
            assertEquals("ball and bear, ball and two walls", 3, _collision.statistics.tests);
            assertEquals(3, _collision.statistics.candidatePairs);
            assertEquals("the cloud", 1, _collision.statistics.agentsSkipped);
            assertEquals(3, _collision.statistics.handlerCalls);
            assertEquals(5, _collision.statistics.agents);
        }

        [Test]
        public function allPairsAreKnownBeforeTheFirstHandlerRuns():void
        {
            add("bears", 0);
            add("bears", 0.5);
            add("bears", 1);
            _collision.onCollision("bears", "bears", function(collider:Agent, collidee:Agent):void
                {
                    _calls.push(collider);
                    collider.moveTo(100, 100, 100);
                    _agents.push(new Agent("sphere", "bears"));
                });
            _collision.update(_agents);
            assertEquals("three pairs, both ways", 6, _calls.length);
        }

        [Test]
        public function updateDoesNotNest():void
        {
            add("bears", 0);
            add("bears", 0.1);
            _collision.onCollision("bears", "bears", function(collider:Agent, collidee:Agent):void
                {
                    _collision.update(_agents);
                });
            assertThrows(IllegalOperationError, /handler/, _collision.update, _agents);
        }

        [Test]
        public function badInputIsNamedAndCallsNoHandler():void
        {
            var a:Agent = add("bears", 0);
            add("bears", 0);
            _collision.onCollision("bears", "bears", note("bump"));
            _agents.push(a);
            assertThrows(ArgumentError, /listed twice/, _collision.update, _agents);
            _agents[2] = null;
            assertThrows(ArgumentError, /agents\[2\] is null/, _collision.update, _agents);
            _agents[2] = new Agent("unicorn");
            assertThrows(ArgumentError, /unicorn/, _collision.update, _agents);
            assertThrows(ArgumentError, /null/, _collision.update, null);
            assertEquals(0, _calls.length);
            assertThrows(ArgumentError, /handler/, _collision.onCollision, "bears", "bears", null);
            assertThrows(ArgumentError, /breeds/, _collision.onCollision, "", "bears", note("x"));
            assertThrows(ArgumentError, /collisionSystem/, create, Collision, null);
            _agents.pop();
            _collision.update(_agents);
            assertEquals("and the game goes on", 2, _calls.length);
        }

        private function add(breed:String, x:Number):Agent
        {
            var agent:Agent = new Agent("sphere", breed);
            agent.x = x;
            _agents.push(agent);
            return agent;
        }

        private function note(name:String):Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                _calls.push([name, collider, collidee]);
            };
        }

        private function assertCalls(...expected):void
        {
            assertEquals(expected.join("\n"), _calls.join("\n"));
        }
    }
}
