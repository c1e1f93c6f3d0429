package starlogo.geometry
{
    /**
     * Throws a RangeError if one of three numbers is not in the world: not a number, or beyond Agent.LARGEST_COORDINATE. Everything that a
     * game passes goes through it: points, places, motions, and the middles and the half lengths of structures. It is short, so V8 inlines it.
     *
     * @param what names the numbers in the message
     * @param x a coordinate; y and z are others, or 0
     * @param owner the agent whose numbers they are, which the message names; null if they are no agent's
     * @private
     */
    public function requireInWorld(what:String, x:Number, y:Number, z:Number, owner:Object = null):void
    {
        if (!isInWorld(x, y, z))
        {
            throw outsideWorldError(what, x, y, z, owner);
        }
    }
}
