package starlogo.collision
{
    import starlogo.agents.Agent;

    /** Two agents that touch, from the frame in which that began on. A TouchTracker's. */
    internal final class TouchRecord
    {
        /** In what is known: the first's handlers have begun to hear of it, or the second's. */
        public static const FIRST:int = 1;

        /** @copy #FIRST */
        public static const SECOND:int = 2;

        /** Who was first in the list when it began. */
        public var first:Agent;

        /** The other one. */
        public var second:Agent;

        /** The breed that the first had when it began. */
        public var firstBreed:String;

        /** The breed of the other one then. */
        public var secondBreed:String;

        /** The number of the first's breed, for the interests whose token this is. */
        public var firstIndex:int;

        /** The same of the other's. */
        public var secondIndex:int;

        /** Of the interests that know the numbers. */
        public var breedToken:Object;

        /** The tracker's frame in which it began. */
        public var beganIn:int;

        /** The tracker's frame in which it was seen last. */
        public var seenIn:int;

        /** Whose handlers know of it: FIRST, SECOND, or both. */
        public var known:int;

        /** The next in the same list of the table, or among those to be used again. */
        public var next:TouchRecord = null;

        /** The one that began before, or null. */
        public var older:TouchRecord = null;

        /** The one that began after, or null. */
        public var newer:TouchRecord = null;

        /** Nobody's. */
        public function TouchRecord()
        {
        }
    }
}
