package starlogo.handlers
{
    /**
     * Tells whether a handler may read a third argument. In JavaScript, functions without three parameters can, too. The ES module has its own
     * version.
     *
     * @private
     */
    public function mayTakeContact(callback:Function):Boolean
    {
        return callback.length >= 3;
    }
}
