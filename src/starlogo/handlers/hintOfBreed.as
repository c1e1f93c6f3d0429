package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.isProbablyMisspelt;
    import starlogo.engine;

    use namespace engine;

    /**
     * What may be meant by a breed that no agent has: a breed of a similar name, or the shape of that name. Returns null if there is neither.
     *
     * @param isThere by the number of a breed: whether a game may mean it
     * @param agents the frame's agents: one may be null
     * @private
     */
    public function hintOfBreed(name:String, isThere:Vector.<Boolean>, agents:Vector.<Agent>):String
    {
        for (var number:int = 0; number < isThere.length; number++)
        {
            var breed:String = Breeds.NAMES.nameOf(number);
            if (isThere[number] && isProbablyMisspelt(name, breed))
            {
                return "; is " + (breed == Breeds.TERRAIN ? "Collision.TERRAIN" : breed == Breeds.EDGE ? "Collision.EDGE" : "\"" + breed + "\"") + " meant?";
            }
        }
        for each (var agent:Agent in agents)
        {
            if (agent != null && agent.shape == name)
            {
                return ", which is the shape of " + agent + ": new Agent(\"" + name + "\", \"BREED\") gives it a breed";
            }
        }
        return null;
    }
}
