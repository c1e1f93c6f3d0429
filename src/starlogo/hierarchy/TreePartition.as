package starlogo.hierarchy
{
    import starlogo.data.zeroedNumbers;

    /**
     * The primitives of a tree while it is made: its triangles or its vertices. Divides the primitives of a node in two, and changes
     * their order so that the primitives of each node stand side by side.
     *
     * @private
     */
    public final class TreePartition
    {
        /** The extents of all primitives together after <code>measure()</code>. */
        public var allExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** After a division, the index at which the second group begins. */
        public var splitIndex:int;

        /** The extents of the first group of the last division. */
        public var leftExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The extents of the second group of the last division. */
        public var rightExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /** The axis of the last division: 0, 1 or 2. */
        public var axis:int;

        private var _tree:BoxTree;

        // The extents of each primitive, by its number in the model: minX, maxX, minY, maxY, minZ, maxZ.
        private var _extents:Vector.<Number>;

        // The current division. The primitives before splitIndex are in the first group, those after _last in the second one.
        private var _last:int;
        private var _doubledSplit:Number;

        /**
         * @param tree has the primitives; receives their order, which begins as that of their numbers
         */
        public function TreePartition(tree:BoxTree)
        {
            _tree = tree;
            clear(allExtents);
            var primitives:Vector.<int> = new Vector.<int>(tree.primitiveCount, true);
            for (var i:int = 0; i < primitives.length; i++)
            {
                primitives[i] = i;
            }
            tree.primitives = primitives;
        }

        /** Measures a range of primitives. Must be called for all primitives before other methods. */
        public function measure(first:int, end:int):void
        {
            _extents ||= zeroedNumbers(6 * _tree.primitives.length);
            for (var i:int = first; i < end; i++)
            {
                // the order is still that of the numbers
                _tree.readExtents(i, i + 1, _extents, 6 * i);
            }
            extend(allExtents, first, end);
        }

        /** Twice the mean of the centres of some primitives along an axis. */
        public function doubledMeanOf(first:int, end:int, axis:int):Number
        {
            var sum:Number = 0;
            for (var i:int = first; i < end; i++)
            {
                sum += doubledCentreOf(_tree.primitives[i], axis);
            }
            return sum / (end - first);
        }

        /**
         * Begins a division: the primitives whose centre is below a splitting point move before the others.
         *
         * @param first the index of the first primitive
         * @param end the index after the last primitive
         * @param axis 0, 1 or 2
         * @param doubledSplit twice the coordinate of the splitting point
         */
        public function beginDivision(first:int, end:int, axis:int, doubledSplit:Number):void
        {
            splitIndex = first;
            _last = end - 1;
            this.axis = axis;
            _doubledSplit = doubledSplit;
            clear(leftExtents);
            clear(rightExtents);
        }

        /**
         * Begins a division at the midpoint of the axis along which the centres of some primitives are spread most. Both groups will have primitives.
         *
         * @param first the index of the first primitive
         * @param end the index after the last primitive
         * @return false if no division is possible, because all centres are in one place, or so near that no number is between them
         */
        public function beginWhereCentresSpread(first:int, end:int):Boolean
        {
            var widest:int = 0;
            var width:Number = 0;
            var begin:Number = 0;
            var doubledSplit:Number = 0;
            for (var along:int = 0; along < 3; along++)
            {
                // twice the smallest and the largest centre
                var least:Number = Infinity;
                var largest:Number = -Infinity;
                for (var i:int = first; i < end; i++)
                {
                    var sum:Number = doubledCentreOf(_tree.primitives[i], along);
                    least = sum < least ? sum : least;
                    largest = sum > largest ? sum : largest;
                }
                if (largest - least > width)
                {
                    widest = along;
                    width = largest - least;
                    begin = least;
                    doubledSplit = least + 0.5 * width;
                }
            }
            beginDivision(first, end, widest, doubledSplit);
            return doubledSplit > begin;
        }

        /**
         * Continues the division, and extends the extents of both groups. Primitives that are on the right side keep their places.
         *
         * @param most the largest number of primitives to look at
         * @return whether there are more primitives
         */
        public function divideSome(most:int):Boolean
        {
            var primitives:Vector.<int> = _tree.primitives;
            var extents:Vector.<Number> = _extents;
            var along:int = 2 * axis;
            var doubledSplit:Number = _doubledSplit;
            var low:int = splitIndex;
            var high:int = _last;
            for (var rest:int = most; rest > 0 && low <= high; rest--)
            {
                var primitive:int = primitives[low];
                var at:int = 6 * primitive + along;
                if (extents[at] + extents[int(at + 1)] < doubledSplit)
                {
                    low++;
                    continue;
                }
                var other:int = primitives[high];
                at = 6 * other + along;
                if (extents[at] + extents[int(at + 1)] < doubledSplit)
                {
                    primitives[low] = other;
                    primitives[high] = primitive;
                    low++;
                }
                high--;
            }
            extend(leftExtents, splitIndex, low);
            extend(rightExtents, high + 1, _last + 1);
            splitIndex = low;
            _last = high;
            return low <= high;
        }

        /**
         * Divides some primitives by their number: each stays in its place.
         *
         * @param first the index of the first primitive
         * @param end the index after the last primitive
         * @param axis the axis that counts as that of the division
         */
        public function halve(first:int, end:int, axis:int):void
        {
            splitIndex = (first + end) >> 1;
            this.axis = axis;
            clear(leftExtents);
            clear(rightExtents);
            extend(leftExtents, first, splitIndex);
            extend(rightExtents, splitIndex, end);
        }

        // Twice the centre of a primitive's extents along an axis.
        private function doubledCentreOf(primitive:int, axis:int):Number
        {
            var at:int = 6 * primitive + 2 * axis;
            return _extents[at] + _extents[int(at + 1)];
        }

        private static function clear(extents:Vector.<Number>):void
        {
            for (var k:int = 0; k < 6; k += 2)
            {
                extents[k] = Infinity;
                extents[k + 1] = -Infinity;
            }
        }

        // Makes extents contain some primitives.
        private function extend(extents:Vector.<Number>, first:int, end:int):void
        {
            var primitives:Vector.<int> = _tree.primitives;
            var ofPrimitives:Vector.<Number> = _extents;
            var minX:Number = extents[0];
            var maxX:Number = extents[1];
            var minY:Number = extents[2];
            var maxY:Number = extents[3];
            var minZ:Number = extents[4];
            var maxZ:Number = extents[5];
            for (var i:int = first; i < end; i++)
            {
                var at:int = 6 * primitives[i];
                var low:Number = ofPrimitives[at];
                var high:Number = ofPrimitives[int(at + 1)];
                minX = low < minX ? low : minX;
                maxX = high > maxX ? high : maxX;
                low = ofPrimitives[int(at + 2)];
                high = ofPrimitives[int(at + 3)];
                minY = low < minY ? low : minY;
                maxY = high > maxY ? high : maxY;
                low = ofPrimitives[int(at + 4)];
                high = ofPrimitives[int(at + 5)];
                minZ = low < minZ ? low : minZ;
                maxZ = high > maxZ ? high : maxZ;
            }
            extents[0] = minX;
            extents[1] = maxX;
            extents[2] = minY;
            extents[3] = maxY;
            extents[4] = minZ;
            extents[5] = maxZ;
        }
    }
}
