package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BoxTreeBuilder;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Makes a model's tree in steps, and on request prepares its triangles for exact tests. For the engine. Clients use the
     * HierarchiesLibrary.
     *
     * @private
     */
    public final class ModelTreeBuilder extends StepSequence
    {
        /** The vertices of a leaf, and the levels of a tree, if a game does not say (thesis §4.4). */
        public static const MIN_VERTICES_TO_SPLIT:int = 5;

        /** @copy #MIN_VERTICES_TO_SPLIT */
        public static const MAX_DEPTH:int = 10;

        /** The tree. It is complete after the last step. */
        public var modelTree:ModelTree;

        /** A node of the tree on this level is a leaf of the thesis. */
        public var maxDepth:int;

        /** Whether no step is left. */
        public var isDone:Boolean = false;

        private var _minVerticesToSplit:int;
        private var _splitByMean:Boolean;

        /**
         * Creates a builder that has not begun yet.
         *
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each, or null if the vertices are the items
         * @param minVerticesToSplit a node with at most this many vertices is a leaf of the thesis
         * @param maxDepth a node on this level is a leaf of the thesis
         * @param splitByMean whether to split at the mean, down to the thesis's leaves
         * @param preparesExact whether to prepare the triangles for exact tests and rays now; otherwise the first of these does
         * @param restoring <code>():Steps</code>, called in the first step: makes the tree from stored results, or returns null if there are none.
         * If it makes no tree, the items are divided as usual
         */
        public function ModelTreeBuilder(vertices:Vector.<Number>, triangles:Vector.<uint>, minVerticesToSplit:int, maxDepth:int, splitByMean:Boolean,
                preparesExact:Boolean = false, restoring:Function = null)
        {
            modelTree = new ModelTree(new BoxTree(vertices, triangles));
            _minVerticesToSplit = minVerticesToSplit;
            this.maxDepth = maxDepth;
            _splitByMean = splitByMean;
            if (restoring != null)
            {
                begin(restoring);
            }
            begin(divide);
            if (preparesExact && triangles != null)
            {
                begin(newInterior);
            }
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if a coordinate is larger than 1e60
         */
        override public function step():Boolean
        {
            isDone = !super.step();
            return !isDone;
        }

        /** Does all work that is left, and returns the complete tree. */
        public function finishTree():ModelTree
        {
            if (!isDone)
            {
                finish(this);
            }
            return modelTree;
        }

        private function divide():Steps
        {
            return modelTree.tree.isMade ? null : new BoxTreeBuilder(modelTree.tree, _minVerticesToSplit, maxDepth, _splitByMean);
        }

        private function newInterior():Steps
        {
            return new InteriorBuilder(modelTree);
        }
    }
}
