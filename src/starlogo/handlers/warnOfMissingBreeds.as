package starlogo.handlers
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.warn;
    import starlogo.engine;
    import starlogo.search.BreedInterests;

    use namespace engine;

    /**
     * Warns if a breed that new handlers or blocks name is probably misspelled: no agent has it, and agents have a breed of a similar name, or its name is
     * their shape's. Agents of the breed may still come, so nothing is refused. An agents' breed that a handler names is not what another name means,
     * unless the two differ by case or by a plural's s alone. Of many such breeds only the first are looked at. The ES module has its own
     * version, the same as that of <code>warnOfBreeds()</code>.
     *
     * @param names the breeds that new handlers of the frame name, or the one that a block names
     * @param agents the frame's agents, not yet checked: one may be null
     * @param interests the breeds that all handlers name; null for a block's breed
     * @private
     */
    public function warnOfMissingBreeds(names:Vector.<String>, agents:Vector.<Agent>, interests:BreedInterests):void
    {
        if (names.length == 0 || agents.length == 0)
        {
            return;
        }
        // handlers may name the ground and the edges too
        var isThere:Vector.<Boolean> = breedsAmong(agents);
        isThere[Breeds.NAMES.knownNumberOf(Breeds.TERRAIN)] = true;
        isThere[Breeds.NAMES.knownNumberOf(Breeds.EDGE)] = true;
        // a few, because each is compared with all breeds and agents
        var maxHints:int = 20;
        var missing:Vector.<String> = new Vector.<String>();
        for (var i:int = 0; i < names.length && missing.length < maxHints; i++)
        {
            // a name that only a block has named has no number
            var known:int = Breeds.NAMES.knownNumberOf(names[i]);
            if ((known < 0 || !isThere[known]) && missing.indexOf(names[i]) < 0)
            {
                missing.push(names[i]);
            }
        }
        for each (var name:String in missing)
        {
            var hint:String = BreedHints.hintFor(name, isThere, agents, interests);
            if (hint != null)
            {
                warn("no agent is of the breed \"" + name + "\"" + hint);
            }
        }
    }
}
