package starlogo.libraries
{
    /**
     * What a game has under the names of shapes, and how often any of it was replaced or removed: what was derived from it is void when that number
     * has changed.
     *
     * @private
     */
    public final class ShapeTable
    {
        // in front of every key: a shape may be called "hasOwnProperty"
        private static const PREFIX:String = ":";

        /** How often something was replaced or removed, whatever its name. */
        public var revision:int = 0;

        private var _entries:Object = {};

        /** An empty table. */
        public function ShapeTable()
        {
        }

        /** The entry of a name; an empty one if nothing is known. Once made, an entry stays: its revisions are counted on. */
        public function of(name:String):ShapeEntry
        {
            var entry:ShapeEntry = _entries[PREFIX + name];
            if (entry == null)
            {
                entry = new ShapeEntry(this);
                _entries[PREFIX + name] = entry;
            }
            return entry;
        }

        /** Throws an ArgumentError if a name is null or empty. */
        public static function checkName(name:String):void
        {
            if (name == null || name == "")
            {
                throw new ArgumentError("a shape must have a name: " + name);
            }
        }

        /**
         * The error to throw if something is missing under a name.
         *
         * @param what the thing that is missing
         * @param name the name
         * @param flag the flag that would have it computed
         */
        public static function missing(what:String, name:String, flag:String):ArgumentError
        {
            return new ArgumentError("there is no " + what + " for shape \"" + name + "\": add its model first, with " + flag + " set");
        }
    }
}
