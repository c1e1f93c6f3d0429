package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;

    use namespace engine;

    /**
     * The agent that stands for the ground or for the edges of the world. Its place counts only for rounding. Of its other traits, its breed
     * and isOneWay count. It adds the tests of pairs with it to a narrow phase, so a game without ground or edges does not load their code.
     *
     * @private
     */
    public final class WorldAgent extends Agent
    {
        /** The heights of the ground that it stands for, or null. */
        public var grid:HeightGrid = null;

        /** The edges that it stands for, or null: the least and the greatest x, then y, then z. */
        public var edges:Vector.<Number> = null;

        /** Adds the tests of pairs with it to a narrow phase: <code>function(narrowPhase:NarrowPhase):void</code>; null if there are none. */
        public var addTests:Function;

        // The number of agents without a counted id: those of edges, and the copies that hold() makes.
        private static var sUncounted:int = 0;

        private var _edgesRevision:int = 0;

        /**
         * @param breed Breeds.TERRAIN or Breeds.EDGE
         * @param addTests adds the tests of pairs with it to a narrow phase; null if there are none
         */
        public function WorldAgent(breed:String, addTests:Function = null)
        {
            // the name without its asterisk
            super(breed.substr(1));
            breedNumber = Breeds.numberOf(breed);
            this.addTests = addTests;
        }

        /** @private An id that is not counted: the edges', and held copies'. A Terrain gives its agent a counted one. */
        override engine function newId():int
        {
            sUncounted++;
            return -sUncounted;
        }

        /** Sets the edges that it stands for. */
        public function setEdges(value:Vector.<Number>):void
        {
            edges = value;
            _edgesRevision++;
        }

        /**
         * Returns a copy with the heights or the edges as they are now, until <code>release()</code>. If the ground changes in the meantime, it makes new
         * lists of its numbers. Otherwise this costs nothing.
         *
         * @param copy a copy of this agent or of another one of the kind, which is used again; null for a new one
         */
        public function hold(copy:WorldAgent):WorldAgent
        {
            copy ||= new WorldAgent(breed, addTests);
            copy.edges = edges;
            if (grid != null)
            {
                copy.grid = grid.copyInto(copy.grid);
                // another frame may hold the ground already
                copy.grid.isHeld = grid.isHeld;
                grid.isHeld = true;
            }
            return copy;
        }

        /** Lets go of a copy that <code>hold()</code> has returned. */
        public function release(copy:WorldAgent):void
        {
            if (grid != null)
            {
                grid.isHeld = copy.grid.isHeld;
            }
        }

        /** Another number after each change of the heights or of the edges. */
        public function get surfaceRevision():int
        {
            return grid == null ? _edgesRevision : grid.revision;
        }

        /** Whether it stands for the ground. */
        public function get isGround():Boolean
        {
            return Breeds.isGround(breedNumber);
        }
    }
}
