package starlogo.data
{
    /**
     * Whether two lists of numbers are the same to the last bit, including the sign of zeros.
     *
     * @private
     */
    public function areSameNumbers(a:Vector.<Number>, b:Vector.<Number>):Boolean
    {
        for (var i:int = 0; i < a.length && a.length == b.length; i++)
        {
            if (a[i] != b[i] || a[i] == 0 && 1 / a[i] != 1 / b[i])
            {
                return false;
            }
        }
        return a.length == b.length;
    }
}
