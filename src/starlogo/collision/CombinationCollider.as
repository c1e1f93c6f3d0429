package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.engine;
    import starlogo.search.StructureTests;
    import starlogo.search.TreesAndFits;

    use namespace engine;

    /**
     * Takes the agents that are hierarchical for the hierarchies of their models, and all others for their tightest fits
     * (thesis §5): precise where a player looks, cheap everywhere else.
     *
     * <p>Two agents that are not hierarchical collide as in the TightestFitCollider, two that are as in the
     * HierarchicalCollider. If one is, its hierarchy is tested against the other's structure: it is visited down to a leaf, or a
     * node at the depth limit, that the structure overlaps. The trait <code>hierarchical</code> may change between frames.</p>
     *
     * <p>Models of hierarchical agents need their hierarchies, other models their tightest fits.</p>
     */
    public class CombinationCollider extends TreeCollider
    {
        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, loaded with loadTightestFit and loadHierarchies
         * @throws ArgumentError if it is null
         */
        public function CombinationCollider(greatLand:GreatLand)
        {
            super(new TreesAndFits(greatLand));
        }

        /** How the structures of two agents that are not hierarchical are tested. */
        public function get structureTests():StructureTests
        {
            return pairs.structures;
        }
    }
}
