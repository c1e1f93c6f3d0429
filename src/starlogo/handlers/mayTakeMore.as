package starlogo.handlers
{
    /**
     * Tells whether a handler with fewer than three parameters may read a third argument. In ActionScript it can't, so this is false. In
     * JavaScript it can, and the ES module has its own version.
     *
     * @private
     */
    public function mayTakeMore(handler:Function):Boolean
    {
        return false;
    }
}
