package starlogo.solid.interior
{
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Prepares a model for exact tests, in steps: which vertices are at the same place; the surface that the triangles make; the outermost points of its
     * parts. A surface that is known already is not found again. A SurfaceBuilder takes most of the time.
     *
     * @private
     */
    public final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** The surface that the triangles make, when no step is left. */
        public var surface:SurfaceTopology;

        /** What is inside of it. */
        public var interior:Interior = null;

        private var _mesh:TriangleMesh;

        // Which vertices are at the same place; null if the surface is known, and no vertices of its seams are apart.
        private var _welding:Welding = null;

        private var _windingCounter:WindingCounter;
        private var _parts:OutermostPoints;

        /**
         * @param mesh the triangles
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function InteriorBuilder(mesh:TriangleMesh, knownSurface:SurfaceTopology)
        {
            _mesh = mesh;
            surface = knownSurface;
            if (knownSurface == null || knownSurface.widestSeam > 0)
            {
                _welding = new Welding(mesh.vertices);
                add(_welding);
            }
            begin(findSurface).call(beginParts).slices(mesh.tree.itemCount, TRIANGLES_PER_STEP, addToParts).call(conclude);
        }

        private function findSurface():Steps
        {
            var isKnown:Boolean = surface != null;
            surface ||= new SurfaceTopology(_mesh.tree.itemCount);
            _windingCounter = new WindingCounter(_mesh, surface, _welding == null || _welding.widestSeam == 0 ? null : _welding.welded);
            return isKnown ? null : new SurfaceBuilder(_windingCounter, _welding);
        }

        private function beginParts():void
        {
            _parts = new OutermostPoints(_mesh, surface.partCount);
        }

        private function addToParts(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                _parts.add(surface.parts[_mesh.tree.items[slot]], slot);
            }
        }

        private function conclude():void
        {
            interior = new Interior(_windingCounter, _parts);
        }
    }
}
