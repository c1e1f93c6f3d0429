package starlogo.models
{
    /**
     * Which material or mesh each triangle of a file has: runs of triangles that follow one another and have the same number.
     *
     * @private
     */
    public final class TriangleRuns
    {
        /** The name of each number; null if it has none. */
        public var names:Vector.<String> = new Vector.<String>();

        /** For each run, its first triangle. */
        public var starts:Vector.<int> = new Vector.<int>();

        /** For each run, the number of its triangles; -1 for none. */
        public var numbers:Vector.<int> = new Vector.<int>();

        private var _known:Object = {}; // the key is "#" and the key
        private var _run:int = 0;

        /** The number of a key. A new key gets the next number. @param name its name; null if it has none */
        public function numberOf(key:String, name:String):int
        {
            if (_known["#" + key] === undefined)
            {
                names.push(name);
                _known["#" + key] = names.length - 1;
            }
            return _known["#" + key];
        }

        /** Gives a number to all triangles from one on. It must not be before the last one. */
        public function begin(number:int, triangle:int):void
        {
            var last:int = starts.length - 1;
            if (number == (last < 0 ? -1 : numbers[last]))
            {
                return;
            }
            if (last >= 0 && starts[last] == triangle)
            {
                numbers[last] = number;
                return;
            }
            starts.push(triangle);
            numbers.push(number);
        }

        /** Whether no triangle has a number. @param count the number of triangles */
        public function isEmpty(count:int):Boolean
        {
            for (var i:int = 0; i < starts.length; i++)
            {
                if (numbers[i] >= 0 && starts[i] < count)
                {
                    return false;
                }
            }
            return true;
        }

        /** Writes the numbers of a range of triangles. The ranges of all calls must follow one another. */
        public function write(first:int, end:int, out:Vector.<int>):void
        {
            for (var i:int = first; i < end; i++)
            {
                while (_run < starts.length && starts[_run] <= i)
                {
                    _run++;
                }
                out[i] = _run == 0 ? -1 : numbers[int(_run - 1)];
            }
        }

        /** The runs of a list of numbers. */
        public static function of(numbers:Vector.<int>, names:Vector.<String>):TriangleRuns
        {
            var runs:TriangleRuns = new TriangleRuns();
            runs.names = names;
            for (var i:int = 0; i < numbers.length; i++)
            {
                runs.begin(numbers[i], i);
            }
            return runs;
        }
    }
}
