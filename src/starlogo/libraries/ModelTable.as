package starlogo.libraries
{
    import starlogo.data.hintOfName;
    import starlogo.data.keyOf;
    import starlogo.geometry.vertices.VertexBounds;

    /**
     * The data of a game under the names of shapes. Its revision increases when data is replaced, removed or posed. Results derived from the
     * data are then out of date.
     *
     * @private
     */
    public final class ModelTable
    {
        /** Increased with the revision of each entry, by the entry. Otherwise read only. */
        public var revision:int = 0;

        private var _entries:Object = {};
        private var _unknown:ModelEntry;

        /** Creates a table without entries. */
        public function ModelTable()
        {
            _unknown = new ModelEntry(this);
        }

        /** The entry of a name, to read. All unknown names, and null, share an empty one. */
        public function entryOf(name:String):ModelEntry
        {
            return name == null ? _unknown : _entries[keyOf(name)] || _unknown;
        }

        /** The entry of a name, to write to. It is made if there is none. It is never removed, so its revision only increases. */
        public function entryToWrite(name:String):ModelEntry
        {
            return _entries[keyOf(name)] ||= new ModelEntry(this);
        }

        /** The names under which there is a model, a structure or a hierarchy. */
        public function get names():Vector.<String>
        {
            var all:Vector.<String> = new Vector.<String>();
            for (var key:String in _entries)
            {
                var entry:ModelEntry = _entries[key];
                if (entry.model != null || entry.structures != null || entry.tree != null)
                {
                    all.push(key.substr(1));
                }
            }
            return all;
        }

        /** Throws an ArgumentError if a name is null or empty. */
        public static function requireName(name:String):void
        {
            if (name == null || name == "")
            {
                throw new ArgumentError("a shape must have a name: " + name);
            }
        }

        /** Throws an ArgumentError if a coordinate of a shape's vertices is beyond 1e60. */
        public static function requireCoordinates(name:String, vertices:Vector.<Number>):void
        {
            VertexBounds.requireWithin(VertexBounds.of(vertices).largest, problemOf(name, ""));
        }

        /** The error for something that is wrong with a shape. */
        public static function errorOf(name:String, problem:String):ArgumentError
        {
            return new ArgumentError(problemOf(name, problem));
        }

        /** The message of an error: something that is wrong with a shape. */
        public static function problemOf(name:String, problem:String):String
        {
            return "shape \"" + name + "\": " + problem;
        }

        /**
         * The error for something that is missing under a name. If the name is unknown, it tells those that are known.
         *
         * @param what the thing that is missing
         * @param name the name
         * @param flag the flag that makes addModel compute it
         */
        public function missing(what:String, name:String, flag:String):ArgumentError
        {
            var remedy:String = names.indexOf(name) < 0 ? "to the GreatLand or to this library first" + hintOfName(name, names) : "again by addModel(), with " + flag + " set";
            return new ArgumentError("there is no " + what + " for shape \"" + name + "\": add its model " + remedy);
        }
    }
}
