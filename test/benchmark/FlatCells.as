package benchmark
{
    /**
     * The floor that BinCollider is measured against: the fastest broad phase for spheres of one size over a bounded
     * ground that could be written by hand. Linked cells just as wide as a sphere, half the neighbourhood, flat vectors
     * of numbers instead of agents, no checks of any input.
     */
    public final class FlatCells
    {
        /** The pairs found: two indices a pair. */
        public var pairs:Vector.<int> = new Vector.<int>();

        /** How many numbers of pairs are in use. */
        public var length:int;

        private var _columns:int;
        private var _rows:int;
        private var _origin:Number;
        private var _perWidth:Number;
        private var _heads:Vector.<int> = new Vector.<int>();
        private var _offsets:Vector.<int>;
        private var _cells:Vector.<int> = new Vector.<int>();
        private var _next:Vector.<int> = new Vector.<int>();

        /**
         * @param halfWidth the ground reaches from -halfWidth to halfWidth in x and y
         * @param diameter of the largest sphere
         */
        public function FlatCells(halfWidth:Number, diameter:Number)
        {
            // a border of empty cells all around spares the inner loop its checks
            _origin = -halfWidth - diameter;
            _perWidth = 1 / diameter;
            _columns = int(2 * halfWidth / diameter) + 4;
            _rows = _columns;
            _offsets = new <int>[1, _columns - 1, _columns, _columns + 1];
        }

        /** Finds the pairs of spheres that touch. */
        public function find(x:Vector.<Number>, y:Vector.<Number>, z:Vector.<Number>, radius:Vector.<Number>):void
        {
            var heads:Vector.<int> = _heads;
            var cells:Vector.<int> = _cells;
            var offsets:Vector.<int> = _offsets;
            var next:Vector.<int> = _next;
            var out:Vector.<int> = pairs;
            var columns:int = _columns;
            var origin:Number = _origin;
            var perWidth:Number = _perWidth;
            var count:int = x.length;
            var found:int = 0;
            if (next.length < count + 1)
            {
                next.length = count + 1;
            }
            heads.length = 0;
            heads.length = columns * _rows;
            for (var i:int = 0; i < count; i++)
            {
                var cell:int = int((y[i] - origin) * perWidth) * columns + int((x[i] - origin) * perWidth);
                cells[i] = cell;
                next[i + 1] = heads[cell];
                heads[cell] = i + 1;
            }
            for (i = 0; i < count; i++)
            {
                var xi:Number = x[i];
                var yi:Number = y[i];
                var zi:Number = z[i];
                var ri:Number = radius[i];
                cell = cells[i];
                // the rest of its own cell, then four of the eight around it
                var link:int = next[i + 1];
                for (var neighbour:int = 0; neighbour < 5; neighbour++)
                {
                    while (link != 0)
                    {
                        var j:int = link - 1;
                        link = next[link];
                        var dx:Number = x[j] - xi;
                        if (dx > 1 || dx < -1)
                        {
                            continue;
                        }
                        var dy:Number = y[j] - yi;
                        if (dy > 1 || dy < -1)
                        {
                            continue;
                        }
                        var dz:Number = z[j] - zi;
                        var reach:Number = ri + radius[j];
                        if (dx * dx + dy * dy + dz * dz <= reach * reach)
                        {
                            out[found] = i;
                            out[found + 1] = j;
                            found += 2;
                        }
                    }
                    if (neighbour < 4)
                    {
                        link = heads[cell + offsets[neighbour]];
                    }
                }
            }
            length = found;
        }
    }
}
