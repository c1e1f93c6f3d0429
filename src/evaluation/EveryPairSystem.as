package evaluation
{
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionStatistics;
    import starlogo.collision.CollisionSystem;

    /** A client's own collision system, in which every agent collides with every other. */
    public class EveryPairSystem implements CollisionSystem
    {
        private var _statistics:CollisionStatistics = new CollisionStatistics();

        /** Has the numbers of agents and pairs. */
        public function get statistics():CollisionStatistics
        {
            return _statistics;
        }

        /** Always true. */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            return true;
        }

        /** Returns every pair once. */
        public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            out ||= new Vector.<Agent>();
            out.length = 0;
            for (var i:int = 0; i < agents.length; i++)
            {
                for (var j:int = i + 1; j < agents.length; j++)
                {
                    out.push(agents[i], agents[j]);
                }
            }
            _statistics.agents = agents.length;
            _statistics.collisions = out.length >> 1;
            return out;
        }
    }
}
