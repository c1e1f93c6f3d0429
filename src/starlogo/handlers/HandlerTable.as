package starlogo.handlers
{
    import starlogo.engine;
    import starlogo.search.BreedInterests;

    use namespace engine;

    /**
     * Finds the handlers of two breeds by the breeds' numbers. Handlers can be added. When one is removed, the Collision makes a new table.
     *
     * @private
     */
    public final class HandlerTable
    {
        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests = new BreedInterests();

        /** True if no handler takes contacts and no handler is for starts or ends. */
        public var isPlain:Boolean = true;

        /** Whether any handler for the ground or the edges of the world takes contacts. */
        public var takesFixtureContacts:Boolean = false;

        // How many handlers were read. By the number of the collider's breed: its handlers, in the order in which they were added.
        private var _count:int = 0;
        private var _handlers:Vector.<Vector.<CollisionHandler>> = new Vector.<Vector.<CollisionHandler>>();

        // By the numbers of the two breeds, from -1 on: what was found so far.
        private var _pairs:Vector.<Vector.<PairHandlers>> = null;

        /** Begins without handlers. */
        public function HandlerTable()
        {
        }

        /** Reads the handlers that were added to a list after the last call. */
        public function read(handlers:Vector.<CollisionHandler>):void
        {
            for (; _count < handlers.length; _count++)
            {
                add(handlers[_count]);
            }
            _pairs = new Vector.<Vector.<PairHandlers>>(interests.breedCount + 1, true);
        }

        private function add(handler:CollisionHandler):void
        {
            interests.add(handler.breed, handler.otherBreed);
            handler.order = handler.kind * int.MAX_VALUE + _count;
            handler.breedNumber = interests.numberOf(handler.breed);
            handler.otherNumber = interests.numberOf(handler.otherBreed);
            while (_handlers.length < interests.breedCount)
            {
                _handlers.push(new Vector.<CollisionHandler>());
            }
            _handlers[handler.breedNumber].push(handler);
            isPlain = isPlain && handler.kind == CollisionHandler.COLLISION && !handler.takesContact;
            takesFixtureContacts ||= handler.takesContact && !(interests.isOfAgents(handler.breedNumber) && interests.isOfAgents(handler.otherNumber));
        }

        /**
         * Returns the handlers of two breeds. They are empty if the two have no handlers.
         *
         * @param breedNumber the number of the first agent's breed
         * @param otherNumber the number of the second agent's breed
         */
        public function handlersOf(breedNumber:int, otherNumber:int):PairHandlers
        {
            var numbers:Vector.<int> = interests.numbers;
            if (breedNumber >= numbers.length || otherNumber >= numbers.length)
            {
                // a handler may have made a new breed
                interests.follow();
            }
            var breed:int = numbers[breedNumber];
            var otherBreed:int = numbers[otherNumber];
            var ofBreed:Vector.<PairHandlers> = _pairs[breed + 1];
            if (ofBreed == null)
            {
                ofBreed = _pairs[breed + 1] = new Vector.<PairHandlers>(_pairs.length, true);
            }
            var found:PairHandlers = ofBreed[otherBreed + 1];
            if (found == null)
            {
                found = ofBreed[otherBreed + 1] = make(breed, otherBreed);
            }
            return found;
        }

        private function make(breed:int, otherBreed:int):PairHandlers
        {
            var forward:Vector.<CollisionHandler> = between(breed, otherBreed);
            var back:Vector.<CollisionHandler> = between(otherBreed, breed);
            var result:PairHandlers = new PairHandlers(forward, back, CollisionHandler.COLLISION, CollisionHandler.COLLISION);
            var ofStart:PairHandlers = new PairHandlers(forward, back, CollisionHandler.START, CollisionHandler.COLLISION);
            var ofEnd:PairHandlers = new PairHandlers(forward, back, CollisionHandler.END, CollisionHandler.END);
            if (ofStart.handlers.length > result.handlers.length || ofEnd.handlers.length > 0)
            {
                result.ofStart = ofStart;
                result.ofEnd = ofEnd;
                result.takesContacts = ofStart.takesContacts;
            }
            return result;
        }

        // The handlers whose collider is of the first breed and whose collidee is of the second, in the order of their calls.
        private function between(breed:int, otherBreed:int):Vector.<CollisionHandler>
        {
            var found:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
            var others:int = interests.numberOf(BreedInterests.ANY_BREED);
            var otherAny:int = interests.isOfAgents(otherBreed) ? others : -1;
            for each (var number:int in interests.isOfAgents(breed) && others >= 0 && others != breed ? [breed, others] : [breed])
            {
                for (var i:int = 0; number >= 0 && i < _handlers[number].length; i++)
                {
                    var handler:CollisionHandler = _handlers[number][i];
                    if (handler.otherNumber == otherBreed || handler.otherNumber == otherAny)
                    {
                        found.push(handler);
                    }
                }
            }
            return found.sort(function(a:CollisionHandler, b:CollisionHandler):Number
                {
                    return a.order - b.order;
                });
        }
    }
}
