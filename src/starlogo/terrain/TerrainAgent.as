package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * The agent that stands for a terrain. Its place is the place of the terrain's first height. Neither its place nor its other traits count.
     *
     * @private
     */
    public final class TerrainAgent extends Agent
    {
        /** The ground that it stands for. */
        public var terrain:Terrain;

        /** @param terrain the ground */
        public function TerrainAgent(terrain:Terrain)
        {
            super("terrain");
            this.terrain = terrain;
            takeBreed(Breeds.TERRAIN);
            moveTo(terrain.x, terrain.y, 0);
        }
    }
}
