package starlogo.queries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.collision.QuerySource;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BoxTreeBuilder;
    import starlogo.libraries.ModelStructures;
    import starlogo.libraries.ModelTable;
    import starlogo.models.Model;
    import starlogo.search.ModelShape;
    import starlogo.search.NarrowPhase;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * What agents are seen as in a game that loads little: nothing is fitted, so it needs no GreatLand. An agent's <code>shape</code> is the name
     * of a model or of a structure here. A model is a level, or whatever else stands in it: it is seen as its tree, or as its triangles if
     * <code>exact</code> is set. A character is best a structure. The traits <code>hierarchical</code> and <code>collideAs</code> have no effect.
     * Pass it to SeenAgents for questions, and to a LevelCollider for collisions.
     *
     * <listing version="3.0">
     * var shapes:LevelShapes = new LevelShapes();
     * shapes.addModel(BuiltInModel.box(20, 20, 1, "floor"));
     * shapes.addStructure("hero", new Capsule(new Vector3D(0, 0, 0.4), new Vector3D(0, 0, 1.4), 0.4));
     * var seen:SeenAgents = new SeenAgents(shapes);
     * var rays:AgentRays = new AgentRays(seen);
     * seen.update(new &lt;Agent&gt;[new Agent("floor"), new Agent("hero")]);
     * </listing>
     */
    public final class LevelShapes extends QuerySource
    {
        /**
         * Whether the triangles of a model, and what is inside of them, are prepared when the model is added. This takes two to five times as long
         * as building its tree. Otherwise they are prepared all at once when they are first needed.
         */
        public var prepareExact:Boolean = false;

        /** @private */
        engine var choice:LevelChoice = new LevelChoice();

        /** Creates a LevelShapes without models and structures. */
        public function LevelShapes()
        {
        }

        /**
         * Adds a model. It replaces a model or a structure of the same name. Its tree is built at once.
         *
         * @param model its name is the shape's name for agents
         * @throws ArgumentError if it is null, or a coordinate is beyond 1e60
         */
        public function addModel(model:Model):void
        {
            requireGiven("model", model);
            ModelTable.requireCoordinates(model.name, model.vertices);
            var tree:ModelTree = new ModelTree(new BoxTree(model.vertices, model.triangles));
            tree.beginBuilding(BoxTreeBuilder.DEFAULT_LEAF_VERTICES, BoxTreeBuilder.DEFAULT_DEPTH, false, prepareExact);
            tree.finishBuilding();
            choice.models.entryToWrite(model.name).replace(model, null, tree);
        }

        /**
         * Adds a structure. It replaces a model or a structure of the same name.
         *
         * @param name the shape's name for agents
         * @param structure a Sphere, Capsule, Box or Hull in the agents' own space, where an agent's place is the origin. Do not change it
         *     afterwards
         * @throws ArgumentError if the name is null or empty, or the structure is null or another one
         */
        public function addStructure(name:String, structure:BoundingStructure):void
        {
            ModelTable.requireName(name);
            ModelShape.requireStructure(structure);
            choice.models.entryToWrite(name).replace(null, ModelStructures.of(structure), null);
        }

        /**
         * The number of levels that a test visits in each tree, unless the agent has a <code>traversalDepth</code>. At least 1.
         *
         * @default 5
         * @throws RangeError if it is less than 1
         */
        public function get maxDepth():int
        {
            return choice.narrowPhase.treeLimits.maxDepth;
        }

        public function set maxDepth(value:int):void
        {
            choice.narrowPhase.treeLimits.maxDepth = value;
        }

        /**
         * Whether the triangles of trees decide.
         *
         * @default false
         */
        public function get exact():Boolean
        {
            return choice.narrowPhase.treeLimits.isExact;
        }

        public function set exact(value:Boolean):void
        {
            choice.narrowPhase.treeLimits.isExact = value;
        }

        /** @private */
        override engine function get isForAllQuestions():Boolean
        {
            return false;
        }

        /** @private */
        override engine function findNarrowPhase():NarrowPhase
        {
            return choice.narrowPhase;
        }
    }
}
