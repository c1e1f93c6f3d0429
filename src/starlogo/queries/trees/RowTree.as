package starlogo.queries.trees
{
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A balanced tree of boxes around rows of a table. NearSearch and SweptBoxSearch find rows in it without a test of every row (Bentley,
     * "Multidimensional Binary Search Trees", 1975). In addition, each node has a box around its rows. A place is a box without size.
     *
     * <p>The nodes are numbered as in a heap: the root is node 1, and the children of node i are nodes 2 i and 2 i + 1. All leaves are on one
     * level, and the nodes of each level have equal parts of the rows. So the tree has to store nothing but the boxes. The rows stand in slots,
     * in the order of the leaves. RowDivision brings them into that order.</p>
     *
     * <p>A search for a rare breed can skip nodes without it. The nodes learn which breeds they have when searches have tested as many rows
     * that filters exclude as the tree has, and again when an agent has got another breed.</p>
     *
     * @private
     */
    public final class RowTree
    {
        /** The number of the root. */
        public static const ROOT:int = 1;

        /** How many numbers a box takes: its least x, y, z, then its greatest x, y, z. */
        public static const PER_BOX:int = 6;

        // The most rows that a leaf can have.
        private static const LEAF_SIZE:int = 24;

        /** The number of bits in a set of breeds. */
        public static const BREED_BITS:int = 32;

        /** The set of all breeds. */
        public static const ALL_BREEDS:int = -1;

        // After this many enlargements of a leaf's box per row, the tree has to be built again.
        private static const ENLARGEMENTS_PER_ROW:Number = 0.5;

        /** The number of rows. Read only. */
        public var count:int = 0;

        /** The node number of the first leaf. The number of leaves is the same. Read only. */
        public var firstLeaf:int = 1;

        /** By slot: the row. Read only. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** By slot: the row's box, widened by a slack that is larger than its rounding errors. A place has no slack. Read only. */
        public var rowBoxes:Vector.<Number> = new Vector.<Number>();

        /** By node: a box around the boxes of the node's rows. Read only. */
        public var nodeBoxes:Vector.<Number> = new Vector.<Number>();

        /** No row has had a larger extent since the tree was built. It may be too large by a factor of three. Read only. */
        public var maxExtent:Number = 0;

        /** How many rows that did not count, mostly because of filters, were tested since the nodes learned their breeds. Searches add to it. */
        public var excludedCount:int = 0;

        // By node: the set of its rows' breeds; and what Breeds.changes was when the nodes learned them, or -1.
        private var _breedSets:Vector.<int> = new Vector.<int>();
        private var _breedsAsOf:int = -1;

        // How many times a leaf's box may still be enlarged. If it is less than 0, the tree is stale.
        private var _enlargementsLeft:int = -1;

        // By row: its slot.
        private var _slots:Vector.<int> = new Vector.<int>();

        /**
         * Builds the tree again.
         *
         * @param rows a list of rows
         * @param count how many rows the tree has: the first ones of the list
         * @param points by row: the middle of its box
         * @param sizes by row: half of its box's lengths; null for a tree of places
         */
        public function build(rows:Vector.<int>, count:int, points:Points, sizes:Extents):void
        {
            _enlargementsLeft = ENLARGEMENTS_PER_ROW * count;
            excludedCount = 0;
            maxExtent = 0;
            _breedsAsOf = -1;
            this.count = count;
            firstLeaf = 1;
            while (firstLeaf * LEAF_SIZE < count)
            {
                firstLeaf *= 2;
            }
            reserve(points.x.length);
            for (var i:int = 0; i < count; i++)
            {
                this.rows[i] = rows[i];
            }
            RowDivision.divide(this.rows, count, points, nodeBoxes, firstLeaf);
            boundAll(points, sizes);
        }

        /** Whether the tree must be built again before the next search. */
        public function get isStale():Boolean
        {
            return _enlargementsLeft < 0;
        }

        /** The rows have changed: the tree is built again before it is asked. */
        public function makeStale():void
        {
            _enlargementsLeft = -1;
        }

        /** The bit of a breed in a set of breeds. Breeds with the same remainder share one. */
        public static function breedBit(breed:int):int
        {
            return 1 << breed % BREED_BITS;
        }

        /** Lets the nodes learn their breeds, if so many excluded rows were tested that this takes no longer. */
        public function learnBreeds(agents:Vector.<Agent>):void
        {
            if (excludedCount < count || _breedsAsOf == Breeds.changes)
            {
                return;
            }
            excludedCount = 0;
            _breedsAsOf = Breeds.changes;
            for (var node:int = 2 * firstLeaf - 1; node > 0; node--)
            {
                _breedSets[node] = node < firstLeaf ? _breedSets[int(2 * node)] | _breedSets[int(2 * node + 1)] : breedsIn(node, agents);
            }
        }

        private function breedsIn(leaf:int, agents:Vector.<Agent>):int
        {
            var breeds:int = 0;
            var end:int = startOf(leaf + 1);
            for (var slot:int = startOf(leaf); slot < end; slot++)
            {
                breeds |= breedBit(agents[rows[slot]].breedNumber);
            }
            return breeds;
        }

        /** Whether a node may have rows of a set of breeds. */
        public function mayHave(node:int, breedSet:int):Boolean
        {
            return breedSet == ALL_BREEDS || _breedsAsOf != Breeds.changes || (_breedSets[node] & breedSet) != 0;
        }

        /** The slot where the rows of a leaf begin. Those of the leaf before it, or of the last leaf of all, end there. */
        public function startOf(leaf:int):int
        {
            return int((leaf - firstLeaf) * count / firstLeaf);
        }

        /** The node number of the leaf that has a row. */
        public function leafOf(row:int):int
        {
            return firstLeaf + int(((_slots[row] + 1) * firstLeaf - 1) / count);
        }

        /** The number of rows in a node, without one row, which may be -1 for none. */
        public function countIn(node:int, except:int):int
        {
            var last:int = node;
            while (node < firstLeaf)
            {
                node = node << 1;
                last = (last << 1) + 1;
            }
            var start:int = startOf(node);
            var end:int = startOf(last + 1);
            return except >= 0 && _slots[except] >= start && _slots[except] < end ? end - start - 1 : end - start;
        }

        /**
         * Reads the box of one row again, and enlarges the nodes' boxes around it to contain it, unless the tree is stale. These never get smaller.
         *
         * @param points as in build
         * @param sizes as in build
         */
        public function enlargeAround(row:int, points:Points, sizes:Extents):void
        {
            if (isStale)
            {
                return;
            }
            var slot:int = _slots[row];
            var leaf:int = leafOf(row);
            var node:int = leaf;
            boundRow(slot, points, sizes);
            // if a box does not grow, the boxes around it do not grow either
            while (node > 0 && expandToContain(PER_BOX * node, rowBoxes, PER_BOX * slot))
            {
                node >>= 1;
            }
            if (node < leaf)
            {
                _enlargementsLeft--;
            }
        }

        // Makes room for the rows and the nodes.
        private function reserve(rowCount:int):void
        {
            _slots.length = Math.max(_slots.length, rowCount);
            rows.length = Math.max(rows.length, count);
            rowBoxes.length = PER_BOX * rows.length;
            _breedSets.length = Math.max(_breedSets.length, 2 * firstLeaf);
            nodeBoxes.length = PER_BOX * _breedSets.length;
        }

        private function boundAll(points:Points, sizes:Extents):void
        {
            for (var slot:int = 0; slot < count; slot++)
            {
                _slots[rows[slot]] = slot;
                boundRow(slot, points, sizes);
            }
            for (var leaf:int = 2 * firstLeaf - 1; leaf >= firstLeaf; leaf--)
            {
                boundNode(leaf, rowBoxes, startOf(leaf), startOf(leaf + 1));
            }
            for (var node:int = firstLeaf - 1; node > 0; node--)
            {
                boundNode(node, nodeBoxes, 2 * node, 2 * node + 2);
            }
        }

        // Makes a node's box the one around some boxes.
        private function boundNode(node:int, boxes:Vector.<Number>, first:int, end:int):void
        {
            var box:int = PER_BOX * node;
            for (var side:int = 0; side < 3; side++)
            {
                nodeBoxes[box + side] = Infinity;
                nodeBoxes[box + 3 + side] = -Infinity;
            }
            for (var i:int = first; i < end; i++)
            {
                expandToContain(box, boxes, PER_BOX * i);
            }
        }

        // Reads the box of a slot's row.
        private function boundRow(slot:int, points:Points, sizes:Extents):void
        {
            var row:int = rows[slot];
            var box:int = PER_BOX * slot;
            var x:Number = points.x[row];
            var y:Number = points.y[row];
            var z:Number = points.z[row];
            var halfX:Number = 0;
            var halfY:Number = 0;
            var halfZ:Number = 0;
            if (sizes != null)
            {
                halfX = sizes.halfX[row];
                halfY = sizes.halfY[row];
                halfZ = sizes.halfZ[row];
                var halves:Number = halfX + halfY + halfZ;
                maxExtent = 2 * halves > maxExtent ? 2 * halves : maxExtent;
                var slack:Number = slackOf(x, y, z, halves, sizes.distanceFromPlace(row));
                halfX += slack;
                halfY += slack;
                halfZ += slack;
            }
            rowBoxes[box] = x - halfX;
            rowBoxes[int(box + 1)] = y - halfY;
            rowBoxes[int(box + 2)] = z - halfZ;
            rowBoxes[int(box + 3)] = x + halfX;
            rowBoxes[int(box + 4)] = y + halfY;
            rowBoxes[int(box + 5)] = z + halfZ;
        }

        /**
         * The slack by which a box is widened. It is larger than the gap across which what is in the box touches, and than the rounding errors of the
         * box's middle and lengths.
         *
         * @param x the box's middle
         * @param y the box's middle
         * @param z the box's middle
         * @param halves the sum of half its lengths
         * @param offset how far the middle is from the place that it was computed from
         */
        public static function slackOf(x:Number, y:Number, z:Number, halves:Number, offset:Number):Number
        {
            return Tolerances.EXTENTS * halves
                + Tolerances.EXTENTS_GAPS * Tolerances.PLACES * (Math.abs(x) + Math.abs(y) + Math.abs(z) + offset);
        }

        // Expands a node's box so that it contains another box. Returns whether it has grown.
        private function expandToContain(box:int, others:Vector.<Number>, other:int):Boolean
        {
            var boxes:Vector.<Number> = nodeBoxes;
            var hasGrown:Boolean = false;
            for (var side:int = 0; side < 3; side++)
            {
                var least:Number = others[int(other + side)];
                if (least < boxes[int(box + side)])
                {
                    boxes[int(box + side)] = least;
                    hasGrown = true;
                }
                var greatest:Number = others[int(other + 3 + side)];
                if (greatest > boxes[int(box + 3 + side)])
                {
                    boxes[int(box + 3 + side)] = greatest;
                    hasGrown = true;
                }
            }
            return hasGrown;
        }
    }
}
