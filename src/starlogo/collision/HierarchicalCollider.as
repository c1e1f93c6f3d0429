package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.TreeChoice;

    /**
     * Finds collisions by the hierarchies of the agents' models (thesis §4): trees of boxes around their parts. If it is exact, it finds them by
     * the models' triangles.
     *
     * <p>The extents of an agent's whole model decide which agents it is near (§4.7). If the extents of two agents overlap, their
     * hierarchies are visited together, depth-first (§4.6). The two collide if two of their structures overlap, and each of these is a leaf
     * or at the depth limit. A depth counts levels; the root is on level 1. If one hierarchy ends before the other, only the other is
     * descended further.</p>
     *
     * <p>The thesis transforms the two structures of each pair of nodes into the world (§4.5), and descends both hierarchies at once (§4.6).
     * Here one transform for each pair of agents serves all nodes. If two nodes overlap, the larger one is divided; if the middle of one is in
     * the other, both are. The answers are the same with one exception: two nodes at their depth limits count as a collision, whatever their
     * levels.</p>
     *
     * <p>If models have triangles, no depth misses a collision of their surfaces, or a model inside a closed one. A greater depth finds fewer false
     * collisions, and never more. See HierarchiesLibrary.</p>
     */
    public class HierarchicalCollider extends TreeCollider
    {
        /**
         * Creates a collider.
         *
         * @param greatLand the models of the agents, loaded with loadHierarchies
         * @throws ArgumentError if it is null
         */
        public function HierarchicalCollider(greatLand:GreatLand)
        {
            super(new TreeChoice(greatLand));
        }
    }
}
