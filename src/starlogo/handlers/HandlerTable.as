// This room keeps a game's handlers, and the touches that begin and end. HandlerTable finds the handlers of two breeds (PairHandlers);
// TouchTracker knows since which frame two agents touch (Touch). Read this file first, then HandlerCalls in the room collision, which calls them.
package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.agents.warnOfBreeds;
    import starlogo.data.HashTable;
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
        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests = new BreedInterests();

        /** The kinds of the handlers: a bit for each kind, 1 << kind. */
        public var kinds:int = 0;

        /** The kinds of the handlers that take the contact of a touch. */
        public var contactKinds:int = 0;

        // An entry for each two breeds that have handlers, or that have met, and its index.
        private var _all:Vector.<PairHandlers> = new Vector.<PairHandlers>();
        private var _indices:HashTable = new HashTable();

        // The handlers that came after the last frame began, and whether one was removed since then. How many were ever added, and how many of
        // them the frame knows.
        private var _added:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
        private var _isOneRemoved:Boolean = false;
        private var _count:int = 0;
        private var _knownCount:int = 0;

        /**
         * Adds a handler of a kind.
         *
         * @throws ArgumentError as Collision.onCollision does
         */
        public function add(kind:int, breed:String, otherBreed:String, callback:Function):void
        {
            require(breed, otherBreed, callback);
            requireParameters(breed, otherBreed, callback, kind);
            enter(new CollisionHandler(kind, breed, otherBreed, callback, _count));
            _count++;
        }

        /** See Collision.removeHandler. */
        public function remove(breed:String, otherBreed:String, callback:Function, kind:String):Boolean
        {
            require(breed, otherBreed, callback);
            var wanted:int = CollisionHandler.KINDS.indexOf(kind);
            if (kind != null && wanted < 0)
            {
                throw new ArgumentError("kind must be \"collision\", \"start\", \"end\" or null, not \"" + kind + "\"");
            }
            var index:int = _indices.valueOf(findBreed(breed), findBreed(otherBreed));
            var removed:CollisionHandler = index < 0 ? null : _all[index].find(callback, kind == null ? PairHandlers.ANY_KIND : wanted);
            if (removed == null)
            {
                return false;
            }
            _isOneRemoved = true;
            _all[index].remove(removed, _knownCount);
            return true;
        }

        /** Removes all handlers. */
        public function clear():void
        {
            for each (var entry:PairHandlers in _all)
            {
                entry.removeAll(_knownCount);
            }
            _isOneRemoved = true;
        }

        /**
         * Begins a frame: takes the handlers as they are now.
         *
         * @param agents the frame's agents
         */
        public function begin(agents:Vector.<Agent>):void
        {
            if (_isOneRemoved)
            {
                startAgain();
            }
            if (_added.length == 0)
            {
                return;
            }
            for each (var handler:CollisionHandler in _added)
            {
                interests.addNumbers(handler.breedNumber, handler.otherNumber);
                warnOfBreeds(new <String>[Breeds.nameOf(handler.breedNumber), Breeds.nameOf(handler.otherNumber)], agents);
                kinds |= 1 << handler.kind;
                contactKinds |= handler.needsContact ? 1 << handler.kind : 0;
            }
            _added.length = 0;
            _knownCount = _count;
        }

        /**
         * Returns the handlers of two breeds. They are empty if the two have no handlers.
         *
         * @param breed the number of the first agent's breed
         * @param otherBreed the number of the second agent's breed
         */
        public function handlersOf(breed:int, otherBreed:int):PairHandlers
        {
            var index:int = _indices.valueOf(breed, otherBreed);
            var found:PairHandlers = index < 0 ? entryOf(breed, otherBreed) : _all[index];
            return found.knownCount == _knownCount ? found : refresh(found);
        }

        /** Returns the handlers of the breeds that the agents of a found pair have now. */
        public function handlersOfPair(pairs:FoundPairs, pair:int):PairHandlers
        {
            return handlersOf(pairs.firstOf(pair).breedNumber, pairs.secondOf(pair).breedNumber);
        }

        // Finds the handlers of an entry, as they were when the frame began.
        private function refresh(entry:PairHandlers):PairHandlers
        {
            entry.setHandlers(between(entry.breed, entry.otherBreed), between(entry.otherBreed, entry.breed));
            entry.knownCount = _knownCount;
            return entry;
        }

        // The handlers whose collider is of the first breed and whose collidee is of the second, in the order of their calls.
        private function between(breed:int, otherBreed:int):Vector.<CollisionHandler>
        {
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var number:int in breed > Breeds.ANY ? [breed, Breeds.ANY] : [breed])
            {
                for each (var other:int in otherBreed > Breeds.ANY ? [otherBreed, Breeds.ANY] : [otherBreed])
                {
                    var index:int = _indices.valueOf(number, other);
                    for each (var handler:CollisionHandler in index < 0 ? null : _all[index].added)
                    {
                        if (handler.order < _knownCount)
                        {
                            found.push(handler);
                        }
                    }
                }
            }
            return found.sort(function(a:CollisionHandler, b:CollisionHandler):Number
                {
                    return a.kind == b.kind ? a.order - b.order : a.kind - b.kind;
                });
        }

        /** The breeds that handlers of the last frame name, and that none of these agents has. */
        public function breedsWithout(agents:Vector.<Agent>):Vector.<String>
        {
            var isThere:Vector.<Boolean> = new Vector.<Boolean>(Breeds.count);
            for each (var agent:Agent in agents)
            {
                isThere[agent.breedNumber] = true;
            }
            var missing:Vector.<String> = new Vector.<String>();
            for (var number:int = Breeds.ANY + 1; number < Breeds.count; number++)
            {
                if (!isThere[number] && interests.representativeOf(number) == number)
                {
                    missing.push(Breeds.nameOf(number));
                }
            }
            return missing;
        }

        private function enter(handler:CollisionHandler):void
        {
            _added.push(handler);
            entryOf(handler.breedNumber, handler.otherNumber).added.push(handler);
        }

        // Begins an empty table with the handlers that are not removed.
        private function startAgain():void
        {
            var before:Vector.<PairHandlers> = _all;
            _all = new Vector.<PairHandlers>();
            _indices.clear();
            // another object, because its revision begins again: KeptPairs compares both
            interests = new BreedInterests();
            kinds = contactKinds = 0;
            _isOneRemoved = false;
            _added.length = 0;
            for each (var entry:PairHandlers in before)
            {
                for each (var handler:CollisionHandler in entry.added)
                {
                    if (!handler.isRemoved)
                    {
                        enter(handler);
                    }
                }
            }
        }

        // The entry of two breeds. A new one has no handlers yet.
        private function entryOf(breed:int, otherBreed:int):PairHandlers
        {
            var index:int = _indices.valueOf(breed, otherBreed);
            if (index < 0)
            {
                index = _all.push(new PairHandlers(breed, otherBreed)) - 1;
                _indices.set (breed, otherBreed, index);
            }
            return _all[index];
        }

        // The number of a breed, Breeds.ANY for ANY_BREED, or -1 for an unknown breed, which has no handlers.
        private static function findBreed(name:String):int
        {
            return name == BreedInterests.ANY_BREED ? Breeds.ANY : Breeds.find(name);
        }

        private static function require(breed:String, otherBreed:String, callback:Function):void
        {
            requireBreed("breed", breed);
            requireBreed("otherBreed", otherBreed);
            if (callback == null)
            {
                throw new ArgumentError("handler must be a function, not " + textOf(callback));
            }
        }

        private static function requireBreed(argument:String, breed:String):void
        {
            if (!breed)
            {
                throw new ArgumentError(argument + " must be the name of a breed or ANY_BREED, not " + (breed == "" ? "\"\"" : textOf(breed)));
            }
        }
    }
}
