package starlogo.solid.interior
{
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Prepares a model for exact tests, in steps: which vertices are at the same place; the surface that the triangles make, which takes most of the
     * time. A surface that is known already is not found again.
     *
     * @private
     */
    public final class InteriorBuilder extends StepSequence
    {
        /** What is inside of the triangles, and their surface: complete when no step is left. */
        public var interior:Interior;

        // Which vertices are at the same place; null if the surface is known, and no vertices of its seams are apart.
        private var _welder:VertexWelder = null;

        /**
         * @param tree of the triangles, whose corners are listed
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function InteriorBuilder(tree:BoxTree, knownSurface:SurfaceTopology)
        {
            interior = new Interior(tree, knownSurface || new SurfaceTopology(tree.primitiveCount));
            if (knownSurface == null || knownSurface.widestSeam > 0)
            {
                _welder = new VertexWelder(tree.vertices);
                add(_welder).call(takeSeams);
            }
            if (knownSurface == null)
            {
                begin(findSurface);
            }
            call(function():void
                {
                    interior.hasClosedShell = interior.surface.hasClosedShell;
                });
        }

        private function takeSeams():void
        {
            if (_welder.widestSeam > 0)
            {
                interior.welded = _welder.welded;
            }
        }

        private function findSurface():Steps
        {
            var surface:SurfaceTopology = interior.surface;
            var triangles:Vector.<uint> = interior.tree.triangles;
            var edges:EdgeMatcher = new EdgeMatcher(triangles, _welder);
            var shells:ShellFinder = new ShellFinder(surface, edges);
            surface.widestSeam = _welder.widestSeam;
            return new StepSequence().add(new ComponentFinder(surface, triangles, _welder.welded)).add(edges).add(shells).begin(function():Steps
                {
                    return new CavityFinder(interior, shells, _welder.welded);
                });
        }
    }
}
