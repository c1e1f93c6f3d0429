package starlogo.solid
{
    import starlogo.steps.Steps;

    /**
     * Finds which triangles of a closed surface must be reversed so that all have the same orientation. It goes from triangle to triangle
     * over the edges that exactly two triangles share. Each connected part keeps the orientation of most of its triangles. If both are
     * equally frequent, its triangles face outwards.
     */
    internal final class Orientation implements Steps
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** For each triangle, whether it must be reversed. Valid after the last step. Null if the surface cannot be oriented. */
        public var isTurned:Vector.<Boolean>;

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;

        // For each edge of each triangle: the neighbour over it, counted from 1, or 0; and whether exactly one of the two must be reversed.
        private var _neighbours:Vector.<int>;
        private var _differs:Vector.<Boolean>;
        private var _isKnown:Vector.<Boolean>;
        private var _first:int = 0;

        // The triangles connected so far. It is also the queue of triangles to visit.
        private var _part:Vector.<int> = new Vector.<int>();
        private var _next:int = 0;

        /**
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each
         */
        public function Orientation(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
        }

        /**
         * Connects two triangles that share an edge with no other triangle.
         *
         * @param a three times the first triangle's index, plus the number of its edge, from 0
         * @param b three times the second triangle's index, plus the number of its edge, from 0
         * @param differs whether both run along the edge in the same direction
         */
        public function connect(a:int, b:int, differs:Boolean):void
        {
            if (_neighbours == null)
            {
                var count:int = _triangles.length;
                _neighbours = new Vector.<int>(count, true);
                _differs = new Vector.<Boolean>(count, true);
                _isKnown = new Vector.<Boolean>(count / 3, true);
                isTurned = new Vector.<Boolean>(count / 3, true);
            }
            _neighbours[a] = 1 + int(b / 3);
            _neighbours[b] = 1 + int(a / 3);
            _differs[a] = _differs[b] = differs;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            for (var i:int = 0; i < TRIANGLES_PER_STEP && isTurned != null; i++)
            {
                if (_next < _part.length)
                {
                    goOnFrom(_part[_next++]);
                    continue;
                }
                turnPart();
                _part.length = _next = 0;
                while (_first < _isKnown.length && _isKnown[_first])
                {
                    _first++;
                }
                if (_first == _isKnown.length)
                {
                    return false;
                }
                _isKnown[_first] = true;
                isTurned[_first] = false;
                _part.push(_first);
            }
            return isTurned != null;
        }

        private function goOnFrom(triangle:int):void
        {
            for (var edge:int = 3 * triangle; edge < 3 * triangle + 3; edge++)
            {
                var neighbour:int = _neighbours[edge] - 1;
                if (neighbour < 0)
                {
                    continue;
                }
                var mustTurn:Boolean = isTurned[triangle] != _differs[edge];
                if (!_isKnown[neighbour])
                {
                    _isKnown[neighbour] = true;
                    isTurned[neighbour] = mustTurn;
                    _part.push(neighbour);
                }
                else if (isTurned[neighbour] != mustTurn)
                {
                    // The surface is one-sided, like Klein's bottle.
                    isTurned = null;
                    return;
                }
            }
        }

        // Reverses the other triangles of a part instead if they are fewer.
        private function turnPart():void
        {
            var turned:int = 0;
            for each (var triangle:int in _part)
            {
                turned += isTurned[triangle] ? 1 : 0;
            }
            if (2 * turned > _part.length || (2 * turned == _part.length && volumeOfPart() < 0))
            {
                for each (triangle in _part)
                {
                    isTurned[triangle] = !isTurned[triangle];
                }
            }
        }

        // Six times the volume. Only its sign is used.
        private function volumeOfPart():Number
        {
            var sum:Number = 0;
            for each (var triangle:int in _part)
            {
                var a:int = 3 * _triangles[3 * triangle];
                var b:int = 3 * _triangles[3 * triangle + 1];
                var c:int = 3 * _triangles[3 * triangle + 2];
                var volume:Number = _vertices[a] * (_vertices[b + 1] * _vertices[c + 2] - _vertices[b + 2] * _vertices[c + 1])
                    + _vertices[a + 1] * (_vertices[b + 2] * _vertices[c] - _vertices[b] * _vertices[c + 2])
                    + _vertices[a + 2] * (_vertices[b] * _vertices[c + 1] - _vertices[b + 1] * _vertices[c]);
                sum += isTurned[triangle] ? -volume : volume;
            }
            return sum;
        }
    }
}
