package starlogo.handlers
{
    import starlogo.search.BreedPairs;

    /**
     * The handlers of each pair of breeds, by the breeds' numbers. Does not change: new handlers make a new table.
     *
     * @private
     */
    public final class HandlerTable
    {
        /** The pairs of breeds that have handlers. */
        public var breedPairs:BreedPairs;

        /** Whether no handler asks for contacts, or when touches begin or end. */
        public var isPlain:Boolean = true;

        private var _handlers:Vector.<CollisionHandler>;

        // By the numbers of breeds, from -1 on.
        private var _pairs:Vector.<PairHandlers>;
        private var _rowLength:int;

        /**
         * @param handlers in the order in which they are to be called
         * @param breedPairs takes the pairs of breeds that have handlers; it has none yet
         */
        public function HandlerTable(handlers:Vector.<CollisionHandler>, breedPairs:BreedPairs)
        {
            this.breedPairs = breedPairs;
            // others may be added before a pair of breeds is asked about
            _handlers = handlers.concat();
            for each (var handler:CollisionHandler in _handlers)
            {
                breedPairs.add(handler.breed, handler.otherBreed);
                isPlain = isPlain && handler.kind == CollisionHandler.COLLISION && !handler.takesContact;
            }
            _rowLength = breedPairs.breedCount + 1;
            _pairs = new Vector.<PairHandlers>(_rowLength * _rowLength, true);
        }

        /** The handlers of two agents of these breeds that collide; none where a breed is -1. */
        public function handlersOf(breed:int, otherBreed:int):PairHandlers
        {
            var place:int = (breed + 1) * _rowLength + otherBreed + 1;
            if (_pairs[place] == null)
            {
                _pairs[place] = make(breed, otherBreed);
            }
            return _pairs[place];
        }

        private function make(breed:int, otherBreed:int):PairHandlers
        {
            var forward:Vector.<CollisionHandler> = between(breed, otherBreed, CollisionHandler.COLLISION);
            var back:Vector.<CollisionHandler> = between(otherBreed, breed, CollisionHandler.COLLISION);
            var result:PairHandlers = new PairHandlers(forward, back);
            forward = between(breed, otherBreed, CollisionHandler.START).concat(forward);
            back = between(otherBreed, breed, CollisionHandler.START).concat(back);
            var ofStart:PairHandlers = new PairHandlers(forward, back);
            forward = between(breed, otherBreed, CollisionHandler.END);
            back = between(otherBreed, breed, CollisionHandler.END);
            if (ofStart.handlers.length > result.handlers.length || forward.length > 0 || back.length > 0)
            {
                result.ofStart = ofStart;
                result.ofEnd = new PairHandlers(forward, back);
                result.takesContacts = ofStart.takesContacts;
            }
            return result;
        }

        private function between(breed:int, otherBreed:int, kind:int):Vector.<CollisionHandler>
        {
            return _handlers.filter(function(handler:CollisionHandler, ...ignored):Boolean
                {
                    return handler.kind == kind && standsFor(handler.breed, breed) && standsFor(handler.otherBreed, otherBreed);
                });
        }

        private function standsFor(name:String, breed:int):Boolean
        {
            return name == BreedPairs.ANY_BREED || breedPairs.numberOf(name) == breed;
        }
    }
}
