package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.utils.getTimer;
    import starlogo.agents.Agent;
    import starlogo.data.requireGiven;
    import starlogo.data.textOf;
    import starlogo.data.warnOfUnknownProperties;
    import starlogo.engine;
    import starlogo.search.BreedInterests;
    import starlogo.search.FoundPairs;
    import starlogo.search.SearchInput;
    import starlogo.search.NarrowPhase;
    import starlogo.search.PairReader;

    use namespace engine;

    /**
     * The base class for collision systems of your own. It has all methods that a Collision uses. A subclass overrides some of them, and another
     * collision system does the rest.
     */
    public class BaseCollider extends QuerySource implements CollisionSystem
    {
        private var _collisionSystem:CollisionSystem;
        private var _foundAgents:Vector.<Agent> = new Vector.<Agent>();

        /**
         * Creates a collider that finds the same pairs as another collision system.
         *
         * @param collisionSystem the other system; null if a subclass overrides <code>areColliding</code>, <code>findCollisions</code> and
         *     <code>statistics</code>
         */
        public function BaseCollider(collisionSystem:CollisionSystem = null)
        {
            _collisionSystem = collisionSystem;
        }

        /** @private Returns the system itself if it is a BaseCollider, otherwise a BaseCollider around it. */
        engine static function wrap(system:CollisionSystem):BaseCollider
        {
            warnOfUnknownProperties(system);
            return system as BaseCollider || new BaseCollider(system);
        }

        /** @private The engine's collider that this one is or contains, which one Collision at most owns; null if there is none. */
        engine function get innerCollider():Collider
        {
            return innerSystem == null ? null : innerSystem.innerCollider;
        }

        /**
         * @private The engine's collider that finds just the pairs of this system, so that snapshots and questions can use it. It is null for a system
         * of the game's own, also for one around a collider.
         */
        engine function get samePairsCollider():Collider
        {
            return null;
        }

        /** The collision system that does the work that a subclass does not override; null if there is none. */
        public function get collisionSystem():CollisionSystem
        {
            return _collisionSystem;
        }

        /** @inheritDoc */
        public function get statistics():CollisionStatistics
        {
            return requireSystem().statistics;
        }

        /** @inheritDoc */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            return requireSystem().areColliding(a, b);
        }

        /** @inheritDoc */
        public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return requireSystem().findCollisions(agents, out);
        }

        /**
         * Finds every pair of agents that collide and whose breeds have handlers. It may also find other pairs; by default it calls
         * <code>findCollisions</code>. A subclass overrides it to test fewer pairs.
         *
         * @param agents the agents of the game
         * @param interests the pairs of breeds that have handlers; null for all
         * @param out receives the pairs; overwritten, and created if null
         * @return out, as from findCollisions
         * @throws ArgumentError as findCollisions does
         */
        public function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return findCollisions(agents, out);
        }

        /**
         * Computes how two agents touch, for handlers with a third argument. If the other collision system is a BaseCollider, its contact
         * is returned. Otherwise the point is half way between the agents, and the depth is 0.
         *
         * @param collider the normal points to it
         * @param collidee another agent
         * @param out receives the contact; created if null
         * @return out. A subclass may return another Contact: what it returns counts
         */
        public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            if (innerSystem != null)
            {
                return innerSystem.contactOf(collider, collidee, out);
            }
            var contact:Contact = out || new Contact();
            contact.setBetween(collider, collidee);
            return contact;
        }

        /** @private */
        override engine function findNarrowPhase():NarrowPhase
        {
            if (samePairsCollider != null)
            {
                return samePairsCollider.narrowPhase;
            }
            throw errorAbout(systemForErrors);
        }

        /**
         * @private Finds the pairs of a Collision's frame. A game's own system may return its own vector, and need not count its tests.
         *
         * @param reader reads the pairs of a system that is not the engine's. Each Collision has its own, because Collisions may share such a system
         * @param counts takes the counts and the time
         * @return the pairs, until the next call
         * @throws ArgumentError if an agent of the list is null or listed twice, or if the system finds an agent that is not in the list, an agent with
         * itself, or a pair twice, or has no statistics
         * @throws IllegalOperationError if there is ground or there are edges, but this is not one of the engine's systems
         */
        engine function findPairs(input:SearchInput, reader:PairReader, counts:CollisionStatistics):FoundPairs
        {
            var start:Number = getTimer();
            if (input.ground != null || input.edges != null)
            {
                var what:String = input.ground != null ? "a terrain needs" : "bounds need";
                throw new IllegalOperationError(what + " one of the engine's collision systems, not " + textOf(systemForErrors, "a Collider"));
            }
            reader.begin(input.agents);
            var listed:Vector.<Agent> = input.admittedAgents;
            var pairs:FoundPairs = reader.read(findCollisionsAmong(listed, input.interests, _foundAgents));
            requireGiven("statistics of the collision system", statistics);
            counts.copyFrom(statistics);
            // the engine's collider counts all agents of the frame, even within another system. Other systems have only those that the filter admits
            if (innerCollider == null)
            {
                counts.agentsSkipped += input.agents.length - listed.length;
            }
            counts.agents = input.agents.length;
            counts.collisions = pairs.count;
            counts.findMs = getTimer() - start;
            return pairs;
        }

        /** @private Lets no agent have a motion in the next frame. */
        engine function forgetMotions():void
        {
            if (innerSystem != null)
            {
                innerSystem.forgetMotions();
            }
        }

        /** @private Called when a Collision's frame is over, handlers included, with the Collision's statistics. */
        engine function onFrame(statistics:CollisionStatistics):void
        {
            if (innerSystem != null)
            {
                innerSystem.onFrame(statistics);
            }
        }

        // The system that does the work, if it is a BaseCollider; or else null.
        private function get innerSystem():BaseCollider
        {
            return _collisionSystem as BaseCollider;
        }

        // What errors name if this is none of the engine's systems: a game's own system that wrap() has put into this, or else this.
        private function get systemForErrors():CollisionSystem
        {
            return _collisionSystem == null || innerSystem != null ? this : _collisionSystem;
        }

        // Returns the collision system that does the work.
        private function requireSystem():CollisionSystem
        {
            if (_collisionSystem == null)
            {
                throw new IllegalOperationError(this + " must override areColliding, findCollisions and statistics, because there is no other collision system "
                        + "in it");
            }
            return _collisionSystem;
        }
    }
}
