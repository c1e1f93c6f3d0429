package
{
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;

    /** Contacts that separate: Marbles roll to the middle. When two overlap, each moves back by half of the contact's depth. Push them. */
    [SWF(width="600", height="400", frameRate="60", backgroundColor="#eef1ee")]
    public class Contacts extends Land
    {
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _collision:Collision = new Collision(new BinCollider());
        private var _pusher:Agent = make("sphere", "pushers", 3, GREY);
        private var _deepest:Number;

        public function Contacts()
        {
            for (var i:int = 0; i < 100; i++)
            {
                _agents.push(make("sphere", "marbles", random(0.6, 1.4), COLOURS[i % 5]));
            }
            _agents.push(_pusher);
            for each (var agent:Agent in _agents)
            {
                agent.z = -agent.size / 2; // the middles of all agents are at z = 0
            }
            _collision.onCollision("marbles", Collision.ANY_BREED, giveWay);
        }

        // The normal points to the marble. Two marbles make two calls, so each moves half of the way.
        private function giveWay(marble:Agent, other:Agent, contact:Contact):void
        {
            var way:Number = other == _pusher ? contact.depth : contact.depth / 2;
            marble.moveTo(marble.x + way * contact.normal.x, marble.y + way * contact.normal.y, marble.z);
            _deepest = Math.max(_deepest, contact.depth);
        }

        override protected function step():void
        {
            for each (var agent:Agent in _agents)
            {
                agent.moveTo(agent.x * 0.995, agent.y * 0.995, agent.z);
            }
            follow(_pusher, 0.15);
            for (var round:int = 0; round < 3; round++)
            {
                _deepest = 0;
                _collision.update(_agents);
            }
            draw(_agents);
            say(_collision.statistics.collisions + " touches, the deepest " + _deepest.toFixed(2) + " patches");
        }
    }
}
