package starlogo.queries
{
    /**
     * Throws a RangeError if a number is negative or not a number.
     *
     * @private
     */
    public function requireNotNegative(name:String, value:Number):void
    {
        if (!(value >= 0))
        {
            throw new RangeError(name + " must be 0 or more, not " + value);
        }
    }
}
