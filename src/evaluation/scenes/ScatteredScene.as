package evaluation.scenes
{
    import starlogo.agents.Agent;

    /**
     * Agents all over SpaceLand. Each walks straight on and turns a little every frame. An agent that leaves comes in on the other side.
     */
    public class ScatteredScene extends Scene
    {
        private static const HALF_WIDTH:Number = 50;
        private static const STEP:Number = 0.3;

        // a linear congruential generator (Knuth, TAOCP 2, §3.3.4), because scenes must be the same on every run
        private var _random:uint = 20150601;

        /**
         * @param count the number of agents
         * @param shapes their shapes, used in turn
         * @param size the size of each
         */
        public function ScatteredScene(count:int, shapes:Array, size:Number = 1)
        {
            super(count + " agents scattered: " + shapes.join(", "));
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = new Agent(shapes[i % shapes.length]);
                agent.moveTo(between(-HALF_WIDTH, HALF_WIDTH), between(-HALF_WIDTH, HALF_WIDTH), 0);
                agent.heading = between(0, 360);
                agent.size = size;
                agents.push(agent);
            }
        }

        /** @inheritDoc */
        override public function step():void
        {
            for (var i:int = 0; i < agents.length; i++)
            {
                var agent:Agent = agents[i];
                agent.heading += between(-10, 10);
                var angle:Number = agent.heading * Math.PI / 180;
                agent.moveTo(wrap(agent.x + STEP * Math.cos(angle)), wrap(agent.y + STEP * Math.sin(angle)), agent.z);
            }
        }

        private static function wrap(coordinate:Number):Number
        {
            if (coordinate > HALF_WIDTH)
            {
                return coordinate - 2 * HALF_WIDTH;
            }
            return coordinate < -HALF_WIDTH ? coordinate + 2 * HALF_WIDTH : coordinate;
        }

        private function between(low:Number, high:Number):Number
        {
            // The product of two 32-bit numbers is not exact, so the halves are multiplied.
            var lowHalf:uint = (_random & 0xffff) * 1664525;
            var highHalf:uint = ((_random >>> 16) * 1664525) << 16;
            _random = lowHalf + highHalf + 1013904223;
            return low + (high - low) * _random / 4294967296;
        }
    }
}
