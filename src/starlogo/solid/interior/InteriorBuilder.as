package starlogo.solid.interior
{
    import starlogo.data.zeroedInts;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Prepares a model for exact tests, in steps: which vertices are at the same place; the surface that the triangles make, which takes most of the
     * time; a point of each of its components; which components overlap. A surface that is known already is not found again.
     *
     * @private
     */
    public final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;
        private static const COMPONENTS_PER_STEP:int = 50;

        /** Knows the surface that the triangles make, and what is inside of it, when no step is left. */
        public var windingCounter:WindingCounter = null;

        private var _tree:BoxTree;
        private var _surface:SurfaceTopology;

        // Which vertices are at the same place; null if the surface is known, and no vertices of its seams are apart.
        private var _welding:Welding = null;

        // For each component, where the coordinates of one of its vertices begin. For each shell, its component. The sets of components that overlap, and
        // how many crossings were counted to find them.
        private var _vertexOfComponent:Vector.<int>;
        private var _componentOfShell:Vector.<int>;
        private var _overlapping:DisjointSets;
        private var _countedCrossings:int = 0;

        /**
         * @param tree of the triangles, whose corners are listed
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function InteriorBuilder(tree:BoxTree, knownSurface:SurfaceTopology)
        {
            _tree = tree;
            _surface = knownSurface;
            if (knownSurface == null || knownSurface.widestSeam > 0)
            {
                _welding = new Welding(tree.vertices);
                add(_welding);
            }
            begin(findSurface).call(beginComponents).slices(tree.primitiveCount, TRIANGLES_PER_STEP, addToComponents).call(beginOverlaps);
        }

        private function findSurface():Steps
        {
            var isKnown:Boolean = _surface != null;
            _surface ||= new SurfaceTopology(_tree.primitiveCount);
            windingCounter = new WindingCounter(_tree, _surface, _welding == null || _welding.widestSeam == 0 ? null : _welding.welded);
            if (isKnown)
            {
                return null;
            }
            _surface.widestSeam = _welding.widestSeam;
            var triangles:Vector.<uint> = _tree.triangles;
            var edges:EdgeMatcher = new EdgeMatcher(triangles, _welding);
            var shells:ShellFinder = new ShellFinder(_surface, edges);
            return new StepSequence().add(new ComponentFinder(_surface, triangles, _welding.welded)).add(edges).add(shells).begin(function():Steps
                {
                    return new CavityFinder(windingCounter, shells, _welding.welded);
                });
        }

        private function beginComponents():void
        {
            _vertexOfComponent = zeroedInts(_surface.componentCount);
            _componentOfShell = zeroedInts(_surface.shellStates.length);
            _overlapping = new DisjointSets(_surface.componentCount);
        }

        private function addToComponents(first:int, end:int):void
        {
            for (var index:int = first; index < end; index++)
            {
                var triangle:int = _tree.primitives[index];
                var shell:int = _surface.shellOf(triangle);
                if (shell >= 0)
                {
                    _componentOfShell[shell] = _surface.components[triangle];
                }
                _vertexOfComponent[_surface.components[triangle]] = _tree.cornerOffsets[3 * index];
            }
        }

        // A figure often consists of shells that overlap. Another model contains all of them or none, unless it is inside one of them. So one component
        // stands for all those that it overlaps, and each pair of models needs fewer points.
        private function beginOverlaps():void
        {
            windingCounter.hasClosedShell = _surface.hasClosedShell;
            if (windingCounter.hasClosedShell)
            {
                slices(_surface.componentCount, COMPONENTS_PER_STEP, findOverlaps);
            }
            call(conclude);
        }

        // If too many crossings are counted, the components that are left stand for themselves. The answers are the same.
        private function findOverlaps(first:int, end:int):void
        {
            var enclosing:Vector.<int> = new Vector.<int>();
            var most:int = WindingCounter.MAX_CROSSINGS_PER_TRIANGLE * _tree.primitiveCount;
            for (var component:int = first; component < end && _countedCrossings < most; component++)
            {
                var at:int = _vertexOfComponent[component];
                _countedCrossings += windingCounter.findEnclosing(_tree.vertices[at], _tree.vertices[at + 1], _tree.vertices[at + 2], enclosing);
                for each (var shell:int in enclosing)
                {
                    _overlapping.join(_componentOfShell[shell], component);
                }
            }
        }

        private function conclude():void
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var component:int = 0; component < _surface.componentCount; component++)
            {
                if (_overlapping.rootOf(component) == component)
                {
                    var at:int = _vertexOfComponent[component];
                    points.push(_tree.vertices[at], _tree.vertices[at + 1], _tree.vertices[at + 2]);
                }
            }
            windingCounter.componentPoints = points;
        }
    }
}
