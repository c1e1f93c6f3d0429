package starlogo.solid
{
    import starlogo.steps.StepSequence;

    /**
     * Computes a model's SurfaceTopology, in steps: which vertices are at the same place, to within Tolerances.WELDING, which shells the triangles
     * form, and which shells are connected. A CavityFinder and a SolidBuilder complete the surface.
     */
    internal final class SurfaceBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** The result. Complete after the last step. */
        public var surface:SurfaceTopology;

        private var _triangles:Vector.<uint>;
        private var _welding:Welding;
        private var _shells:ShellFinder;

        // The connected vertices. For the representative of a set, one more than its part's number, or 0.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;

        /**
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each
         */
        public function SurfaceBuilder(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            var count:int = triangles.length / 3;
            surface = new SurfaceTopology(count);
            _triangles = triangles;
            _welding = new Welding(vertices);
            _sets = new DisjointSets(vertices.length / 3);
            _numbers = new Vector.<int>(vertices.length / 3, true);
            var edges:EdgeMatcher = new EdgeMatcher(triangles, _welding);
            _shells = new ShellFinder(surface, edges);
            add(_welding).slices(count, TRIANGLES_PER_STEP, joinSome).slices(count, TRIANGLES_PER_STEP, numberSome).add(edges).add(_shells);
        }

        /** For each shell, the number of its triangles that are not reversed, minus the number of those that are. */
        public function get balances():Vector.<int>
        {
            return _shells.balances;
        }

        private function joinSome(first:int, end:int):void
        {
            var welded:Vector.<int> = _welding.welded;
            for (var corner:int = 3 * first; corner < 3 * end; corner += 3)
            {
                _sets.join(welded[_triangles[corner]], welded[_triangles[int(corner + 1)]]);
                _sets.join(welded[_triangles[corner]], welded[_triangles[int(corner + 2)]]);
            }
        }

        private function numberSome(first:int, end:int):void
        {
            surface.widestSeam = _welding.widestSeam;
            for (var i:int = first; i < end; i++)
            {
                var root:int = _sets.rootOf(_welding.welded[_triangles[3 * i]]);
                if (_numbers[root] == 0)
                {
                    _numbers[root] = ++surface.partNumberEnd;
                }
                surface.parts[i] = _numbers[root] - 1;
            }
        }
    }
}
