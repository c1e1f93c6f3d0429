package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.broadphase.Bins;
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions are of interest. The order within a pair does not matter. Its breeds have numbers of their own, so
     * that a frame looks pairs up in a small table.
     */
    public final class BreedInterests
    {
        /** Stands for any breed, where a breed's name is wanted. An agent whose own breed has this name is of a breed like any other. */
        public static const ANY_BREED:String = "*";

        /** @private Whether a pair of breeds is of interest, at the number of one breed times breedCount plus the number of the other. */
        engine var areOfInterest:Vector.<Boolean> = new Vector.<Boolean>();

        /** @private Whether every pair of the breeds that have numbers is of interest. */
        engine var areAll:Boolean = true;

        /**
         * @private For the <code>breedNumber</code> of an agent, the number of its breed here; -1 for a breed that is in no pair. It may lack new
         * breeds: see <code>follow()</code>.
         */
        engine var numbers:Vector.<int> = new Vector.<int>();

        // The breeds that were named, by their numbers in Breeds.
        private var _named:Vector.<int> = new Vector.<int>();
        private var _hasAny:Boolean = false;

        // breed, otherBreed, breed, otherBreed, ...
        private var _added:Vector.<String> = new Vector.<String>();

        // By row of the table that was read last: the number of its breed.
        private var _ofRows:Vector.<int> = new Vector.<int>();

        /** No pairs yet. */
        public function BreedInterests()
        {
        }

        /** How many breeds are told apart: those that were named, and all others as one if any breed counts. */
        public function get breedCount():int
        {
            return _hasAny ? _named.length + 1 : _named.length;
        }

        /**
         * Adds a pair of breeds; a pair that is already there stays.
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
                // in Ruffle an element that was not set is null
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

        /** A breed's number, from 0 on; -1 for a breed that is in no pair. */
        public function indexOf(breed:String):int
        {
            var number:int = Breeds.numberOf(breed);
            follow();
            return numbers[number];
        }

        /** Whether a pair of breeds is of interest, given by their numbers; false if one is -1. */
        public function includes(index:int, otherIndex:int):Boolean
        {
            var count:int = breedCount;
            return index >= 0 && index < count && otherIndex >= 0 && otherIndex < count && areOfInterest[index * count + otherIndex];
        }

        /** @private Gives the breeds that were new since the last call their numbers. */
        engine function follow():void
        {
            for (var number:int = numbers.length; number < Breeds.count; number++)
            {
                var index:int = _named.indexOf(number);
                numbers[number] = index < 0 && _hasAny && !Breeds.isReserved(number) ? _named.length : index;
            }
        }

        /**
         * Reads the breeds of a table's agents, if they matter.
         *
         * @return how many of the agents have a breed that is in no pair
         */
        internal function read(table:AgentTable):int
        {
            if (_hasAny && areAll)
            {
                return 0;
            }
            follow();
            var ofRows:Vector.<int> = _ofRows;
            var agents:Vector.<Agent> = table.agents;
            var rows:Vector.<int> = table.rows;
            var ofNames:Vector.<int> = numbers;
            var end:int = table.count;
            if (ofRows.length < agents.length)
            {
                ofRows.length = agents.length;
            }
            var outsiders:int = 0;
            for (var i:int = 0; i < end; i++)
            {
                var row:int = rows[i];
                var number:int = ofNames[agents[row].breedNumber];
                ofRows[row] = number;
                if (number < 0)
                {
                    outsiders++;
                }
            }
            return outsiders;
        }

        /** Whether the breed of a row that was read is in a pair. */
        internal function hasBreedOf(row:int):Boolean
        {
            return _ofRows[row] >= 0;
        }

        /**
         * Moves those candidates of a member to the beginning whose breeds are of interest together with its own.
         *
         * @param others the slots of the candidates
         * @param count how many they are
         * @return how many these are
         */
        internal function keepOfInterest(bins:Bins, slot:int, others:Vector.<int>, count:int):int
        {
            var ofRows:Vector.<int> = _ofRows;
            var rowAt:Vector.<int> = bins.rowAt;
            var first:int = ofRows[rowAt[slot]] * breedCount;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                if (areOfInterest[first + ofRows[rowAt[other]]])
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /** @private Whether a number is of a breed of agents, not of the ground or the edges of the world. */
        engine function isOfAgents(index:int):Boolean
        {
            return index < 0 || index == _named.length || !Breeds.isReserved(_named[index]);
        }

        // The numbers of the breeds that a name matches: all of agents for ANY_BREED.
        private function numbersOf(breed:String):Vector.<int>
        {
            if (breed != ANY_BREED)
            {
                return new <int>[indexOf(breed)];
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

        private function markPairs(someNumbers:Vector.<int>, otherNumbers:Vector.<int>):void
        {
            for each (var number:int in someNumbers)
            {
                for each (var other:int in otherNumbers)
                {
                    areOfInterest[number * breedCount + other] = true;
                    areOfInterest[other * breedCount + number] = true;
                }
            }
        }
    }
}
