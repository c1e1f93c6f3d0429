package starlogo.models
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

        /** The number of each triangle, -1 for none; after <code>close()</code>. Null if no triangle has one. */
        public var numbers:Vector.<int> = null;

        /** The number of the triangles that come next. */
        public var next:int = -1;

        // Until close(): the first triangle of each run of triangles with the same number, and the number.
        private var _starts:Vector.<int> = new <int>[0];
        private var _runs:Vector.<int> = new <int>[-1];

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

        /** Gives a number to all triangles from one on. It must not be before the last run. */
        public function beginRun(number:int, triangle:int):void
        {
            if (number != next)
            {
                next = number;
                _starts.push(triangle);
                _runs.push(number);
            }
        }

        /** Lists the numbers, when all triangles are known. If none has a number, there are no names either. @param count the number of triangles */
        public function close(count:int):void
        {
            var list:Vector.<int> = _runs.length == 1 ? null : new Vector.<int>(count, true);
            var isUsed:Boolean = false;
            _starts.push(count);
            for (var run:int = 0; run < _runs.length && list != null; run++)
            {
                var number:int = _runs[run];
                var end:int = _starts[run + 1];
                isUsed ||= number >= 0 && _starts[run] < end;
                for (var i:int = _starts[run]; i < end; i++)
                {
                    list[i] = number;
                }
            }
            numbers = isUsed ? list : null;
            names = isUsed ? names : null;
            _starts = _runs = null;
        }

        /** The number of a triangle; -1 if it has none. */
        public function numberOf(triangle:int):int
        {
            return numbers == null ? -1 : numbers[triangle];
        }

        /** The name of a number; null if it has none. */
        public function nameOf(number:int):String
        {
            return names == null || number < 0 || number >= names.length ? null : names[number];
        }
    }
}
