package starlogo.search
{
    import starlogo.engine;

    use namespace engine;

    /**
     * Keeps the ground and the edges of the world as a frame has seen them while its handlers run. A change of the ground makes new lists of its
     * numbers, so keeping them costs nothing otherwise.
     */
    internal final class HeldWorld
    {
        // By row: what stands for the ground and for the edges while they are held.
        private var _kept:Vector.<WorldAgent> = new <WorldAgent>[null, null];

        // Whether another frame held the ground before.
        private var _wasHeld:Boolean;

        /** Keeps the ground and the edges of a table as they are now: its tests see them so. */
        public function hold(table:AgentTable, narrowPhase:NarrowPhase):void
        {
            for (var row:int = ListedAgents.GROUND; row <= ListedAgents.EDGES; row++)
            {
                var fixture:WorldAgent = table.list.agents[row] as WorldAgent;
                if (fixture == null)
                {
                    continue;
                }
                // its own agent brings the tests
                narrowPhase.testsOfFixture(table.bodyOf(row));
                var kept:WorldAgent = _kept[row] ||= new WorldAgent(fixture.breed);
                kept.edges = fixture.edges;
                if (fixture.grid != null)
                {
                    kept.grid = fixture.grid.copyInto(kept.grid);
                    _wasHeld = fixture.grid.isHeld;
                    fixture.grid.isHeld = true;
                }
                table.shapes[row].fixture = kept;
            }
        }

        /** Lets go of them. From now on the tests see them as they are. */
        public function release(table:AgentTable):void
        {
            for (var row:int = ListedAgents.GROUND; row <= ListedAgents.EDGES; row++)
            {
                var fixture:WorldAgent = table.list.agents[row] as WorldAgent;
                if (fixture == null || table.shapes[row].fixture === fixture)
                {
                    continue;
                }
                table.shapes[row].fixture = fixture;
                if (fixture.grid != null)
                {
                    fixture.grid.isHeld = _wasHeld;
                }
            }
        }
    }
}
