package starlogo.queries
{
    import starlogo.agents.Agent;

    /** An agent with a speed, gravity and jumps of its own, as a game would move it: a step is a walk, or a move up. */
    internal final class GameCharacter
    {
        private static const GRAVITY:Number = 9.81;

        /** The agent that walks. */
        public var agent:Agent;

        /** How it walks; <code>fall</code> changes in each step. */
        public var options:WalkOptions = new WalkOptions();

        /** How it stands since the last step. */
        public var footing:Footing = new Footing();

        /** Its speed along x and y, in patches a second. */
        public var speedX:Number = 0;
        public var speedY:Number = 0;

        /** Its speed upwards. */
        public var speedZ:Number = 0;

        /** The speed of a jump that begins with the next step, if it stands; 0 for none. */
        public var jumpSpeed:Number = 0;

        private var _queries:AgentQueries;
        private var _seconds:Number;

        /** @param seconds the time of a step */
        public function GameCharacter(queries:AgentQueries, agent:Agent, seconds:Number = 1 / 60)
        {
            _queries = queries;
            this.agent = agent;
            _seconds = seconds;
        }

        /** Goes on for some seconds. */
        public function run(seconds:Number):void
        {
            for (var i:int = Math.round(seconds / _seconds); i > 0; i--)
            {
                step();
            }
        }

        /** Returns whether it stands after the step. */
        public function step():Boolean
        {
            if (footing.stands)
            {
                speedZ = jumpSpeed;
                jumpSpeed = 0;
            }
            speedZ -= GRAVITY * _seconds;
            if (speedZ > 0)
            {
                _queries.moveUntilTouch(agent, 0, 0, speedZ * _seconds);
                footing.stands = false;
            }
            else
            {
                options.fall = -speedZ * _seconds;
                _queries.walk(agent, speedX * _seconds, speedY * _seconds, options, footing);
                speedZ = footing.stands ? 0 : speedZ;
            }
            return footing.stands;
        }
    }
}
