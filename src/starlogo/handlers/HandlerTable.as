// This room keeps a game's handlers, and the touches that begin and end. HandlerTable takes what a game adds (HandlerList), and finds what a
// frame calls for two breeds (PairHandlers); TouchTracker keeps the touches, and finds which of them go on. Read this file first, then the room
// collision's HandlerDispatcher, which calls them.
package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.IntPairMap;
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.search.BreedInterests;
    import starlogo.search.FoundPairs;

    use namespace engine;

    /**
     * The handlers of a Collision. It finds the handlers of two breeds by the breeds' numbers. Changes while a frame runs count from the next
     * frame on, except that a removed handler is not called any more.
     *
     * @private
     */
    public final class HandlerTable
    {
        /** The pairs of breeds that have handlers. Each frame after a change of the handlers has another object. */
        public var interests:BreedInterests = new BreedInterests();

        /** The phases of all handlers of the frame, and of those that take contacts: sums as in PairHandlers. */
        public var phases:int = 0;
        public var contactPhases:int = 0;

        // By the numbers of two breeds: the index of their list. They have one if they have handlers, or if their agents have met since the handlers changed.
        private var _indices:IntPairMap = new IntPairMap();

        // By index: the handlers that were added for just these two breeds, the first one as the collider.
        private var _lists:Vector.<HandlerList> = new Vector.<HandlerList>();

        // Counts the changes of the handlers.
        private var _revision:int = 0;

        // The revision at which the frame began. It calls the handlers that were there before.
        private var _frameRevision:int = 0;

        /**
         * Adds a handler for a phase.
         *
         * @throws ArgumentError as Collision.onCollision does
         */
        public function add(breed:String, otherBreed:String, callback:Function, phase:int):void
        {
            requireArguments(breed, otherBreed, callback);
            requireParameters(breed, otherBreed, callback, phase);
            var handler:CollisionHandler = new CollisionHandler(breed, otherBreed, callback, phase, _revision);
            if (Breeds.isEnvironment(handler.colliderBreed) && Breeds.isEnvironment(handler.collideeBreed))
            {
                throw new ArgumentError("TERRAIN and EDGE do not collide with each other");
            }
            listFor(handler.colliderBreed, handler.collideeBreed).add(handler);
            _revision++;
        }

        /** Removes a handler for one of some phases, a sum: see Collision.removeHandler. */
        public function remove(breed:String, otherBreed:String, callback:Function, phases:int):Boolean
        {
            requireArguments(breed, otherBreed, callback);
            var list:HandlerList = findList(Breeds.NAMES.knownNumberOf(breed), Breeds.NAMES.knownNumberOf(otherBreed));
            var isRemoved:Boolean = list != null && list.remove(callback, phases);
            _revision += isRemoved ? 1 : 0;
            return isRemoved;
        }

        /** Removes all handlers. */
        public function clear():void
        {
            for each (var list:HandlerList in _lists)
            {
                list.clear();
            }
            interests = new BreedInterests();
            phases = contactPhases = 0;
            _revision++;
        }

        /**
         * Begins a frame: takes the handlers as they are now.
         *
         * @param agents the frame's agents
         */
        public function begin(agents:Vector.<Agent>):void
        {
            if (_revision == _frameRevision)
            {
                return;
            }
            var handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var list:HandlerList in _lists)
            {
                list.appendTo(handlers, _revision);
            }
            _lists.length = 0;
            _indices.clear();
            interests = new BreedInterests();
            phases = contactPhases = 0;
            var newNames:Vector.<String> = new Vector.<String>();
            for each (var handler:CollisionHandler in handlers)
            {
                listFor(handler.colliderBreed, handler.collideeBreed).add(handler);
                interests.addNumbers(handler.colliderBreed, handler.collideeBreed);
                phases |= handler.phase;
                contactPhases |= handler.contactPhase;
                if (handler.addedAt >= _frameRevision)
                {
                    newNames.push(Breeds.NAMES.nameOf(handler.colliderBreed), Breeds.NAMES.nameOf(handler.collideeBreed));
                }
            }
            warnOfMissingBreeds(newNames, agents, interests);
            _frameRevision = _revision;
        }

        /**
         * Returns what the frame calls for two breeds. It is empty if the two have no handlers.
         *
         * @param firstBreed the number of the first agent's breed
         * @param secondBreed the number of the second agent's breed
         */
        public function handlersOf(firstBreed:int, secondBreed:int):PairHandlers
        {
            var list:HandlerList = listFor(firstBreed, secondBreed);
            if (list.pairHandlers == null)
            {
                list.pairHandlers = new PairHandlers(collect(firstBreed, secondBreed), collect(secondBreed, firstBreed));
            }
            return list.pairHandlers;
        }

        /** Returns the handlers of the breeds that the agents of a found pair have now. */
        public function handlersOfPair(pairs:FoundPairs, pair:int):PairHandlers
        {
            return handlersOf(pairs.firstOf(pair).breedNumber, pairs.secondOf(pair).breedNumber);
        }

        /** The breeds that handlers of the last frame name, and that none of these agents has. An agent may be null. */
        public function breedsWithout(agents:Vector.<Agent>):Vector.<String>
        {
            var isThere:Vector.<Boolean> = breedsAmong(agents);
            var missing:Vector.<String> = new Vector.<String>();
            for (var number:int = 0; number < Breeds.NAMES.count; number++)
            {
                if (!isThere[number] && interests.isNamed(number))
                {
                    missing.push(Breeds.NAMES.nameOf(number));
                }
            }
            return missing;
        }

        // The handlers that the frame calls for a collider and a collidee of two breeds, also those for any breed.
        private function collect(colliderBreed:int, collideeBreed:int):Vector.<CollisionHandler>
        {
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var collider:int in withAny(colliderBreed))
            {
                for each (var collidee:int in withAny(collideeBreed))
                {
                    var list:HandlerList = findList(collider, collidee);
                    if (list != null)
                    {
                        list.appendTo(found, _frameRevision);
                    }
                }
            }
            return found;
        }

        // The numbers of breeds whose handlers count for an agent of a breed. Any breed does not stand for the ground and the edges.
        private static function withAny(breed:int):Array
        {
            return Breeds.isEnvironment(breed) ? [breed] : [breed, Breeds.ANY_NUMBER];
        }

        // The list of two breeds, by their numbers; a new one if there is none.
        private function listFor(colliderBreed:int, collideeBreed:int):HandlerList
        {
            var index:int = _indices.find(colliderBreed, collideeBreed);
            if (index < 0)
            {
                index = _lists.push(new HandlerList()) - 1;
                _indices.set (colliderBreed, collideeBreed, index);
            }
            return _lists[index];
        }

        // The list for just two breeds; null if there is none.
        private function findList(colliderBreed:int, collideeBreed:int):HandlerList
        {
            var index:int = _indices.find(colliderBreed, collideeBreed);
            return index < 0 ? null : _lists[index];
        }

        private static function requireArguments(breed:String, otherBreed:String, callback:Function):void
        {
            BreedInterests.requireName("breed", breed);
            BreedInterests.requireName("otherBreed", otherBreed);
            if (callback == null)
            {
                throw new ArgumentError("handler must be a function, not " + textOf(callback) + ", for " + textOf(breed) + " and " + textOf(otherBreed));
            }
        }
    }
}
