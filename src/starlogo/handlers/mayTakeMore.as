package starlogo.handlers
{
    /**
     * Whether a handler that takes fewer than three arguments may look at a third: none does in ActionScript, where it would have to say so. The
     * ES module has its own answer.
     *
     * @private
     */
    public function mayTakeMore(handler:Function):Boolean
    {
        return false;
    }
}
