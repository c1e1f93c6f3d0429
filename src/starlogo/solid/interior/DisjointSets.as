package starlogo.solid.interior
{
    import starlogo.data.zeroedInts;

    /**
     * Disjoint sets of numbered elements: union-find with path halving (Tarjan and van Leeuwen, "Worst-case analysis of set union
     * algorithms", Journal of the ACM 31(2), 1984).
     */
    internal final class DisjointSets
    {
        private var _parents:Vector.<int>;

        /**
         * Each element starts as a set of its own.
         *
         * @param count the number of elements
         */
        public function DisjointSets(count:int)
        {
            _parents = zeroedInts(count);
            for (var i:int = 0; i < count; i++)
            {
                _parents[i] = i;
            }
        }

        /** The representative of an element's set. It may change when the set is joined to another one. */
        public function rootOf(element:int):int
        {
            var parents:Vector.<int> = _parents;
            var parent:int = parents[element];
            while (parent != element)
            {
                // This shortens the path for the next call.
                var above:int = parents[parent];
                parents[element] = above;
                element = above;
                parent = parents[element];
            }
            return element;
        }

        /** Joins two sets. The first set's representative becomes the representative of both. */
        public function join(a:int, b:int):void
        {
            _parents[rootOf(b)] = rootOf(a);
        }
    }
}
