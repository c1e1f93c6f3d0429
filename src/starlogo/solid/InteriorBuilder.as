package starlogo.solid
{
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Prepares a model for exact tests, in steps: the corners of its triangles by slot; which vertices are at the same place; the surface that the
     * triangles make; the outermost points of its parts. What is known already is not found again. A SurfaceBuilder takes most of the time.
     */
    internal final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** What is inside of the triangles, when no step is left. Its WindingCounter has the triangles and their surface. */
        public var interior:Interior = null;

        private var _mesh:TriangleMesh;
        private var _surface:SurfaceTopology;

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
            _mesh = knownMesh || new TriangleMesh(tree);
            _surface = knownSurface;
            if (knownMesh == null)
            {
                slices(tree.itemCount, TRIANGLES_PER_STEP, _mesh.fillCorners);
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
            var isKnown:Boolean = _surface != null;
            _surface ||= new SurfaceTopology(_mesh.tree.itemCount);
            _windingCounter = new WindingCounter(_mesh, _surface, _welding == null || _welding.widestSeam == 0 ? null : _welding.welded);
            return isKnown ? null : new SurfaceBuilder(_windingCounter, _welding);
        }

        private function beginParts():void
        {
            _parts = new OutermostPoints(_mesh.corners, _surface.partNumberEnd);
        }

        private function addToParts(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                _parts.add(_surface.parts[_mesh.tree.items[slot]], slot);
            }
        }

        private function conclude():void
        {
            interior = new Interior(_windingCounter, _parts);
        }
    }
}
