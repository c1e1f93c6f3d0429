package starlogo.collision
{
    import starlogo.engine;
    import starlogo.search.BreedPairs;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions somebody cares about; the order within a pair does not matter.
     */
    public final class BreedInterests
    {
        /** In place of a breed's name: any breed. An agent's breed that is called so is a breed like any other. */
        public static const ANY_BREED:String = BreedPairs.ANY_BREED;

        /**
         * What searches and handlers ask.
         *
         * @private
         */
        engine var breedPairs:BreedPairs = new BreedPairs();

        /** Nobody cares about anything yet. */
        public function BreedInterests()
        {
        }

        /** How many breeds are told apart: those that were named, and all others as one if any breed counts. */
        public function get breedCount():int
        {
            return breedPairs.breedCount;
        }

        /**
         * Adds a pair of breeds; a pair that is already there stays.
         *
         * @param breed a breed's name, or ANY_BREED
         * @param otherBreed a breed's name, which may be the same, or ANY_BREED
         */
        public function add(breed:String, otherBreed:String):void
        {
            breedPairs.add(breed, otherBreed);
        }

        /** A breed's number, from 0 on; -1 for one that takes part in no pair. */
        public function indexOf(breed:String):int
        {
            return breedPairs.numberOf(breed);
        }

        /** Whether somebody cares about a pair of breeds, given by their numbers. */
        public function includes(index:int, otherIndex:int):Boolean
        {
            return breedPairs.counts[index * breedCount + otherIndex];
        }
    }
}
