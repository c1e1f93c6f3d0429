package starlogo.queries
{
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.hintOfName;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BoxTreeBuilder;
    import starlogo.libraries.ModelEntry;
    import starlogo.libraries.ModelStructures;
    import starlogo.libraries.ModelTable;
    import starlogo.models.Model;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.ModelShape;
    import starlogo.search.NarrowPhase;
    import starlogo.solid.ModelTree;

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

        private var _models:ModelTable = new ModelTable();

        public function LevelChoice()
        {
            super(null, LEVEL);
            narrowPhase = new NarrowPhase(this);
        }

        /** Builds the tree of a model, and prepares its triangles if it shall. It replaces what has its name. */
        public function addModel(model:Model, preparesExact:Boolean):void
        {
            var tree:ModelTree = new ModelTree(new BoxTree(model.vertices, model.triangles));
            tree.beginBuilding(BoxTreeBuilder.MOST_VERTICES_OF_LEAF, BoxTreeBuilder.MAX_DEPTH, false, preparesExact);
            tree.finishBuilding();
            _models.entryToWrite(model.name).replace(model, null, tree);
        }

        /**
         * Uses a structure as the shape with a name. It replaces what has this name.
         *
         * @throws ArgumentError if the name is null or empty, or the structure is null or not one of the engine's
         */
        public function addStructure(name:String, structure:BoundingStructure):void
        {
            ModelTable.checkName(name);
            ModelShape.requireStructure(structure);
            _models.entryToWrite(name).replace(null, ModelStructures.of(structure), null);
        }

        /** @inheritDoc */
        override engine function get revision():int
        {
            return _models.revision;
        }

        /** @inheritDoc */
        override engine function revisionOf(name:String):int
        {
            return _models.entryOf(name).revision;
        }

        /** @inheritDoc */
        override engine function modelOf(name:String):Model
        {
            return _models.entryOf(name).model;
        }

        /** @inheritDoc */
        override engine function isLoading(agent:Agent):Boolean
        {
            var entry:ModelEntry = _models.entryOf(agent.shape);
            if (entry.model == null && entry.structures == null)
            {
                throw new ArgumentError(agent + ": there is no model and no structure \"" + agent.shape + "\"; add it to the LevelShapes first"
                        + hintOfName(agent.shape, _models.names));
            }
            return false;
        }

        /** @inheritDoc */
        override public function bind(shape:ModelShape, agent:Agent):void
        {
            var entry:ModelEntry = _models.entryOf(shape.modelName);
            if (entry.structures != null)
            {
                shape.setStructure(entry.structures.tightest);
                return;
            }
            shape.setTree(entry.builtTree());
        }
    }
}
