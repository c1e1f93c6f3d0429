package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;

    use namespace engine;

    /**
     * The agent that stands for the ground or for the edges of the world. Its revision counts the changes of these. Of its traits, only
     * its breed and isOneWay count.
     *
     * @private
     */
    public final class EnvironmentAgent extends Agent
    {
        /**
         * The ground or the edges as they are now; null if they are not known. A change makes another shape, except for a change of heights
         * that no frame holds.
         */
        public var surface:ModelShape = null;

        // The last id that was not counted.
        private static var sUncountedId:int = 0;

        /** @param breed Breeds.TERRAIN or Breeds.EDGE */
        public function EnvironmentAgent(breed:String)
        {
            // its shape's name, which errors show, is that of the breed without the asterisk. The reserved breed itself is refused there
            super(breed.substr(1));
            breedNumber = Breeds.NAMES.numberOf(breed);
        }

        /**
         * The ground or the edges as they are now.
         *
         * @throws ArgumentError if they are not known
         */
        public function requireSurface():ModelShape
        {
            if (surface == null)
            {
                throw new ArgumentError("the place of " + this + " is not known: it was exchanged before another Collision wrote the snapshot");
            }
            return surface;
        }

        /** @private An id that is not counted: the edges'. A Terrain gives its agent a counted one. */
        override engine function newId():int
        {
            return --sUncountedId;
        }

        /** Returns the heights of the ground for a change. If a frame holds the present heights, a copy takes their place. */
        public function beginChange():HeightGrid
        {
            revision++;
            var grid:HeightGrid = surface.grid.writable();
            if (grid != surface.grid)
            {
                takeGrid(grid);
            }
            return grid;
        }

        /** Gets other heights of the same cells. A frame that holds the present ones keeps them. */
        public function restoreGrid(grid:HeightGrid):void
        {
            revision++;
            takeGrid(grid);
        }

        private function takeGrid(grid:HeightGrid):void
        {
            surface = ModelShape.ofEnvironment(grid, null, surface.addEnvironmentTests);
        }
    }
}
