package starlogo.data
{
    /**
     * A set of small whole numbers, from 0 on. It is emptied at once, however many numbers it has.
     *
     * @private
     */
    public class IntSet
    {
        /** By number: the mark of the last set that had it. A loop may compare it with <code>mark</code> in place of <code>has()</code>. Read only. */
        public var marks:Vector.<int> = new Vector.<int>();

        /** The mark of the numbers that are in the set. Read only. */
        public var mark:int = 1;

        /**
         * Empties the set.
         *
         * @param length numbers that are less than this may be added
         */
        public function clear(length:int):void
        {
            if (mark == int.MAX_VALUE)
            {
                marks.length = mark = 0;
            }
            mark++;
            grow(length);
        }

        /** Makes room for numbers that are less than a length. */
        public function grow(length:int):void
        {
            makeRoom(marks, length);
        }

        /** Adds a number. Returns whether it was not in the set. */
        public function add(number:int):Boolean
        {
            var isNew:Boolean = marks[number] != mark;
            marks[number] = mark;
            return isNew;
        }

        /** Whether a number is in the set. */
        public function has(number:int):Boolean
        {
            return marks[number] == mark;
        }
    }
}
