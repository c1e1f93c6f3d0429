package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Lets a game choose the shape of each agent's model for a Collider. Extend this abstract class if none of the engine's four colliders has
     * the shapes that your game wants.
     *
     * <p>The Collider adds everything else: bins, sweeping, contacts, questions, snapshots and statistics.</p>
     */
    public class ShapeChoice
    {
        /** The models, or null if the shapes need no models. */
        public var greatLand:GreatLand;

        /**
         * For subclasses only.
         *
         * @param greatLand the models
         * @param isNeeded whether greatLand must not be null
         * @throws ArgumentError if greatLand is null but needed
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
         * The number of an agent's shape among the shapes that its model can have. Agents with the same model and the same number share a shape.
         * The number may depend on the traits <code>hierarchical</code> and <code>collideAs</code>.
         *
         * @param agent not null
         */
        public function kindOf(agent:Agent):int
        {
            return Agent.ANY_KIND;
        }

        /**
         * @private Gives the pairs their tests for trees. Only choices with trees override it, so a game without trees does not load that code.
         */
        engine function prepare(narrowPhase:NarrowPhase):void
        {
        }

        /**
         * Sets the shape of a model. All agents with the same model and kind use it.
         *
         * @param shape has the model's name and the kind. Call its setStructure()
         * @param agent an agent with the model; the model is in the GreatLand
         * @throws ArgumentError if the shape needs something that was not loaded
         */
        public function bind(shape:ModelShape, agent:Agent):void
        {
            throw new IllegalOperationError(this + " does not implement bind");
        }
    }
}
