package starlogo.search
{
    import starlogo.agents.Breeds;
    import starlogo.data.IntPairMap;
    import starlogo.data.textOf;
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions a collision system should find. It skips all other pairs of breeds. The order within a pair does not
     * matter.
     *
     * <p>A breed that a pair names has the same number in all objects. If a pair has ANY_BREED, all breeds that no pair names share one number.
     * Otherwise they have none.</p>
     */
    public final class BreedInterests
    {
        /**
         * Matches every breed. Pass it in place of a breed's name. No agent's own breed is called so.
         */
        public static const ANY_BREED:String = Breeds.ANY_BREED;

        /** @private All pairs of breeds of agents. It must not be changed. */
        engine static const ALL:BreedInterests = newOfAll();

        /** @private The number of pairs. It grows with each pair that is added, because none is ever removed. */
        engine var pairCount:int = 0;

        // The pairs, in both orders. ANY_NUMBER is a breed like the others, so a breed with ANY_BREED costs no more than a breed with one other.
        private var _pairs:IntPairMap = new IntPairMap();

        // By the number of a breed: whether a pair names it.
        private var _isNamed:Vector.<Boolean> = new Vector.<Boolean>(Breeds.ANY_NUMBER + 1);

        private static function newOfAll():BreedInterests
        {
            var all:BreedInterests = new BreedInterests();
            all.addNumbers(Breeds.ANY_NUMBER, Breeds.ANY_NUMBER);
            return all;
        }

        /**
         * Adds a pair of breeds. A pair that is already there is not added again.
         *
         * @param breed a breed's name, or ANY_BREED
         * @param otherBreed a breed's name, which may be the same, or ANY_BREED
         * @throws ArgumentError if a name is null or empty
         */
        public function add(breed:String, otherBreed:String):void
        {
            requireName("breed", breed);
            requireName("otherBreed", otherBreed);
            addNumbers(Breeds.NAMES.numberOf(breed), Breeds.NAMES.numberOf(otherBreed));
        }

        /** @private Throws an ArgumentError if an argument is no name of a breed. */
        engine static function requireName(argument:String, breed:String):void
        {
            if (!breed)
            {
                throw new ArgumentError(argument + " must be the name of a breed or ANY_BREED, not " + textOf(breed));
            }
        }

        /** @private Adds a pair of breeds by their numbers. */
        engine function addNumbers(number:int, other:int):void
        {
            markNamed(number);
            markNamed(other);
            if (!hasPair(number, other))
            {
                pairCount++;
                _pairs.set (number, other, 0);
                _pairs.set (other, number, 0);
            }
        }

        /**
         * The number of a breed, from 0 on, or -1 if no pair concerns it. If a pair has ANY_BREED, all breeds that no pair names have one number.
         */
        public function indexOf(breed:String):int
        {
            var number:int = Breeds.NAMES.knownNumberOf(breed);
            // no pair names an unknown breed
            return matchingBreedOf(number < 0 ? Breeds.ANY_NUMBER : number);
        }

        /** Whether a pair of breeds is of interest. Pass their numbers; the answer is false if one of them is -1. */
        public function includes(number:int, otherNumber:int):Boolean
        {
            // ANY_BREED does not stand for the ground or the edges. -1 is in no pair, and is no breed of agents
            var anyOfFirst:int = Breeds.isEnvironment(number) ? -1 : Breeds.ANY_NUMBER;
            var anyOfOther:int = Breeds.isEnvironment(otherNumber) ? -1 : Breeds.ANY_NUMBER;
            return hasPair(number, otherNumber) || hasPair(number, anyOfOther) || hasPair(anyOfFirst, otherNumber) || hasPair(anyOfFirst, anyOfOther);
        }

        /** @private Whether all pairs of two breeds of agents that have numbers here are of interest. The ground and the edges do not count. */
        engine function includesAllOfAgents():Boolean
        {
            // ANY_NUMBER is the first breed here, and stands for those that no pair names
            for (var breed:int = Breeds.ANY_NUMBER; breed < _isNamed.length; breed++)
            {
                for (var other:int = breed; _isNamed[breed] && other < _isNamed.length; other++)
                {
                    if (_isNamed[other] && !includes(breed, other))
                    {
                        return false;
                    }
                }
            }
            return true;
        }

        /**
         * @private The breed of the pairs that matches a breed, both by their numbers in the class Breeds: the breed itself if a pair names it,
         *     Breeds.ANY_NUMBER if not and a pair has ANY_BREED, or -1.
         */
        engine function matchingBreedOf(breed:int):int
        {
            if (isNamed(breed))
            {
                return breed;
            }
            return !isNamed(Breeds.ANY_NUMBER) || Breeds.isEnvironment(breed) ? -1 : Breeds.ANY_NUMBER;
        }

        /**
         * @private Keeps a row's candidates whose breeds are of interest together with its own breed, and moves them to the beginning of the list.
         *
         * @param breeds by row: the number of its breed. A breed that is in no pair has no partners but those of ANY_BREED
         * @param others the candidates, which are rows
         * @param count the number of candidates
         * @return the number of candidates that it keeps
         */
        internal function keepOfInterest(breeds:Vector.<int>, row:int, others:Vector.<int>, count:int):int
        {
            var kept:int = 0;
            // candidates often have the breed of the one before
            var last:int = -1;
            var isWanted:Boolean = false;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                if (breeds[other] != last)
                {
                    last = breeds[other];
                    isWanted = includes(breeds[row], last);
                }
                if (isWanted)
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /** @private Whether a pair names a breed. */
        engine function isNamed(breed:int):Boolean
        {
            return breed >= 0 && breed < _isNamed.length && _isNamed[breed];
        }

        private function hasPair(breed:int, other:int):Boolean
        {
            return _pairs.find(breed, other) >= 0;
        }

        private function markNamed(breed:int):void
        {
            if (breed >= _isNamed.length)
            {
                // room for all breeds at once, because Adobe's VM copies a vector whenever its length is set
                _isNamed.length = Breeds.NAMES.count;
            }
            _isNamed[breed] = true;
        }
    }
}
