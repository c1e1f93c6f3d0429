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

        /** Takes the numbers of another list. */
        public function copyFrom(other:IntList):void
        {
            var end:int = other.count;
            count = 0;
            for (var i:int = 0; i < end; i++)
            {
                add(other.values[i]);
            }
        }

        /** Takes the numbers of a list, which may be this one, except for one number. */
        public function copyExcept(other:IntList, except:int):void
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
            copyExcept(this, value);
        }
    }
}
