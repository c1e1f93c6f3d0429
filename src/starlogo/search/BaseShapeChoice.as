package starlogo.search
{
    import flash.errors.IllegalOperationError;
    import starlogo.data.meantOf;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.Model;

    use namespace engine;

    /**
     * Chooses the shape of each agent's model for a Collider. Each of the engine's colliders has a subclass of its own. Games extend ShapeChoice.
     */
    public class BaseShapeChoice
    {
        /** @private For <code>system</code>: a collider of the game's own. */
        engine static const OWN:int = 0;

        /** @private For <code>system</code>: a BinCollider. */
        engine static const BIN:int = 1;

        /** @private For <code>system</code>: a TightestFitCollider. */
        engine static const TIGHTEST_FIT:int = 2;

        /** @private For <code>system</code>: a HierarchicalCollider. */
        engine static const HIERARCHICAL:int = 3;

        /** @private For <code>system</code>: a CombinationCollider. */
        engine static const COMBINATION:int = 4;

        /** The models, or null if the shapes need no models. */
        public var greatLand:GreatLand;

        /**
         * For subclasses only.
         *
         * @param greatLand the models; null if the shapes need no models
         */
        public function BaseShapeChoice(greatLand:GreatLand)
        {
            this.greatLand = greatLand;
        }

        /** @private The collision system that the shapes belong to: OWN, BIN and so on. Snapshots have this number. */
        engine function get system():int
        {
            return OWN;
        }

        /**
         * @private Gives a collider's narrow phase the tests of pairs of the shapes. A game loads only the code of these tests. Shapes that only
         * questions see have none, because each kind of questions brings its own (SeenAgents.needTests).
         *
         * @throws ArgumentError if these shapes have none
         */
        engine function addTests(narrowPhase:NarrowPhase):void
        {
            throw new ArgumentError("a Collider needs a ShapeChoice, not " + this + ", which gives no tests of its shapes");
        }

        /** @private Increased whenever data of any model is replaced, removed or posed. Shapes made from the data are then void. */
        engine function get revision():int
        {
            return greatLand == null ? 0 : greatLand.revision;
        }

        /** @private The revision of one model. */
        engine function revisionOf(name:String):int
        {
            return greatLand == null ? 0 : greatLand.revisionOf(name);
        }

        /** @private The model with a name; null if there is none, or if the shapes need no models. */
        engine function modelOf(name:String):Model
        {
            return greatLand == null ? null : greatLand.modelOf(name);
        }

        /** @private Whether the model of an agent is still loading. Throws an ArgumentError if the model is unknown. */
        engine function isLoading(agent:Agent):Boolean
        {
            if (greatLand == null || greatLand.hasModel(agent.shape))
            {
                return false;
            }
            if (!greatLand.isLoading(agent.shape))
            {
                throw new ArgumentError(agent + ": there is no model \"" + agent.shape + "\"; add it to the GreatLand first"
                        + meantOf(agent.shape, greatLand.modelNames));
            }
            return true;
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
