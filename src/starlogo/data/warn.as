package starlogo.data
{
    /**
     * Says that something is probably a mistake. Nothing is refused. In ActionScript it is traced. The ES module has its own version, which
     * writes to the console, and only while a game is developed.
     *
     * @param message says what is meant, and what to do
     * @private
     */
    public function warn(message:String):void
    {
        trace("starlogo: " + message);
    }
}
