package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.data.hintOfName;
    import starlogo.engine;
    import starlogo.libraries.ModelEntry;
    import starlogo.libraries.ModelTable;
    import starlogo.models.Model;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.ModelShape;
    import starlogo.search.NarrowPhase;

    use namespace engine;

    /**
     * The shapes of a LevelShapes. Under each name there is a model, whose tree is the shape, or a structure. Nothing is fitted, so a game loads no
     * fitter.
     *
     * @private
     */
    public final class LevelChoice extends BaseShapeChoice
    {
        /** The tests of its shapes, with the limits for trees: for questions and colliders alike. Each brings the tests that it needs. */
        public var narrowPhase:NarrowPhase;

        /** The models and structures by name. The LevelShapes adds them. */
        public var models:ModelTable = new ModelTable();

        public function LevelChoice()
        {
            super(null);
            systemName = "a LevelCollider";
            narrowPhase = new NarrowPhase(this);
        }

        /** @inheritDoc */
        override engine function get revision():int
        {
            return models.revision;
        }

        /** @inheritDoc */
        override engine function revisionOf(name:String):int
        {
            return models.entryOf(name).revision;
        }

        /** @inheritDoc */
        override engine function modelOf(name:String):Model
        {
            return models.entryOf(name).model;
        }

        /** @inheritDoc */
        override engine function isLoading(agent:Agent):Boolean
        {
            var entry:ModelEntry = models.entryOf(agent.shape);
            if (entry.model == null && entry.structures == null)
            {
                throw new ArgumentError(agent + ": there is no model and no structure \"" + agent.shape + "\"; add it to the LevelShapes first"
                        + hintOfName(agent.shape, models.names, agent.breed));
            }
            return false;
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            var entry:ModelEntry = models.entryOf(shape.modelName);
            if (entry.structures != null)
            {
                shape.setStructure(entry.structures.tightest);
                return;
            }
            shape.setTree(entry.builtTree());
        }
    }
}
