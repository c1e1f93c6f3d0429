package starlogo.search
{
    /**
     * A list of whole numbers whose memory is used again.
     *
     * @private
     */
    public final class NumberList
    {
        /** The numbers. After the last one, numbers may be left over from earlier lists. */
        public var numbers:Vector.<int> = new Vector.<int>();

        /** How many they are. */
        public var count:int = 0;

        /** Adds a number at the end. */
        public function add(number:int):void
        {
            numbers[count] = number;
            count++;
        }
    }
}
