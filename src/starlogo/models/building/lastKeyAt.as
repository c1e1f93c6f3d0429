package starlogo.models.building
{
    /**
     * The index of the last key of an animation that is not after a time. Before the first key it is the first.
     *
     * @param times the times of the keys, at least one, in ascending order
     * @param time a finite time
     *
     * @private
     */
    public function lastKeyAt(times:Vector.<Number>, time:Number):int
    {
        var low:int = 0;
        var high:int = times.length - 1;
        while (low < high)
        {
            var middle:int = (low + high + 1) >> 1;
            if (times[middle] <= time)
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
