package starlogo.data
{
    /**
     * The index of the last of ascending numbers that is not greater than a value; 0 if all are greater. For example the key of an animation that
     * counts at a time.
     *
     * @param numbers at least one, in ascending order
     * @param value a finite number
     *
     * @private
     */
    public function lastAtMost(numbers:Vector.<Number>, value:Number):int
    {
        var low:int = 0;
        var high:int = numbers.length - 1;
        while (low < high)
        {
            var middle:int = (low + high + 1) >> 1;
            if (numbers[middle] <= value)
            {
                low = middle;
            }
            else
            {
                high = middle - 1;
            }
        }
        return low;
    }
}
