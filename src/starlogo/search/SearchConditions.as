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

        /** By index in the list: whether the agent takes part; null for all. */
        public var takePart:Vector.<Boolean> = null;

        /** Whether all shapes that the collider has made are spheres. */
        public var areSpheres:Boolean = false;

        /** Whether an agent of the list sweeps. */
        public var isSwept:Boolean = false;

        /** How deep trees are tested; 0 if exactly. */
        public var maxDepth:int = 0;

        /** Whether the agent of a row takes part. */
        public function isMember(table:AgentTable, row:int):Boolean
        {
            return table.shapes[row] != null && (interests == null || interests.indexOfNumber(table.breeds[row]) >= 0)
                && (takePart == null || takePart[table.list.ranks[row]]);
        }

        /** Whether two searches of the same agents find the same pairs, if the same agents take part. */
        public function isLike(other:SearchConditions):Boolean
        {
            return interests === other.interests && interestsRevision == other.interestsRevision && isSwept == other.isSwept
                && maxDepth == other.maxDepth && (takePart == null) == (other.takePart == null);
        }

        /** Takes the conditions of another search. */
        public function copyFrom(other:SearchConditions):void
        {
            interests = other.interests;
            interestsRevision = other.interestsRevision;
            takePart = other.takePart;
            areSpheres = other.areSpheres;
            isSwept = other.isSwept;
            maxDepth = other.maxDepth;
        }
    }
}
