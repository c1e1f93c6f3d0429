package starlogo.collision
{
    import starlogo.agents.Agent;

    /**
     * A collision system that tests only the pairs of some breeds.
     */
    public interface SelectiveCollisionSystem extends CollisionSystem
    {
        /**
         * Finds every pair of agents that collide and whose breeds are of interest.
         *
         * @param agents the agents of the game
         * @param interests the pairs of breeds; null for all
         * @param out where to put the pairs; overwritten
         * @return out, as from findCollisions
         * @throws ArgumentError as findCollisions does
         */
        function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent>):Vector.<Agent>;
    }
}
