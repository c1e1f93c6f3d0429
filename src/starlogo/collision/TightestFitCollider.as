package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.TightestFitChoice;

    /**
     * Finds collisions by the tightest sphere, box or capsule around each agent's model (thesis §3), or by the structure that the agent's
     * <code>collideAs</code> names, for example a hull. The agent's whole transform counts. It is nearly as fast as the BinCollider, and misses no
     * collision of models with triangles that are not posed.
     *
     * <p>The extents of an agent's structure decide which agents it is near (§3.7). A structure is placed in the world when its agent has changed,
     * not for each pair. Each pair of kinds has an exact test (§3.6).</p>
     */
    public class TightestFitCollider extends Collider
    {
        /**
         * Creates a collider.
         *
         * @param greatLand the models of the agents, loaded with loadTightestFit
         * @throws ArgumentError if it is null
         */
        public function TightestFitCollider(greatLand:GreatLand)
        {
            super(new TightestFitChoice(greatLand));
        }
    }
}
