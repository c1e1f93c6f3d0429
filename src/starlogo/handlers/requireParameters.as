package starlogo.handlers
{
    import starlogo.data.warnOfNoParameters;

    /**
     * Checks that a handler can be called with two agents, or with two agents and a contact. A function without named parameters passes,
     * because it may have a rest parameter. If it has none, Adobe's player cannot call it, so a line is traced. In JavaScript a function takes
     * any number of arguments. The ES module has its own version, which warns.
     *
     * @param phase CollisionHandler.EVERY_FRAME, START or END
     * @throws ArgumentError if the function has one parameter, or more than three
     *
     * @private
     */
    public function requireParameters(breed:String, otherBreed:String, callback:Function, phase:int):void
    {
        var count:int = callback.length;
        var handler:String = "the handler for \"" + breed + "\" and \"" + otherBreed + "\"";
        warnOfNoParameters(callback, handler, "collider:Agent, collidee:Agent", "void");
        if (count == 1 || count > 3)
        {
            var allowed:String = "two agents, or two agents and a contact: function(collider:Agent, collidee:Agent):void or "
                + "function(collider:Agent, collidee:Agent, contact:Contact):void";
            if (phase == CollisionHandler.END)
            {
                allowed = "two agents: function(collider:Agent, collidee:Agent):void";
            }
            throw new ArgumentError(handler + " has " + count + " parameter"
                    + (count == 1 ? "" : "s") + ", and gets " + allowed);
        }
    }
}
