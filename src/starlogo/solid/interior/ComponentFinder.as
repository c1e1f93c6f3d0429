package starlogo.solid.interior
{
    import starlogo.steps.StepSequence;

    /** Finds the components of a surface, in steps: sets of triangles that are connected over vertices. */
    internal final class ComponentFinder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        private var _surface:SurfaceTopology;
        private var _triangles:Vector.<uint>;

        // For each vertex, the first one at its place.
        private var _welded:Vector.<int>;

        // The sets of connected vertices. For the representative of a set, whether a triangle of its component is found.
        private var _sets:DisjointSets;
        private var _isFound:Vector.<Boolean>;

        /**
         * @param surface receives the components
         * @param triangles three vertex indices each
         * @param welded for each vertex, the first one at its place
         */
        public function ComponentFinder(surface:SurfaceTopology, triangles:Vector.<uint>, welded:Vector.<int>)
        {
            _surface = surface;
            _triangles = triangles;
            _welded = welded;
            _sets = new DisjointSets(welded.length);
            _isFound = new Vector.<Boolean>(welded.length, true);
            slices(triangles.length / 3, TRIANGLES_PER_STEP, joinVertices).slices(triangles.length / 3, TRIANGLES_PER_STEP, findComponents);
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

        private function findComponents(first:int, end:int):void
        {
            for (var triangle:int = first; triangle < end; triangle++)
            {
                var root:int = _sets.rootOf(_welded[_triangles[3 * triangle]]);
                if (!_isFound[root])
                {
                    _isFound[root] = true;
                    _surface.componentTriangles.push(triangle);
                }
            }
        }
    }
}
