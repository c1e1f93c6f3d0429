package starlogo.models.building
{
    /**
     * The material or the mesh of each triangle: a number, which may have a name. A reader says where triangles with another number begin.
     *
     * @private
     */
    public final class TriangleLabels
    {
        /** The name of each number, or null for a number without a name. Null if nothing gives names. */
        public var names:Vector.<String>;

        /**
         * Triangles that follow one another and have the same number are a run. This is the first triangle of each run. <code>close()</code> adds the
         * number of triangles, so each run ends where the next entry begins. Read only.
         */
        public var starts:Vector.<Number> = new <Number>[0];

        /** The number of each run. That of the first run is -1, for triangles without a number. Only the first run may have no triangle. Read only. */
        public var numbersOfRuns:Vector.<int> = new <int>[-1];

        // The number of each triangle, after it was first asked for.
        private var _list:Vector.<int> = null;

        // The number of each key. A "#" stands before a key, so that none is the name of a property that every Object has.
        private var _known:Object = {};

        /** Labels without triangles. @param names the name of each number so far; kept; null if nothing will give names */
        public function TriangleLabels(names:Vector.<String>)
        {
            this.names = names;
        }

        /** Adds a key, if it is new, and gives it the next number. Returns its number. @param name the number's name; null if it has none */
        public function addKey(key:String, name:String):int
        {
            if (_known["#" + key] === undefined)
            {
                _known["#" + key] = addName(name);
            }
            return _known["#" + key];
        }

        /** Adds the next number, without a key. Returns it. @param name its name; null if it has none */
        public function addName(name:String):int
        {
            return names.push(name) - 1;
        }

        /** The number of the last run. Triangles that come next have it. */
        public function get current():int
        {
            return numbersOfRuns[numbersOfRuns.length - 1];
        }

        /** Gives a number to all triangles from one on. It must not be before the last run. */
        public function beginRun(number:int, triangle:int):void
        {
            endRun(triangle);
            if (number != current)
            {
                starts.push(triangle);
                numbersOfRuns.push(number);
            }
        }

        /** Ends the last run. If then no triangle has a number, there are no names either. @param count the number of triangles */
        public function close(count:int):void
        {
            endRun(count);
            starts.push(count);
            names = numbersOfRuns.length == 1 ? null : names;
        }

        /** The number of each triangle, -1 for none, after <code>close()</code>. Always the same list. Null if no triangle has a number. */
        public function get numbers():Vector.<int>
        {
            if (_list == null && numbersOfRuns.length > 1)
            {
                _list = new Vector.<int>(starts[numbersOfRuns.length], true);
                for (var run:int = 0; run < numbersOfRuns.length; run++)
                {
                    for (var i:int = starts[run]; i < starts[run + 1]; i++)
                    {
                        _list[i] = numbersOfRuns[run];
                    }
                }
            }
            return _list;
        }

        /** The number of a triangle, after <code>close()</code>; -1 if it has none. */
        public function numberOf(triangle:int):int
        {
            return numbersOfRuns[lastNotAfter(starts, triangle)];
        }

        /** The name of a number; null if it has none. */
        public function nameOf(number:int):String
        {
            return names == null || number < 0 || number >= names.length ? null : names[number];
        }

        // Ends the last run before a triangle. If it has no triangle, it is removed, unless it is the first.
        private function endRun(end:int):void
        {
            var last:int = numbersOfRuns.length - 1;
            if (last > 0 && starts[last] == end)
            {
                starts.length = numbersOfRuns.length = last;
            }
        }
    }
}
