package evaluation.scenes
{
    import starlogo.agents.Agent;

    /**
     * The thesis's set-up (§6.1): all agents are at (1, 1), so they are in one bin, and every agent collides with every other in each
     * frame. Each frame moves all agents by 1. At the border of SpaceLand they turn back.
     */
    public class CrowdScene extends Scene
    {
        private var _direction:int = 1;

        /**
         * @param count the number of agents
         * @param shapes their shapes, used in turn
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
