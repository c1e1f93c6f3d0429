package starlogo.blocks
{
    import starlogo.agents.Agent;

    /** What a block is about: an agent, or all agents of a breed, given by its name. */
    internal final class BlockSubject
    {
        /** Makes sure that it is one of the two. */
        public static function check(block:String, subject:Object):void
        {
            if (subject is String)
            {
                checkBreed(block, subject as String);
            }
            else if (!(subject is Agent))
            {
                throw new BlockError(block, "needs an agent or a breed, but got " + nameOf(subject)
                        + ". Remember: \"collidee\" is an agent only while a collision block runs.");
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

        /** How a message names what a student put into a block. */
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
