package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * Which breeds agents have: by the breeds' numbers, whether an agent has the breed. Any breed counts as one that is there. An agent may be null.
     *
     * @private
     */
    public function breedsAmong(agents:Vector.<Agent>):Vector.<Boolean>
    {
        var isThere:Vector.<Boolean> = new Vector.<Boolean>(Breeds.NAMES.count);
        isThere[Breeds.ANY_NUMBER] = true;
        for (var i:int = 0; i < agents.length; i++)
        {
            if (agents[i] != null)
            {
                isThere[agents[i].breedNumber] = true;
            }
        }
        return isThere;
    }
}
