package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;

    /**
     * Warns that a ray begins inside of an agent which probably sends it. Such rays may come in every frame. So in ActionScript this does nothing. The
     * ES module has its own version, which warns once.
     *
     * @param agent the agent that the ray begins in
     * @param origin where the ray begins
     * @private
     */
    public function warnOfSender(agent:Agent, origin:Vector3D):void
    {
    }
}
