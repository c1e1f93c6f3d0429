package starlogo.data
{
    /**
     * A list of whole numbers whose memory is used again.
     *
     * @private
     */
    public final class IntList
    {
        /** The values. After the last one, values may be left over from earlier lists. */
        public var values:Vector.<int> = new Vector.<int>();

        /** How many numbers there are. */
        public var count:int = 0;

        /** Takes the numbers of another list, except for one; -1 takes all. */
        public function copyFrom(other:IntList, except:int = -1):void
        {
            var end:int = other.count;
            count = 0;
            for (var i:int = 0; i < end; i++)
            {
                if (other.values[i] != except)
                {
                    add(other.values[i]);
                }
            }
        }

        /** Adds a number at the end. */
        public function add(value:int):void
        {
            values[count] = value;
            count++;
        }

        /** Removes a number wherever it is in the list. The others keep their order. */
        public function remove(value:int):void
        {
            copyFrom(this, value);
        }
    }
}
