package starlogo.collision
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.BuiltInModel;
    import support.EachCollider;
    import support.landOf;

    /** How fast two agents come together, as their contact says. */
    public class ApproachSpeedTest
    {
        private static const NEAR:Number = 1e-9;

        private var _greatLand:GreatLand = landOf(BuiltInModel.cube(), BuiltInModel.sphere());
        private var _speeds:Array;

        [Test]
        public function itIsThatOfTheMotionsAlongTheNormal():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                // from both sides; the wall may move as well, and comes to the ball in no other way than the ball to it
                assertSpeeds(name, true, 6, 0, 0, [6, 6]);
                assertSpeeds(name, true, 6, 0, -2, [8, 8]);
                assertSpeeds(name, true, 6, 0, 2, [4, 4]);
                assertSpeeds(name + ": nothing sweeps", false, 3, 0, 0, [0, 0]);
            }
            // along the wall it does not come nearer
            for each (name in ["tightest fits", "hierarchies", "triangles", "combinations"])
            {
                assertSpeeds(name, true, 6, 1, 0, [6, 6]);
            }
        }

        [Test]
        public function whatPartsDoesNotApproach():void
        {
            for each (var name:String in EachCollider.NAMES)
            {
                var ball:Agent = agentAt("sphere", "balls", 3.2);
                var wall:Agent = agentAt("cube", "walls", 4);
                ball.sweeps = true;
                var collider:Collider = EachCollider.make(name, _greatLand);
                collider.findCollisions(new <Agent>[ball, wall]);
                ball.x = 0;
                assertEquals(name, 2, collider.findCollisions(new <Agent>[ball, wall]).length);
                var contact:Contact = collider.contactOf(ball, wall);
                assertEquals(name, 0, contact.time);
                assertEquals(name, 0, contact.approachSpeed);
                assertEquals(name + ": not in the last search", 0, collider.contactOf(ball, new Agent("cube")).approachSpeed);
            }
        }

        private function assertSpeeds(message:String, sweeps:Boolean, dx:Number, dy:Number, wallDx:Number, expected:Array):void
        {
            var ball:Agent = agentAt("sphere", "balls", 0);
            var wall:Agent = agentAt("cube", "walls", 4);
            var agents:Vector.<Agent> = new <Agent>[ball, wall];
            ball.sweeps = sweeps;
            var collision:Collision = new Collision(EachCollider.make(message.split(":")[0], _greatLand));
            collision.onCollision("balls", "walls", note);
            collision.onCollision("walls", "balls", note);
            collision.update(agents);
            ball.moveTo(dx, dy, 0);
            wall.x += wallDx;
            _speeds = [];
            collision.update(agents);
            assertEquals(message, expected.length, _speeds.length);
            for (var i:int = 0; i < expected.length; i++)
            {
                assertTrue(message + ": " + _speeds[i], Math.abs(_speeds[i] - expected[i]) < NEAR);
            }
        }

        private function note(a:Agent, b:Agent, contact:Contact):void
        {
            _speeds.push(contact.approachSpeed);
        }

        private static function agentAt(shape:String, breed:String, x:Number):Agent
        {
            var agent:Agent = new Agent(shape, breed);
            agent.x = x;
            return agent;
        }
    }
}
