package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * The agent that stands for the ground or for the edges of the world. Neither its place nor its other traits count.
     *
     * @private
     */
    public final class WorldAgent extends Agent
    {
        /** The ground that it stands for, or null. */
        public var terrain:Terrain = null;

        /** The edges that it stands for, or null: the least and the greatest x, then y, then z. */
        public var edges:Vector.<Number> = null;

        /** @param breed Breeds.TERRAIN or Breeds.EDGE */
        public function WorldAgent(breed:String)
        {
            // the name without its asterisk
            super(breed.substr(1));
            breedNumber = Breeds.numberOf(breed);
        }

        /** @private It does not count as an agent of the game. */
        override engine function newNumber():int
        {
            return 0;
        }
    }
}
