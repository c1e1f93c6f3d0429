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
    public final class SolidHierarchyBuilder implements Steps
    {
        private var _minVerticesToSplit:int;
        private var _maxDepth:int;
        private var _splitByMean:Boolean;
        private var _boundsKind:int;
        private var _preparesExact:Boolean;
        private var _hierarchy:SolidHierarchy;
        private var _builder:HierarchyBuilder;
        private var _work:StepSequence;
        private var _isDone:Boolean;

        /**
         * @param minVerticesToSplit a node of no more vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         * @param boundsKind which structures the nodes have
         * @param preparesExact whether to prepare what exact tests and rays need of triangles, rather than leave it to the first of them
         */
        public function SolidHierarchyBuilder(minVerticesToSplit:int, maxDepth:int, splitByMean:Boolean, boundsKind:int,
                preparesExact:Boolean = false)
        {
            _minVerticesToSplit = minVerticesToSplit;
            _maxDepth = maxDepth;
            _splitByMean = splitByMean;
            _boundsKind = boundsKind;
            _preparesExact = preparesExact;
        }

        /** Begins a hierarchy of triangles, or of vertices where triangles is null. It keeps both lists. */
        public function setModel(vertices:Vector.<Number>, triangles:Vector.<uint>):void
        {
            _hierarchy = new SolidHierarchy(vertices, triangles, _boundsKind);
            _builder = new HierarchyBuilder(_hierarchy, _minVerticesToSplit, _maxDepth, _splitByMean);
            _work = new StepSequence().add(_builder);
            if (_preparesExact && triangles != null)
            {
                _work.begin(newSolid).begin(newRays);
            }
            _isDone = false;
        }

        /**
         * Spares most of the work, if what is given is true; what turns out not to be is done anyhow. To be called between
         * <code>setModel()</code> and the first step.
         *
         * @param tree how the items were divided, not begun
         * @param notes what was noted of the surface; null for nothing
         */
        public function useStored(tree:StoredTree, notes:SurfaceNotes):void
        {
            _builder.useStored(tree);
            _hierarchy.notes = notes;
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the model's extent is not finite
         */
        public function step():Boolean
        {
            _isDone = !_work.step();
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

        private function newRays():Steps
        {
            return new RayTreeBuilder(_hierarchy);
        }
    }
}
