package support
{
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionStatistics;
    import starlogo.collision.CollisionSystem;

    /** A collision system of a client's that returns a vector of its own, whatever out it is given. */
    public class OwnVectorSystem implements CollisionSystem
    {
        private var _pairs:Vector.<Agent>;
        private var _statistics:CollisionStatistics = new CollisionStatistics();

        /**
         * @param pairs what it finds
         */
        public function OwnVectorSystem(pairs:Vector.<Agent>)
        {
            _pairs = pairs;
        }

        public function get statistics():CollisionStatistics
        {
            return _statistics;
        }

        public function areColliding(a:Agent, b:Agent):Boolean
        {
            return false;
        }

        public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _pairs;
        }
    }
}
