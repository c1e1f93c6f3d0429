// This room keeps a game's handlers, and the touches that begin and end. HandlerTable takes what a game adds (AddedHandlers), and finds what a
// frame calls for two breeds (PairHandlers); TouchTracker knows since which frame two agents touch (Touch). Read this file first, then
// HandlerCalls in the room collision, which calls them.
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
        /** The pairs of breeds that have handlers. Each frame after a change of the handlers has another object. */
        public var interests:BreedInterests = new BreedInterests();

        /** The kinds of the handlers: a bit for each kind, 1 << kind. */
        public var kinds:int = 0;

        /** The kinds of the handlers that take the contact of a touch. */
        public var contactKinds:int = 0;

        // The added handlers, and by the numbers of the collider's breed and of the collidee's: their index.
        private var _added:Vector.<AddedHandlers> = new Vector.<AddedHandlers>();
        private var _addedIndices:HashTable = new HashTable();

        // What the frame calls for breeds that have met, and its index by their numbers.
        private var _called:Vector.<PairHandlers> = new Vector.<PairHandlers>();
        private var _calledIndices:HashTable = new HashTable();

        // The serial number of the next handler. The frame calls handlers with lower numbers than the second one. Whether any has come or gone since
        // the frame began.
        private var _nextSerial:int = 0;
        private var _endSerial:int = 0;
        private var _hasChanged:Boolean = false;

        /**
         * Adds a handler of a kind.
         *
         * @throws ArgumentError as Collision.onCollision does
         */
        public function add(kind:int, breed:String, otherBreed:String, callback:Function):void
        {
            require(breed, otherBreed, callback);
            requireParameters(breed, otherBreed, callback, kind);
            enter(new CollisionHandler(kind, breed, otherBreed, callback, _nextSerial));
            _nextSerial++;
            _hasChanged = true;
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
            var entry:AddedHandlers = addedFor(knownNumberOf(breed), knownNumberOf(otherBreed));
            var isRemoved:Boolean = entry != null && entry.remove(callback, wanted);
            _hasChanged ||= isRemoved;
            return isRemoved;
        }

        /** Removes all handlers. */
        public function clear():void
        {
            for each (var entry:AddedHandlers in _added)
            {
                entry.clear();
            }
            _hasChanged = true;
        }

        /**
         * Begins a frame: takes the handlers as they are now.
         *
         * @param agents the frame's agents
         */
        public function begin(agents:Vector.<Agent>):void
        {
            if (!_hasChanged)
            {
                return;
            }
            _hasChanged = false;
            var all:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var entry:AddedHandlers in _added)
            {
                entry.appendTo(all, _nextSerial);
            }
            _added.length = _called.length = 0;
            _addedIndices.clear();
            _calledIndices.clear();
            interests = new BreedInterests();
            kinds = contactKinds = 0;
            var newNames:Vector.<String> = new Vector.<String>();
            for each (var handler:CollisionHandler in all)
            {
                enter(handler);
                interests.addNumbers(handler.breedNumber, handler.otherNumber);
                kinds |= 1 << handler.kind;
                contactKinds |= handler.needsContact ? 1 << handler.kind : 0;
                if (handler.serial >= _endSerial)
                {
                    newNames.push(Breeds.NAMES.nameOf(handler.breedNumber), Breeds.NAMES.nameOf(handler.otherNumber));
                }
            }
            warnOfBreeds(newNames, agents);
            _endSerial = _nextSerial;
        }

        /**
         * Returns what the frame calls for two breeds. It is empty if the two have no handlers.
         *
         * @param breed the number of the first agent's breed
         * @param otherBreed the number of the second agent's breed
         */
        public function handlersOf(breed:int, otherBreed:int):PairHandlers
        {
            var index:int = _calledIndices.find(breed, otherBreed);
            if (index < 0)
            {
                index = _called.push(new PairHandlers(between(breed, otherBreed), between(otherBreed, breed))) - 1;
                _calledIndices.set (breed, otherBreed, index);
            }
            return _called[index];
        }

        /** Returns the handlers of the breeds that the agents of a found pair have now. */
        public function handlersOfPair(pairs:FoundPairs, pair:int):PairHandlers
        {
            return handlersOf(pairs.firstOf(pair).breedNumber, pairs.secondOf(pair).breedNumber);
        }

        /** The breeds that handlers of the last frame name, and that none of these agents has. */
        public function breedsWithout(agents:Vector.<Agent>):Vector.<String>
        {
            var isThere:Vector.<Boolean> = new Vector.<Boolean>(Breeds.NAMES.count);
            for each (var agent:Agent in agents)
            {
                isThere[agent.breedNumber] = true;
            }
            var missing:Vector.<String> = new Vector.<String>();
            for (var number:int = Breeds.ANY + 1; number < Breeds.NAMES.count; number++)
            {
                if (!isThere[number] && interests.representativeOf(number) == number)
                {
                    missing.push(Breeds.NAMES.nameOf(number));
                }
            }
            return missing;
        }

        private function enter(handler:CollisionHandler):void
        {
            var entry:AddedHandlers = addedFor(handler.breedNumber, handler.otherNumber);
            if (entry == null)
            {
                entry = new AddedHandlers();
                _addedIndices.set (handler.breedNumber, handler.otherNumber, _added.push(entry) - 1);
            }
            entry.add(handler);
        }

        // The handlers that the frame calls if an agent of the first breed, as the collider, meets one of the second.
        private function between(breed:int, otherBreed:int):Vector.<CollisionHandler>
        {
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var number:int in breed > Breeds.ANY ? [breed, Breeds.ANY] : [breed])
            {
                for each (var other:int in otherBreed > Breeds.ANY ? [otherBreed, Breeds.ANY] : [otherBreed])
                {
                    var entry:AddedHandlers = addedFor(number, other);
                    if (entry != null)
                    {
                        entry.appendTo(found, _endSerial);
                    }
                }
            }
            return found;
        }

        // The handlers that were added for two breeds, by their numbers; null if there are none.
        private function addedFor(breed:int, otherBreed:int):AddedHandlers
        {
            var index:int = _addedIndices.find(breed, otherBreed);
            return index < 0 ? null : _added[index];
        }

        // The number of a breed's name, or of ANY_BREED; -1 if it has none yet.
        private static function knownNumberOf(breed:String):int
        {
            return breed == BreedInterests.ANY_BREED ? Breeds.ANY : Breeds.NAMES.knownNumberOf(breed);
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
