package starlogo.solid.interior
{
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Prepares a model for exact tests, in steps: the triangles by slot; which vertices are at the same place; the surface that the
     * triangles make; the outermost points of its parts. What is known already is not found again. A SurfaceBuilder takes most of the time.
     *
     * @private
     */
    public final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** The triangles, when no step is left. */
        public var mesh:TriangleMesh;

        /** The surface that they make. */
        public var surface:SurfaceTopology;

        /** What is inside of it. */
        public var interior:Interior = null;

        // Which vertices are at the same place; null if the surface is known, and no vertices of its seams are apart.
        private var _welding:Welding = null;

        private var _windingCounter:WindingCounter;
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
                add(_welding);
            }
            begin(findSurface).call(beginParts).slices(tree.itemCount, TRIANGLES_PER_STEP, addToParts).call(conclude);
        }

        private function findSurface():Steps
        {
            var isKnown:Boolean = surface != null;
            surface ||= new SurfaceTopology(mesh.tree.itemCount);
            _windingCounter = new WindingCounter(mesh, surface, _welding == null || _welding.widestSeam == 0 ? null : _welding.welded);
            return isKnown ? null : new SurfaceBuilder(_windingCounter, _welding);
        }

        private function beginParts():void
        {
            _parts = new OutermostPoints(mesh, surface.partNumberEnd);
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
            interior = new Interior(_windingCounter, _parts);
        }
    }
}
