package starlogo.solid
{
    import starlogo.steps.Steps;

    /**
     * Finds the pieces of a surface: triangles that are connected over edges. It goes from triangle to triangle, and finds which of a
     * piece's triangles have to be reversed so that all have the same orientation.
     */
    internal final class PieceFinder implements Steps
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** For each piece, the number of its triangles that are not reversed, minus the number of those that are. */
        public var balances:Vector.<int> = new Vector.<int>();

        private var _surface:SurfaceTopology;
        private var _edges:EdgeMatcher;
        private var _first:int = 0;

        // The triangles of all pieces so far. It is also the queue of triangles to visit.
        private var _queue:Vector.<int> = new Vector.<int>();
        private var _next:int = 0;

        /**
         * @param surface receives the pieces
         * @param edges matched before the first step
         */
        public function PieceFinder(surface:SurfaceTopology, edges:EdgeMatcher)
        {
            _surface = surface;
            _edges = edges;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            var signedPieces:Vector.<int> = _surface.signedPieces;
            for (var i:int = 0; i < TRIANGLES_PER_STEP; i++)
            {
                if (_next < _queue.length)
                {
                    goOnFrom(_queue[_next++]);
                }
                else if (_first == signedPieces.length)
                {
                    return false;
                }
                else
                {
                    if (signedPieces[_first] == 0 && _edges.hasEdges(_first))
                    {
                        _surface.pieceStates.push(SurfaceTopology.SOLID);
                        balances.push(0);
                        add(_first, balances.length);
                    }
                    _first++;
                }
            }
            return true;
        }

        private function add(triangle:int, side:int):void
        {
            _surface.signedPieces[triangle] = side;
            balances[int(balances.length - 1)] += side > 0 ? 1 : -1;
            _queue.push(triangle);
        }

        private function goOnFrom(triangle:int):void
        {
            var piece:int = balances.length - 1;
            var pieceStates:Vector.<int> = _surface.pieceStates;
            for (var edge:int = 3 * triangle; edge < 3 * triangle + 3; edge++)
            {
                var partner:int = _edges.partners[edge] - 1;
                if (partner < 0)
                {
                    pieceStates[piece] = SurfaceTopology.OPEN;
                    continue;
                }
                var side:int = _surface.signedPieces[triangle];
                if (_edges.beginOf(edge) == _edges.beginOf(partner))
                {
                    side = -side;
                }
                var neighbour:int = partner / 3;
                if (_surface.signedPieces[neighbour] == 0)
                {
                    add(neighbour, side);
                }
                else if (_surface.signedPieces[neighbour] != side && pieceStates[piece] == SurfaceTopology.SOLID)
                {
                    pieceStates[piece] = SurfaceTopology.ONE_SIDED;
                }
            }
        }
    }
}
