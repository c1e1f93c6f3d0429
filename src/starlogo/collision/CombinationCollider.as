package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.TightestFitChoice;
    import starlogo.search.TreeChoice;

    /**
     * Finds collisions precisely for the agents that ask for it, and fast for all others. Agents with the trait <code>hierarchical</code>
     * collide by the hierarchies of their models, all others by their tightest fits (thesis §5).
     *
     * <p>Two agents that are not hierarchical collide as in the TightestFitCollider. Two hierarchical agents collide as in the
     * HierarchicalCollider. If only one is hierarchical, its hierarchy is tested with the other's structure. They collide if the structure overlaps
     * a leaf, or a node at the depth limit. The trait may change between frames.</p>
     *
     * <p>To be exact for one agent, set <code>exact</code> of this collider and <code>hierarchical</code> of the agent. Then its triangles are
     * tested, with the structures of agents that are not hierarchical.</p>
     *
     * <p>Models of hierarchical agents need hierarchies. Other models need tightest fits.</p>
     */
    public class CombinationCollider extends TreeCollider
    {
        /**
         * Creates a collider.
         *
         * @param greatLand the models of the agents, loaded with loadTightestFit and loadHierarchies
         * @throws ArgumentError if it is null
         */
        public function CombinationCollider(greatLand:GreatLand)
        {
            super(new TreeChoice(greatLand, new TightestFitChoice(greatLand)));
        }
    }
}
