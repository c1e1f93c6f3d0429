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

        // Triangles that follow one another and have the same number are a run. The first triangle of each run, and its number. close() adds the
        // number of triangles to _starts. So each run ends where the next entry begins.
        private var _starts:Vector.<int> = new <int>[0];
        private var _runs:Vector.<int> = new <int>[-1];

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

        /** The number of the triangles that come next. */
        public function get next():int
        {
            return _runs[_runs.length - 1];
        }

        /** Gives a number to all triangles from one on. It must not be before the last run. */
        public function beginRun(number:int, triangle:int):void
        {
            if (number != next)
            {
                _starts.push(triangle);
                _runs.push(number);
            }
        }

        /** Ends the last run. If then no triangle has a number, there are no names either. @param count the number of triangles */
        public function close(count:int):void
        {
            _starts.push(count);
            for (var run:int = 0; run < _runs.length; run++)
            {
                if (_runs[run] >= 0 && _starts[run] < _starts[run + 1])
                {
                    return;
                }
            }
            _runs.length = 1; // triangles before the first number have none
            names = null;
        }

        /** The number of each triangle, -1 for none, after <code>close()</code>. Always the same list. Null if no triangle has a number. */
        public function get numbers():Vector.<int>
        {
            if (_list == null && _runs.length > 1)
            {
                _list = new Vector.<int>(_starts[_runs.length], true);
                for (var i:int = 0; i < _list.length; i++)
                {
                    _list[i] = numberOf(i);
                }
            }
            return _list;
        }

        /** The number of a triangle, after <code>close()</code>; -1 if it has none. */
        public function numberOf(triangle:int):int
        {
            var low:int = 0;
            var high:int = _runs.length - 1;
            while (low < high)
            {
                var middle:int = (low + high + 1) >> 1;
                if (_starts[middle] <= triangle)
                {
                    low = middle;
                }
                else
                {
                    high = middle - 1;
                }
            }
            return _runs[low];
        }

        /** The name of a number; null if it has none. */
        public function nameOf(number:int):String
        {
            return names == null || number < 0 || number >= names.length ? null : names[number];
        }
    }
}
