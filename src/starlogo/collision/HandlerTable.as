package starlogo.collision
{
    /** The handlers of each pair of breeds, by the breeds' numbers. Does not change: new handlers make a new table. */
    internal final class HandlerTable
    {
        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests = new BreedInterests();

        private var _handlers:Vector.<Vector.<Function>>;

        /**
         * @param handlers in the order in which they are to be called
         */
        public function HandlerTable(handlers:Vector.<CollisionHandler>)
        {
            for each (var handler:CollisionHandler in handlers)
            {
                interests.add(handler.breed, handler.otherBreed);
            }
            _handlers = new Vector.<Vector.<Function>>(interests.breedCount * interests.breedCount, true);
            for each (handler in handlers)
            {
                var place:int = interests.indexOf(handler.breed) * interests.breedCount + interests.indexOf(handler.otherBreed);
                _handlers[place] ||= new Vector.<Function>();
                _handlers[place].push(handler.handler);
            }
        }

        /** The handlers of colliders of one breed that meet collidees of another, or null. */
        public function handlersOf(breed:int, otherBreed:int):Vector.<Function>
        {
            return _handlers[breed * interests.breedCount + otherBreed];
        }
    }
}
