package starlogo.data
{
    /**
     * Warns if an object has a property that does nothing, because its name is misspelled. In ActionScript the compiler refuses such names, so
     * this does nothing. In JavaScript they are allowed, and the ES module has its own version.
     *
     * @param object an agent or a collision system
     * @private
     */
    public function warnOfUnknownProperties(object:Object):void
    {
    }
}
