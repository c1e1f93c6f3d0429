package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.search.BreedPairs;

    use namespace engine;

    /** The pairs of breeds whose collisions are of interest; the order within a pair does not matter. */
    public final class BreedInterests
    {
        /** In place of a breed's name: any breed. An agent whose own breed has this name is of a breed like any other. */
        public static const ANY_BREED:String = BreedPairs.ANY_BREED;

        /** @private The same for searches and handlers. */
        engine var breedPairs:BreedPairs = new BreedPairs();

        /** No pairs yet. */
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

        /** A breed's number, from 0 on; -1 for a breed that is in no pair. */
        public function indexOf(breed:String):int
        {
            return breedPairs.numberOf(breed);
        }

        /** Whether a pair of breeds is of interest, given by their numbers; false if one is -1. */
        public function includes(index:int, otherIndex:int):Boolean
        {
            var count:int = breedCount;
            return index >= 0 && index < count && otherIndex >= 0 && otherIndex < count && breedPairs.areOfInterest[index * breedCount + otherIndex];
        }

        /** @private The collisions of interest that a collision system finds: all of them, if it is not selective. */
        engine static function findIn(system:CollisionSystem, agents:Vector.<Agent>, interests:BreedInterests,
                out:Vector.<Agent>):Vector.<Agent>
        {
            var selective:SelectiveCollisionSystem = system as SelectiveCollisionSystem;
            return selective == null ? system.findCollisions(agents, out) : selective.findCollisionsAmong(agents, interests, out);
        }
    }
}
