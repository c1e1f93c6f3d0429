package starlogo.libraries
{
    /**
     * What a game knows under the names of shapes, and how often something of that was replaced or removed: what was made of it is void
     * when the number has changed.
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

        /** A table of nothing. */
        public function ShapeTable()
        {
        }

        /** What is known under a name; an entry of nothing if nothing is. Once made, an entry stays: its revisions count on. */
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
         * What to throw if there is nothing under a name.
         *
         * @param what what there is nothing of
         * @param name the name
         * @param flag the flag that would have it computed
         */
        public static function missing(what:String, name:String, flag:String):ArgumentError
        {
            return new ArgumentError("there is no " + what + " for shape \"" + name + "\": add its model first, with " + flag + " set");
        }
    }
}
