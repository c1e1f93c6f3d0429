package starlogo.blocks
{
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.engine;

    use namespace engine;

    /** Checks what blocks are given: agents, names of breeds, and numbers. */
    internal final class BlockChecks
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

        /** As check(). Also throws a BlockError if the subject is the ground, the edges or any breed, which have no traits. */
        public static function checkOfGame(block:String, subject:Object):void
        {
            check(block, subject);
            var breed:String = subject is Agent ? Agent(subject).breed : subject as String;
            if ([Collision.ANY_BREED, Collision.TERRAIN, Collision.EDGE].indexOf(breed) >= 0)
            {
                throw new BlockError(block, "needs an agent or a breed of the game, not the ground, the edges of the world or any breed.");
            }
        }

        /** Throws a BlockError if there is no agent. */
        public static function checkGiven(block:String, agent:Agent):void
        {
            if (agent == null)
            {
                throw new BlockError(block, "needs an agent, but got nothing" + HINT);
            }
        }

        /** Throws a BlockError if there is no agent, or if it stands for the ground or the edges, which have no place and do not move. */
        public static function checkAgent(block:String, agent:Agent):void
        {
            checkGiven(block, agent);
            if (agent.isEnvironment)
            {
                throw new BlockError(block, "needs an agent, but got the ground or the edges of the world.");
            }
        }

        /** Throws a BlockError if one of two agents is missing, if they are the same, or if neither is an agent of the game. */
        public static function checkBoth(block:String, agent:Agent, other:Agent):void
        {
            checkGiven(block, agent);
            if (other == null || other === agent)
            {
                throw new BlockError(block, "needs another agent, but got " + (other == null ? "nothing" + HINT : "the same."));
            }
            checkAgent(block, agent.isEnvironment ? other : agent);
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
        public static function checkReach(block:String, value:Number, what:String):void
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
