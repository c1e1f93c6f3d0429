package starlogo.search
{
    import starlogo.GreatLand;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.search.pairs.StructurePairTests;

    use namespace engine;

    /**
     * Lets a game choose the shape of each agent's model for a Collider. Extend this abstract class if none of the engine's colliders has
     * the shapes that your game wants.
     *
     * <p>The Collider adds everything else: bins, sweeping, contacts, questions, snapshots and statistics.</p>
     */
    public class ShapeChoice extends BaseShapeChoice
    {
        /**
         * For subclasses only.
         *
         * @param greatLand the models; null if the shapes need none
         * @param isNeeded whether greatLand must not be null
         * @throws ArgumentError if greatLand is null but needed
         */
        public function ShapeChoice(greatLand:GreatLand, isNeeded:Boolean = true)
        {
            super(greatLand);
            if (isNeeded)
            {
                requireGiven("greatLand", greatLand);
            }
        }

        /** @private The shapes may be structures of all kinds. */
        override engine function addTests(narrowPhase:NarrowPhase):void
        {
            StructurePairTests.addTo(narrowPhase);
        }
    }
}
