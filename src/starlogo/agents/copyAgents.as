package starlogo.agents
{
    /**
     * Copies a list of agents into another one. If both are the same list, the copy is a new one.
     *
     * @param to is overwritten
     * @return the copy
     * @private
     */
    public function copyAgents(from:Vector.<Agent>, to:Vector.<Agent>):Vector.<Agent>
    {
        var copy:Vector.<Agent> = from === to ? new Vector.<Agent>() : to;
        copy.length = from.length;
        for (var i:int = 0; i < from.length; i++)
        {
            // writing a reference costs more than comparing it
            if (copy[i] !== from[i])
            {
                copy[i] = from[i];
            }
        }
        return copy;
    }
}
