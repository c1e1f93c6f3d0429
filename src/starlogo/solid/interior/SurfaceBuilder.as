package starlogo.solid.interior
{
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Finds the surface that a model's triangles make, in steps: its parts, which are the sets of triangles with common vertices; which shells the
     * triangles form, and which of these bound cavities; and at last which parts overlap, because these become one.
     */
    internal final class SurfaceBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;
        private static const PARTS_PER_STEP:int = 50;

        // After so many windings of shells for each triangle, the parts that are left stay as they are. The answers are the same.
        private static const WINDINGS_PER_TRIANGLE:int = 20;

        private var _surface:SurfaceTopology;
        private var _mesh:TriangleMesh;

        // For each vertex, the first one at its place.
        private var _places:Vector.<int>;

        // The sets of connected vertices. For the representative of a set, one more than its part's number, or 0.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;

        private var _shells:ShellFinder;
        private var _windingCounter:WindingCounter;

        // The outermost points of each part; for each shell, its part; and the parts that are one because they overlap.
        private var _extremes:OutermostPoints;
        private var _partOf:Vector.<int>;
        private var _joined:DisjointSets;
        private var _windingCount:int = 0;

        /**
         * @param windingCounter of the triangles and their surface. The surface is empty, and complete when no step is left
         * @param welding says which vertices are at the same place
         */
        public function SurfaceBuilder(windingCounter:WindingCounter, welding:Welding)
        {
            _windingCounter = windingCounter;
            _mesh = windingCounter.mesh;
            _surface = windingCounter.surface;
            var count:int = _mesh.tree.itemCount;
            var edges:EdgeMatcher = new EdgeMatcher(_mesh.tree.triangles, welding);
            var vertexCount:int = _mesh.tree.vertices.length / 3;
            _places = welding.welded;
            _surface.widestSeam = welding.widestSeam;
            _sets = new DisjointSets(vertexCount);
            _numbers = new Vector.<int>(vertexCount, true);
            _shells = new ShellFinder(_surface, edges);
            slices(count, TRIANGLES_PER_STEP, joinVertices).slices(count, TRIANGLES_PER_STEP, numberParts);
            add(edges).add(_shells).begin(findCavities).call(beginJoining);
        }

        private function joinVertices(first:int, end:int):void
        {
            var triangles:Vector.<uint> = _mesh.tree.triangles;
            for (var corner:int = 3 * first; corner < 3 * end; corner += 3)
            {
                _sets.join(_places[triangles[corner]], _places[triangles[int(corner + 1)]]);
                _sets.join(_places[triangles[corner]], _places[triangles[int(corner + 2)]]);
            }
        }

        private function numberParts(first:int, end:int):void
        {
            var triangles:Vector.<uint> = _mesh.tree.triangles;
            for (var triangle:int = first; triangle < end; triangle++)
            {
                var root:int = _sets.rootOf(_places[triangles[3 * triangle]]);
                if (_numbers[root] == 0)
                {
                    _numbers[root] = ++_surface.partNumberEnd;
                }
                _surface.parts[triangle] = _numbers[root] - 1;
            }
        }

        private function findCavities():Steps
        {
            return new CavityFinder(_windingCounter, _shells.balances);
        }

        // A figure often consists of shells that overlap. Another model contains all of them or none, unless that model is inside one of them. So
        // overlapping shells are joined to one part, and each pair of agents needs fewer points.
        private function beginJoining():void
        {
            if (!_surface.hasClosedShell || _surface.partNumberEnd == 1)
            {
                return;
            }
            var count:int = _mesh.tree.itemCount;
            _extremes = new OutermostPoints(_mesh, _surface.partNumberEnd);
            _partOf = new Vector.<int>(_surface.shellStates.length, true);
            _joined = new DisjointSets(_surface.partNumberEnd);
            slices(count, TRIANGLES_PER_STEP, measureParts).slices(_surface.partNumberEnd, PARTS_PER_STEP, joinParts);
            slices(count, TRIANGLES_PER_STEP, numberJoined);
        }

        private function measureParts(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                var triangle:int = _mesh.tree.items[slot];
                var shell:int = _surface.shellOf(triangle);
                if (shell >= 0)
                {
                    _partOf[shell] = _surface.parts[triangle];
                }
                _extremes.add(_surface.parts[triangle], slot);
            }
        }

        private function joinParts(first:int, end:int):void
        {
            var points:Vector.<Number> = _extremes.points;
            var around:Vector.<int> = new Vector.<int>();
            for (var part:int = first; part < end && _windingCount < WINDINGS_PER_TRIANGLE * _mesh.tree.itemCount; part++)
            {
                var start:int = _extremes.startOf(part);
                for (var i:int = start; i < start + OutermostPoints.STRIDE; i += 3)
                {
                    _windingCount += _windingCounter.findAround(points[i], points[i + 1], points[i + 2], around);
                    for each (var shell:int in around)
                    {
                        _joined.join(_partOf[shell], part);
                    }
                }
            }
        }

        private function numberJoined(first:int, end:int):void
        {
            for (var triangle:int = first; triangle < end; triangle++)
            {
                _surface.parts[triangle] = _joined.rootOf(_surface.parts[triangle]);
            }
        }
    }
}
