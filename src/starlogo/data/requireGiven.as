package starlogo.data
{
    /**
     * Throws an ArgumentError if an argument is null.
     *
     * @param what names it in the message
     * @private
     */
    public function requireGiven(what:String, value:Object):void
    {
        if (value == null)
        {
            throw new ArgumentError(what + " must not be null");
        }
    }
}
