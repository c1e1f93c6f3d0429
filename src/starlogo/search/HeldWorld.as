package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;

    use namespace engine;

    /**
     * Keeps the ground and the edges of the world as a frame has seen them while its handlers run. A change of the ground makes new lists of its
     * numbers, so keeping them costs nothing otherwise.
     */
    internal final class HeldWorld
    {
        // The ground's grid, or null; the values that exchange() swaps with the grid's; and whether another frame held it before.
        private var _grid:HeightGrid = null;
        private var _heights:Vector.<Number>;
        private var _bounds:Vector.<Number>;
        private var _isBlocky:Boolean;
        private var _wasHeld:Boolean;

        // The agent of the edges, or null, and what is exchanged.
        private var _agent:WorldAgent = null;
        private var _edges:Vector.<Number>;

        /** Keeps them as they are now. Each of the two agents may be null. */
        public function hold(ground:Agent, edges:Agent):void
        {
            release();
            if (ground != null)
            {
                var fixture:WorldAgent = WorldAgent(ground);
                var grid:HeightGrid = fixture.grid;
                _grid = grid;
                _heights = grid.heights;
                _bounds = grid.bounds;
                _isBlocky = grid.isBlocky;
                _wasHeld = grid.isHeld;
                grid.isHeld = true;
            }
            if (edges != null)
            {
                fixture = WorldAgent(edges);
                _agent = fixture;
                _edges = fixture.edges;
            }
        }

        /** Lets go of them. */
        public function release():void
        {
            if (_grid != null)
            {
                _grid.isHeld = _wasHeld;
            }
            _grid = null;
            _agent = null;
            _heights = _bounds = _edges = null;
        }

        /** Swaps the held values and the present ones. The second call swaps them back. */
        public function exchange():void
        {
            var grid:HeightGrid = _grid;
            if (grid != null)
            {
                var heights:Vector.<Number> = grid.heights;
                var bounds:Vector.<Number> = grid.bounds;
                var isBlocky:Boolean = grid.isBlocky;
                grid.heights = _heights;
                grid.bounds = _bounds;
                grid.isBlocky = _isBlocky;
                _heights = heights;
                _bounds = bounds;
                _isBlocky = isBlocky;
            }
            if (_agent != null)
            {
                var edges:Vector.<Number> = _agent.edges;
                _agent.edges = _edges;
                _edges = edges;
            }
        }
    }
}
