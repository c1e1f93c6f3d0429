package support
{
    import starlogo.agents.Agent;

    /** Makes an agent at a place. */
    public function agentAt(shape:String, x:Number, y:Number, z:Number, breed:String = "turtles"):Agent
    {
        var agent:Agent = new Agent(shape, breed);
        agent.moveTo(x, y, z);
        return agent;
    }
}
