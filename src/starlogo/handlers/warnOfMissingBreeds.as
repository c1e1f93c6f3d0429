package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.areSimilar;
    import starlogo.data.warn;

    /**
     * Warns if a breed that new handlers name is probably misspelled: no agent has it, and agents have a breed of a similar name, or its name is
     * their shape's. Agents of the breed may still come, so nothing is refused. The ES module has its own version, the same as that of
     * <code>warnOfBreeds()</code>.
     *
     * @param names the breeds that the frame's new handlers name
     * @param agents the frame's agents, not yet checked: one may be null
     * @private
     */
    public function warnOfMissingBreeds(names:Vector.<String>, agents:Vector.<Agent>):void
    {
        if (names.length == 0 || agents.length == 0)
        {
            return;
        }
        var breeds:Vector.<String> = new Vector.<String>();
        for each (var agent:Agent in agents)
        {
            if (agent != null && breeds.indexOf(agent.breed) < 0)
            {
                breeds.push(agent.breed);
            }
        }
        breeds.push(Breeds.TERRAIN, Breeds.EDGE);
        for each (var name:String in names)
        {
            if (breeds.indexOf(name) >= 0)
            {
                continue;
            }
            var hint:String = "";
            for each (agent in agents)
            {
                if (agent != null && agent.shape == name)
                {
                    hint = ", which is the shape of " + agent + ": new Agent(\"" + name + "\", \"BREED\") gives it a breed";
                    break;
                }
            }
            for each (var breed:String in breeds)
            {
                if (areSimilar(name, breed))
                {
                    hint = "; is " + (breed == Breeds.TERRAIN ? "Collision.TERRAIN" : breed == Breeds.EDGE ? "Collision.EDGE" : "\"" + breed + "\"") + " meant?";
                    break;
                }
            }
            if (hint != "")
            {
                warn("no agent is of the breed \"" + name + "\"" + hint);
            }
        }
    }
}
