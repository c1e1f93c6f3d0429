package starlogo.blocks
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.collision.Contact;

    /** Contacts in the collision system of blocks: as the last frame saw them, and as they are now. */
    internal final class BlockContacts
    {
        private var _collisions:CollisionBlocks;

        // Its systems never search, so they give contacts of the agents' present places.
        private var _now:CollisionBlocks;

        public function BlockContacts(collisions:CollisionBlocks)
        {
            _collisions = collisions;
        }

        /** How two agents touch, or touched in the last frame. */
        public function ofFrame(agent:Agent, other:Agent):Contact
        {
            return Collider(_collisions.systemNamed(_collisions.systemName)).contactOf(agent, other);
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
            if (_now == null)
            {
                _now = new CollisionBlocks(_collisions.greatLand, new <Agent>[]);
            }
            var system:Collider = Collider(_now.systemNamed(_collisions.systemName));
            return system.areColliding(agent, other) ? system.contactOf(agent, other) : null;
        }
    }
}
