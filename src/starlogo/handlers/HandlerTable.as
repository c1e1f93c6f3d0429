package starlogo.handlers
{
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.search.BreedInterests;
    import starlogo.search.textOf;

    use namespace engine;

    /**
     * The handlers of a Collision. It finds the handlers of two breeds by the breeds' numbers. Changes while a frame runs count from the next
     * frame on, except that a removed handler is not called any more.
     *
     * @private
     */
    public final class HandlerTable
    {
        private static const NONE:PairHandlers = new PairHandlers(new <CollisionHandler>[], new <CollisionHandler>[]);

        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests;

        /** True if no handler takes contacts and no handler is for starts or ends. */
        public var isPlain:Boolean;

        // All handlers, in the order in which they were added. How many of them the table has; -1 after one was removed.
        private var _handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
        private var _count:int = -1;

        // By the number of the collider's breed: its handlers.
        private var _ofBreeds:Vector.<Vector.<CollisionHandler>>;

        // By the numbers of the two breeds: what was found since the last handler was added. Breeds that no handler names share what belongs
        // to OTHERS.
        private var _pairs:Vector.<Vector.<PairHandlers>>;

        /**
         * Adds a handler of a kind.
         *
         * @throws ArgumentError as Collision.onCollision does
         */
        public function add(kind:int, breed:String, otherBreed:String, handler:Function):void
        {
            require(breed, otherBreed, handler);
            _handlers.push(new CollisionHandler(kind, breed, otherBreed, handler));
        }

        /** See Collision.removeHandler. */
        public function remove(breed:String, otherBreed:String, handler:Function, kind:String):Boolean
        {
            require(breed, otherBreed, handler);
            var wanted:int = CollisionHandler.KINDS.indexOf(kind);
            if (kind != null && wanted < 0)
            {
                throw new ArgumentError("kind must be \"collision\", \"start\", \"end\" or null, not \"" + kind + "\"");
            }
            for (var i:int = 0; i < _handlers.length; i++)
            {
                var added:CollisionHandler = _handlers[i];
                if (added.breed == breed && added.otherBreed == otherBreed && added.handler == handler && (kind == null || added.kind == wanted))
                {
                    added.isRemoved = true;
                    _handlers.splice(i, 1);
                    _count = -1;
                    return true;
                }
            }
            return false;
        }

        /** Removes all handlers. */
        public function clear():void
        {
            for (var i:int = 0; i < _handlers.length; i++)
            {
                _handlers[i].isRemoved = true;
            }
            _handlers.length = 0;
            _count = -1;
        }

        /** Begins a frame: takes the handlers as they are now. */
        public function begin():void
        {
            if (_count == _handlers.length && _pairs.length == Breeds.count + 1)
            {
                return;
            }
            if (_count < 0)
            {
                _count = 0;
                isPlain = true;
                interests = new BreedInterests();
                _ofBreeds = new Vector.<Vector.<CollisionHandler>>();
            }
            for (; _count < _handlers.length; _count++)
            {
                enter(_handlers[_count]);
            }
            _pairs = new Vector.<Vector.<PairHandlers>>(Breeds.count + 1, true);
        }

        /**
         * Returns the handlers of two breeds. They are empty if the two have no handlers.
         *
         * @param breed the number of the first agent's breed
         * @param otherBreed the number of the second agent's breed
         */
        public function handlersOf(breed:int, otherBreed:int):PairHandlers
        {
            var length:int = _pairs.length - 1;
            if (breed < length && otherBreed < length)
            {
                var ofBreed:Vector.<PairHandlers> = _pairs[int(breed + 1)];
                if (ofBreed != null)
                {
                    var found:PairHandlers = ofBreed[int(otherBreed + 1)];
                    if (found != null)
                    {
                        return found;
                    }
                }
            }
            // a pair for the first time, or a handler has made a new breed
            return find(breed, otherBreed);
        }

        private function find(breed:int, otherBreed:int):PairHandlers
        {
            var index:int = interests.indexOfNumber(breed);
            var otherIndex:int = interests.indexOfNumber(otherBreed);
            if (!interests.includes(index, otherIndex))
            {
                return NONE;
            }
            if (_pairs[index] == null)
            {
                _pairs[index] = new Vector.<PairHandlers>(_pairs.length, true);
            }
            var ofBreed:Vector.<PairHandlers> = _pairs[index];
            if (ofBreed[otherIndex] == null)
            {
                ofBreed[otherIndex] = new PairHandlers(between(index, otherIndex), between(otherIndex, index));
            }
            if (breed + 1 < _pairs.length && otherBreed + 1 < _pairs.length)
            {
                _pairs[breed + 1] = ofBreed;
                ofBreed[otherBreed + 1] = ofBreed[otherIndex];
            }
            return ofBreed[otherIndex];
        }

        private function enter(handler:CollisionHandler):void
        {
            interests.add(handler.breed, handler.otherBreed);
            handler.order = handler.kind * int.MAX_VALUE + _count;
            isPlain = isPlain && handler.kind == CollisionHandler.COLLISION && !handler.takesContact;
            if (_ofBreeds.length < interests.breedCount)
            {
                _ofBreeds.length = interests.breedCount;
            }
            if (_ofBreeds[handler.breedNumber] == null)
            {
                _ofBreeds[handler.breedNumber] = new Vector.<CollisionHandler>();
            }
            _ofBreeds[handler.breedNumber].push(handler);
        }

        // The handlers whose collider is of the first breed and whose collidee is of the second, in the order of their calls.
        private function between(breed:int, otherBreed:int):Vector.<CollisionHandler>
        {
            var isOfAgents:Boolean = BreedInterests.isOfAgents(otherBreed);
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var number:int in breed != BreedInterests.OTHERS && BreedInterests.isOfAgents(breed) ? [breed, BreedInterests.OTHERS] : [breed])
            {
                var handlers:Vector.<CollisionHandler> = _ofBreeds[number];
                for (var i:int = 0; handlers != null && i < handlers.length; i++)
                {
                    var other:int = handlers[i].otherNumber;
                    if (other == otherBreed || isOfAgents && other == BreedInterests.OTHERS)
                    {
                        found.push(handlers[i]);
                    }
                }
            }
            return found.sort(function(a:CollisionHandler, b:CollisionHandler):Number
                {
                    return a.order - b.order;
                });
        }

        private static function require(breed:String, otherBreed:String, handler:Function):void
        {
            if (!breed || !otherBreed || handler == null)
            {
                throw new ArgumentError("two breeds and a handler are needed, not \"" + breed + "\", \"" + otherBreed + "\" and " + textOf(handler));
            }
        }
    }
}
