package starlogo.collision
{
    import starlogo.engine;

    use namespace engine;

    /** The handlers of each pair of breeds, by the breeds' numbers. Does not change: new handlers make a new table. */
    internal final class HandlerTable
    {
        private static const NONE:PairHandlers = new PairHandlers(null, null);

        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests = new BreedInterests();

        /** Whether somebody asks when touches begin or end. */
        public var tracks:Boolean = false;

        /** Whether somebody asks for contacts. */
        public var takesContacts:Boolean = false;

        private var _handlers:Vector.<Vector.<CollisionHandler>>;
        private var _pairs:Vector.<PairHandlers>;

        /**
         * @param handlers in the order in which they are to be called
         */
        public function HandlerTable(handlers:Vector.<CollisionHandler>)
        {
            for each (var handler:CollisionHandler in handlers)
            {
                interests.add(handler.breed, handler.otherBreed);
                tracks = tracks || handler.kind != CollisionHandler.COLLISION;
                takesContacts = takesContacts || handler.takesContact;
            }
            var count:int = interests.breedCount;
            _handlers = new Vector.<Vector.<CollisionHandler>>(count * count, true);
            _pairs = new Vector.<PairHandlers>(count * count, true);
            for each (handler in handlers)
            {
                enter(handler, interests.indicesOf(handler.breed), interests.indicesOf(handler.otherBreed));
            }
        }

        /** The handlers of two agents of these breeds that collide; none where a breed is negative, one that nobody asks about. */
        public function handlersOf(breed:int, otherBreed:int):PairHandlers
        {
            if (breed < 0 || otherBreed < 0)
            {
                return NONE;
            }
            var count:int = interests.breedCount;
            var place:int = breed * count + otherBreed;
            if (_pairs[place] == null)
            {
                _pairs[place] = new PairHandlers(_handlers[place], _handlers[otherBreed * count + breed]);
            }
            return _pairs[place];
        }

        private function enter(handler:CollisionHandler, breeds:Vector.<int>, otherBreeds:Vector.<int>):void
        {
            for each (var breed:int in breeds)
            {
                for each (var otherBreed:int in otherBreeds)
                {
                    var place:int = breed * interests.breedCount + otherBreed;
                    _handlers[place] ||= new Vector.<CollisionHandler>();
                    _handlers[place].push(handler);
                }
            }
        }
    }
}
