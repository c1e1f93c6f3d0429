package starlogo.agents
{
    /**
     * Gives each breed's name a number, so that frames and questions need not compare text. A name keeps its number as long as the program
     * runs.
     *
     * @private
     */
    public final class Breeds
    {
        /** The breed of agents that stand for the ground. */
        public static const TERRAIN:String = "*terrain";

        /** The breed of agents that stand for the edges of the world. */
        public static const EDGE:String = "*edge";

        /** The number that stands for any breed of agents. Its name is empty, and no breed has such a name. */
        public static const ANY:int = 2;

        // The names by number. The first two are those of the ground and of the edges.
        private static const OF_WORLD:int = 2;
        private static var sNames:Vector.<String> = new <String>[TERRAIN, EDGE, ""];

        // The numbers in the order of their names. A binary search in it needs no key, so it allocates no text. sLast is the last number
        // asked for.
        private static var sOrder:Vector.<int> = new <int>[2, 1, 0];
        private static var sLast:int = 0;

        private static var sChanges:int = 0;

        /** How often agents have got other breeds. What is computed from the breeds of agents holds until it is another number. */
        public static function get changes():int
        {
            return sChanges;
        }

        /** Counts that an agent has got another breed. */
        public static function countChange():void
        {
            sChanges++;
        }

        /** The number of names so far. */
        public static function get count():int
        {
            return sNames.length;
        }

        /** The number of a name, from 0. A new name gets the next number. */
        public static function numberOf(name:String):int
        {
            if (sNames[sLast] != name)
            {
                sLast = knownNumberOf(name);
                if (sLast < 0)
                {
                    sLast = sNames.push(name) - 1;
                    sOrder.splice(countBefore(name), 0, sLast);
                }
            }
            return sLast;
        }

        /** The number of a name; -1 if it has none yet. */
        public static function knownNumberOf(name:String):int
        {
            var index:int = countBefore(name);
            return index < sOrder.length && sNames[sOrder[index]] == name ? sOrder[index] : -1;
        }

        // How many names come before a name in sOrder.
        private static function countBefore(name:String):int
        {
            var low:int = 0;
            var high:int = sOrder.length;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (sNames[sOrder[middle]] < name)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle;
                }
            }
            return low;
        }

        /** Whether a number is that of the breed of the ground or of the edges. No other agent may have these breeds. */
        public static function isOfWorld(number:int):Boolean
        {
            return number < OF_WORLD;
        }

        /** The name for a number. */
        public static function nameOf(number:int):String
        {
            return sNames[number];
        }
    }
}
