package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.geometry.requireInWorld;

    /**
     * Throws a RangeError that names the first of a motion's numbers that is not in the world.
     *
     * @param asker the agent that moves, which the message names; null if a structure does
     * @private
     */
    public function requireMotion(dx:Number, dy:Number, dz:Number, asker:Agent):void
    {
        requireInWorld("dx of a motion", dx, 0, 0, asker);
        requireInWorld("dy of a motion", 0, dy, 0, asker);
        requireInWorld("dz of a motion", 0, 0, dz, asker);
    }
}
