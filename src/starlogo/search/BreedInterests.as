package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions a collision system should find. It skips all other pairs of breeds. The order within a pair does not
     * matter.
     *
     * <p>A breed has the same number in all objects. All breeds that no pair names have one number together, so that the search can look up a pair
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

        // A page has a bit for each of 1,024 numbers, so its place in a row is the number without its last ten bits. Most pages are empty, and
        // all empty ones are this one. So the memory hardly grows with the square of the number of breeds.
        private static const EMPTY:Vector.<int> = new Vector.<int>(32, true);

        // By number: its row of _pageCount pages, with a bit for each other number: whether the two are of interest. The row is null for a breed
        // that no pair names, and for ANY until a pair has ANY_BREED.
        private var _bits:Vector.<Vector.<Vector.<int>>> = new Vector.<Vector.<Vector.<int>>>(Breeds.ANY + 1);
        private var _pageCount:int = 1;

        // The numbers that have bits. How many of them are breeds of agents, and how many pairs of these are of interest.
        private var _numbers:Vector.<int> = new Vector.<int>();
        private var _agentBreeds:int = 0;
        private var _agentPairs:int = 0;

        /** By row of the table that was read last: the number of its breed, or -1. */
        internal var ofRows:Vector.<int> = new Vector.<int>();

        /** All numbers of breeds are less than this. It grows when a pair is added. */
        public function get breedCount():int
        {
            return _bits.length;
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
            enter(number);
            enter(other);
            if (!hasBit(number, other))
            {
                markWith(number, other);
            }
            areAll = 2 * _agentPairs == _agentBreeds * (_agentBreeds + 1);
        }

        /** The number of a breed, from 0 on, or -1 if the breed is in no pair. */
        public function indexOf(breed:String):int
        {
            return indexOfNumber(Breeds.numberOf(breed));
        }

        /** Whether a pair of breeds is of interest. Pass their numbers; the answer is false if one of them is -1. */
        public function includes(index:int, otherIndex:int):Boolean
        {
            return isEntered(index) && isEntered(otherIndex) && hasBit(index, otherIndex);
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
            return _bits[Breeds.ANY] == null || Breeds.isReserved(breed) ? -1 : Breeds.ANY;
        }

        /**
         * Reads the breed of each agent in a table. It reads nothing if all pairs of all breeds are of interest, and there is
         * neither ground nor edges.
         *
         * @return the number of agents whose breed is in no pair; 0 if nothing was read
         */
        internal function read(table:AgentTable):int
        {
            var agents:Vector.<Agent> = table.agents;
            var bits:Vector.<Vector.<Vector.<int>>> = _bits;
            var others:int = bits[Breeds.ANY] == null ? -1 : Breeds.ANY;
            if (others == Breeds.ANY && areAll && agents[RowList.GROUND] == null && agents[RowList.EDGES] == null)
            {
                return 0;
            }
            var numbers:Vector.<int> = ofRows;
            if (numbers.length < agents.length)
            {
                numbers.length = agents.length;
            }
            for (var fixture:int = RowList.GROUND; fixture <= RowList.EDGES; fixture++)
            {
                numbers[fixture] = agents[fixture] == null ? -1 : indexOfNumber(agents[fixture].breedNumber);
            }
            var rows:Vector.<int> = table.rows;
            var known:int = bits.length;
            var end:int = table.count;
            var outside:int = others < 0 ? 1 : 0;
            var outsiders:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = rows[i];
                var number:int = agents[row].breedNumber;
                if (number >= known || bits[number] == null)
                {
                    number = others;
                    outsiders += outside;
                }
                numbers[row] = number;
            }
            return outsiders;
        }

        /**
         * Keeps a row's candidates whose breeds are of interest together with its own breed, and moves them to the beginning of the list.
         *
         * @param rows the candidates are indices in this list of rows
         * @param others the candidates
         * @param count the number of candidates
         * @return the number of candidates that it keeps
         */
        internal function keepOfInterest(row:int, rows:Vector.<int>, others:Vector.<int>, count:int):int
        {
            var numbers:Vector.<int> = ofRows;
            var pages:Vector.<Vector.<int>> = _bits[numbers[row]];
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var number:int = numbers[rows[other]];
                if ((pages[number >> 10][number >> 5 & 31] & 1 << number) != 0)
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        private function isEntered(number:int):Boolean
        {
            return number >= 0 && number < _bits.length && _bits[number] != null;
        }

        // Gives a number its bits.
        private function enter(number:int):void
        {
            if (isEntered(number))
            {
                return;
            }
            if (number >= _bits.length)
            {
                _bits.length = number + 1;
            }
            while (number >> 10 >= _pageCount)
            {
                _pageCount *= 2;
                for each (var named:int in _numbers)
                {
                    widen(_bits[named]);
                }
            }
            _bits[number] = new Vector.<Vector.<int>>();
            widen(_bits[number]);
            _numbers.push(number);
            if (Breeds.isReserved(number))
            {
                return;
            }
            _agentBreeds++;
            // until now the breed was one of the others
            for (var i:int = 0; _bits[Breeds.ANY] != null && i < _numbers.length; i++)
            {
                if (hasBit(Breeds.ANY, _numbers[i] == number ? Breeds.ANY : _numbers[i]))
                {
                    mark(number, _numbers[i]);
                }
            }
        }

        // Marks a pair of numbers. Breeds.ANY stands for all breeds of agents.
        private function markWith(number:int, other:int):void
        {
            for each (var i:int in number == Breeds.ANY ? _numbers : new <int>[number])
            {
                for each (var k:int in other == Breeds.ANY ? _numbers : new <int>[other])
                {
                    if ((i == number || !Breeds.isReserved(i)) && (k == other || !Breeds.isReserved(k)))
                    {
                        mark(i, k);
                    }
                }
            }
        }

        private function mark(number:int, other:int):void
        {
            if (!hasBit(number, other))
            {
                setBit(_bits[number], other);
                setBit(_bits[other], number);
                _agentPairs += !Breeds.isReserved(number) && !Breeds.isReserved(other) ? 1 : 0;
            }
        }

        private function widen(pages:Vector.<Vector.<int>>):void
        {
            while (pages.length < _pageCount)
            {
                pages.push(EMPTY);
            }
        }

        private function hasBit(number:int, other:int):Boolean
        {
            return (_bits[number][other >> 10][other >> 5 & 31] & 1 << other) != 0;
        }

        private static function setBit(pages:Vector.<Vector.<int>>, other:int):void
        {
            var page:int = other >> 10;
            if (pages[page] == EMPTY)
            {
                pages[page] = new Vector.<int>(32, true);
            }
            pages[page][other >> 5 & 31] |= 1 << other;
        }
    }
}
