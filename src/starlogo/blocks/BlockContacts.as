package starlogo.blocks
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Contact;
    import starlogo.engine;
    import starlogo.search.CollisionSearch;

    use namespace engine;

    /** Contacts in the collision system of blocks: as the last frame saw them, and as they are now. */
    internal final class BlockContacts
    {
        private var _collisions:CollisionBlocks;

        // The collider that was asked last about present places, and a search with its settings. That search never gets a list of agents, so it
        // takes all agents where they are now.
        private var _collider:Collider;
        private var _search:CollisionSearch;

        /** @param collisions the system whose contacts these are */
        public function BlockContacts(collisions:CollisionBlocks)
        {
            _collisions = collisions;
        }

        /** How two agents touch, or touched in the last frame. */
        public function ofFrame(agent:Agent, other:Agent):Contact
        {
            return inUse.contactOf(agent, other);
        }

        /** Moves an agent out of another one by the shortest way, from where both are now; null if they do not touch. */
        public function pushOut(agent:Agent, other:Agent):Contact
        {
            var contact:Contact = now(agent, other);
            if (contact != null)
            {
                var way:Vector3D = contact.normal;
                agent.moveTo(agent.x + contact.depth * way.x, agent.y + contact.depth * way.y, agent.z + contact.depth * way.z);
            }
            return contact;
        }

        /** How two agents touch where they are now; null if they do not. */
        public function now(agent:Agent, other:Agent):Contact
        {
            var collider:Collider = inUse;
            if (collider !== _collider)
            {
                _collider = collider;
                _search = new CollisionSearch(collider.narrowPhase);
            }
            return _search.areColliding(agent, other) ? collider.contactIn(_search, agent, other, new Contact()) : null;
        }

        private function get inUse():Collider
        {
            return Collider(_collisions.systemNamed(_collisions.systemName));
        }
    }
}
