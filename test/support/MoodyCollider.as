package support
{
    import starlogo.agents.Agent;
    import starlogo.collision.BaseCollider;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.Contact;

    /** A game's own collider, which may refuse to compute contacts. */
    public class MoodyCollider extends BaseCollider
    {
        /** Whether contactOf throws. */
        public var refuses:Boolean = false;

        /** @param system finds the pairs */
        public function MoodyCollider(system:CollisionSystem)
        {
            super(system);
        }

        override public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            if (refuses)
            {
                throw new Error("no contact");
            }
            return super.contactOf(collider, collidee, out);
        }
    }
}
