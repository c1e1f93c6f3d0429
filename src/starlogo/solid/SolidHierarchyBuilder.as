package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyBuilder;
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
        /** The hierarchy. It is complete after the last step. */
        public var hierarchy:SolidHierarchy;

        /** Whether no step is left. */
        public var isDone:Boolean = false;

        private var _stored:Steps = null;

        /**
         * Creates a builder that has not begun yet.
         *
         * @param hierarchy without nodes; receives them
         * @param preparesExact whether to prepare the triangles for exact tests and rays now; otherwise the first of these does
         */
        public function SolidHierarchyBuilder(hierarchy:SolidHierarchy, preparesExact:Boolean = false)
        {
            this.hierarchy = hierarchy;
            begin(readStored).begin(divide);
            if (preparesExact && hierarchy.hasTriangles)
            {
                begin(newSolid);
            }
        }

        /**
         * Uses stored results, which saves most of the work. Must be called before the first step.
         *
         * @param tree makes the nodes again; not begun yet. If it makes none, the items are divided as usual
         * @param surface null if nothing is known of it
         */
        public function useStored(tree:Steps, surface:SurfaceTopology):void
        {
            _stored = tree;
            hierarchy.surface = surface;
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

        /** The complete hierarchy. The first call does all remaining work. */
        public function get finished():SolidHierarchy
        {
            if (!isDone)
            {
                finish(this);
            }
            return hierarchy;
        }

        /** Whether the nodes come from a stored tree. It becomes false if the tree does not fit the items. */
        public function get isStored():Boolean
        {
            return _stored != null;
        }

        private function readStored():Steps
        {
            return _stored;
        }

        private function divide():Steps
        {
            if (hierarchy.root != null)
            {
                return null;
            }
            _stored = null;
            return new HierarchyBuilder(hierarchy);
        }

        private function newSolid():Steps
        {
            return new SolidBuilder(hierarchy, true);
        }
    }
}
