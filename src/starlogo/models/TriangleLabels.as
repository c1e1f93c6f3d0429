package starlogo.models
{
    /**
     * The material or the mesh of each triangle: a number, which may have a name. Triangles that follow one another and have the same
     * number are a run.
     *
     * @private
     */
    public final class TriangleLabels
    {
        /** The name of each number, or null for a number without a name. Null if nothing gives names. */
        public var names:Vector.<String>;

        /** The first triangle of each run. Triangles before the first run have the number -1. */
        public var starts:Vector.<int> = new Vector.<int>();

        /** The number of each run; -1 for none. */
        public var numbers:Vector.<int> = new Vector.<int>();

        // The number of each key. A "#" stands before a key, so that none is the name of a property that every Object has.
        private var _known:Object = {};

        // The number of each triangle, after it was first needed.
        private var _list:Vector.<int> = null;

        /** Labels without runs. @param names the name of each number so far; kept; null if nothing will give names */
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
            var last:int = starts.length - 1;
            if (last >= 0 && starts[last] == triangle)
            {
                numbers[last] = number;
            }
            else if (number != (last < 0 ? -1 : numbers[last]))
            {
                starts.push(triangle);
                numbers.push(number);
            }
        }

        /** Drops runs beyond the last triangle, and the names if then no triangle has a number. @param count the number of triangles */
        public function trim(count:int):void
        {
            while (starts.length > 0 && starts[starts.length - 1] >= count)
            {
                starts.pop();
                numbers.pop();
            }
            for each (var number:int in numbers)
            {
                if (number >= 0)
                {
                    return;
                }
            }
            starts.length = numbers.length = 0;
            names = null;
        }

        /** Whether no triangle has a number. Of trimmed labels. */
        public function get isEmpty():Boolean
        {
            return starts.length == 0;
        }

        /** Reverses the order of the triangles. Of trimmed labels. @param count the number of triangles */
        public function reverse(count:int):void
        {
            var oldStarts:Vector.<int> = starts;
            var oldNumbers:Vector.<int> = numbers;
            starts = new Vector.<int>();
            numbers = new Vector.<int>();
            var end:int = count;
            for (var i:int = oldStarts.length - 1; i >= 0; i--)
            {
                beginRun(oldNumbers[i], count - end);
                end = oldStarts[i];
            }
            if (end > 0)
            {
                beginRun(-1, count - end);
            }
        }

        /** The number of each triangle, as a list. Always the same list. Null if no triangle has a number. @param count the number of triangles */
        public function list(count:int):Vector.<int>
        {
            if (_list == null && !isEmpty)
            {
                _list = new Vector.<int>(count, true);
                for (var i:int = 0; i < count; i++)
                {
                    _list[i] = numberOf(i);
                }
            }
            return _list;
        }

        /** The number of a triangle; -1 if it has none. */
        public function numberOf(triangle:int):int
        {
            var low:int = -1;
            var high:int = starts.length;
            // the last run that does not begin after the triangle
            while (low + 1 < high)
            {
                var middle:int = (low + high) >> 1;
                if (starts[middle] <= triangle)
                {
                    low = middle;
                }
                else
                {
                    high = middle;
                }
            }
            return low < 0 ? -1 : numbers[low];
        }

        /** The name of a number; null if it has none. */
        public function nameOf(number:int):String
        {
            return names == null || number < 0 || number >= names.length ? null : names[number];
        }
    }
}
