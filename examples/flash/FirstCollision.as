package
{
    import flash.display.Shape;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;

    /** First collision: Balls of paint roll among turtles. A turtle that is touched takes the ball's colour. Lead the orange ball. */
    [SWF(width="600", height="400", frameRate="60", backgroundColor="#eef1ee")]
    public class FirstCollision extends Land
    {
        private var _agents:Vector.<Agent> = new Vector.<Agent>();
        private var _shapes:Vector.<Shape> = new Vector.<Shape>();
        private var _yours:Agent = make("sphere", "paint", 1, ORANGE);
        private var _collision:Collision = new Collision(new BinCollider()); // every agent is a sphere
        private var _touches:int = 0;

        public function FirstCollision()
        {
            for (var i:int = 0; i < 40; i++)
            {
                add(make("sphere", "turtles", 1.3, GREY));
            }
            add(make("sphere", "paint", 1, GREEN));
            add(_yours);
            _collision.onCollision("turtles", "paint", paint);
        }

        private function add(agent:Agent):void
        {
            _agents.push(agent);
            _shapes.push(world.addChild(new Shape()));
        }

        private function paint(turtle:Agent, ball:Agent):void
        {
            turtle.color = ball.color;
            _touches++;
        }

        override protected function step():void
        {
            for each (var agent:Agent in _agents)
            {
                walk(agent, agent.breed == "paint" ? 0.12 : 0.03);
            }
            follow(_yours, 0.2);
            _collision.update(_agents); // once a frame, when all have moved
            for (var i:int = 0; i < _agents.length; i++)
            {
                _shapes[i].x = _agents[i].x * PATCH;
                _shapes[i].y = _agents[i].y * PATCH;
                _shapes[i].graphics.clear();
                _shapes[i].graphics.beginFill(_agents[i].color);
                _shapes[i].graphics.drawCircle(0, 0, _agents[i].size * PATCH / 2);
            }
            say(_touches + " touches");
        }
    }
}
