package docs
{
    import game.Bubbles;
    import game.DiscCollider;
    import game.SelectiveDiscCollider;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;

    /** For docs/adding-a-collider.md: both colliders find what all pairs, tried one by one, have. */
    public class AddingAColliderPage extends Page
    {
        public static const FIXTURES:Array = [];

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals(1, collision.statistics.collisions);
            var crowd:Vector.<Agent> = new Vector.<Agent>();
            for (var n:int = 0; n < 200; n++)
            {
                var agent:Agent = new Agent("sphere");
                agent.size = 1 + n % 5;
                agent.moveTo(n * 37 % 101, n * 53 % 97, 0);
                crowd.push(agent);
            }
            var collider:DiscCollider = new DiscCollider();
            var found:Vector.<Agent> = collider.findCollisions(crowd);
            var expected:int = 0;
            for (var i:int = 0; i < crowd.length; i++)
            {
                for (var j:int = i + 1; j < crowd.length; j++)
                {
                    expected += collider.areColliding(crowd[i], crowd[j]) ? 1 : 0;
                }
            }
            assertEquals(expected, found.length / 2);
            assertTrue(expected + " collisions", expected > 50 && expected < 2000);
            assertTrue("fewer tests than pairs", collider.statistics.candidatePairs < 19900 / 4);
            for (var at:int = 0; at < found.length; at += 2)
            {
                assertTrue(crowd.indexOf(found[at]) < crowd.indexOf(found[at + 1]));
            }
            checkSelective(crowd, collider);
            checkBubbles(crowd);
        }

        private function checkSelective(crowd:Vector.<Agent>, all:DiscCollider):void
        {
            var expected:int = 0;
            for (var i:int = 0; i < crowd.length; i++)
            {
                crowd[i].breed = ["cats", "dogs", "trees"][i % 3];
                for (var j:int = 0; j < i; j++)
                {
                    expected += i % 3 == 0 && j % 3 == 1 && all.areColliding(crowd[i], crowd[j]) ? 1 : 0;
                    expected += i % 3 == 1 && j % 3 == 0 && all.areColliding(crowd[i], crowd[j]) ? 1 : 0;
                }
            }
            var calls:int = 0;
            var selective:Collision = new Collision(new SelectiveDiscCollider());
            selective.onCollision("cats", "dogs", function(cat:Agent, dog:Agent):void
                {
                    calls++;
                });
            selective.update(crowd);
            assertEquals(expected, calls);
            assertTrue(String(calls), calls > 20);
            // two of three agents take part, so four of nine pairs do
            var tested:int = selective.statistics.candidatePairs;
            assertTrue(tested + " of " + all.statistics.candidatePairs, 2 * tested < all.statistics.candidatePairs);
            assertEquals("trees", Math.floor(crowd.length / 3), selective.statistics.agentsSkipped);
        }

        // As spheres of twice the size are.
        private function checkBubbles(crowd:Vector.<Agent>):void
        {
            var found:Vector.<Agent> = new Collider(new Bubbles(greatLand)).findCollisions(crowd);
            var doubled:Vector.<Agent> = new Vector.<Agent>();
            for each (var agent:Agent in crowd)
            {
                var twice:Agent = new Agent("sphere");
                twice.size = 2 * agent.size;
                twice.moveTo(agent.x, agent.y, agent.z - agent.size / 2);
                doubled.push(twice);
            }
            var expected:Vector.<Agent> = new BinCollider().findCollisions(doubled);
            assertEquals(expected.length, found.length);
            assertTrue("bubbles meet: " + found.length, found.length > 100);
        }
    }
}
