package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyBuilder;
    import starlogo.hierarchy.StoredTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * Builds a model's hierarchy in steps, and what exact tests need of its triangles if that is wanted at once. For the engine; a client
     * has the HierarchiesLibrary.
     *
     * @private
     */
    public final class SolidHierarchyBuilder extends StepSequence
    {
        private var _hierarchy:SolidHierarchy;
        private var _builder:HierarchyBuilder;
        private var _isDone:Boolean = false;

        /**
         * A hierarchy that is not begun.
         *
         * @param vertices x, y, z each; kept, not copied
         * @param triangles three vertex indices each; null if the vertices are the items; kept, not copied
         * @param boundsKind which structures the nodes have
         * @param minVerticesToSplit a node of no more vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         * @param preparesExact whether to prepare what exact tests and rays need of triangles, rather than leave it to the first of them
         */
        public function SolidHierarchyBuilder(vertices:Vector.<Number>, triangles:Vector.<uint>, boundsKind:int, minVerticesToSplit:int,
                maxDepth:int, splitByMean:Boolean, preparesExact:Boolean = false)
        {
            _hierarchy = new SolidHierarchy(vertices, triangles, boundsKind);
            _builder = new HierarchyBuilder(_hierarchy, minVerticesToSplit, maxDepth, splitByMean);
            add(_builder);
            if (preparesExact && triangles != null)
            {
                begin(newSolid);
            }
        }

        /**
         * Spares most of the work. To be called before the first step. Items that the tree does not divide are divided anyhow.
         *
         * @param tree how the items were divided, not begun
         * @param surface what is known of the surface; null for nothing
         */
        public function useStored(tree:StoredTree, surface:Surface):void
        {
            _builder.useStored(tree);
            _hierarchy.surface = surface;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if a coordinate is larger than 1e100
         */
        override public function step():Boolean
        {
            _isDone = !super.step();
            return !_isDone;
        }

        /** The hierarchy, when no step is left. */
        public function get hierarchy():SolidHierarchy
        {
            return _hierarchy;
        }

        /** Whether no step is left. */
        public function get isDone():Boolean
        {
            return _isDone;
        }

        /** The hierarchy; what is left to do of it is done now. */
        public function get finished():SolidHierarchy
        {
            if (!_isDone)
            {
                finish(this);
            }
            return _hierarchy;
        }

        /** Whether it makes what is known again, rather than divide the items: until that turns out not to be true. */
        public function get isTaken():Boolean
        {
            return _builder.isStored;
        }

        private function newSolid():Steps
        {
            return new SolidBuilder(_hierarchy);
        }
    }
}
