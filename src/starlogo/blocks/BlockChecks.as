package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.textOf;
    import starlogo.engine;

    use namespace engine;

    /** Checks what blocks are given: agents, names of breeds, and numbers. */
    internal final class BlockChecks
    {
        private static const HINT:String = ". Remember: \"collidee\" is an agent only while a collision block runs.";

        /** Throws a BlockError if the subject is neither an agent nor the name of a breed. The name stands for all agents of the breed. */
        public static function requireSubject(block:String, subject:Object):void
        {
            if (subject is String)
            {
                requireBreed(block, subject as String);
            }
            else if (!(subject is Agent))
            {
                throw new BlockError(block, "needs an agent or a breed, but got " + nameOf(subject) + HINT);
            }
        }

        /** As requireSubject(). Also throws a BlockError if the subject is the ground, the edges or any breed, which have no traits. */
        public static function requireTraitSubject(block:String, subject:Object):void
        {
            requireSubject(block, subject);
            var breed:String = subject is Agent ? Agent(subject).breed : subject as String;
            if (Breeds.isReserved(breed))
            {
                throw new BlockError(block, "needs an agent or a breed of the game, not the ground, the edges of the world or any breed.");
            }
        }

        /** Throws a BlockError if there is no agent. */
        public static function requireAgent(block:String, agent:Agent):void
        {
            if (agent == null)
            {
                throw new BlockError(block, "needs an agent, but got nothing" + HINT);
            }
        }

        /** Throws a BlockError if there is no agent, or if it stands for the ground or the edges, which have no place and do not move. */
        public static function requirePlacedAgent(block:String, agent:Agent):void
        {
            requireAgent(block, agent);
            if (agent.isEnvironment)
            {
                throw new BlockError(block, "needs an agent, but got the ground or the edges of the world.");
            }
        }

        /** Throws a BlockError if one of two agents is missing, if they are the same, or if neither is an agent of the game. */
        public static function requirePair(block:String, agent:Agent, other:Agent):void
        {
            requireAgent(block, agent);
            if (other == null || other === agent)
            {
                throw new BlockError(block, "needs another agent, but got " + (other == null ? "nothing" + HINT : "the same."));
            }
            requirePlacedAgent(block, agent.isEnvironment ? other : agent);
        }

        /** Throws a BlockError if a value is not a number, or is more than any place or height either way. @param what the value is for */
        public static function requireNumber(block:String, value:Number, what:String):void
        {
            if (!(Math.abs(value) <= Agent.LARGEST_COORDINATE))
            {
                throw new BlockError(block, "needs a number up to " + Agent.LARGEST_COORDINATE + " for " + what + ", but got " + value + ".");
            }
        }

        /** Throws a BlockError if a value is negative or not a number. @param what the value is, without an article */
        public static function requireNotNegative(block:String, value:Number, what:String):void
        {
            if (!(value >= 0))
            {
                throw new BlockError(block, "needs a " + what + " of 0 or more, but got " + value + ".");
            }
        }

        /** Throws a BlockError if the breed's name is missing. */
        public static function requireBreed(block:String, breed:String):void
        {
            if (breed == null || breed == "")
            {
                throw new BlockError(block, "needs the name of a breed, but got nothing.");
            }
        }

        /**
         * Calls a function of the engine with arguments that may be wrong.
         *
         * @param problem what the block can't do then; the engine's own words follow
         * @return what the function returns
         * @throws BlockError if the function throws an ArgumentError or a RangeError
         */
        public static function attempt(block:String, problem:String, action:Function, ...all):Object
        {
            try
            {
                return action.apply(null, all);
            }
            catch (error:Error)
            {
                if (!(error is ArgumentError || error is RangeError))
                {
                    throw error;
                }
                problem += ": " + error.message + ".";
            }
            throw new BlockError(block, problem);
        }

        /** The words for a value in a message. */
        public static function nameOf(value:Object):String
        {
            return value == null || value === "" ? "nothing" : textOf(value);
        }
    }
}
