package starlogo.solid.interior
{
    import starlogo.data.zeroedNumbers;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Prepares a model for exact tests, in steps: which vertices are at the same place; the surface that the triangles make, which takes most of the
     * time; a point of each of its components. A surface that is known already is not found again.
     *
     * @private
     */
    public final class InteriorBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** Knows the surface that the triangles make, and what is inside of it, when no step is left. */
        public var windingCounter:WindingCounter;

        // Which vertices are at the same place; null if the surface is known, and no vertices of its seams are apart.
        private var _welding:Welding = null;

        /**
         * @param tree of the triangles, whose corners are listed
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function InteriorBuilder(tree:BoxTree, knownSurface:SurfaceTopology)
        {
            windingCounter = new WindingCounter(tree, knownSurface || new SurfaceTopology(tree.primitiveCount));
            if (knownSurface == null || knownSurface.widestSeam > 0)
            {
                _welding = new Welding(tree.vertices);
                add(_welding).call(takeSeams);
            }
            if (knownSurface == null)
            {
                begin(findSurface);
            }
            call(beginPoints).slices(tree.primitiveCount, TRIANGLES_PER_STEP, takePoints);
        }

        private function takeSeams():void
        {
            if (_welding.widestSeam > 0)
            {
                windingCounter.welded = _welding.welded;
            }
        }

        private function findSurface():Steps
        {
            var surface:SurfaceTopology = windingCounter.surface;
            var triangles:Vector.<uint> = windingCounter.tree.triangles;
            var edges:EdgeMatcher = new EdgeMatcher(triangles, _welding);
            var shells:ShellFinder = new ShellFinder(surface, edges);
            surface.widestSeam = _welding.widestSeam;
            return new StepSequence().add(new ComponentFinder(surface, triangles, _welding.welded)).add(edges).add(shells).begin(function():Steps
                {
                    return new CavityFinder(windingCounter, shells, _welding.welded);
                });
        }

        private function beginPoints():void
        {
            windingCounter.hasClosedShell = windingCounter.surface.hasClosedShell;
            windingCounter.componentPoints = zeroedNumbers(3 * windingCounter.surface.componentCount);
        }

        // Takes a corner of each triangle as the point of its component. The last one counts.
        private function takePoints(first:int, end:int):void
        {
            var tree:BoxTree = windingCounter.tree;
            for (var index:int = first; index < end; index++)
            {
                var to:int = 3 * windingCounter.surface.components[tree.primitives[index]];
                var from:int = tree.cornerOffsets[int(3 * index)];
                for (var axis:int = 0; axis < 3; axis++)
                {
                    windingCounter.componentPoints[int(to + axis)] = tree.vertices[int(from + axis)];
                }
            }
        }
    }
}
