package starlogo.collision
{
    import starlogo.handlers.CollisionHandler;
    import starlogo.handlers.HandlerTable;
    import starlogo.search.textOf;

    /** The handlers of a Collision, in the order in which they were added, and the table of them, which a frame reads. */
    internal final class HandlerList
    {
        private var _handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();

        // Null after a handler was removed; stale after one was added.
        private var _table:HandlerTable = null;
        private var _isStale:Boolean = true;

        /** Begins without handlers. */
        public function HandlerList()
        {
        }

        /** The table of the handlers as they are now. Changes while a frame uses it count from the next call on. */
        public function get table():HandlerTable
        {
            if (_table == null || _isStale)
            {
                _table ||= new HandlerTable();
                _table.read(_handlers);
                _isStale = false;
            }
            return _table;
        }

        /**
         * Adds a handler of a kind.
         *
         * @throws ArgumentError as Collision.onCollision does
         */
        public function add(kind:int, breed:String, otherBreed:String, handler:Function):void
        {
            require(breed, otherBreed, handler);
            _handlers.push(new CollisionHandler(kind, breed, otherBreed, handler));
            _isStale = true;
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
                    _table = null;
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
            _table = null;
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
