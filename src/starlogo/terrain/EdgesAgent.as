package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * The agent that stands for the edges of the world. Neither its place nor its other traits count.
     *
     * @private
     */
    public final class EdgesAgent extends Agent
    {
        /** The edges: the least and the greatest x, then y, then z. */
        public var edges:Vector.<Number> = new Vector.<Number>(6, true);

        /** Begins with all edges at 0. */
        public function EdgesAgent()
        {
            super("edge");
            giveIdBack();
            takeBreed(Breeds.EDGE);
        }
    }
}
