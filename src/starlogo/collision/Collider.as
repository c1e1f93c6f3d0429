package starlogo.collision
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;

    /**
     * A collision system of the engine's: the common face of its four colliders.
     *
     * <p>Only agents that share a bin of the ground plane are tested (thesis §3.7), each pair once. A frame costs time in
     * proportion to the agents and to the pairs that overlap on the ground plane, memory in proportion to the agents, and allocates
     * nothing once it has run. What stands for an agent is computed when the agent has changed, and kept with the agent; any number
     * of colliders may share agents.</p>
     *
     * <p>An agent whose model a ModelLoader is still loading collides with nothing, and is counted in the statistics. Models
     * may be replaced and removed at any time.</p>
     */
    public class Collider implements ContactSystem
    {
        private var _search:CollisionSearch;

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
            return _search.statistics;
        }

        /** @inheritDoc */
        public function areColliding(a:Agent, b:Agent):Boolean
        {
            return _search.areColliding(a, b);
        }

        /** @inheritDoc */
        public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return _search.find(agents, null, out || new Vector.<Agent>());
        }

        /** @inheritDoc */
        public function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent>):Vector.<Agent>
        {
            return _search.find(agents, interests, out);
        }

        /** @inheritDoc */
        public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            if (collider == null || collidee == null || collider === collidee)
            {
                throw new ArgumentError("two agents are needed, not " + collider + " and " + collidee);
            }
            var contact:Contact = out || new Contact();
            _search.findContact(collider, collidee, contact);
            return contact;
        }

        /** As contactOf, of two records that findRecordsAmong gave. */
        internal function findContactOf(collider:AgentRecord, collidee:AgentRecord, out:Contact):void
        {
            _search.findContactOf(collider, collidee, out);
        }

        /** As findCollisionsAmong, but gives the collider's records of the agents. */
        internal function findRecordsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<AgentRecord>):void
        {
            _search.findRecords(agents, interests, out);
        }
    }
}
