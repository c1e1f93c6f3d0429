package starlogo.solid.interior
{
    import starlogo.data.zeroedInts;
    import starlogo.steps.StepSequence;

    /**
     * Finds the shells of a surface: triangles that are connected over edges. It goes from triangle to triangle, and finds which of a
     * shell's triangles have to be reversed so that all have the same orientation.
     */
    internal final class ShellFinder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** For each shell, the number of its triangles that are not reversed, minus the number of those that are. */
        public var balances:Vector.<int> = new Vector.<int>();

        /**
         * The triangles of all shells so far, shell by shell, and how many they are. It is also the queue of triangles to visit: from the next one on, as
         * far as it goes.
         */
        public var triangles:Vector.<int>;
        public var triangleCount:int = 0;

        private var _surface:SurfaceTopology;
        private var _edges:EdgeMatcher;

        // The first triangle that may begin another shell.
        private var _nextSeed:int = 0;

        // The next entry of triangles to visit.
        private var _nextQueued:int = 0;

        /**
         * @param surface receives the shells
         * @param edges matched before the first step
         */
        public function ShellFinder(surface:SurfaceTopology, edges:EdgeMatcher)
        {
            _surface = surface;
            _edges = edges;
            triangles = zeroedInts(surface.orientedShells.length);
            repeat(visitTriangles);
        }

        private function visitTriangles():Boolean
        {
            var orientedShells:Vector.<int> = _surface.orientedShells;
            for (var i:int = 0; i < TRIANGLES_PER_STEP; i++)
            {
                if (_nextQueued < triangleCount)
                {
                    visitNeighbours(triangles[_nextQueued++]);
                }
                else if (_nextSeed == orientedShells.length)
                {
                    return false;
                }
                else
                {
                    if (orientedShells[_nextSeed] == 0 && _edges.hasEdges(_nextSeed))
                    {
                        _surface.shellStates.push(SurfaceTopology.ORIENTABLE);
                        balances.push(0);
                        addTriangle(_nextSeed, balances.length);
                    }
                    _nextSeed++;
                }
            }
            return true;
        }

        private function addTriangle(triangle:int, orientedShell:int):void
        {
            _surface.orientedShells[triangle] = orientedShell;
            balances[int(balances.length - 1)] += orientedShell > 0 ? 1 : -1;
            triangles[triangleCount++] = triangle;
        }

        private function visitNeighbours(triangle:int):void
        {
            var partners:Vector.<int> = _edges.partners;
            var orientedShells:Vector.<int> = _surface.orientedShells;
            var own:int = orientedShells[triangle];
            for (var edge:int = 3 * triangle; edge < 3 * triangle + 3; edge++)
            {
                var partner:int = partners[edge];
                if (partner < 0)
                {
                    lowerState(SurfaceTopology.OPEN);
                    continue;
                }
                var expected:int = _edges.beginOf(edge) == _edges.beginOf(partner) ? -own : own;
                var neighbour:int = partner / 3;
                var found:int = orientedShells[neighbour];
                if (found == 0)
                {
                    addTriangle(neighbour, expected);
                }
                else if (found != expected)
                {
                    lowerState(SurfaceTopology.NON_ORIENTABLE);
                }
            }
        }

        // The last shell is open rather than non-orientable, and that rather than orientable: the least state counts.
        private function lowerState(state:int):void
        {
            var states:Vector.<int> = _surface.shellStates;
            states[int(states.length - 1)] = Math.min(states[int(states.length - 1)], state);
        }
    }
}
