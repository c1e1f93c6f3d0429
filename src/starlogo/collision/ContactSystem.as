package starlogo.collision
{
    import starlogo.agents.Agent;

    /** A collision system that tells how agents touch, not only that they do. */
    public interface ContactSystem extends SelectiveCollisionSystem
    {
        /**
         * How two agents touch: as they were in the last search, whatever has changed since; or, if not both were in it, as they are now.
         *
         * @param collider the normal points to it
         * @param collidee another agent
         * @param out takes the contact; made if null
         * @return out, or the new one. For two that do not touch: where they are nearest, or overlap the least, with a depth of 0
         * @throws ArgumentError if one is null, both are one, or a model is unknown or still loading
         */
        function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact;
    }
}
