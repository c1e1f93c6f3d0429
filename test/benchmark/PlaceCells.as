package benchmark
{
    import starlogo.agents.Agent;

    /**
     * The floor that counts of what is near are measured against: places copied in the order of cells of a bounded ground, as wide as the radius,
     * of which nine are looked at. It knows one radius, no filters and no list.
     */
    public final class PlaceCells
    {
        private var _halfWidth:Number;
        private var _radius:Number;
        private var _columns:int;
        private var _starts:Vector.<int>;
        private var _cells:Vector.<int>;
        private var _x:Vector.<Number>;
        private var _y:Vector.<Number>;
        private var _z:Vector.<Number>;

        /**
         * @param halfWidth the ground reaches from -halfWidth to halfWidth in x and y
         * @param radius of all questions
         * @param count how many agents there are
         */
        public function PlaceCells(halfWidth:Number, radius:Number, count:int)
        {
            // a border of empty cells all around spares the loop its checks
            _halfWidth = halfWidth + radius;
            _radius = radius;
            _columns = int(2 * halfWidth / radius) + 3;
            _starts = new Vector.<int>(_columns * _columns + 2, true);
            _cells = new Vector.<int>(count, true);
            _x = new Vector.<Number>(count, true);
            _y = new Vector.<Number>(count, true);
            _z = new Vector.<Number>(count, true);
        }

        /** Takes the places of agents. */
        public function update(agents:Vector.<Agent>):void
        {
            var starts:Vector.<int> = _starts;
            var count:int = agents.length;
            for (var i:int = 0; i < starts.length; i++)
            {
                starts[i] = 0;
            }
            for (i = 0; i < count; i++)
            {
                var cell:int = cellOf(agents[i].x, agents[i].y);
                _cells[i] = cell;
                starts[int(cell + 2)]++;
            }
            for (i = 2; i < starts.length; i++)
            {
                starts[i] += starts[int(i - 1)];
            }
            for (i = 0; i < count; i++)
            {
                var agent:Agent = agents[i];
                var at:int = starts[int(_cells[i] + 1)]++;
                _x[at] = agent.x;
                _y[at] = agent.y;
                _z[at] = agent.z;
            }
        }

        /** How many agents are near one, itself among them. */
        public function count(agent:Agent):int
        {
            var x:Number = agent.x;
            var y:Number = agent.y;
            var z:Number = agent.z;
            var limit:Number = _radius * _radius;
            var near:int = 0;
            var cell:int = cellOf(x, y) - _columns - 1;
            for (var line:int = 0; line < 3; line++)
            {
                var end:int = _starts[int(cell + 3)];
                for (var at:int = _starts[cell]; at < end; at++)
                {
                    var toX:Number = _x[at] - x;
                    var toY:Number = _y[at] - y;
                    var toZ:Number = _z[at] - z;
                    if (toX * toX + toY * toY + toZ * toZ <= limit)
                    {
                        near++;
                    }
                }
                cell += _columns;
            }
            return near;
        }

        private function cellOf(x:Number, y:Number):int
        {
            return int((y + _halfWidth) / _radius) * _columns + int((x + _halfWidth) / _radius);
        }
    }
}
