package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.SphereChoice;

    /**
     * Finds collisions by one sphere per agent, whatever its model: the client's first collision system (thesis §2.2), and the fastest.
     *
     * <p>The sphere has radius 0.5 and its centre at (0, 0, 0.5) of the model. It is scaled by the agent's size and moved to the agent. No rotation
     * moves it.</p>
     */
    public class BinCollider extends Collider
    {
        /**
         * Creates a collider.
         *
         * @param greatLand the models of the agents, which must be loaded. With null, agents need no models, and their shapes may have any names
         */
        public function BinCollider(greatLand:GreatLand = null)
        {
            super(new SphereChoice(greatLand));
        }
    }
}
