package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * Decides which agents have collided (thesis §3.7). Touching counts as colliding.
     */
    public interface CollisionSystem
    {
        /**
         * Tells whether two agents collide.
         *
         * @param a an agent
         * @param b another agent
         * @throws ArgumentError if one is null, they are the same, or a model is not known
         */
        function areColliding(a:Agent, b:Agent):Boolean;

        /**
         * Finds every pair of agents that collide.
         *
         * @param agents the agents of the game
         * @param out receives the pairs; overwritten, and created if null
         * @return out: a0, b0, a1, b1, ... Each pair is there once. The agent that comes first in the list comes first
         * @throws ArgumentError if an agent is null or listed twice, or its model is not known; out is then unchanged
         * @throws RangeError if a structure is out of the world; out is then unchanged
         */
        function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>;

        /** Counts and times of the last search. The next search overwrites them. Never null. */
        function get statistics():CollisionStatistics;
    }
}
