package starlogo.collision
{
    import starlogo.agents.AgentRecord;
    import starlogo.broadphase.AgentProxy;
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions somebody cares about; the order within a pair does not matter.
     */
    public final class BreedInterests
    {
        /** In place of a breed's name: any breed. An agent's breed that is called so is a breed like any other. */
        public static const ANY_BREED:String = "*";

        /**
         * Whether somebody cares about a pair of breeds, at <code>index</code> times <code>breedCount</code> plus <code>otherIndex</code>.
         *
         * @private
         */
        engine var pairs:Vector.<Boolean> = new Vector.<Boolean>();

        /**
         * Records of agents remember what was found under this; another one makes them ask again.
         *
         * @private
         */
        engine var token:Object = {};

        /**
         * Whether every pair of those breeds counts.
         *
         * @private
         */
        engine var areAll:Boolean = true;

        private var _breeds:Vector.<String> = new Vector.<String>();
        private var _hasAny:Boolean = false;

        // breed, otherBreed, breed, otherBreed, ...
        private var _added:Vector.<String> = new Vector.<String>();

        /** Nobody cares about anything yet. */
        public function BreedInterests()
        {
        }

        /** How many breeds are told apart: those that were named, and all others as one if any breed counts. */
        public function get breedCount():int
        {
            return _hasAny ? _breeds.length + 1 : _breeds.length;
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
            token = {};
            pairs = new Vector.<Boolean>(breedCount * breedCount);
            for (var i:int = 0; i < _added.length; i += 2)
            {
                markPairs(indicesOf(_added[i]), indicesOf(_added[i + 1]));
            }
            areAll = true;
            for each (var counts:Boolean in pairs)
            {
                areAll = areAll && counts;
            }
        }

        /** A breed's number, from 0 on; -1 for one that takes part in no pair. */
        public function indexOf(breed:String):int
        {
            var index:int = _breeds.indexOf(breed);
            return index < 0 && _hasAny ? _breeds.length : index;
        }

        /** Whether somebody cares about a pair of breeds, given by their numbers. */
        public function includes(index:int, otherIndex:int):Boolean
        {
            return pairs[index * breedCount + otherIndex];
        }

        /**
         * The numbers of the breeds that a name stands for: all of them for ANY_BREED.
         *
         * @private
         */
        engine function indicesOf(breed:String):Vector.<int>
        {
            if (breed != ANY_BREED)
            {
                return new <int>[_breeds.indexOf(breed)];
            }
            var indices:Vector.<int> = new Vector.<int>();
            for (var i:int = 0; i < breedCount; i++)
            {
                indices.push(i);
            }
            return indices;
        }

        /**
         * Notes the number of an agent's breed in a record of the agent.
         *
         * @private
         */
        engine function lookUp(record:AgentRecord):void
        {
            record.breedIndex = indexOf(record.agent.breed);
            record.breedToken = token;
        }

        /**
         * Of those that a proxy may meet, moves the ones of breeds that count to the beginning.
         *
         * @param proxy whose breed was looked up, as theirs were
         * @param others so many at the beginning are those that it may meet
         * @param count how many
         * @return how many count
         *
         * @private
         */
        engine function keepThoseThatCount(proxy:AgentProxy, others:Vector.<AgentProxy>, count:int):int
        {
            var counting:Vector.<Boolean> = pairs;
            var row:int = proxy.breedIndex * breedCount;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:AgentProxy = others[i];
                if (counting[int(row + other.breedIndex)])
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        private function enter(breed:String):void
        {
            if (breed == ANY_BREED)
            {
                _hasAny = true;
            }
            else if (_breeds.indexOf(breed) < 0)
            {
                _breeds.push(breed);
            }
        }

        private function markPairs(indices:Vector.<int>, otherIndices:Vector.<int>):void
        {
            for each (var index:int in indices)
            {
                for each (var otherIndex:int in otherIndices)
                {
                    pairs[index * breedCount + otherIndex] = true;
                    pairs[otherIndex * breedCount + index] = true;
                }
            }
        }
    }
}
