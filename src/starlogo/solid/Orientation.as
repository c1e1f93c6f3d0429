package starlogo.solid
{
    import starlogo.steps.Steps;

    /**
     * Orients the triangles of a closed surface alike where some were turned round by mistake: from triangle to triangle over the edges that just
     * two share. A connected part keeps the side that most of its triangles have for the front, or, if it is a draw, faces outwards.
     */
    internal final class Orientation implements Steps
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        /** For each triangle, whether it must be turned round, when no step is left; null if the surface cannot be oriented. */
        public var isTurned:Vector.<Boolean>;

        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;

        // Three a triangle: the neighbour over each edge, counted from 1, or 0, and whether one of the two must be turned.
        private var _neighbours:Vector.<int>;
        private var _differs:Vector.<Boolean>;
        private var _isKnown:Vector.<Boolean>;
        private var _first:int = 0;

        // Those connected so far, which is also the queue of those to go on from.
        private var _part:Vector.<int> = new Vector.<int>();
        private var _next:int = 0;

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         */
        public function Orientation(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _vertices = vertices;
            _triangles = triangles;
        }

        /**
         * Says that two triangles share an edge with no other.
         *
         * @param a three times the number of the first, plus that of its edge, from 0
         * @param b the same of the second
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
                    // one-sided, like Klein's bottle
                    isTurned = null;
                    return;
                }
            }
        }

        // Turns the other triangles of a part instead if they are fewer.
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

        // Six times the volume, of which the sign counts.
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
