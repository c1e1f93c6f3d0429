package benchmark
{
    import starlogo.agents.Agent;

    /**
     * The floor that BinCollider is measured against: the fastest broad phase for agents that are unit spheres over a bounded
     * ground that could be written by hand. It reads where the agents are, counts how many are in each cell as wide as a sphere,
     * copies their places in the order of the cells, and looks at half the neighbourhood of each: two runs of that order. It checks
     * no input, and knows neither models nor sizes.
     */
    public final class AgentCells
    {
        private var _shift:Number;
        private var _columns:int;
        private var _starts:Vector.<int>;
        private var _cells:Vector.<int>;
        private var _order:Vector.<int>;
        private var _readX:Vector.<Number>;
        private var _readY:Vector.<Number>;
        private var _readZ:Vector.<Number>;
        private var _x:Vector.<Number>;
        private var _y:Vector.<Number>;
        private var _z:Vector.<Number>;

        /**
         * @param halfWidth the ground reaches from -halfWidth to halfWidth in x and y
         * @param count how many agents there are
         */
        public function AgentCells(halfWidth:Number, count:int)
        {
            // a border of empty cells all around spares the inner loop its checks
            _shift = halfWidth + 1;
            _columns = int(2 * halfWidth + 1) + 2;
            _starts = new Vector.<int>(_columns * _columns + 2);
            _cells = new Vector.<int>(count, true);
            _order = new Vector.<int>(count, true);
            _readX = new Vector.<Number>(count, true);
            _readY = new Vector.<Number>(count, true);
            _readZ = new Vector.<Number>(count, true);
            _x = new Vector.<Number>(count, true);
            _y = new Vector.<Number>(count, true);
            _z = new Vector.<Number>(count, true);
        }

        /**
         * Finds the pairs that touch.
         *
         * @param agents as many as were announced
         * @param out a0, b0, a1, b1, ...
         */
        public function find(agents:Vector.<Agent>, out:Vector.<Agent>):void
        {
            sort(agents);
            var order:Vector.<int> = _order;
            var x:Vector.<Number> = _x;
            var y:Vector.<Number> = _y;
            var z:Vector.<Number> = _z;
            var starts:Vector.<int> = _starts;
            var columns:int = _columns;
            var last:int = columns * (columns - 1) - 2;
            var found:int = 0;
            var end:int = 0;
            for (var cell:int = columns + 1; cell <= last; cell++)
            {
                var i:int = end;
                end = starts[cell + 1];
                if (i == end)
                {
                    continue;
                }
                var right:int = starts[cell + 2];
                var below:int = starts[cell + columns - 1];
                var belowEnd:int = starts[cell + columns + 2];
                for (; i < end; i++)
                {
                    var xi:Number = x[i];
                    var yi:Number = y[i];
                    var zi:Number = z[i];
                    var agent:Agent = agents[order[i]];
                    // the rest of its own cell and the cell to the right
                    for (var j:int = i + 1; j < right; j++)
                    {
                        var dx:Number = x[j] - xi;
                        // spares Ruffle the rest of a third of them
                        if (dx > 1)
                        {
                            continue;
                        }
                        var dy:Number = y[j] - yi;
                        var dz:Number = z[j] - zi;
                        if (dx * dx + dy * dy + dz * dz <= 1)
                        {
                            out[found] = agent;
                            out[found + 1] = agents[order[j]];
                            found += 2;
                        }
                    }
                    // the three cells below
                    for (j = below; j < belowEnd; j++)
                    {
                        dx = x[j] - xi;
                        dy = y[j] - yi;
                        dz = z[j] - zi;
                        if (dx * dx + dy * dy + dz * dz <= 1)
                        {
                            out[found] = agent;
                            out[found + 1] = agents[order[j]];
                            found += 2;
                        }
                    }
                }
            }
            out.length = found;
        }

        // Reads the agents, and puts them into the order of their cells.
        private function sort(agents:Vector.<Agent>):void
        {
            var readX:Vector.<Number> = _readX;
            var readY:Vector.<Number> = _readY;
            var readZ:Vector.<Number> = _readZ;
            var cells:Vector.<int> = _cells;
            var starts:Vector.<int> = _starts;
            var columns:int = _columns;
            var shift:Number = _shift;
            var count:int = agents.length;
            var all:int = starts.length;
            // native, where a loop is not
            starts.length = 0;
            starts.length = all;
            for (var i:int = 0; i < count; i++)
            {
                var agent:Agent = agents[i];
                var ax:Number = agent.x;
                var ay:Number = agent.y;
                readX[i] = ax;
                readY[i] = ay;
                readZ[i] = agent.z;
                var cell:int = int(ay + shift) * columns + int(ax + shift);
                cells[i] = cell;
                starts[cell]++;
            }
            var sum:int = 0;
            for (cell = 0; cell < all; cell++)
            {
                sum += starts[cell];
                starts[cell] = sum;
            }
            var order:Vector.<int> = _order;
            var x:Vector.<Number> = _x;
            var y:Vector.<Number> = _y;
            var z:Vector.<Number> = _z;
            // each cell's end becomes its start
            for (i = 0; i < count; i++)
            {
                cell = cells[i];
                var place:int = starts[cell] - 1;
                starts[cell] = place;
                order[place] = i;
                x[place] = readX[i];
                y[place] = readY[i];
                z[place] = readZ[i];
            }
        }
    }
}
