package starlogo.collision
{
    import flash.utils.getTimer;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.search.BreedPairs;
    import starlogo.search.CollisionSearch;
    import starlogo.search.FoundPairs;
    import starlogo.search.RowPairs;
    import starlogo.search.ShapeChoice;

    use namespace engine;

    /**
     * A collision system of the shapes that a ShapeChoice gives; the engine's four collision systems extend it.
     *
     * <p>Only agents that are near each other on the ground plane are tested (thesis §3.7), each pair once. A frame takes time in
     * proportion to the agents and to the pairs that overlap on the ground plane, and memory in proportion to the agents; after the first it
     * allocates nothing. An agent's shape is placed anew only when the agent has changed. Any number of colliders may share agents.</p>
     *
     * <p>Pairs come cell by cell of the ground, the coarser cells first; where an agent sweeps, by the times of impact. The order depends only on
     * the agents whose breeds count, their order in the list, their positions and extents. Of a pair, the agent that is first in the list comes
     * first.</p>
     *
     * <p>An agent whose model a ModelLoader is still loading collides with nothing, and is counted in the statistics. Models
     * may be replaced and removed at any time.</p>
     */
    public class Collider implements ContactSystem
    {
        /** @private Finds the shapes of agents, for questions too. */
        engine var choice:ShapeChoice;

        /** @private Decides which of them touch, for questions too. */
        engine var pairs:RowPairs;

        private var _search:CollisionSearch;
        private var _statistics:CollisionStatistics = new CollisionStatistics();
        private var _contactPoint:ContactPoint = new ContactPoint();

        /**
         * A collider for the agents of a game.
         *
         * @param choice says which shapes represent them
         */
        public function Collider(choice:ShapeChoice)
        {
            pairs = new RowPairs(choice);
            _search = new CollisionSearch(choice, pairs);
            this.choice = choice;
        }

        /** @inheritDoc */
        public function get statistics():CollisionStatistics
        {
            return _statistics;
        }

        /** @inheritDoc */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            requireTwo(a, b);
            return _search.areColliding(a, b);
        }

        /** @inheritDoc */
        public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return find(agents, null, out || new Vector.<Agent>());
        }

        /** @inheritDoc */
        public function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent>):Vector.<Agent>
        {
            if (out == null)
            {
                throw new ArgumentError("out must not be null");
            }
            return find(agents, interests == null ? null : interests.breedPairs, out);
        }

        /** @inheritDoc */
        public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            requireTwo(collider, collidee);
            var contact:Contact = out || new Contact();
            var contactPoint:ContactPoint = _contactPoint;
            contact.time = _search.findContact(collider, collidee, contactPoint);
            contact.depth = contactPoint.depth;
            contact.normal.setTo(contactPoint.normalX, contactPoint.normalY, contactPoint.normalZ);
            contact.point.setTo(contactPoint.x, contactPoint.y, contactPoint.z);
            return contact;
        }

        /**
         * As findCollisionsAmong, with the agents' places in the list and their breeds' numbers.
         *
         * @param takePart which agents do, by their places in the list; null for all
         */
        internal function findPairsAmong(agents:Vector.<Agent>, breeds:BreedPairs, takePart:Vector.<Boolean>, out:FoundPairs):void
        {
            var start:Number = getTimer();
            _search.findPairs(agents, breeds, takePart, out);
            _statistics.setCounts(_search.counts, getTimer() - start);
        }

        /** @private The engine's collider that finds what a collision system finds: itself, or the one that observers are put around; or null. */
        engine static function behind(system:Object):Collider
        {
            while (system is CollisionObserver)
            {
                system = CollisionObserver(system).collisionSystem;
            }
            return system as Collider;
        }

        /** The search that the collider makes. */
        internal function get search():CollisionSearch
        {
            return _search;
        }

        private function find(agents:Vector.<Agent>, breeds:BreedPairs, out:Vector.<Agent>):Vector.<Agent>
        {
            if (agents == null)
            {
                throw new ArgumentError("agents must not be null");
            }
            var start:Number = getTimer();
            _search.find(agents, breeds, out);
            _statistics.setCounts(_search.counts, getTimer() - start);
            return out;
        }

        private static function requireTwo(a:Agent, b:Agent):void
        {
            if (a == null || b == null)
            {
                throw new ArgumentError("two agents are needed, not " + a + " and " + b);
            }
            if (a === b)
            {
                throw new ArgumentError("two agents are needed: " + a + " is no pair with itself");
            }
        }
    }
}
