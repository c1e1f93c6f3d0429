package starlogo.search
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;
    import starlogo.intersection.ray.Ray;

    use namespace engine;

    /**
     * The agent that stands for the ground or for the edges of the world. Neither its place nor its other traits count. It brings the tests of
     * pairs with it, so a game without ground or edges does not load their code.
     *
     * @private
     */
    public class WorldAgent extends Agent
    {
        /** The heights of the ground that it stands for, or null. */
        public var grid:HeightGrid = null;

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

        /** Creates the tests of pairs with what it stands for. */
        public function newTests(narrowPhase:NarrowPhase):PairTests
        {
            return null;
        }

        /** Whether a ray meets the ground. If it does, the ray ends there, and has the normal. */
        public function isMet(ray:Ray):Boolean
        {
            return false;
        }
    }
}
