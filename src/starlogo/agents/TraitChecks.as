package starlogo.agents
{
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;

    use namespace engine;

    /** Refuses values that a trait of an agent may not have, with errors that name the agent. */
    internal final class TraitChecks
    {
        /** Throws an ArgumentError if the trait is given no name. */
        public static function requireName(agent:Agent, trait:String, value:String):void
        {
            if (value == null || value == "")
            {
                throw new ArgumentError(agent + ": " + trait + " must be a name, not " + textOf(value));
            }
        }

        /** Throws an ArgumentError if the agent may not have the breed, which is reserved or no name. The environment may have no other breed. */
        public static function requireBreed(agent:Agent, value:String):void
        {
            requireName(agent, "breed", value);
            if (Breeds.isReserved(value) || (agent.idNumber != 0 && agent.isEnvironment))
            {
                var reason:String = value == Breeds.ANY_BREED ? "it stands for any breed" : "the ground and the edges of the world have their own breeds";
                throw new ArgumentError(agent + ": breed must not be \"" + value + "\": " + reason);
            }
        }

        /** Throws a RangeError if a place is not finite, or beyond LARGEST_COORDINATE. */
        public static function requirePlace(agent:Agent, x:Number, y:Number, z:Number):void
        {
            requireInWorld("x", x, 0, 0, agent);
            requireInWorld("y", y, 0, 0, agent);
            requireInWorld("z", z, 0, 0, agent);
        }

        /** Throws a RangeError if an angle is not finite. */
        public static function requireAngles(agent:Agent, heading:Number, pitch:Number, roll:Number):void
        {
            requireFinite(agent, "heading", heading);
            requireFinite(agent, "pitch", pitch);
            requireFinite(agent, "roll", roll);
        }

        /** Throws a RangeError if a quaternion is not finite, or 0. */
        public static function requireQuaternion(agent:Agent, x:Number, y:Number, z:Number, w:Number):void
        {
            requireFinite(agent, "a quaternion's x", x);
            requireFinite(agent, "a quaternion's y", y);
            requireFinite(agent, "a quaternion's z", z);
            requireFinite(agent, "a quaternion's w", w);
            if (x == 0 && y == 0 && z == 0 && w == 0)
            {
                throw new RangeError(agent + ": a quaternion must not be 0");
            }
        }

        /** Throws a RangeError if a size is not from SMALLEST_SIZE to LARGEST_SIZE. */
        public static function requireSize(agent:Agent, value:Number):void
        {
            if (!Agent.isSize(value))
            {
                var range:String = value > 0 && value < Infinity ? "between " + Agent.SMALLEST_SIZE + " and " + Agent.LARGEST_SIZE : "a positive, finite number";
                throw new RangeError(agent + ": size must be " + range + ", not " + value);
            }
        }

        private static function requireFinite(agent:Agent, trait:String, value:Number):void
        {
            if (!isFinite(value))
            {
                throw new RangeError(agent + ": " + trait + " must be a finite number, not " + value);
            }
        }
    }
}
