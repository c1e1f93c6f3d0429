package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.engine;
    import starlogo.search.StructureTests;
    import starlogo.search.TightestFits;

    use namespace engine;

    /**
     * Takes every agent for the tightest fitting sphere, box or capsule of its model (thesis §3), put through the agent's
     * whole transform.
     *
     * <p>The extents of its structure decide which agents it is near (§3.7). A structure is placed in the world when its agent has changed,
     * not for each pair. Pairs that are near each other are decided by the exact test of their kinds (§3.6).</p>
     */
    public class TightestFitCollider extends Collider
    {
        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, loaded with loadTightestFit
         * @throws ArgumentError if it is null
         */
        public function TightestFitCollider(greatLand:GreatLand)
        {
            super(new TightestFits(greatLand));
        }

        /** How two structures are tested. */
        public function get structureTests():StructureTests
        {
            return pairs.structures;
        }
    }
}
