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

        private static const LEAST_SLOTS:int = 64;

        // The factor of the first breed in the hash of a pair: an odd number, so that pairs of neighbouring numbers have slots of their own.
        private static const SPREAD:int = 40503;

        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests;

        /** True if no handler takes contacts and no handler is for starts or ends. */
        public var isPlain:Boolean;

        // All handlers, in the order in which they were added. How many of them the table has; -1 after one was removed.
        private var _handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
        private var _count:int = -1;

        // By the number of the collider's breed: its handlers.
        private var _ofBreeds:Vector.<Vector.<CollisionHandler>>;

        // The handlers of the pairs of breeds that were asked for since the last handler was added: a hash table with open addressing, at most half
        // full. Its memory is in proportion to the pairs that meet.
        private var _pairs:Vector.<PairHandlers>;
        private var _pairCount:int = 0;

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
            var number:int = BreedInterests.numberOf(breed);
            var otherNumber:int = BreedInterests.numberOf(otherBreed);
            for (var i:int = 0; i < _handlers.length; i++)
            {
                var added:CollisionHandler = _handlers[i];
                if (added.breedNumber == number && added.otherNumber == otherNumber && added.handler == handler && (kind == null || added.kind == wanted))
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
            if (_count == _handlers.length)
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
            _pairs = new Vector.<PairHandlers>(LEAST_SLOTS, true);
            _pairCount = 0;
        }

        /**
         * Returns the handlers of two breeds. They are empty if the two have no handlers.
         *
         * @param breed the number of the first agent's breed
         * @param otherBreed the number of the second agent's breed
         */
        public function handlersOf(breed:int, otherBreed:int):PairHandlers
        {
            var pairs:Vector.<PairHandlers> = _pairs;
            var last:int = pairs.length - 1;
            var slot:int = breed * SPREAD + otherBreed & last;
            var found:PairHandlers = pairs[slot];
            while (found != null)
            {
                if (found.breed == breed && found.otherBreed == otherBreed)
                {
                    return found;
                }
                slot = slot + 1 & last;
                found = pairs[slot];
            }
            return find(breed, otherBreed, slot);
        }

        // Finds the handlers of a pair that is not in the table. Puts them into a free slot.
        private function find(breed:int, otherBreed:int, slot:int):PairHandlers
        {
            var index:int = interests.indexOfNumber(breed);
            var otherIndex:int = interests.indexOfNumber(otherBreed);
            if (!interests.includes(index, otherIndex))
            {
                return NONE;
            }
            if (2 * (_pairCount + 1) > _pairs.length)
            {
                // a larger table begins empty: pairs that are asked for again are found again
                _pairs = new Vector.<PairHandlers>(2 * _pairs.length, true);
                _pairCount = 0;
                slot = breed * SPREAD + otherBreed & _pairs.length - 1;
            }
            var found:PairHandlers = new PairHandlers(between(index, otherIndex), between(otherIndex, index));
            found.breed = breed;
            found.otherBreed = otherBreed;
            _pairs[slot] = found;
            _pairCount++;
            return found;
        }

        private function enter(handler:CollisionHandler):void
        {
            interests.addNumbers(handler.breedNumber, handler.otherNumber);
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
            var isOfAgents:Boolean = !Breeds.isReserved(otherBreed);
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var number:int in breed > Breeds.ANY ? [breed, Breeds.ANY] : [breed])
            {
                var handlers:Vector.<CollisionHandler> = _ofBreeds[number];
                for (var i:int = 0; handlers != null && i < handlers.length; i++)
                {
                    var other:int = handlers[i].otherNumber;
                    if (other == otherBreed || isOfAgents && other == Breeds.ANY)
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
