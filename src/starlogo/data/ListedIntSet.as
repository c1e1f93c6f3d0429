package starlogo.data
{
    /**
     * A set of small whole numbers that also lists them.
     *
     * @private
     */
    public final class ListedIntSet extends IntSet
    {
        /** The numbers, in the order in which they were added. Read only. */
        public var list:IntList = new IntList();

        /** @inheritDoc */
        override public function clear(length:int):void
        {
            super.clear(length);
            list.count = 0;
        }

        /** @inheritDoc */
        override public function add(number:int):Boolean
        {
            var isNew:Boolean = super.add(number);
            if (isNew)
            {
                list.add(number);
            }
            return isNew;
        }

        /** Adds the numbers of a list. */
        public function addAll(numbers:IntList):void
        {
            for (var i:int = 0; i < numbers.count; i++)
            {
                add(numbers.values[i]);
            }
        }
    }
}
