package soak
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;

    /** A handler of a soak's game, and for which breeds. */
    internal final class SoakHandler
    {
        internal var breed:String;
        internal var otherBreed:String;

        /** What the Collision calls. */
        internal var call:Function;

        /** As in onCollision. */
        public function SoakHandler(breed:String, otherBreed:String)
        {
            this.breed = breed;
            this.otherBreed = otherBreed;
        }

        /** Whether it is called for two agents in this order, as their breeds are now. */
        internal function cares(collider:Agent, collidee:Agent):Boolean
        {
            return fits(breed, collider) && fits(otherBreed, collidee);
        }

        private static function fits(breed:String, agent:Agent):Boolean
        {
            return breed == Collision.ANY_BREED || breed == agent.breed;
        }
    }
}
