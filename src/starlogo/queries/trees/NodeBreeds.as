package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.engine;

    use namespace engine;

    /**
     * The breeds of the rows in each node of a tree, so that a search for a rare breed skips the nodes without it.
     *
     * <p>The nodes learn them when searches have passed over as many rows that do not count as the tree has, and forget them when an agent gets
     * another breed. So they cost a game without such searches nothing, and take no longer than the searches do.</p>
     *
     * @private
     */
    public final class NodeBreeds
    {
        /** A set of breeds: all. */
        public static const ALL:int = -1;

        // A set has a bit for each breed. Breeds with the same remainder share one.
        private static const BITS:int = 32;

        // How many rows that do not count searches have tested since the nodes learned their breeds, or the tree was built. A test reads it.
        engine var passedOver:int = 0;

        // By node: the set of its rows' breeds; and what Breeds.changes was when the nodes learned them, or -1.
        private var _sets:Vector.<int> = new Vector.<int>();
        private var _since:int = -1;

        // The set with one breed.
        private static function setOf(breed:int):int
        {
            return 1 << breed % BITS;
        }

        /** The set with some breeds. A name may be null. A new name becomes a breed, so ask areSetsExact afterwards. */
        public static function setOfNames(names:Vector.<String>):int
        {
            var found:int = 0;
            for (var i:int = 0; i < names.length; i++)
            {
                if (names[i] != null)
                {
                    found |= setOf(Breeds.numberOf(names[i]));
                }
            }
            return found;
        }

        /** Whether each breed has a bit of its own. */
        public static function get areSetsExact():Boolean
        {
            return Breeds.count <= BITS;
        }

        /** Counts rows that a filter does not let through, by their breeds or otherwise. */
        public function passOver(rows:int):void
        {
            passedOver += rows;
        }

        /** Begins anew, for other rows. */
        public function forget():void
        {
            passedOver = 0;
            _since = -1;
        }

        /** Lets the nodes learn their breeds, if searches have passed over so many rows that this takes no longer. */
        public function learn(tree:RowTree, agents:Vector.<Agent>):void
        {
            if (passedOver < tree.count || _since == Breeds.changes)
            {
                return;
            }
            passedOver = 0;
            _since = Breeds.changes;
            var firstLeaf:int = tree.firstLeaf;
            if (_sets.length < 2 * firstLeaf)
            {
                _sets.length = 2 * firstLeaf;
            }
            for (var node:int = 2 * firstLeaf - 1; node > 0; node--)
            {
                var found:int = 0;
                if (node < firstLeaf)
                {
                    found = _sets[int(2 * node)] | _sets[int(2 * node + 1)];
                }
                else
                {
                    var leaf:int = node - firstLeaf;
                    for (var slot:int = tree.starts[leaf]; slot < tree.starts[int(leaf + 1)]; slot++)
                    {
                        found |= setOf(agents[tree.rows[slot]].breedNumber);
                    }
                }
                _sets[node] = found;
            }
        }

        /** Whether a node may have rows of some breeds. */
        public function mayHave(node:int, breeds:int):Boolean
        {
            return breeds == ALL || _since != Breeds.changes || (_sets[node] & breeds) != 0;
        }
    }
}
