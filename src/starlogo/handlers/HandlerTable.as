package starlogo.handlers
{
    import starlogo.engine;
    import starlogo.search.BreedInterests;

    use namespace engine;

    /**
     * Finds the handlers of two breeds by the breeds' numbers. A table does not change. When handlers are added or removed, the Collision makes a
     * new one.
     *
     * @private
     */
    public final class HandlerTable
    {
        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests = new BreedInterests();

        /** True if no handler takes contacts and no handler is for starts or ends. */
        public var isPlain:Boolean = true;

        // In the order of their kinds; handlers of one kind in the order in which they were added.
        private var _handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();

        // By the numbers of breeds, from -1 on.
        private var _pairs:Vector.<PairHandlers>;
        private var _rowLength:int;

        /**
         * @param handlers in the order in which they were added
         */
        public function HandlerTable(handlers:Vector.<CollisionHandler>)
        {
            for (var kind:int = CollisionHandler.START; kind <= CollisionHandler.END; kind++)
            {
                for each (var handler:CollisionHandler in handlers)
                {
                    if (handler.kind == kind)
                    {
                        _handlers.push(handler);
                        interests.add(handler.breed, handler.otherBreed);
                        isPlain = isPlain && kind == CollisionHandler.COLLISION && !handler.mayTakeContact;
                    }
                }
            }
            _rowLength = interests.breedCount + 1;
            _pairs = new Vector.<PairHandlers>(_rowLength * _rowLength, true);
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
            var index:int = (breed + 1) * _rowLength + otherBreed + 1;
            return _pairs[index] || (_pairs[index] = make(breed, otherBreed));
        }

        private function make(breed:int, otherBreed:int):PairHandlers
        {
            var result:PairHandlers = ofKinds(CollisionHandler.COLLISION, CollisionHandler.COLLISION, breed, otherBreed);
            var ofStart:PairHandlers = ofKinds(CollisionHandler.START, CollisionHandler.COLLISION, breed, otherBreed);
            var ofEnd:PairHandlers = ofKinds(CollisionHandler.END, CollisionHandler.END, breed, otherBreed);
            if (ofStart.handlers.length > result.handlers.length || ofEnd.handlers.length > 0)
            {
                result.ofStart = ofStart;
                result.ofEnd = ofEnd;
                result.takesContacts = ofStart.takesContacts;
            }
            return result;
        }

        private function ofKinds(first:int, last:int, breed:int, otherBreed:int):PairHandlers
        {
            return new PairHandlers(between(first, last, breed, otherBreed), between(first, last, otherBreed, breed));
        }

        private function between(first:int, last:int, breed:int, otherBreed:int):Vector.<CollisionHandler>
        {
            return _handlers.filter(function(handler:CollisionHandler, ...ignored):Boolean
                {
                    return handler.kind >= first && handler.kind <= last && interests.matches(handler.breed, breed)
                        && interests.matches(handler.otherBreed, otherBreed);
                });
        }
    }
}
