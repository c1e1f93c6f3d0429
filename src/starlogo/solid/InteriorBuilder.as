package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Prepares a model for exact tests, in steps: the corners of its triangles by slot; the surface that they make;
     * what counts its windings; and the outermost points of its parts.
     *
     * <p>The surface takes most of the work, unless it is known already: which vertices are at the same place, to within Tolerances.WELDING, which
     * shells the triangles form, which shells bound cavities, and which are one part because they are connected or overlap.</p>
     */
    internal final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;
        private static const PARTS_PER_STEP:int = 50;

        // After so many windings of shells for each triangle, the parts that are left stay as they are. The answers are the same.
        private static const WINDINGS_PER_TRIANGLE:int = 20;

        /** The triangles, when no step is left. */
        public var mesh:TriangleMesh;

        /** The surface that they make, when no step is left. */
        public var surface:SurfaceTopology;

        /** What is inside of it, when no step is left. */
        public var interior:Interior = null;

        private var _tree:BoxTree;
        private var _welding:Welding;
        private var _windingCounter:WindingCounter;

        // Null if the surface is known already.
        private var _shells:ShellFinder = null;

        // The outermost points of each part; for each shell, its part; and the parts that are one because they overlap.
        private var _extremes:PartExtremes;
        private var _partOf:Vector.<int>;
        private var _joined:DisjointSets;
        private var _windingCount:int = 0;

        /**
         * @param tree of triangles
         * @param knownMesh its triangles if they are prepared; otherwise null
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function InteriorBuilder(tree:BoxTree, knownMesh:TriangleMesh, knownSurface:SurfaceTopology)
        {
            _tree = tree;
            mesh = knownMesh || new TriangleMesh(tree);
            surface = knownSurface || new SurfaceTopology(tree.itemCount);
            if (knownMesh == null)
            {
                sliced(mesh.fillCorners);
            }
            if (knownSurface == null || surface.widestSeam > 0)
            {
                _welding = new Welding(tree.vertices);
                add(_welding);
            }
            if (knownSurface == null)
            {
                addShells(new EdgeMatcher(_tree.triangles, _welding), new DisjointSets(_tree.vertices.length / 3));
            }
            call(beginWindings);
        }

        private function sliced(work:Function):StepSequence
        {
            return slices(_tree.itemCount, TRIANGLES_PER_STEP, work);
        }

        // Finds the parts, which are the sets of connected vertices, and the shells.
        private function addShells(edges:EdgeMatcher, sets:DisjointSets):void
        {
            // For the representative of a set, one more than its part's number, or 0.
            var numbers:Vector.<int> = new Vector.<int>(_tree.vertices.length / 3, true);
            _shells = new ShellFinder(surface, edges);
            sliced(function(first:int, end:int):void
                {
                    joinVertices(first, end, sets);
                });
            sliced(function(first:int, end:int):void
                {
                    numberSets(first, end, sets, numbers);
                }).add(edges).add(_shells);
        }

        private function joinVertices(first:int, end:int, sets:DisjointSets):void
        {
            var welded:Vector.<int> = _welding.welded;
            var triangles:Vector.<uint> = _tree.triangles;
            for (var corner:int = 3 * first; corner < 3 * end; corner += 3)
            {
                sets.join(welded[triangles[corner]], welded[triangles[int(corner + 1)]]);
                sets.join(welded[triangles[corner]], welded[triangles[int(corner + 2)]]);
            }
        }

        private function numberSets(first:int, end:int, sets:DisjointSets, numbers:Vector.<int>):void
        {
            for (var triangle:int = first; triangle < end; triangle++)
            {
                var root:int = sets.rootOf(_welding.welded[_tree.triangles[3 * triangle]]);
                if (numbers[root] == 0)
                {
                    numbers[root] = ++surface.partNumberEnd;
                }
                surface.parts[triangle] = numbers[root] - 1;
            }
        }

        private function beginWindings():void
        {
            if (_shells != null)
            {
                surface.widestSeam = _welding.widestSeam;
            }
            _windingCounter = new WindingCounter(mesh, surface);
            _partOf = new Vector.<int>(surface.shellStates.length, true);
            if (surface.widestSeam > 0)
            {
                sliced(weld);
            }
            if (_shells != null)
            {
                _joined = new DisjointSets(surface.partNumberEnd);
                var cavities:CavityFinder = new CavityFinder(_windingCounter, _shells.balances);
                add(cavities).call(function():void
                    {
                        surface.shellStates = cavities.states;
                    });
                addMeasuring().slices(surface.hasClosedShell && surface.partNumberEnd > 1 ? surface.partNumberEnd : 0, PARTS_PER_STEP, joinParts);
                sliced(numberParts);
            }
            addMeasuring().call(conclude);
        }

        private function weld(first:int, end:int):void
        {
            _windingCounter.weld(first, end, _welding.welded);
        }

        // Measures the parts as they are then.
        private function addMeasuring():StepSequence
        {
            call(beginMeasuring);
            return sliced(addToParts);
        }

        private function beginMeasuring():void
        {
            _extremes = new PartExtremes(mesh.corners, surface.partNumberEnd);
        }

        private function addToParts(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                var part:int = surface.parts[_tree.items[slot]];
                var shell:int = surface.shellOf(_tree.items[slot]);
                if (shell >= 0)
                {
                    _partOf[shell] = part;
                }
                _extremes.add(part, slot);
            }
        }

        // A figure often consists of shells that overlap. Another model contains all of them or none, unless that model is inside one of them. So
        // overlapping shells are joined to one part, and each pair of agents needs fewer points.
        private function joinParts(first:int, end:int):void
        {
            var points:Vector.<Number> = _extremes.points;
            var around:Vector.<int> = new Vector.<int>();
            for (var part:int = first; part < end && _windingCount < WINDINGS_PER_TRIANGLE * _tree.itemCount; part++)
            {
                var at:int = _extremes.pointsAt[part];
                for (var i:int = at; i < at + PartExtremes.STRIDE; i += 3)
                {
                    _windingCount += _windingCounter.findAround(points[i], points[i + 1], points[i + 2], around);
                    for each (var shell:int in around)
                    {
                        _joined.join(_partOf[shell], part);
                    }
                }
            }
        }

        private function numberParts(first:int, end:int):void
        {
            for (var triangle:int = first; triangle < end; triangle++)
            {
                surface.parts[triangle] = _joined.rootOf(surface.parts[triangle]);
            }
        }

        private function conclude():void
        {
            interior = new Interior(_windingCounter, _extremes);
        }
    }
}
