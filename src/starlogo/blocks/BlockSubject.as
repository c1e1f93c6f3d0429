package starlogo.blocks
{
    import starlogo.agents.Agent;

    /** Checks what blocks are given: agents, names of breeds, and numbers. */
    internal final class BlockSubject
    {
        private static const HINT:String = ". Remember: \"collidee\" is an agent only while a collision block runs.";

        /** Throws a BlockError if the subject is neither an agent nor the name of a breed, which stands for all its agents. */
        public static function check(block:String, subject:Object):void
        {
            if (subject is String)
            {
                checkBreed(block, subject as String);
            }
            else if (!(subject is Agent))
            {
                throw new BlockError(block, "needs an agent or a breed, but got " + nameOf(subject) + HINT);
            }
        }

        /** Throws a BlockError if there is no agent that uses the block. */
        public static function checkAgent(block:String, agent:Agent):void
        {
            if (agent == null)
            {
                throw new BlockError(block, "needs an agent, but got nothing" + HINT);
            }
        }

        /** Throws a BlockError if one of two agents is missing, or if they are the same. */
        public static function checkBoth(block:String, agent:Agent, other:Agent):void
        {
            checkAgent(block, agent);
            if (other == null || other === agent)
            {
                throw new BlockError(block, "needs another agent, but got " + (other == null ? "nothing" + HINT : "the same."));
            }
        }

        /** Throws a BlockError if a value is not a finite number. @param what the value is for */
        public static function checkNumber(block:String, value:Number, what:String):void
        {
            if (!isFinite(value))
            {
                throw new BlockError(block, "needs a number for " + what + ", but got " + value + ".");
            }
        }

        /** Throws a BlockError if an agent cannot go so far in one step, or not so fast. @param what the value is for */
        public static function checkWay(block:String, value:Number, what:String):void
        {
            checkNumber(block, value, what);
            if (Math.abs(value) > Agent.LARGEST_COORDINATE)
            {
                throw new BlockError(block, "needs a number up to " + Agent.LARGEST_COORDINATE + " for " + what + ", but got " + value + ".");
            }
        }

        /** Throws a BlockError if the breed's name is missing. */
        public static function checkBreed(block:String, breed:String):void
        {
            if (breed == null || breed == "")
            {
                throw new BlockError(block, "needs the name of a breed, but got nothing.");
            }
        }

        /** The words for a value in a message. */
        public static function nameOf(value:Object):String
        {
            if (value == null || value === "")
            {
                return "nothing";
            }
            return value is String ? "\"" + value + "\"" : String(value);
        }
    }
}
