package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * Which breeds the nodes of a RowTree have, so that a search for a rare breed can skip nodes without it. It learns them when searches have passed
     * over as many rows that do not count as the tree has, and again when an agent has got another breed.
     *
     * <p>A set of breeds is a number with a bit for each. Breeds with the same remainder share one.</p>
     *
     * @private
     */
    public final class NodeBreeds
    {
        /** How many breeds have bits of their own. */
        public static const BITS:int = 32;

        /** The set of all breeds. */
        public static const ALL:int = -1;

        // How many rows that do not count searches have tested since the breeds were learned. A test reads it.
        engine var passedOver:int = 0;

        // By node: the set of its rows' breeds; and what Breeds.changes was when they were learned, or -1.
        private var _sets:Vector.<int> = new Vector.<int>();
        private var _asOf:int = -1;

        /** The bit of a breed in a set. */
        public static function bitOf(breed:int):int
        {
            return 1 << breed % BITS;
        }

        /** Begins without knowledge, for a tree whose nodes have numbers below this one. */
        public function forget(nodes:int):void
        {
            passedOver = 0;
            _asOf = -1;
            if (_sets.length < nodes)
            {
                _sets.length = nodes;
            }
        }

        /** Counts rows that a filter does not let through, by their breeds or otherwise. */
        public function passOver(rows:int):void
        {
            passedOver += rows;
        }

        /**
         * Learns the breeds, if searches have passed over so many rows that this takes no longer.
         *
         * @param tree the nodes and their rows
         * @param agents by row
         */
        public function learn(tree:RowTree, agents:Vector.<Agent>):void
        {
            if (passedOver < tree.count || _asOf == Breeds.changes)
            {
                return;
            }
            passedOver = 0;
            _asOf = Breeds.changes;
            for (var node:int = 2 * tree.firstLeaf - 1; node > 0; node--)
            {
                _sets[node] = node < tree.firstLeaf ? _sets[int(2 * node)] | _sets[int(2 * node + 1)] : breedsIn(tree, node - tree.firstLeaf, agents);
            }
        }

        private static function breedsIn(tree:RowTree, leaf:int, agents:Vector.<Agent>):int
        {
            var found:int = 0;
            for (var slot:int = tree.starts[leaf]; slot < tree.starts[int(leaf + 1)]; slot++)
            {
                found |= bitOf(agents[tree.rows[slot]].breedNumber);
            }
            return found;
        }

        /** Whether a node may have rows of some breeds, a set. */
        public function mayHave(node:int, breeds:int):Boolean
        {
            return breeds == ALL || _asOf != Breeds.changes || (_sets[node] & breeds) != 0;
        }
    }
}
