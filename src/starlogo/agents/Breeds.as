package starlogo.agents
{
    /**
     * Numbers for the names of breeds, so that frames and questions compare no text. A name keeps its number as long as the program runs.
     *
     * @private
     */
    public final class Breeds
    {
        /** The breed of agents that stand for the ground. */
        public static const TERRAIN:String = "*terrain";

        /** The breed of agents that stand for the edges of the world. */
        public static const EDGE:String = "*edge";

        // How many names, the first, are of no agents that a game makes.
        private static const RESERVED:int = 2;

        private static var sNames:Vector.<String> = new <String>[TERRAIN, EDGE];

        // The numbers in the order of the names: so a name is found without a text that is made for a key. The last that was asked for.
        private static var sOrder:Vector.<int> = new <int>[1, 0];
        private static var sLast:int = 0;

        /** Has only static members. */
        public function Breeds()
        {
        }

        /** How many names have a number. */
        public static function get count():int
        {
            return sNames.length;
        }

        /** The number of a name, from 0 on. A new name gets the next one. */
        public static function numberOf(name:String):int
        {
            if (sNames.length == 0 || sNames[sLast] != name)
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
                if (low == sOrder.length || sNames[sOrder[low]] != name)
                {
                    sOrder.splice(low, 0, sNames.push(name) - 1);
                }
                sLast = sOrder[low];
            }
            return sLast;
        }

        /** Whether a number is that of a breed of the ground or the edges, which no other agent may have. */
        public static function isReserved(number:int):Boolean
        {
            return number < RESERVED;
        }

        /** The name that has a number. */
        public static function nameOf(number:int):String
        {
            return sNames[number];
        }
    }
}
