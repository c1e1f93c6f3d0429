package starlogo.solid
{
    /**
     * Finds out what a model's triangles are as a whole, in steps: every edge is compared with those between the same two places. Costs
     * sorting vertices and edges, and a few look-ups for each triangle.
     */
    internal final class SurfaceBuilder extends SurfaceFinder
    {
        private static const TRIANGLES_PER_STEP:int = 400;

        private var _orientation:Orientation;

        // Three for each triangle that has an area.
        private var _edges:EdgeBuckets;
        private var _bucket:int = 0;

        /**
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         */
        public function SurfaceBuilder(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            super(vertices, triangles, TRIANGLES_PER_STEP);
            _orientation = new Orientation(vertices, triangles);
            _edges = new EdgeBuckets(vertices.length / 3, triangles.length);
            repeat(compareSome).call(conclude);
        }

        /** @inheritDoc */
        override protected function addTriangle(triangle:int, a:int, b:int, c:int):void
        {
            _edges.add(3 * triangle, a, b);
            _edges.add(3 * triangle + 1, b, c);
            _edges.add(3 * triangle + 2, c, a);
        }

        // Whether the next bucket's edges between the same two vertices close the surface, and cancel out.
        private function compareSome():Boolean
        {
            var isTurned:Vector.<Boolean> = found.isTurned;
            var pairs:Array = _edges.pairsOf(_bucket);
            var edges:Array = _edges.edgesOf(_bucket);
            var order:Array = _edges.orderOf(_bucket++);
            var count:int = order.length;
            var i:int = 0;
            while (i < count)
            {
                var first:int = i;
                var pair:Number = pairs[order[i]];
                var balance:int = 0;
                while (i < count && pairs[order[i]] == pair)
                {
                    var edge:int = edges[order[i++]];
                    var isBackward:Boolean = edge < 0;
                    if (isTurned != null && isTurned[int(EdgeBuckets.numberOf(edge) / 3)])
                    {
                        isBackward = !isBackward;
                    }
                    balance += isBackward ? -1 : 1;
                }
                found.isOriented &&= balance == 0;
                if (isTurned == null)
                {
                    compare(edges, order, first, i, balance);
                }
            }
            return _bucket < _edges.length;
        }

        // Edges of the same two vertices, from one place in the order up to another.
        private function compare(edges:Array, order:Array, first:int, end:int, balance:int):void
        {
            found.isClosed &&= (end - first) % 2 == 0;
            if (end - first == 2)
            {
                var a:int = EdgeBuckets.numberOf(edges[order[first]]);
                var b:int = EdgeBuckets.numberOf(edges[order[int(first + 1)]]);
                _orientation.connect(a, b, balance != 0);
            }
        }

        private function conclude():void
        {
            found.isClosed &&= hasArea;
            found.isOriented &&= found.isClosed;
            if (found.isClosed && !found.isOriented)
            {
                add(_orientation).call(turn);
            }
        }

        // Whether edges cancel out once triangles are turned is found out by comparing them once more.
        private function turn():void
        {
            found.isTurned = _orientation.isTurned;
            found.isOriented = found.isTurned != null;
            if (found.isOriented)
            {
                _bucket = 0;
                repeat(compareSome);
            }
        }
    }
}
