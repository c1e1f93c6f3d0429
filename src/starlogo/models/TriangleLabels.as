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

        /** The number of each triangle, -1 for none. Null after <code>close()</code> if no triangle has one. */
        public var numbers:Vector.<int> = new Vector.<int>();

        /** The number of the triangles that come after those in the list. */
        public var next:int = -1;

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

        /** Gives a number to all triangles from one on. Those before it keep the number that they have. */
        public function beginRun(number:int, triangle:int):void
        {
            if (number != next)
            {
                fill(triangle);
                next = number;
            }
        }

        /** Adds triangles to the list, up to one. While no triangle has a number, the list stays empty. */
        public function fillTo(end:int):void
        {
            if (next >= 0 || numbers.length > 0)
            {
                fill(end);
            }
        }

        /** Ends the list. If no triangle has a number, it becomes null, and so do the names. */
        public function close():void
        {
            for each (var number:int in numbers)
            {
                if (number >= 0)
                {
                    numbers.fixed = true;
                    return;
                }
            }
            numbers = null;
            names = null;
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

        private function fill(end:int):void
        {
            for (var i:int = numbers.length; i < end; i++)
            {
                numbers[i] = next;
            }
        }
    }
}
