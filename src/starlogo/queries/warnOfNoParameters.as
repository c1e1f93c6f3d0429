package starlogo.queries
{
    import starlogo.data.warn;

    /**
     * Warns if the function of a filter has no parameters. In JavaScript a function takes any number of arguments. So the ES module has a version
     * of its own, which does nothing.
     *
     * @private
     */
    public function warnOfNoParameters(accepts:Function):void
    {
        if (accepts != null && accepts.length == 0)
        {
            warn("accepts of a filter has no parameters. If it is function():Boolean, Adobe's player throws an ArgumentError when it is called, and "
                    + "other players may not: write function(agent:Agent):Boolean. If it is function(...all):Boolean, nothing is wrong");
        }
    }
}
