package starlogo.collision
{
    import evaluation.EveryPairSystem;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import support.landOf;

    use namespace engine;

    /** Any number of colliders, Collisions and recorders share agents. */
    public class SharedAgentsTest
    {
        private var _greatLand:GreatLand = landOf(BuiltInModel.sphere(), BuiltInModel.cube());
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        [Before]
        public function makeGame():void
        {
            for (var i:int = 0; i < 12; i++)
            {
                var agent:Agent = new Agent(i % 2 == 0 ? "sphere" : "cube", i % 3 == 0 ? "bears" : "balls");
                agent.x = i * 0.4;
                _agents.push(agent);
            }
        }

        [Test]
        public function aHandlerMayUpdateAnotherCollision():void
        {
            // the inner list is shorter, and begins elsewhere: notes of places that were shared would be wrong
            var some:Vector.<Agent> = _agents.slice(7).reverse();
            var alone:Array = callsOf(new BinCollider(_greatLand), null);
            var inner:Collision = new Collision(new TightestFitCollider(_greatLand));
            var innerCalls:int = 0;
            inner.onCollision("balls", "bears", function(collider:Agent, collidee:Agent):void
                {
                    innerCalls++;
                });
            var nested:Array = callsOf(new BinCollider(_greatLand), function():void
                {
                    inner.update(some);
                });
            assertTrue(alone.length > 10);
            assertEquals(alone.join(), nested.join());
            assertTrue("the inner one ran", innerCalls >= alone.length);
        }

        [Test]
        public function aHandlerMayUpdateAnotherCollisionWithTheSameSystemOfTheGame():void
        {
            var some:Vector.<Agent> = _agents.slice(7).reverse();
            var alone:Array = callsOf(new EveryPairSystem(), null);
            var shared:BaseCollider = new BaseCollider(new EveryPairSystem());
            var inner:Collision = new Collision(shared);
            inner.onCollision("balls", "bears", function(collider:Agent, collidee:Agent):void
                {
                });
            assertEquals(alone.join(), callsOf(shared, function():void
                    {
                        inner.update(some);
                    }).join());
        }

        // The calls of a frame; an action runs in each.
        private function callsOf(system:CollisionSystem, action:Function):Array
        {
            var calls:Array = [];
            var collision:Collision = new Collision(system);
            collision.onCollision("bears", "balls", note);
            collision.onCollision("balls", "balls", note);
            collision.update(_agents);
            return calls;

            function note(collider:Agent, collidee:Agent):void
            {
                calls.push(collider.id + "-" + collidee.id);
                if (action != null)
                {
                    action();
                }
            }
        }
    }
}
