package starlogo.terrain
{
    import starlogo.agents.Breeds;
    import starlogo.search.EdgePairTests;
    import starlogo.search.NarrowPhase;
    import starlogo.search.PairTests;
    import starlogo.search.WorldAgent;

    /** Stands for the edges of the world. */
    internal final class EdgeAgent extends WorldAgent
    {
        public function EdgeAgent()
        {
            super(Breeds.EDGE);
        }

        /** @inheritDoc */
        override public function newTests(narrowPhase:NarrowPhase):PairTests
        {
            return new EdgePairTests(narrowPhase);
        }
    }
}
