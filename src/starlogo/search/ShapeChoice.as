package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Says which shape represents an agent in a Collider. Abstract; a game that wants other shapes than the engine's four colliders have extends it.
     *
     * <p>All else comes with the Collider: bins, sweeping, contacts, questions, snapshots and statistics.</p>
     */
    public class ShapeChoice
    {
        /** Has the models; null if none are needed. */
        public var greatLand:GreatLand;

        /**
         * For subclasses only.
         *
         * @param greatLand has the models
         * @param isNeeded whether there has to be one
         * @throws ArgumentError if it is null, but needed
         */
        public function ShapeChoice(greatLand:GreatLand, isNeeded:Boolean = true)
        {
            if (greatLand == null && isNeeded)
            {
                throw new ArgumentError("greatLand must not be null");
            }
            this.greatLand = greatLand;
        }

        /**
         * A number for each of the shapes that one model may have: agents with the same model and the same number share a shape. It may depend on
         * the traits <code>hierarchical</code> and <code>collideAs</code>.
         *
         * @param agent not null
         */
        public function kindOf(agent:Agent):int
        {
            return Agent.ANY_KIND;
        }

        /** @private Gives the pairs what answers for trees. Only choices that have trees override it, so other games do not load that code. */
        engine function prepare(pairs:RowPairs):void
        {
        }

        /**
         * Finds the shape of a model.
         *
         * @param shape has the model's name and the kind; its setStructure() takes the shape
         * @param agent has the model, which was added to the GreatLand
         * @throws ArgumentError if what is needed was not loaded
         */
        public function bind(shape:ModelShape, agent:Agent):void
        {
            throw new IllegalOperationError(this + " does not implement bind");
        }
    }
}
