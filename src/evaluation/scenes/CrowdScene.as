package evaluation.scenes
{
    import starlogo.agents.Agent;

    /**
     * The thesis's set-up (§6.1): all agents at (1, 1), so that they are in one bin and every one collides with every
     * other, each frame. A frame moves them all on by one; they turn back where SpaceLand ends.
     */
    public class CrowdScene extends Scene
    {
        private var _direction:int = 1;

        /**
         * @param count how many agents
         * @param shapes their shapes, in turn
         */
        public function CrowdScene(count:int, shapes:Array)
        {
            super(count + " agents in one bin: " + shapes.join(", "));
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = new Agent(shapes[i % shapes.length]);
                agent.moveTo(1, 1, 0);
                agents.push(agent);
            }
        }

        /** @inheritDoc */
        override public function step():void
        {
            if (agents[0].x + 2 * _direction > 50 || agents[0].x + 2 * _direction < -50)
            {
                _direction = -_direction;
            }
            for (var i:int = 0; i < agents.length; i++)
            {
                agents[i].x += _direction;
            }
        }
    }
}
