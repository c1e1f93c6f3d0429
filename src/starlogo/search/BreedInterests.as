package starlogo.search
{
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions a collision system should find. It skips all other pairs of breeds. The order within a pair does not
     * matter.
     *
     * <p>A breed has the same number in all objects. All breeds that no pair names share one number, so that the search can look up a pair
     * in a small table.</p>
     */
    public final class BreedInterests
    {
        /**
         * Matches every breed. Pass it in place of a breed's name. If an agent's own breed is called "*", that breed is still an ordinary one.
         */
        public static const ANY_BREED:String = "*";

        /** @private Whether all pairs of the breeds of agents that are told apart are of interest. */
        engine var areAll:Boolean = true;

        // By number: the numbers that make a pair with it, plus 1, because no id is 0. Null for a breed that no pair names, and for ANY until a
        // pair has ANY_BREED. ANY is a member like the others, so a breed with ANY_BREED costs no more than a breed with one other.
        private var _partners:Vector.<IdTable> = new Vector.<IdTable>(Breeds.ANY + 1);

        // How many breeds of agents the pairs name, and how many pairs are of two of these.
        private var _agentBreeds:int = 0;
        private var _agentPairs:int = 0;

        /** How often a pair was added. */
        internal var revision:int = 0;

        /** All numbers of breeds in pairs are less than this. It grows when a pair is added. */
        public function get breedCount():int
        {
            return _partners.length;
        }

        /**
         * Adds a pair of breeds. A pair that is already there is not added again.
         *
         * @param breed a breed's name, or ANY_BREED
         * @param otherBreed a breed's name, which may be the same, or ANY_BREED
         */
        public function add(breed:String, otherBreed:String):void
        {
            addNumbers(numberOf(breed), numberOf(otherBreed));
        }

        /** @private Adds a pair of breeds by their numbers. */
        engine function addNumbers(number:int, other:int):void
        {
            revision++;
            enter(number);
            enter(other);
            if (!_partners[number].has(other + 1))
            {
                _partners[number].set (other + 1, 0);
                _partners[other].set (number + 1, 0);
                _agentPairs += number > Breeds.ANY && other > Breeds.ANY ? 1 : 0;
            }
            // the breeds that no pair names are told apart from the others once a pair has ANY_BREED
            var any:IdTable = _partners[Breeds.ANY];
            areAll = any == null ? 2 * _agentPairs == _agentBreeds * (_agentBreeds + 1) : any.has(Breeds.ANY + 1);
        }

        /** The number of a breed, from 0 on, or -1 if the breed is in no pair. */
        public function indexOf(breed:String):int
        {
            return indexOfNumber(Breeds.numberOf(breed));
        }

        /** Whether a pair of breeds is of interest. Pass their numbers; the answer is false if one of them is -1. */
        public function includes(index:int, otherIndex:int):Boolean
        {
            if (!isEntered(index) || !isEntered(otherIndex))
            {
                return false;
            }
            var isOfAgents:Boolean = !Breeds.isReserved(index);
            var isOtherOfAgents:Boolean = !Breeds.isReserved(otherIndex);
            return _partners[index].has(otherIndex + 1) || isOfAgents && isOtherOfAgents && areAll ||
                isOtherOfAgents && _partners[index].has(Breeds.ANY + 1) || isOfAgents && _partners[otherIndex].has(Breeds.ANY + 1);
        }

        /** @private The number of a breed in the class Breeds, or Breeds.ANY for ANY_BREED. */
        engine static function numberOf(name:String):int
        {
            return name == ANY_BREED ? Breeds.ANY : Breeds.numberOf(name);
        }

        /** @private The same as <code>indexOf()</code> of a breed's name, from the breed's number in the class Breeds. */
        engine function indexOfNumber(breed:int):int
        {
            if (isEntered(breed))
            {
                return breed;
            }
            return _partners[Breeds.ANY] == null || Breeds.isReserved(breed) ? -1 : Breeds.ANY;
        }

        /** The number of listed agents whose breed is in no pair. */
        internal function countOutsiders(table:AgentTable):int
        {
            var partners:Vector.<IdTable> = _partners;
            var breeds:Vector.<int> = table.breeds;
            var rows:Vector.<int> = table.list.rows;
            var known:int = partners.length;
            var end:int = partners[Breeds.ANY] == null ? table.list.count : 0;
            var outsiders:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                var number:int = breeds[rows[i]];
                if (number >= known || partners[number] == null)
                {
                    outsiders++;
                }
            }
            return outsiders;
        }

        /**
         * Keeps a row's candidates whose breeds are of interest together with its own breed, and moves them to the beginning of the list.
         *
         * @param numbers by row: the number of its breed. A breed that is in no pair has no partners but those of ANY_BREED
         * @param others the candidates, which are rows
         * @param count the number of candidates
         * @return the number of candidates that it keeps
         */
        internal function keepOfInterest(numbers:Vector.<int>, row:int, others:Vector.<int>, count:int):int
        {
            var own:int = indexOfNumber(numbers[row]);
            var any:IdTable = _partners[Breeds.ANY];
            if (any != null && any.has(own + 1))
            {
                return count;
            }
            // ANY_BREED does not stand for the ground or the edges
            any = Breeds.isReserved(own) ? null : any;
            var partners:IdTable = _partners[own];
            var ids:Vector.<int> = partners.slots;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var number:int = numbers[other] + 1;
                // as has(), with one call less for each candidate
                if (ids[partners.slotOf(number)] == number || any != null && any.has(number))
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /** Whether pairs of a breed were added. */
        internal function isEntered(number:int):Boolean
        {
            return number >= 0 && number < _partners.length && _partners[number] != null;
        }

        private function enter(number:int):void
        {
            if (number >= _partners.length)
            {
                // room for all breeds at once, because Adobe's VM copies a vector whenever its length is set
                _partners.length = Breeds.count;
            }
            if (_partners[number] == null)
            {
                _partners[number] = new IdTable();
                _agentBreeds += number > Breeds.ANY ? 1 : 0;
            }
        }
    }
}
