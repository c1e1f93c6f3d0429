package starlogo.solid.interior
{
    import starlogo.data.fixedInts;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Finds the surface that a model's triangles make, in steps: its parts, which are the sets of triangles with common vertices; which shells the
     * triangles form; and which of these bound cavities.
     */
    internal final class SurfaceBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        private var _triangles:Vector.<uint>;

        // For each vertex, the first one at its place.
        private var _welded:Vector.<int>;

        // The sets of connected vertices. For the representative of a set, one more than the number of its part, or 0 as long as it has none.
        private var _sets:DisjointSets;
        private var _partOfSet:Vector.<int>;

        private var _shells:ShellFinder;
        private var _windingCounter:WindingCounter;

        /**
         * @param windingCounter of the triangles and their surface. The surface is empty, and complete when no step is left
         * @param welding says which vertices are at the same place
         */
        public function SurfaceBuilder(windingCounter:WindingCounter, welding:Welding)
        {
            _windingCounter = windingCounter;
            _triangles = windingCounter.mesh.tree.triangles;
            _welded = welding.welded;
            windingCounter.surface.widestSeam = welding.widestSeam;
            var count:int = _triangles.length / 3;
            var edges:EdgeMatcher = new EdgeMatcher(_triangles, welding);
            _sets = new DisjointSets(_welded.length);
            _partOfSet = fixedInts(_welded.length);
            _shells = new ShellFinder(windingCounter.surface, edges);
            slices(count, TRIANGLES_PER_STEP, joinVertices).slices(count, TRIANGLES_PER_STEP, numberParts);
            add(edges).add(_shells).begin(findCavities);
        }

        private function joinVertices(first:int, end:int):void
        {
            var triangles:Vector.<uint> = _triangles;
            for (var corner:int = 3 * first; corner < 3 * end; corner += 3)
            {
                _sets.join(_welded[triangles[corner]], _welded[triangles[int(corner + 1)]]);
                _sets.join(_welded[triangles[corner]], _welded[triangles[int(corner + 2)]]);
            }
        }

        private function numberParts(first:int, end:int):void
        {
            var surface:SurfaceTopology = _windingCounter.surface;
            for (var triangle:int = first; triangle < end; triangle++)
            {
                var root:int = _sets.rootOf(_welded[_triangles[3 * triangle]]);
                if (_partOfSet[root] == 0)
                {
                    _partOfSet[root] = ++surface.partCount;
                }
                surface.parts[triangle] = _partOfSet[root] - 1;
            }
        }

        private function findCavities():Steps
        {
            return new CavityFinder(_windingCounter, _shells, _welded);
        }
    }
}
