package starlogo.data
{
    /**
     * Warns of a game's function that has no named parameters. If it has no rest parameter either, Adobe's player cannot call it with arguments. In
     * JavaScript a function takes any number of arguments. So the ES module has a version of its own, which does nothing.
     *
     * @param callback the function, or null
     * @param what what it is
     * @param parameters the parameters that it should have
     * @param result the type that it returns
     * @private
     */
    public function warnOfNoParameters(callback:Function, what:String, parameters:String, result:String):void
    {
        if (callback != null && callback.length == 0)
        {
            warn(what + " has no parameters. If it is function():" + result + ", Adobe's player throws an ArgumentError when it is called, and other "
                    + "players may not: write function(" + parameters + "):" + result + ". If it is function(...all):" + result + ", nothing is wrong");
        }
    }
}
