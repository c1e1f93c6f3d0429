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

        /**
         * @private Whether a pair of breeds is of interest. The index is the number of one breed times breedCount, plus the number of the other.
         */
        engine var areOfInterest:Vector.<Boolean> = new Vector.<Boolean>();

        /** @private Whether all pairs of the breeds that are told apart are of interest. */
        engine var areAll:Boolean = true;

        /**
         * @private By an agent's <code>breedNumber</code>: the number of its breed in this object, or -1 if the breed is in no pair. Breeds that
         * appeared after the last <code>follow()</code> are missing.
         */
        engine var numbers:Vector.<int> = new Vector.<int>();

        // The named breeds, as numbers of the class Breeds.
        private var _named:Vector.<int> = new Vector.<int>();
        private var _hasAny:Boolean = false;

        // breed, otherBreed, breed, otherBreed, ...
        private var _added:Vector.<String> = new Vector.<String>();

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
            return _hasAny ? _named.length + 1 : _named.length;
        }

        /**
         * Adds a pair of breeds. A pair that is already there is not added again.
         *
         * @param breed a breed's name, or ANY_BREED
         * @param otherBreed a breed's name, which may be the same, or ANY_BREED
         */
        public function add(breed:String, otherBreed:String):void
        {
            _added.push(breed, otherBreed);
            enter(breed);
            enter(otherBreed);
            numbers.length = 0;
            follow();
            areOfInterest = new Vector.<Boolean>(breedCount * breedCount);
            for (var i:int = 0; i < areOfInterest.length; i++)
            {
                // Ruffle leaves an element null until it is set
                areOfInterest[i] = false;
            }
            for (i = 0; i < _added.length; i += 2)
            {
                markPairs(numbersOf(_added[i]), numbersOf(_added[i + 1]));
            }
            areAll = true;
            for (i = 0; i < areOfInterest.length; i++)
            {
                areAll = areAll && (areOfInterest[i] || !isOfAgents(i % breedCount) || !isOfAgents(i / breedCount));
            }
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
            return index >= 0 && index < count && otherIndex >= 0 && otherIndex < count && areOfInterest[index * count + otherIndex];
        }

        /** @private Gives numbers to the breeds that appeared after the last call. */
        engine function follow():void
        {
            for (var number:int = numbers.length; number < Breeds.count; number++)
            {
                var index:int = _named.indexOf(number);
                numbers[number] = index < 0 && _hasAny && !Breeds.isReserved(number) ? _named.length : index;
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
            if (_hasAny && areAll && !hasFixture)
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
            var first:int = numbersOfRows[row] * breedCount;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                if (areOfInterest[first + numbersOfRows[rows[other]]])
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /** @private Whether a name matches the breed with a number. ANY_BREED matches all breeds of agents. */
        engine function matches(name:String, index:int):Boolean
        {
            return name == ANY_BREED ? isOfAgents(index) : indexOf(name) == index;
        }

        // Tells whether a number belongs to a breed of agents, not to the ground or the edges of the world.
        private function isOfAgents(index:int):Boolean
        {
            return index < 0 || index == _named.length || !Breeds.isReserved(_named[index]);
        }

        private function enter(breed:String):void
        {
            if (breed == ANY_BREED)
            {
                _hasAny = true;
            }
            else if (_named.indexOf(Breeds.numberOf(breed)) < 0)
            {
                _named.push(Breeds.numberOf(breed));
            }
        }

        // The numbers of the breeds that a name matches. A breed's name is looked up once, because a game may have hundreds of handlers.
        private function numbersOf(name:String):Vector.<int>
        {
            if (name != ANY_BREED)
            {
                return new <int>[indexOf(name)];
            }
            var all:Vector.<int> = new Vector.<int>();
            for (var i:int = 0; i < breedCount; i++)
            {
                if (isOfAgents(i))
                {
                    all.push(i);
                }
            }
            return all;
        }

        private function markPairs(someNumbers:Vector.<int>, otherNumbers:Vector.<int>):void
        {
            for each (var number:int in someNumbers)
            {
                for each (var other:int in otherNumbers)
                {
                    areOfInterest[number * breedCount + other] = areOfInterest[other * breedCount + number] = true;
                }
            }
        }
    }
}
