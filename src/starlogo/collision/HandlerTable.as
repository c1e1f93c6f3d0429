package starlogo.collision
{
    import starlogo.engine;

    use namespace engine;

    /** The handlers of each pair of breeds, by the breeds' numbers. Does not change: new handlers make a new table. */
    internal final class HandlerTable
    {
        /** The pairs of breeds that have handlers. */
        public var interests:BreedInterests = new BreedInterests();

        private var _handlers:Vector.<Vector.<CollisionHandler>>;

        /**
         * @param handlers in the order in which they are to be called
         */
        public function HandlerTable(handlers:Vector.<CollisionHandler>)
        {
            for each (var handler:CollisionHandler in handlers)
            {
                interests.add(handler.breed, handler.otherBreed);
            }
            _handlers = new Vector.<Vector.<CollisionHandler>>(interests.breedCount * interests.breedCount, true);
            for each (handler in handlers)
            {
                enter(handler, interests.indicesOf(handler.breed), interests.indicesOf(handler.otherBreed));
            }
        }

        /** The handlers of colliders of one breed that meet collidees of another, or null. */
        public function handlersOf(breed:int, otherBreed:int):Vector.<CollisionHandler>
        {
            return _handlers[breed * interests.breedCount + otherBreed];
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
