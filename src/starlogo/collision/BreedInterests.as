package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions somebody cares about; the order within a pair does not matter.
     */
    public final class BreedInterests
    {
        private var _breeds:Vector.<String> = new Vector.<String>();
        private var _pairs:Vector.<Boolean> = new Vector.<Boolean>();

        // Agents remember what was found under this token; another one makes them ask again.
        private var _edition:Object = {};

        /** Nobody cares about anything yet. */
        public function BreedInterests()
        {
        }

        /** How many breeds take part in any pair. */
        public function get breedCount():int
        {
            return _breeds.length;
        }

        /**
         * Adds a pair of breeds; a pair that is already there stays.
         *
         * @param breed a breed's name
         * @param otherBreed a breed's name, which may be the same
         */
        public function add(breed:String, otherBreed:String):void
        {
            var a:int = enter(breed);
            var b:int = enter(otherBreed);
            _pairs[a * _breeds.length + b] = true;
            _pairs[b * _breeds.length + a] = true;
        }

        /**
         * A breed's number among those that take part in a pair, from 0 on; -1 for one that takes part in none.
         */
        public function indexOf(breed:String):int
        {
            return _breeds.indexOf(breed);
        }

        /**
         * Whether somebody cares about a pair of breeds, given by their numbers.
         */
        public function includes(index:int, otherIndex:int):Boolean
        {
            return _pairs[index * _breeds.length + otherIndex];
        }

        /**
         * The number of an agent's breed, remembered in the agent.
         *
         * @private
         */
        engine function breedIndexOf(agent:Agent):int
        {
            if (agent.breedResolver !== _edition)
            {
                agent.breedIndex = indexOf(agent.breed);
                agent.breedResolver = _edition;
            }
            return agent.breedIndex;
        }

        private function enter(breed:String):int
        {
            var index:int = indexOf(breed);
            if (index < 0)
            {
                index = _breeds.length;
                widen();
                _breeds.push(breed);
                _edition = {};
            }
            return index;
        }

        // One row and one column more.
        private function widen():void
        {
            var count:int = _breeds.length;
            var wider:Vector.<Boolean> = new Vector.<Boolean>((count + 1) * (count + 1));
            for (var a:int = 0; a < count; a++)
            {
                for (var b:int = 0; b < count; b++)
                {
                    wider[a * (count + 1) + b] = _pairs[a * count + b];
                }
            }
            _pairs = wider;
        }
    }
}
