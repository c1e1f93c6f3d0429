package starlogo.collision
{
    import flash.utils.getTimer;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.search.BreedPairs;
    import starlogo.search.CollisionSearch;
    import starlogo.search.FoundPairs;
    import starlogo.search.ShapeStrategy;

    use namespace engine;

    /**
     * A collision system of the engine's: the common face of its four colliders.
     *
     * <p>Only agents that are near each other on the ground plane are tested (thesis §3.7), each pair once. A frame costs time in
     * proportion to the agents and to the pairs that overlap on the ground plane, memory in proportion to the agents, and allocates
     * nothing once it has run. What stands for an agent is found anew when the agent has changed; any number of colliders may share
     * agents.</p>
     *
     * <p>Pairs come cell by cell of the ground, the coarser cells first; where an agent sweeps, by the times of impact. The order
     * depends on the agents that take part, their order in the list, where they are and how far they reach, and on nothing else. Of a
     * pair the agent that comes first in the list comes first.</p>
     *
     * <p>An agent whose model a ModelLoader is still loading collides with nothing, and is counted in the statistics. Models
     * may be replaced and removed at any time.</p>
     */
    public class Collider implements ContactSystem
    {
        private var _search:CollisionSearch;
        private var _statistics:CollisionStatistics = new CollisionStatistics();
        private var _contactPoint:ContactPoint = new ContactPoint();

        /**
         * For the engine's colliders only.
         *
         * @param greatLand has the models of the agents
         * @param strategy says what shapes they have
         * @throws ArgumentError if greatLand is null
         */
        public function Collider(greatLand:GreatLand, strategy:ShapeStrategy)
        {
            _search = new CollisionSearch(greatLand, strategy);
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
            var found:ContactPoint = _contactPoint;
            contact.time = _search.findContact(collider, collidee, found);
            contact.depth = found.depth;
            contact.normal.setTo(found.normalX, found.normalY, found.normalZ);
            contact.point.setTo(found.x, found.y, found.z);
            return contact;
        }

        /** As findCollisionsAmong, with the agents' places in the list and their breeds' numbers. */
        internal function findPairsAmong(agents:Vector.<Agent>, breeds:BreedPairs, out:FoundPairs):void
        {
            requireList(agents);
            var start:int = getTimer();
            _search.findPairs(agents, breeds, out);
            _statistics.setCounts(_search.counts, getTimer() - start);
        }

        private function find(agents:Vector.<Agent>, breeds:BreedPairs, out:Vector.<Agent>):Vector.<Agent>
        {
            requireList(agents);
            var start:int = getTimer();
            _search.find(agents, breeds, out);
            _statistics.setCounts(_search.counts, getTimer() - start);
            return out;
        }

        private static function requireList(agents:Vector.<Agent>):void
        {
            if (agents == null)
            {
                throw new ArgumentError("agents must not be null");
            }
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
