package starlogo.solid.interior
{
    import starlogo.data.zeroedInts;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Prepares a model for exact tests, in steps: which vertices are at the same place; the surface that the triangles make; a point of each of its
     * parts; which parts overlap. A surface that is known already is not found again. A SurfaceBuilder takes most of the time.
     *
     * @private
     */
    public final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;
        private static const PARTS_PER_STEP:int = 50;

        /** Knows the surface that the triangles make, and what is inside of it, when no step is left. */
        public var windingCounter:WindingCounter = null;

        private var _mesh:TriangleMesh;
        private var _surface:SurfaceTopology;

        // Which vertices are at the same place; null if the surface is known, and no vertices of its seams are apart.
        private var _welding:Welding = null;

        // For each part, where the coordinates of one of its vertices begin. For each shell, its part. The sets of parts that overlap, and how many
        // crossings were counted to find them.
        private var _vertexOf:Vector.<int>;
        private var _partOf:Vector.<int>;
        private var _overlapping:DisjointSets;
        private var _countedCrossings:int = 0;

        /**
         * @param mesh the triangles
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function InteriorBuilder(mesh:TriangleMesh, knownSurface:SurfaceTopology)
        {
            _mesh = mesh;
            _surface = knownSurface;
            if (knownSurface == null || knownSurface.widestSeam > 0)
            {
                _welding = new Welding(mesh.vertices);
                add(_welding);
            }
            begin(findSurface).call(beginParts).slices(mesh.tree.itemCount, TRIANGLES_PER_STEP, addToParts).call(beginOverlaps);
        }

        private function findSurface():Steps
        {
            var isKnown:Boolean = _surface != null;
            _surface ||= new SurfaceTopology(_mesh.tree.itemCount);
            windingCounter = new WindingCounter(_mesh, _surface, _welding == null || _welding.widestSeam == 0 ? null : _welding.welded);
            return isKnown ? null : new SurfaceBuilder(windingCounter, _welding);
        }

        private function beginParts():void
        {
            _vertexOf = zeroedInts(_surface.partCount);
            _partOf = zeroedInts(_surface.shellStates.length);
            _overlapping = new DisjointSets(_surface.partCount);
        }

        private function addToParts(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                var triangle:int = _mesh.tree.items[slot];
                var shell:int = _surface.shellOf(triangle);
                if (shell >= 0)
                {
                    _partOf[shell] = _surface.parts[triangle];
                }
                _vertexOf[_surface.parts[triangle]] = _mesh.corners[3 * slot];
            }
        }

        // A figure often consists of shells that overlap. Another model contains all of them or none, unless it is inside one of them. So one part
        // stands for all those that it overlaps, and each pair of models needs fewer points.
        private function beginOverlaps():void
        {
            if (_surface.hasClosedShell)
            {
                slices(_surface.partCount, PARTS_PER_STEP, findOverlaps);
            }
            call(conclude);
        }

        // If too many crossings are counted, the parts that are left stand for themselves. The answers are the same.
        private function findOverlaps(first:int, end:int):void
        {
            var enclosing:Vector.<int> = new Vector.<int>();
            for (var part:int = first; part < end && _countedCrossings < WindingCounter.MAX_CROSSINGS_PER_TRIANGLE * _mesh.tree.itemCount; part++)
            {
                var at:int = _vertexOf[part];
                _countedCrossings += windingCounter.findEnclosing(_mesh.vertices[at], _mesh.vertices[at + 1], _mesh.vertices[at + 2], enclosing);
                for each (var shell:int in enclosing)
                {
                    _overlapping.join(_partOf[shell], part);
                }
            }
        }

        private function conclude():void
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var part:int = 0; part < _surface.partCount; part++)
            {
                if (_overlapping.rootOf(part) == part)
                {
                    var at:int = _vertexOf[part];
                    points.push(_mesh.vertices[at], _mesh.vertices[at + 1], _mesh.vertices[at + 2]);
                }
            }
            windingCounter.partPoints = points;
            windingCounter.hasClosedShell = _surface.hasClosedShell;
        }
    }
}
