package starlogo.collision
{
    import flash.utils.Dictionary;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * The pairs of breeds whose collisions somebody cares about; the order within a pair does not matter.
     */
    public final class BreedInterests
    {
        private var _indices:Dictionary = new Dictionary();
        private var _count:int = 0;
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
            return _count;
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
            _pairs[a * _count + b] = true;
            _pairs[b * _count + a] = true;
        }

        /**
         * A breed's number among those that take part in a pair, from 0 on; -1 for one that takes part in none.
         */
        public function indexOf(breed:String):int
        {
            // not by [breed] alone: a breed may be called "toString"
            return _indices.hasOwnProperty(breed) ? _indices[breed] : -1;
        }

        /**
         * Whether somebody cares about a pair of breeds, given by their numbers.
         */
        public function includes(index:int, otherIndex:int):Boolean
        {
            return _pairs[index * _count + otherIndex];
        }

        /** The number of an agent's breed, remembered in the agent. */
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
                index = _count;
                widen();
                _indices[breed] = index;
                _edition = {};
            }
            return index;
        }

        // One row and one column more.
        private function widen():void
        {
            var wider:Vector.<Boolean> = new Vector.<Boolean>((_count + 1) * (_count + 1));
            for (var a:int = 0; a < _count; a++)
            {
                for (var b:int = 0; b < _count; b++)
                {
                    wider[a * (_count + 1) + b] = _pairs[a * _count + b];
                }
            }
            _pairs = wider;
            _count++;
        }
    }
}
