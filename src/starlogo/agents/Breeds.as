package starlogo.agents
{
    /**
     * Numbers for the names of breeds, so that frames and questions compare no text. A name keeps its number as long as the program runs.
     *
     * @private
     */
    public final class Breeds
    {
        // Stands before every key, because a breed may be called "hasOwnProperty" or "__proto__".
        private static const PREFIX:String = ":";

        private static var sNumbers:Object = {};
        private static var sNames:Vector.<String> = new Vector.<String>();
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
            // mostly the breed that was asked for last
            if (sNames.length == 0 || sNames[sLast] != name)
            {
                var key:String = PREFIX + name;
                if (!(key in sNumbers))
                {
                    sNumbers[key] = sNames.push(name) - 1;
                }
                sLast = sNumbers[key];
            }
            return sLast;
        }

        /** The name that has a number. */
        public static function nameOf(number:int):String
        {
            return sNames[number];
        }
    }
}
