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
     * <p>The handlers of a pair run in the order in which they were added.</p>
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
            _isUpdating = true;
            callHandlers(agents);
            _isUpdating = false;
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
            var interests:BreedInterests = _table.interests;
            rememberPlaces(agents);
            var pairs:Vector.<Agent> = _pairs;
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                var a:Agent = pairs[i];
                var b:Agent = pairs[i + 1];
                var breedA:int = interests.breedIndexOf(a);
                var breedB:int = interests.breedIndexOf(b);
                if (breedA < 0 || breedB < 0)
                {
                    continue;
                }
                callAll(_table.handlersOf(breedA, breedB), a, b, agents);
                callAll(_table.handlersOf(breedB, breedA), b, a, agents);
            }
        }

        private function rememberPlaces(agents:Vector.<Agent>):void
        {
            var count:int = agents.length;
            for (var i:int = 0; i < count; i++)
            {
                agents[i].slot = i;
            }
        }

        private function callAll(handlers:Vector.<Function>, collider:Agent, collidee:Agent, agents:Vector.<Agent>):void
        {
            if (handlers == null)
            {
                return;
            }
            for (var i:int = 0; i < handlers.length; i++)
            {
                if (!isListed(collider, agents) || !isListed(collidee, agents))
                {
                    return;
                }
                _statistics.handlerCalls++;
                try
                {
                    handlers[i](collider, collidee);
                }
                catch (error:Error)
                {
                    _firstError ||= error;
                }
            }
        }

        // Whether no handler has taken the agent out of the list. It mostly still is where it was.
        private function isListed(agent:Agent, agents:Vector.<Agent>):Boolean
        {
            var slot:int = agent.slot;
            if (slot < 0)
            {
                return false;
            }
            if (slot < agents.length && agents[slot] === agent)
            {
                return true;
            }
            agent.slot = agents.indexOf(agent);
            return agent.slot >= 0;
        }
    }
}
