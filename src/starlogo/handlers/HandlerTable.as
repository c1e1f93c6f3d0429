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
        private static const LEAST_SLOTS:int = 64;

        // The factor of the first breed in the hash of a pair: an odd number, so that pairs of neighbouring numbers have slots of their own.
        private static const SPREAD:int = 40503;

        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests = new BreedInterests();

        /** The kinds of the handlers: a bit for each kind, 1 << kind. */
        public var kinds:int = 0;

        /** The kinds of the handlers that take the contact of a touch. */
        public var contactKinds:int = 0;

        // The pairs of breeds that have handlers, or that have met. A hash table with open addressing finds them; it is at most half full. A pair
        // of an older revision gets its handlers anew.
        private var _pairs:Vector.<PairHandlers>;
        private var _slots:Vector.<PairHandlers>;
        private var _revision:int = 0;

        // The handlers that came after the last frame began, and whether one was removed since then. How many were ever added, and how many of
        // them the frame knows.
        private var _added:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
        private var _isOneRemoved:Boolean = false;
        private var _count:int = 0;
        private var _knownCount:int = 0;

        public function HandlerTable()
        {
            fill(new Vector.<PairHandlers>(), LEAST_SLOTS);
        }

        /**
         * Adds a handler of a kind.
         *
         * @throws ArgumentError as Collision.onCollision does
         */
        public function add(kind:int, breed:String, otherBreed:String, handler:Function):void
        {
            require(breed, otherBreed, handler);
            enter(new CollisionHandler(kind, breed, otherBreed, handler, _count));
            _count++;
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
            var pair:PairHandlers = _slots[slotOf(BreedInterests.numberOf(breed), BreedInterests.numberOf(otherBreed))];
            var removed:CollisionHandler = pair == null ? null : pair.find(handler, kind == null ? PairHandlers.ANY_KIND : wanted);
            if (removed == null)
            {
                return false;
            }
            _isOneRemoved = true;
            pair.remove(removed, _knownCount);
            return true;
        }

        /** Removes all handlers. */
        public function clear():void
        {
            for each (var pair:PairHandlers in _pairs)
            {
                pair.removeAll(_knownCount);
            }
            _isOneRemoved = true;
        }

        /** Begins a frame: takes the handlers as they are now. */
        public function begin():void
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
                kinds |= 1 << handler.kind;
                contactKinds |= handler.takesContact && handler.kind != CollisionHandler.END ? 1 << handler.kind : 0;
            }
            _added.length = 0;
            _knownCount = _count;
            _revision++;
        }

        /**
         * Returns the handlers of two breeds. They are empty if the two have no handlers.
         *
         * @param breed the number of the first agent's breed
         * @param otherBreed the number of the second agent's breed
         */
        public function handlersOf(breed:int, otherBreed:int):PairHandlers
        {
            // slotOf() as a loop here, because one more call for each pair takes a tenth of a frame in Adobe's VM
            var slots:Vector.<PairHandlers> = _slots;
            var last:int = slots.length - 1;
            var slot:int = breed * SPREAD + otherBreed & last;
            var found:PairHandlers = slots[slot];
            while (found != null)
            {
                if (found.breed == breed && found.otherBreed == otherBreed)
                {
                    return found.revision == _revision ? found : find(found);
                }
                slot = slot + 1 & last;
                found = slots[slot];
            }
            return find(pairOf(breed, otherBreed));
        }

        // Finds the handlers of a pair, as they were when the frame began.
        private function find(pair:PairHandlers):PairHandlers
        {
            pair.setHandlers(between(pair.breed, pair.otherBreed), between(pair.otherBreed, pair.breed));
            pair.revision = _revision;
            return pair;
        }

        // The handlers whose collider is of the first breed and whose collidee is of the second, in the order of their calls.
        private function between(breed:int, otherBreed:int):Vector.<CollisionHandler>
        {
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            for each (var number:int in breed > Breeds.ANY ? [breed, Breeds.ANY] : [breed])
            {
                for each (var other:int in otherBreed > Breeds.ANY ? [otherBreed, Breeds.ANY] : [otherBreed])
                {
                    var pair:PairHandlers = _slots[slotOf(number, other)];
                    for each (var handler:CollisionHandler in pair == null ? null : pair.added)
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

        private function enter(handler:CollisionHandler):void
        {
            _added.push(handler);
            pairOf(handler.breedNumber, handler.otherNumber).added.push(handler);
        }

        // Begins an empty table with the handlers that are not removed.
        private function startAgain():void
        {
            var pairs:Vector.<PairHandlers> = _pairs;
            fill(new Vector.<PairHandlers>(), LEAST_SLOTS);
            interests = new BreedInterests();
            kinds = contactKinds = 0;
            _isOneRemoved = false;
            _added.length = 0;
            for each (var pair:PairHandlers in pairs)
            {
                for each (var handler:CollisionHandler in pair.added)
                {
                    if (!handler.isRemoved)
                    {
                        enter(handler);
                    }
                }
            }
        }

        // A pair in the table. A new pair has no handlers yet.
        private function pairOf(breed:int, otherBreed:int):PairHandlers
        {
            var slot:int = slotOf(breed, otherBreed);
            if (_slots[slot] != null)
            {
                return _slots[slot];
            }
            var pair:PairHandlers = _slots[slot] = new PairHandlers(breed, otherBreed);
            _pairs.push(pair);
            if (2 * _pairs.length > _slots.length)
            {
                fill(_pairs, 2 * _slots.length);
            }
            return pair;
        }

        private function fill(pairs:Vector.<PairHandlers>, slotCount:int):void
        {
            _pairs = pairs;
            _slots = new Vector.<PairHandlers>(slotCount, true);
            for each (var pair:PairHandlers in pairs)
            {
                _slots[slotOf(pair.breed, pair.otherBreed)] = pair;
            }
        }

        // The slot of a pair, or the free slot where it belongs.
        private function slotOf(breed:int, otherBreed:int):int
        {
            var last:int = _slots.length - 1;
            var slot:int = breed * SPREAD + otherBreed & last;
            while (_slots[slot] != null && (_slots[slot].breed != breed || _slots[slot].otherBreed != otherBreed))
            {
                slot = slot + 1 & last;
            }
            return slot;
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
