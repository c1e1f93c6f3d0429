package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.UnitSpheres;

    /**
     * The client's first collision system (thesis §2.2): every agent is a sphere, whatever its model.
     *
     * <p>The sphere has radius 0.5 and its centre at (0, 0, 0.5) of the model; it is scaled by the agent's size and moved
     * to the agent.</p>
     */
    public class BinCollider extends Collider
    {
        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, which have to be there; null to ask for none, as spheres need none: then an agent's shape
         *     may be any name
         */
        public function BinCollider(greatLand:GreatLand = null)
        {
            super(new UnitSpheres(greatLand));
        }
    }
}
