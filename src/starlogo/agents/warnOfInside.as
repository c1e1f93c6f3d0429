package starlogo.agents
{
    import starlogo.agents.Agent;

    /**
     * Warns that an agent does not stop a motion, because the motion begins deep inside of it. Such motions may come in every frame. So in
     * ActionScript this does nothing. The ES module has its own version, which warns once.
     *
     * @param agent collides as its tree or its triangles
     * @private
     */
    public function warnOfInside(agent:Agent):void
    {
    }
}
