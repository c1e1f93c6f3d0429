package starlogo.data
{
    /**
     * Whether all numbers of a list are finite.
     *
     * @private
     */
    public function areFinite(numbers:Vector.<Number>):Boolean
    {
        for each (var number:Number in numbers)
        {
            if (!isFinite(number))
            {
                return false;
            }
        }
        return true;
    }
}
