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
     * <p>Each breed that is named gets a number, so that the search can look up a pair in a small table.</p>
     */
    public final class BreedInterests
    {
        /**
         * Matches every breed. Pass it in place of a breed's name. If an agent's own breed is called "*", that breed is still an ordinary one.
         */
        public static const ANY_BREED:String = "*";

        /** @private Whether all pairs of the breeds that are told apart are of interest. */
        engine var areAll:Boolean = true;

        /**
         * @private By an agent's <code>breedNumber</code>: the number of its breed in this object, or -1 if the breed is in no pair. Breeds that
         * appeared after the last <code>follow()</code> are missing.
         */
        engine var numbers:Vector.<int> = new Vector.<int>();

        // By number: the breed's number of the class Breeds. Of the breeds that are named nowhere, taken together, it is OTHERS.
        private static const OTHERS:int = -1;
        private var _named:Vector.<int> = new Vector.<int>();

        // The number of the others; -1 until a pair has ANY_BREED. How many numbers belong to breeds of agents.
        private var _others:int = -1;
        private var _agentBreeds:int = 0;

        // A bit for each pair of numbers, in both orders: whether it is of interest. A row of bits has _words elements.
        private var _bits:Vector.<int> = new Vector.<int>();
        private var _words:int = 1;

        // How many pairs of breeds of agents have a bit.
        private var _agentPairs:int = 0;

        /** By row of the table that was read last: the number of its breed, or -1. */
        internal var ofRows:Vector.<int> = new Vector.<int>();

        /** Begins without pairs. */
        public function BreedInterests()
        {
        }

        /**
         * The number of breeds that are told apart. Each breed in a pair counts. If a pair has ANY_BREED, all other breeds together count as one
         * more.
         */
        public function get breedCount():int
        {
            return _named.length;
        }

        /**
         * Adds a pair of breeds. A pair that is already there is not added again.
         *
         * @param breed a breed's name, or ANY_BREED
         * @param otherBreed a breed's name, which may be the same, or ANY_BREED
         */
        public function add(breed:String, otherBreed:String):void
        {
            var number:int = enter(breed);
            var other:int = enter(otherBreed);
            if (!hasBit(number, other))
            {
                var end:int = number == _others ? breedCount : number + 1;
                for (var i:int = number == _others ? 0 : number; i < end; i++)
                {
                    markWith(i, number, other);
                }
            }
            areAll = 2 * _agentPairs == _agentBreeds * (_agentBreeds + 1);
        }

        /** The number of a breed, from 0 on, or -1 if the breed is in no pair. */
        public function indexOf(breed:String):int
        {
            var number:int = Breeds.numberOf(breed);
            follow();
            return numbers[number];
        }

        /** Whether a pair of breeds is of interest. Pass their numbers; the answer is false if one of them is -1. */
        public function includes(index:int, otherIndex:int):Boolean
        {
            var count:int = breedCount;
            return index >= 0 && index < count && otherIndex >= 0 && otherIndex < count
                && hasBit(index, otherIndex);
        }

        /** @private Gives numbers to the breeds that appeared after the last call. */
        engine function follow():void
        {
            for (var number:int = numbers.length; number < Breeds.count; number++)
            {
                numbers[number] = Breeds.isReserved(number) ? -1 : _others;
            }
        }

        /**
         * Reads the breed of each agent in a table. It reads nothing if all pairs of all breeds are of interest, and there is
         * neither ground nor edges.
         *
         * @return the number of agents whose breed is in no pair; 0 if nothing was read
         */
        internal function read(table:AgentTable):int
        {
            var hasFixture:Boolean = table.agents[RowList.GROUND] != null || table.agents[RowList.EDGES] != null;
            if (_others >= 0 && areAll && !hasFixture)
            {
                return 0;
            }
            follow();
            var numbersOfRows:Vector.<int> = ofRows;
            var agents:Vector.<Agent> = table.agents;
            var rows:Vector.<int> = table.rows;
            var ofNames:Vector.<int> = numbers;
            var end:int = table.count;
            if (numbersOfRows.length < agents.length)
            {
                numbersOfRows.length = agents.length;
            }
            for (var fixture:int = RowList.GROUND; fixture <= RowList.EDGES; fixture++)
            {
                numbersOfRows[fixture] = agents[fixture] == null ? -1 : ofNames[agents[fixture].breedNumber];
            }
            var outsiders:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = rows[i];
                var number:int = ofNames[agents[row].breedNumber];
                numbersOfRows[row] = number;
                if (number < 0)
                {
                    outsiders++;
                }
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
            var numbersOfRows:Vector.<int> = ofRows;
            var bits:Vector.<int> = _bits;
            var first:int = numbersOfRows[row] * _words;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var otherNumber:int = numbersOfRows[rows[other]];
                if ((bits[int(first + (otherNumber >> 5))] & (1 << otherNumber)) != 0)
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /** @private The number of a name: of a breed, or of the others for ANY_BREED. The name is in a pair. */
        engine function numberOf(name:String):int
        {
            return name == ANY_BREED ? _others : indexOf(name);
        }

        /** @private Whether a number belongs to a breed of agents, not to the ground or the edges of the world. */
        engine function isOfAgents(number:int):Boolean
        {
            return number >= 0 && (number == _others || !Breeds.isReserved(_named[number]));
        }

        // Returns the number of a name. A new name gets the next number.
        private function enter(name:String):int
        {
            var breed:int = name == ANY_BREED ? OTHERS : Breeds.numberOf(name);
            follow();
            var number:int = breed == OTHERS ? _others : numbers[breed];
            if (number >= 0 && _named[number] == breed)
            {
                return number;
            }
            number = _named.push(breed) - 1;
            if (number >= 32 * _words)
            {
                widen();
            }
            for (var word:int = 0; word < _words; word++)
            {
                _bits.push(0);
            }
            var i:int;
            if (breed == OTHERS)
            {
                _others = number;
                numbers.length = 0;
                follow();
                for (i = 0; i < number; i++)
                {
                    numbers[_named[i]] = i;
                }
            }
            else
            {
                numbers[breed] = number;
            }
            _agentBreeds += isOfAgents(number) ? 1 : 0;
            // until now the breed was one of the others
            for (i = 0; _others >= 0 && _others != number && isOfAgents(number) && i <= number; i++)
            {
                if (hasBit(_others, i == number ? _others : i))
                {
                    mark(number, i);
                }
            }
            return number;
        }

        // Marks the pairs of a number and another number, or all breeds of agents if that stands for ANY_BREED.
        private function markWith(i:int, number:int, other:int):void
        {
            var end:int = other == _others ? breedCount : other + 1;
            for (var k:int = other == _others ? 0 : other; k < end; k++)
            {
                if ((i == number || isOfAgents(i)) && (k == other || isOfAgents(k)))
                {
                    mark(i, k);
                }
            }
        }

        private function mark(number:int, other:int):void
        {
            if (!hasBit(number, other))
            {
                setBit(number, other);
                setBit(other, number);
                _agentPairs += isOfAgents(number) && isOfAgents(other) ? 1 : 0;
            }
        }

        // Makes the rows of bits twice as long.
        private function widen():void
        {
            var wide:Vector.<int> = new Vector.<int>(2 * _bits.length);
            for (var i:int = 0; i < _bits.length; i++)
            {
                wide[i + int(i / _words) * _words] = _bits[i];
            }
            _bits = wide;
            _words *= 2;
        }

        private function hasBit(number:int, other:int):Boolean
        {
            return (_bits[number * _words + (other >> 5)] & (1 << other)) != 0;
        }

        private function setBit(number:int, other:int):void
        {
            _bits[number * _words + (other >> 5)] |= 1 << other;
        }
    }
}
