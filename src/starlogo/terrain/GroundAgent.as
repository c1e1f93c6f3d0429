package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.ground.GroundRay;
    import starlogo.ground.HeightGrid;
    import starlogo.intersection.ray.Ray;
    import starlogo.search.GroundPairTests;
    import starlogo.search.NarrowPhase;
    import starlogo.search.PairTests;
    import starlogo.search.WorldAgent;

    use namespace engine;

    /** Stands for the ground. */
    internal final class GroundAgent extends WorldAgent
    {
        private var _rays:GroundRay = new GroundRay();

        /** @param grid the heights of the ground */
        public function GroundAgent(grid:HeightGrid)
        {
            super(Breeds.TERRAIN);
            this.grid = grid;
            number = Agent.takeNumber();
        }

        /** @inheritDoc */
        override public function newTests(narrowPhase:NarrowPhase):PairTests
        {
            return new GroundPairTests(narrowPhase);
        }

        /** @inheritDoc */
        override public function isMet(ray:Ray):Boolean
        {
            return _rays.find(grid, ray);
        }
    }
}
