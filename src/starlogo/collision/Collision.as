package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.utils.getTimer;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * The collisions of a game: once a frame it finds the pairs of agents that have collided and calls the handlers that
     * care, as the client's block "on collision with" does (thesis §3.7, §6.1).
     *
     * <p>A frame's pairs are all known before the first handler runs. A handler may do anything to the game. What it
     * moves or adds counts from the next frame on; an agent that it takes out of the list takes part in no further call
     * of this one. When a handler throws, the others are called all the same; update then throws the first error.</p>
     *
     * <p>Of a pair, the handlers of the agent that is first in the list run before those of the other, each in the order
     * in which they were added.</p>
     */
    public class Collision
    {
        private var _collisionSystem:CollisionSystem;
        private var _statistics:CollisionStatistics = new CollisionStatistics();
        private var _handlers:Vector.<CollisionHandler> = new Vector.<CollisionHandler>();
        private var _table:HandlerTable = new HandlerTable(new Vector.<CollisionHandler>());
        private var _tableIsStale:Boolean = false;
        private var _isUpdating:Boolean = false;
        private var _pairs:Vector.<Agent> = new Vector.<Agent>();

        // The frame under way: the next call, by its pair, its direction and its handler; what was called, and thrown.
        private var _pair:int;
        private var _direction:int;
        private var _handler:int;
        private var _calls:int;
        private var _listLength:int;
        private var _firstError:Error;

        /**
         * Collisions without handlers.
         *
         * @param collisionSystem decides what collides
         * @throws ArgumentError if it is null
         */
        public function Collision(collisionSystem:CollisionSystem)
        {
            this.collisionSystem = collisionSystem;
        }

        /** Decides what collides; may be exchanged between frames, and from a handler for the next frame. */
        public function get collisionSystem():CollisionSystem
        {
            return _collisionSystem;
        }

        public function set collisionSystem(value:CollisionSystem):void
        {
            if (value == null)
            {
                throw new ArgumentError("collisionSystem must not be null");
            }
            _collisionSystem = value;
        }

        /** What the last frame did; the next overwrites it. */
        public function get statistics():CollisionStatistics
        {
            return _statistics;
        }

        /**
         * Adds a handler: what the agents of a breed do when they collide with those of another.
         *
         * <p>Within one breed, either agent of a pair collides with the other: the handler is called twice, as
         * (a, b) and as (b, a). A handler that is added while the handlers run is called from the next frame on.</p>
         *
         * @param breed the breed of the collider, the agent whose handler it is
         * @param otherBreed the breed of the collidee, the agent that it meets
         * @param handler <code>function(collider:Agent, collidee:Agent):void</code>
         * @throws ArgumentError if one is null, or a breed has no name
         */
        public function onCollision(breed:String, otherBreed:String, handler:Function):void
        {
            if (!breed || !otherBreed || handler == null)
            {
                throw new ArgumentError("two breeds and a handler are needed, not \"" + breed + "\", \"" + otherBreed + "\" and " + handler);
            }
            _handlers.push(new CollisionHandler(breed, otherBreed, handler));
            _tableIsStale = true;
        }

        /**
         * Runs one frame: finds every pair that a handler cares about, then calls the handlers.
         *
         * @param agents the agents of the game; a handler may change the list
         * @throws ArgumentError if an agent is null or listed twice, or its model is not known; no handler has then run
         * @throws IllegalOperationError if called from a handler
         * @throws Error the first error that a handler threw, after all handlers have run
         */
        public function update(agents:Vector.<Agent>):void
        {
            if (_isUpdating)
            {
                throw new IllegalOperationError("update must not be called from a handler");
            }
            var start:int = getTimer();
            if (_tableIsStale)
            {
                _table = new HandlerTable(_handlers);
                _tableIsStale = false;
            }
            findPairs(agents);
            _firstError = null;
            _calls = 0;
            _isUpdating = true;
            try
            {
                callHandlers(agents);
            }
            finally
            {
                _isUpdating = false;
            }
            _statistics.handlerCalls = _calls;
            _statistics.frameMs = getTimer() - start;
            if (_firstError != null)
            {
                throw _firstError;
            }
        }

        private function findPairs(agents:Vector.<Agent>):void
        {
            var selective:SelectiveCollisionSystem = _collisionSystem as SelectiveCollisionSystem;
            if (selective != null)
            {
                selective.findCollisionsAmong(agents, _table.interests, _pairs);
                _statistics.copyFrom(selective.statistics);
                return;
            }
            var start:int = getTimer();
            _collisionSystem.findCollisions(agents, _pairs);
            _statistics.reset();
            _statistics.agents = agents.length;
            _statistics.collisions = _pairs.length >> 1;
            _statistics.findMs = getTimer() - start;
        }

        private function callHandlers(agents:Vector.<Agent>):void
        {
            rememberPlaces(agents);
            _pair = _direction = _handler = 0;
            while (_pair < _pairs.length)
            {
                var calls:int = _calls;
                try
                {
                    callTheRest(agents);
                }
                catch (error:Error)
                {
                    if (_calls == calls)
                    {
                        // not a handler's: it would come again
                        throw error;
                    }
                    _firstError ||= error;
                }
            }
        }

        // Calls handlers from where the fields say. They are one ahead when a handler runs: after one that throws it goes
        // on with the next.
        private function callTheRest(agents:Vector.<Agent>):void
        {
            var interests:BreedInterests = _table.interests;
            for (; _pair < _pairs.length; _pair += 2)
            {
                var a:Agent = _pairs[_pair];
                var b:Agent = _pairs[_pair + 1];
                var breedA:int = interests.breedIndexOf(a);
                var breedB:int = interests.breedIndexOf(b);
                if (breedA >= 0 && breedB >= 0)
                {
                    if (_direction == 0)
                    {
                        callThoseOf(_table.handlersOf(breedA, breedB), a, b, agents);
                        _direction = 1;
                        _handler = 0;
                    }
                    callThoseOf(_table.handlersOf(breedB, breedA), b, a, agents);
                }
                _direction = _handler = 0;
            }
        }

        private function callThoseOf(handlers:Vector.<Function>, collider:Agent, collidee:Agent, agents:Vector.<Agent>):void
        {
            if (handlers == null)
            {
                return;
            }
            var count:int = handlers.length;
            while (_handler < count)
            {
                // mostly both still are where they were; a slot is less than the length that the list had
                if (agents.length != _listLength || agents[collider.slot] !== collider || agents[collidee.slot] !== collidee)
                {
                    if (!isListed(collider, agents) || !isListed(collidee, agents))
                    {
                        return;
                    }
                }
                var handler:Function = handlers[_handler];
                _handler++;
                _calls++;
                handler(collider, collidee);
            }
        }

        private function rememberPlaces(agents:Vector.<Agent>):void
        {
            _listLength = agents.length;
            for (var i:int = 0; i < _listLength; i++)
            {
                agents[i].slot = i;
            }
        }

        // Whether no handler has taken the agent out of the list; remembers where it is now.
        private static function isListed(agent:Agent, agents:Vector.<Agent>):Boolean
        {
            var slot:int = agents.indexOf(agent);
            agent.slot = slot < 0 ? 0 : slot;
            return slot >= 0;
        }
    }
}
