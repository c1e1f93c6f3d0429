package starlogo.geometry
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Throws a RangeError if one of three numbers is not in the world: not a number, or beyond Agent.LARGEST_COORDINATE. Everything that a
     * game passes goes through it: points, places, motions, and the middles and the half lengths of structures.
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
            var most:Number = Placement.LARGEST_COORDINATE;
            // the largest one, because an infinite coordinate of a structure makes others NaN
            var wrong:Number = NaN;
            for each (var value:Number in [x, y, z])
            {
                wrong = Math.abs(value) > most && !(Math.abs(value) <= Math.abs(wrong)) ? value : wrong;
            }
            throw new RangeError((owner == null ? "" : owner + ": ") + what + " must be between " + -most + " and " + most + ", a finite number: " + wrong);
        }
    }
}
