package evaluation
{
    import flash.display.Sprite;
    import starlogo.agents.Agent;

    /** Shows SpaceLand from above: a dot for each agent, red if it has collided. */
    public class GroundView extends Sprite
    {
        private static const HALF_WIDTH:Number = 50.5;
        private static const GROUND:uint = 0xeef2e6;
        private static const BORDER:uint = 0xb9c4a8;
        private static const FREE:uint = 0x3d6b8e;
        private static const COLLIDING:uint = 0xd1442f;

        private var _scale:Number;

        /** @param width the width and height of the view, in pixels */
        public function GroundView(width:Number)
        {
            _scale = width / (2 * HALF_WIDTH);
            // the stage is drawn in every frame, but this view only when it changes
            cacheAsBitmap = true;
        }

        /**
         * Draws the agents.
         *
         * @param agents all agents
         * @param colliding the agents to draw in red, each once
         */
        public function show(agents:Vector.<Agent>, colliding:Vector.<Agent>):void
        {
            graphics.clear();
            graphics.lineStyle(1, BORDER);
            graphics.beginFill(GROUND);
            graphics.drawRect(0, 0, 2 * HALF_WIDTH * _scale, 2 * HALF_WIDTH * _scale);
            graphics.endFill();
            graphics.lineStyle();
            drawDots(agents, FREE);
            drawDots(colliding, COLLIDING);
        }

        private function drawDots(agents:Vector.<Agent>, color:uint):void
        {
            for (var i:int = 0; i < agents.length; i++)
            {
                var agent:Agent = agents[i];
                graphics.beginFill(color);
                graphics.drawCircle((agent.x + HALF_WIDTH) * _scale, (HALF_WIDTH - agent.y) * _scale, Math.max(1.5, agent.size * _scale / 2));
                graphics.endFill();
            }
        }
    }
}
