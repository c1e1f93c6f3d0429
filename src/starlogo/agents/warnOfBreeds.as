package starlogo.agents
{
    /**
     * Warns if a breed that a filter names is probably misspelled, because only a breed of a similar name has agents. Every question calls this. So
     * in ActionScript it does nothing. The ES module has its own version, for games that are developed.
     *
     * @param names the breeds; null for none
     * @param agents the agents that there are; null for a free row
     * @private
     */
    public function warnOfBreeds(names:Vector.<String>, agents:Vector.<Agent>):void
    {
    }
}
