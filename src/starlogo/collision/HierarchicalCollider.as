package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.search.Trees;

    /**
     * Takes every agent for the hierarchy of bounding structures of its model (thesis §4), or, if it is exact, for its
     * model.
     *
     * <p>An agent is in the bins that the structure around its whole model reaches into (§4.7). Of two agents whose extents
     * overlap, the hierarchies are visited together, depth-first, down to two structures that overlap and are leaves or at the depth
     * limit (§4.6). A depth counts levels, the root being level 1; where one hierarchy ends before the other, only the other is
     * descended further.</p>
     *
     * <p>The thesis puts the two structures of each pair of nodes into the world (§4.5), and goes down in both hierarchies at
     * once (§4.6). Here one transform for each pair of agents serves all their nodes, and where two nodes overlap the
     * larger one is divided, or both where one's middle is in the other. The answers are the same but that an overlap of two
     * nodes at their depth limits counts, whatever their levels.</p>
     *
     * <p>With models that have triangles, no depth ever misses a collision of the surfaces, or a model that is inside of a closed
     * one; a greater depth finds fewer false collisions, and never more. See HierarchiesLibrary.</p>
     */
    public class HierarchicalCollider extends TreeCollider
    {
        /**
         * A collider for the agents of a game.
         *
         * @param greatLand has the models of the agents, loaded with loadHierarchies
         * @throws ArgumentError if it is null
         */
        public function HierarchicalCollider(greatLand:GreatLand)
        {
            super(new Trees(greatLand));
        }
    }
}
