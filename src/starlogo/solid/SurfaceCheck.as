package starlogo.solid
{
    /**
     * Finds out in steps what a SurfaceBuilder does, several times as fast, where it is known which triangles must be turned round.
     *
     * <p>What is known is not believed. Whether edges cancel out needs no pairing of them: every pair of vertices has a number that
     * looks random; along a surface that closes the exclusive or of all edges' numbers is 0, and along one that is oriented
     * the sum of those in one direction less those in the other. A surface of another kind passes once in four billion.</p>
     */
    internal final class SurfaceCheck extends SurfaceFinder
    {
        private static const TRIANGLES_PER_STEP:int = 1000;

        private var _isTurned:Vector.<Boolean>;

        // A random number for each vertex.
        private var _marks:Vector.<int>;

        private var _parity:int = 0;
        private var _balance:int = 0;
        private var _turnedBalance:int = 0;

        // Of each piece how many triangles it has, less twice those that are turned.
        private var _majorities:Vector.<int> = new Vector.<int>();

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         * @param isTurned for each triangle, whether it must be turned round, as a SurfaceBuilder found it; null if none must
         */
        public function SurfaceCheck(vertices:Vector.<Number>, triangles:Vector.<uint>, isTurned:Vector.<Boolean>)
        {
            super(vertices, triangles, TRIANGLES_PER_STEP);
            _isTurned = isTurned;
            _marks = randomNumbers(vertices.length / 3);
            call(conclude);
        }

        // Marsaglia, "Xorshift RNGs", Journal of Statistical Software 8(14), 2003.
        private static function randomNumbers(count:int):Vector.<int>
        {
            var numbers:Vector.<int> = new Vector.<int>(count, true);
            var number:int = 0x2545F491;
            for (var i:int = 0; i < count; i++)
            {
                number ^= number << 13;
                number ^= number >>> 17;
                number ^= number << 5;
                numbers[i] = number;
            }
            return numbers;
        }

        /** @inheritDoc */
        override protected function addTriangle(triangle:int, a:int, b:int, c:int):void
        {
            var first:int = mixed(_marks[a] ^ _marks[b]);
            var second:int = mixed(_marks[b] ^ _marks[c]);
            var third:int = mixed(_marks[c] ^ _marks[a]);
            _parity ^= first ^ second ^ third;
            var sum:int = a < b ? first : -first;
            sum += b < c ? second : -second;
            sum += c < a ? third : -third;
            _balance += sum;
            _turnedBalance += _isTurned != null && _isTurned[triangle] ? -sum : sum;
        }

        // Jenkins's one-at-a-time hash's last lines, twice.
        private static function mixed(both:int):int
        {
            both += both << 10;
            both ^= both >>> 6;
            both += both << 3;
            both ^= both >>> 11;
            both += both << 15;
            both ^= both >>> 7;
            return both;
        }

        /** @inheritDoc */
        override protected function addToPiece(triangle:int, piece:int):void
        {
            if (piece == _majorities.length)
            {
                _majorities.push(0);
            }
            _majorities[piece] += _isTurned != null && _isTurned[triangle] ? -1 : 1;
        }

        private function conclude():void
        {
            found.isClosed = hasArea && _parity == 0;
            found.isOriented = found.isClosed && _balance == 0;
            var mustTurn:Boolean = found.isClosed && _balance != 0;
            if (!mustTurn && _isTurned == null)
            {
                return;
            }
            if (mustTurn && _isTurned != null && _turnedBalance == 0 && areFewTurned())
            {
                found.isOriented = true;
                found.isTurned = _isTurned;
                return;
            }
            found = null;
        }

        // A piece keeps the side that most of its triangles have for the front.
        private function areFewTurned():Boolean
        {
            for each (var majority:int in _majorities)
            {
                if (majority < 0)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
