package starlogo.blocks
{
    import starlogo.agents.Agent;

    /** Whom a block is about, which a student says by an agent or by the name of a breed. */
    internal final class Whom
    {
        /** Makes sure that it is one of the two. */
        public static function check(block:String, whom:Object):void
        {
            if (whom is String)
            {
                checkBreed(block, whom as String);
            }
            else if (!(whom is Agent))
            {
                throw new BlockError(block, "needs an agent or a breed, but got " + said(whom)
                        + ". Remember: \"collidee\" is somebody only while a collision block runs.");
            }
        }

        /** Makes sure that a breed has a name. */
        public static function checkBreed(block:String, breed:String):void
        {
            if (breed == null || breed == "")
            {
                throw new BlockError(block, "needs the name of a breed, but got nothing.");
            }
        }

        /** Whether somebody is meant: the agent itself, or one of the breed. */
        public static function means(whom:Object, agent:Agent):Boolean
        {
            return whom === agent || whom === agent.breed;
        }

        /** How a message speaks of what a student put into a block. */
        public static function said(value:Object):String
        {
            if (value == null || value === "")
            {
                return "nothing";
            }
            return value is String ? "\"" + value + "\"" : String(value);
        }
    }
}
