package starlogo.hierarchy
{
    import starlogo.data.zeroedInts;
    import starlogo.data.zeroedNumbers;

    /**
     * The primitives of a tree while it is made: its triangles or its vertices. Divides the primitives of one node after the other into two groups,
     * measures the groups, and makes the node's children. It changes the order of the primitives so that those of each node stand side by side.
     *
     * @private
     */
    public final class TreePartition
    {
        private var _tree:BoxTree;

        // The extents of each primitive, by its number in the model: minX, maxX, minY, maxY, minZ, maxZ.
        private var _extents:Vector.<Number>;

        // The node that is divided, the axis, and twice the coordinate of the splitting point.
        private var _node:int = 0;
        private var _axis:int = 0;
        private var _doubledSplit:Number = 0;

        // The primitives before _splitIndex are in the first group, those after _last in the second one. Those between are not divided yet.
        private var _splitIndex:int = 0;
        private var _last:int = 0;

        // The extents of the primitives of each group before _measured. Before the root is made, the first group is that of all primitives.
        private var _measured:int = 0;
        private var _leftExtents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _rightExtents:Vector.<Number> = new Vector.<Number>(6, true);

        /**
         * @param tree has the primitives; receives their order, which begins as that of their numbers
         */
        public function TreePartition(tree:BoxTree)
        {
            _tree = tree;
            clear(_leftExtents);
            var primitives:Vector.<int> = zeroedInts(tree.primitiveCount);
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
            extend(_leftExtents, first, end);
        }

        /** Makes the root. */
        public function makeRoot():void
        {
            _tree.measureRadiusAboutOrigin(_leftExtents);
            _tree.beginNodes();
            _tree.enclose(0, _leftExtents);
        }

        /**
         * Begins to divide a node: primitives whose centre is below a splitting point on the longest axis of its box move before the others.
         *
         * @param atMean whether that point is the mean of the centres; otherwise it is halfway along the box
         */
        public function begin(node:int, atMean:Boolean):void
        {
            _node = node;
            _axis = longestAxis;
            beginGroups();
            _doubledSplit = 2 * _tree.boxes[6 * node + _axis];
            if (atMean)
            {
                var sum:Number = 0;
                for (var i:int = _splitIndex; i <= _last; i++)
                {
                    sum += doubledCentreOf(_tree.primitives[i], _axis);
                }
                _doubledSplit = sum / (_last + 1 - _splitIndex);
            }
        }

        /**
         * Begins to divide the node again: at the midpoint of the axis along which the centres are spread most. Both groups will have primitives.
         *
         * @return false if no division is possible, because all centres are in one place, or so near that no number is between them
         */
        public function beginWhereCentresSpread():Boolean
        {
            var width:Number = 0;
            var lowest:Number = 0;
            beginGroups();
            for (var along:int = 0; along < 3; along++)
            {
                // twice the smallest and the largest centre
                var least:Number = Infinity;
                var largest:Number = -Infinity;
                for (var i:int = _splitIndex; i <= _last; i++)
                {
                    var sum:Number = doubledCentreOf(_tree.primitives[i], along);
                    least = sum < least ? sum : least;
                    largest = sum > largest ? sum : largest;
                }
                if (largest - least > width)
                {
                    width = largest - least;
                    lowest = least;
                    _axis = along;
                    _doubledSplit = least + 0.5 * width;
                }
            }
            return width > 0 && _doubledSplit > lowest;
        }

        // Begins with two groups without primitives.
        private function beginGroups():void
        {
            _splitIndex = _measured = _tree.firstPrimitive[_node];
            _last = _tree.endPrimitive[_node] - 1;
            clear(_leftExtents);
            clear(_rightExtents);
        }

        /**
         * Continues the division. Primitives that are on the right side keep their places.
         *
         * @param most the largest number of primitives to look at
         * @return whether there are more primitives
         */
        public function divideSome(most:int):Boolean
        {
            var primitives:Vector.<int> = _tree.primitives;
            var extents:Vector.<Number> = _extents;
            var along:int = 2 * _axis;
            var doubledSplit:Number = _doubledSplit;
            var low:int = _splitIndex;
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
            _splitIndex = low;
            _last = high;
            return low <= high;
        }

        /** Whether the division has left a group without primitives. */
        public function get isOneSided():Boolean
        {
            return _splitIndex == _tree.firstPrimitive[_node] || _splitIndex == _tree.endPrimitive[_node];
        }

        /**
         * Divides a node by the number of its primitives, which stay in their places. It is a leaf of the thesis, or below one. The longest axis of its
         * box counts as that of the division.
         */
        public function halve(node:int):void
        {
            _node = node;
            _axis = longestAxis;
            beginGroups();
            _splitIndex = (_splitIndex + _last + 1) >> 1;
            _last = _splitIndex - 1;
        }

        /**
         * Continues to measure the two groups of the node.
         *
         * @param most the largest number of primitives to measure
         * @return whether there are more primitives
         */
        public function measureSome(most:int):Boolean
        {
            var isFirstGroup:Boolean = _measured < _splitIndex;
            var endOfGroup:int = isFirstGroup ? _splitIndex : _tree.endPrimitive[_node];
            var end:int = Math.min(_measured + most, endOfGroup);
            extend(isFirstGroup ? _leftExtents : _rightExtents, _measured, end);
            _measured = end;
            return end < _tree.endPrimitive[_node];
        }

        /** Makes the children of the node: one of each group. @param isLeafOrBelow whether the node is a leaf of the thesis, or below one */
        public function makeChildren(isLeafOrBelow:Boolean):void
        {
            var child:int = _tree.addChildren(_node, _axis, _splitIndex, isLeafOrBelow);
            _tree.enclose(child, _leftExtents);
            _tree.enclose(child + 1, _rightExtents);
        }

        // The axis along which the box of the node is longest: 0, 1 or 2.
        private function get longestAxis():int
        {
            var halfX:Number = _tree.boxes[6 * _node + 3];
            var halfY:Number = _tree.boxes[6 * _node + 4];
            var halfZ:Number = _tree.boxes[6 * _node + 5];
            if (halfX >= halfY && halfX >= halfZ)
            {
                return 0;
            }
            return halfY >= halfZ ? 1 : 2;
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
