package starlogo.search
{
    import starlogo.engine;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * What the pairs of a search depend on besides the agents, the ground and the edges of the world. It is set before the search, and does not
     * change during it.
     */
    internal final class SearchConditions
    {
        /** The pairs of breeds that count; null for all. And how often a pair was added to them. */
        public var interests:BreedInterests = null;
        public var interestsRevision:int = 0;

        /** By index in the list: whether the game lets the agent take part; null for all. */
        public var takePart:Vector.<Boolean> = null;

        /** Whether all shapes that the collider has made are spheres. */
        public var areSpheres:Boolean = false;

        /** Whether an agent of the list sweeps. */
        public var anySweeps:Boolean = false;

        /** How deep trees are tested; 0 if exactly. */
        public var maxDepth:int = 0;

        /** Whether the search before had these conditions too. Then the same agents have the same pairs, if the same ones take part. */
        public var areLikeLast:Boolean = false;

        /** Whether a row is a member of the search: it has a shape, its breed is of interest, and its agent takes part. */
        public function isMember(table:AgentTable, row:int):Boolean
        {
            return table.shapes[row] != null && (interests == null || interests.indexOfNumber(table.breeds[row]) >= 0)
                && (takePart == null || takePart[table.list.ranks[row]]);
        }

        /**
         * Sets the conditions of a search.
         *
         * @param input has the breeds and the agents that count
         */
        public function setTo(input:FrameInput, areSpheres:Boolean, anySweeps:Boolean, maxDepth:int):void
        {
            var revision:int = input.interests == null ? 0 : input.interests.revision;
            areLikeLast = interests === input.interests && interestsRevision == revision && this.anySweeps == anySweeps && this.maxDepth == maxDepth
                && (takePart == null) == (input.takePart == null);
            interests = input.interests;
            interestsRevision = revision;
            takePart = input.takePart;
            this.areSpheres = areSpheres;
            this.anySweeps = anySweeps;
            this.maxDepth = maxDepth;
        }
    }
}
