package starlogo.agents
{
    /**
     * Gives each name a number, so that frames and questions need not compare text. A name keeps its number as long as the program runs.
     *
     * @private
     */
    public final class NameNumbers
    {
        // The names by number; the numbers in the order of their names. A binary search in it needs no key, so it allocates no text.
        private var _names:Vector.<String> = new Vector.<String>();
        private var _order:Vector.<int> = new Vector.<int>();

        /** @param first the names that have the first numbers */
        public function NameNumbers(first:Vector.<String>)
        {
            for (var i:int = 0; i < first.length; i++)
            {
                numberOf(first[i]);
            }
        }

        /** The number of names so far. */
        public function get count():int
        {
            return _names.length;
        }

        /** The number of a name, from 0. A new name gets the next number. */
        public function numberOf(name:String):int
        {
            var number:int = knownNumberOf(name);
            if (number >= 0)
            {
                return number;
            }
            _order.splice(countBefore(name), 0, _names.length);
            return _names.push(name) - 1;
        }

        /** The number of a name; -1 if it has none yet. */
        public function knownNumberOf(name:String):int
        {
            var index:int = countBefore(name);
            return index < _order.length && _names[_order[index]] == name ? _order[index] : -1;
        }

        /** The name for a number. */
        public function nameOf(number:int):String
        {
            return _names[number];
        }

        // How many names come before a name in _order.
        private function countBefore(name:String):int
        {
            var low:int = 0;
            var high:int = _order.length;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (_names[_order[middle]] < name)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle;
                }
            }
            return low;
        }
    }
}
