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
     * Builds a model's hierarchy in steps, and on request prepares its triangles for exact tests. For the engine. Clients use the
     * HierarchiesLibrary.
     *
     * @private
     */
    public final class SolidHierarchyBuilder extends StepSequence
    {
        private var _hierarchy:SolidHierarchy;
        private var _builder:HierarchyBuilder;
        private var _isDone:Boolean = false;

        /**
         * Creates a builder that has not begun yet.
         *
         * @param vertices x, y, z of each; kept, not copied
         * @param triangles three vertex indices each; null if the vertices are the items; kept, not copied
         * @param minVerticesToSplit a node with at most this many vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         * @param preparesExact whether to prepare the triangles for exact tests and rays now; otherwise the first of these does
         */
        public function SolidHierarchyBuilder(vertices:Vector.<Number>, triangles:Vector.<uint>, minVerticesToSplit:int,
                maxDepth:int, splitByMean:Boolean, preparesExact:Boolean = false)
        {
            _hierarchy = new SolidHierarchy(vertices, triangles);
            _builder = new HierarchyBuilder(_hierarchy, minVerticesToSplit, maxDepth, splitByMean);
            add(_builder);
            if (preparesExact && triangles != null)
            {
                begin(newSolid);
            }
        }

        /**
         * Uses stored results, which saves most of the work. Must be called before the first step. If the tree does not fit these items,
         * they are divided as usual.
         *
         * @param tree how the items were divided; not begun yet
         * @param surface null if nothing is known of it
         */
        public function useStored(tree:StoredTree, surface:SurfaceTopology):void
        {
            _builder.useStored(tree);
            _hierarchy.surface = surface;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if a coordinate is larger than 1e60
         */
        override public function step():Boolean
        {
            _isDone = !super.step();
            return !_isDone;
        }

        /** The hierarchy. It is complete after the last step. */
        public function get hierarchy():SolidHierarchy
        {
            return _hierarchy;
        }

        /** Whether no step is left. */
        public function get isDone():Boolean
        {
            return _isDone;
        }

        /** The complete hierarchy. The first call does all remaining work. */
        public function get finished():SolidHierarchy
        {
            if (!_isDone)
            {
                finish(this);
            }
            return _hierarchy;
        }

        /** Whether the nodes come from the stored tree. It becomes false if the tree does not fit the items. */
        public function get isStored():Boolean
        {
            return _builder.isStored;
        }

        private function newSolid():Steps
        {
            return new SolidBuilder(_hierarchy);
        }
    }
}
