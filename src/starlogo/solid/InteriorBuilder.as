package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Prepares a model for exact tests, in steps: the corners of its triangles by slot; the surface that they make; the outermost points of its
     * parts. A SurfaceBuilder finds the surface, which takes most of the work, unless it is known already.
     */
    internal final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** The triangles, when no step is left. */
        public var mesh:TriangleMesh;

        /** The surface that they make, when no step is left. */
        public var surface:SurfaceTopology;

        /** What is inside of it, when no step is left. */
        public var interior:Interior = null;

        // Which vertices are at the same place; null if it is known that none are.
        private var _welding:Welding = null;

        // The corners that are moved by this; null if none are.
        private var _welded:WeldedCorners = null;

        private var _parts:OutermostPoints;

        /**
         * @param tree of triangles
         * @param knownMesh its triangles if they are prepared; otherwise null
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function InteriorBuilder(tree:BoxTree, knownMesh:TriangleMesh, knownSurface:SurfaceTopology)
        {
            mesh = knownMesh || new TriangleMesh(tree);
            surface = knownSurface;
            if (knownMesh == null)
            {
                slices(tree.itemCount, TRIANGLES_PER_STEP, mesh.fillCorners);
            }
            if (knownSurface == null || knownSurface.widestSeam > 0)
            {
                _welding = new Welding(tree.vertices);
                add(_welding).begin(beginWelding);
            }
            if (knownSurface == null)
            {
                begin(buildSurface);
            }
            call(beginParts).slices(tree.itemCount, TRIANGLES_PER_STEP, addToParts).call(conclude);
        }

        private function beginWelding():Steps
        {
            if (_welding.widestSeam == 0)
            {
                return null;
            }
            _welded = new WeldedCorners(mesh.tree.itemCount);
            return new StepSequence().slices(mesh.tree.itemCount, TRIANGLES_PER_STEP, weld);
        }

        private function weld(first:int, end:int):void
        {
            _welded.weld(first, end, mesh, _welding.welded);
        }

        private function buildSurface():Steps
        {
            var builder:SurfaceBuilder = new SurfaceBuilder(mesh, _welding, _welded);
            surface = builder.surface;
            return builder;
        }

        private function beginParts():void
        {
            _parts = new OutermostPoints(mesh.corners, surface.partNumberEnd);
        }

        private function addToParts(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                _parts.add(surface.parts[mesh.tree.items[slot]], slot);
            }
        }

        private function conclude():void
        {
            interior = new Interior(new WindingCounter(mesh, surface, _welded), _parts);
        }
    }
}
