package starlogo.solid
{
    import starlogo.convex.FaceNormal;
    import starlogo.steps.StepSequence;

    /**
     * Finds which pieces of a surface bound cavities, in steps. A piece bounds a cavity if it lies inside of a solid piece, has the opposite
     * orientation, and no other cavity of that solid piece contains it. Only surfaces with pieces of both orientations are searched.
     */
    internal final class CavityFinder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 25;

        // After so many looks at pieces for each triangle, one point decides about each piece. Only models with very many nested pieces reach
        // this limit.
        private static const LOOKS_PER_TRIANGLE:int = 20;

        // How far inside of its piece a point is tested, as a fraction of the piece's extent. Smaller: rounding decides where pieces touch.
        // Larger: it may be outside of a thin piece.
        private static const INWARDS:Number = 1e-7;

        // How much larger a piece has to be to have the other one inside, as a fraction.
        private static const LARGER:Number = 1e-9;

        private var _solid:Solid;
        private var _balances:Vector.<int>;

        // For each piece, its outermost points, a corner, six times the volume, and 1 or -1 for its orientation.
        private var _extremes:PartExtremes;
        private var _corners:Vector.<int>;
        private var _volumes:Vector.<Number>;
        private var _orientations:Vector.<int>;

        // For each piece, the larger pieces that are around all of its points tested so far. Null before the first point.
        private var _around:Vector.<Vector.<int>>;

        private var _face:FaceNormal = new FaceNormal();
        private var _looks:int = 0;
        private var _mostLooks:int;

        /**
         * @param solid has the pieces; receives the cavities
         * @param balances for each piece, the number of its triangles that are not reversed, minus the number of those that are
         */
        public function CavityFinder(solid:Solid, balances:Vector.<int>)
        {
            var pieces:int = balances.length;
            _solid = solid;
            _mostLooks = LOOKS_PER_TRIANGLE * solid.surface.signedPieces.length;
            _balances = balances;
            if (pieces > 1)
            {
                _extremes = new PartExtremes(solid.corners, pieces);
                _corners = new Vector.<int>(pieces, true);
                _volumes = new Vector.<Number>(pieces, true);
                _orientations = new Vector.<int>(pieces, true);
                _around = new Vector.<Vector.<int>>(pieces, true);
                slices(solid.surface.signedPieces.length, 40 * TRIANGLES_PER_STEP, measure).call(orient);
            }
        }

        private function isSolid(piece:int):Boolean
        {
            return piece >= 0 && _solid.surface.pieceStates[piece] == SurfaceTopology.SOLID;
        }

        private function pieceOf(triangle:int):int
        {
            return Math.abs(_solid.sideOf(triangle)) - 1;
        }

        private function measure(first:int, end:int):void
        {
            var corners:Vector.<Number> = _solid.corners;
            for (var i:int = first; i < end; i++)
            {
                var piece:int = pieceOf(i);
                if (!isSolid(piece))
                {
                    continue;
                }
                _corners[piece] ||= 9 * i + 1;
                _extremes.add(piece, i);
                _face.setTriangle(corners, 9 * i);
                if (_face.length > 0)
                {
                    var from:int = _corners[piece] - 1;
                    var volume:Number = _face.length * (_face.x * (corners[9 * i] - corners[from])
                            + _face.y * (corners[9 * i + 1] - corners[from + 1]) + _face.z * (corners[9 * i + 2] - corners[from + 2]));
                    _volumes[piece] += _solid.sideOf(i) > 0 ? volume : -volume;
                }
            }
        }

        // A piece has the orientation of most of its triangles. If both are equally frequent, its triangles face outwards.
        private function orient():void
        {
            var isFound:Vector.<Boolean> = new Vector.<Boolean>(3, true);
            for (var piece:int = 0; piece < _balances.length; piece++)
            {
                var sign:int = _volumes[piece] > 0 ? 1 : (_volumes[piece] < 0 ? -1 : 0);
                _orientations[piece] = _balances[piece] > 0 ? sign : (_balances[piece] < 0 ? -sign : sign * sign);
                isFound[_orientations[piece] + 1] = true;
            }
            if (isFound[0] && isFound[2])
            {
                slices(_solid.surface.signedPieces.length, TRIANGLES_PER_STEP, testSome).call(decide);
            }
        }

        // Tests four points of each triangle: its middle, and points near its corners.
        private function testSome(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var piece:int = pieceOf(i);
                for (var corner:int = 3; corner >= 0 && isSolid(piece) && (_around[piece] == null || _around[piece].length > 0 && _looks < _mostLooks); corner--)
                {
                    windAround(piece, i, corner);
                    _around[piece] = stillAround(piece, _around[piece]);
                    _solid.unwind();
                }
            }
        }

        // Counts the windings around a point that is a little inside of its piece.
        private function windAround(piece:int, triangle:int, corner:int):void
        {
            var corners:Vector.<Number> = _solid.corners;
            var at:int = 9 * triangle;
            var inwards:Number = INWARDS * _extremes.extentAt(_extremes.pointsAt[piece]);
            var isOutwards:Boolean = _solid.sideOf(triangle) > 0 == _volumes[piece] > 0;
            var share:Number = corner == 3 ? 1 / 3 : 0.01;
            var point:Vector.<Number> = new Vector.<Number>(3, true);
            for (var axis:int = 0; axis < 3; axis++)
            {
                point[axis] = share * (corners[at + axis] + corners[at + 3 + axis] + corners[at + 6 + axis])
                    + (corner == 3 ? 0 : 0.97 * corners[at + 3 * corner + axis])
                    + (isOutwards ? -inwards : inwards) * _solid.planes[4 * triangle + axis];
            }
            _solid.wind(point[0], point[1], point[2]);
            _looks += _solid.woundCount;
        }

        // Returns the pieces that wind around the last point; none if all of them have the orientation of this piece.
        private function stillAround(piece:int, before:Vector.<int>):Vector.<int>
        {
            var around:Vector.<int> = new Vector.<int>();
            var hasOpposite:Boolean = false;
            var from:Vector.<int> = before == null ? _solid.wound : before;
            var count:int = before == null ? _solid.woundCount : before.length;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = from[i];
                if (_solid.windings[other] != 0 && (before != null || isLarger(other, piece)))
                {
                    around.push(other);
                    hasOpposite ||= _orientations[other] == -_orientations[piece];
                }
                // so that it is not counted again
                _solid.windings[other] = 0;
            }
            around.length = hasOpposite ? around.length : 0;
            return around;
        }

        // Whether a piece may have another one inside.
        private function isLarger(outer:int, inner:int):Boolean
        {
            var points:Vector.<Number> = _extremes.points;
            var isAround:Boolean = isSolid(outer) && Math.abs(_volumes[outer]) > (1 + LARGER) * Math.abs(_volumes[inner]);
            for (var axis:int = 0; axis < 3 && isAround; axis++)
            {
                var a:int = _extremes.pointsAt[outer] + 7 * axis;
                var b:int = _extremes.pointsAt[inner] + 7 * axis;
                var rounding:Number = LARGER * (points[b + 3] - points[b]);
                isAround = points[a] <= points[b] + rounding && points[a + 3] >= points[b + 3] - rounding;
            }
            return isAround;
        }

        // Decides about the largest pieces first. A piece that is around another one is larger.
        private function decide():void
        {
            var sizes:Array = [];
            for each (var volume:Number in _volumes)
            {
                sizes.push(-Math.abs(volume));
            }
            for each (var piece:int in sizes.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY))
            {
                var innermost:int = -1;
                for each (var outer:int in _around[piece] == null ? new Vector.<int>() : _around[piece])
                {
                    if (innermost < 0 || sizes[outer] > sizes[innermost])
                    {
                        innermost = outer;
                    }
                }
                if (isSolid(innermost) && _orientations[innermost] == -_orientations[piece])
                {
                    _solid.surface.pieceStates[piece] = innermost;
                }
            }
        }
    }
}
