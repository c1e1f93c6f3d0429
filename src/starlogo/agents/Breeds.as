package starlogo.agents
{
    /**
     * The breeds that the engine knows, and the numbers of all breeds' names.
     *
     * @private
     */
    public final class Breeds
    {
        /** The breed of agents that stand for the ground. */
        public static const TERRAIN:String = "*terrain";

        /** The breed of agents that stand for the edges of the world. */
        public static const EDGE:String = "*edge";

        /** The name that stands for any breed of agents. */
        public static const ANY_BREED:String = "*";

        /** The numbers of the names of breeds. The first names are reserved. */
        public static const NAMES:NameNumbers = new NameNumbers(new <String>[TERRAIN, EDGE, ANY_BREED]);

        /** The number of the name that stands for any breed of agents. Lower numbers are of the environment, higher ones of agents. */
        public static const ANY_NUMBER:int = NAMES.knownNumberOf(ANY_BREED);

        /** How often agents have got other breeds. What is computed from the breeds of agents holds until it is another number. Read only. */
        public static var changes:int = 0;

        /** Counts that an agent has got another breed. */
        public static function countChange():void
        {
            changes++;
        }

        /** Whether a number is that of the breed of the ground or of the edges. No other agent may have these breeds. */
        public static function isEnvironment(number:int):Boolean
        {
            return number < ANY_NUMBER;
        }

        /** Whether a name is reserved: no agent of a game may have such a breed. */
        public static function isReserved(name:String):Boolean
        {
            return name == TERRAIN || name == EDGE || name == ANY_BREED;
        }
    }
}
