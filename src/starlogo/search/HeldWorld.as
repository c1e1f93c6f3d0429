package starlogo.search
{
    import starlogo.engine;
    import starlogo.search.table.AgentTable;
    import starlogo.search.table.ListedAgents;

    use namespace engine;

    /**
     * Keeps the ground and the edges of the world as a frame has seen them while its handlers run. A change of the ground makes new lists of its
     * numbers, so keeping them costs nothing otherwise.
     */
    internal final class HeldWorld
    {
        // By row: what stands for the ground and for the edges while they are held.
        private var _heldAgents:Vector.<WorldAgent> = new <WorldAgent>[null, null];

        // Whether another frame held the ground before.
        private var _wasHeld:Boolean;

        /** Keeps the ground and the edges of a table as they are now: its tests see them so. */
        public function hold(table:AgentTable):void
        {
            for (var row:int = ListedAgents.GROUND_ROW; row <= ListedAgents.EDGES_ROW; row++)
            {
                var worldAgent:WorldAgent = table.list.agents[row] as WorldAgent;
                if (worldAgent == null)
                {
                    continue;
                }
                var held:WorldAgent = _heldAgents[row] ||= new WorldAgent(worldAgent.breed, worldAgent.addTests);
                held.edges = worldAgent.edges;
                if (worldAgent.grid != null)
                {
                    held.grid = worldAgent.grid.copyInto(held.grid);
                    _wasHeld = worldAgent.grid.isHeld;
                    worldAgent.grid.isHeld = true;
                }
                table.shapes[row].worldAgent = held;
            }
        }

        /** Lets go of them. From now on the tests see them as they are. */
        public function release(table:AgentTable):void
        {
            for (var row:int = ListedAgents.GROUND_ROW; row <= ListedAgents.EDGES_ROW; row++)
            {
                var worldAgent:WorldAgent = table.list.agents[row] as WorldAgent;
                if (worldAgent == null || table.shapes[row].worldAgent === worldAgent)
                {
                    continue;
                }
                table.shapes[row].worldAgent = worldAgent;
                if (worldAgent.grid != null)
                {
                    worldAgent.grid.isHeld = _wasHeld;
                }
            }
        }
    }
}
