package starlogo.hierarchy
{
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Makes a hierarchy again of what TreeWriter wrote, in steps. Only how the items are divided is taken from there; the boxes
     * are put around them anew, which takes a fraction of dividing them: whatever the bytes are, a hierarchy that comes of them
     * encloses the model, and one of a true record is the same to the last bit as the one that was built.
     */
    internal final class TreeReader implements Steps
    {
        private static const ITEMS_A_STEP:int = 1500;
        private static const NODES_A_STEP:int = 300;
        private static const NUMBERS_A_NODE:int = 5;

        private static const ORDERING:int = 0;
        private static const DIVIDING:int = 1;
        private static const MEASURING:int = 2;
        private static const MAKING:int = 3;
        private static const DONE:int = 4;

        /** The nodes, parents before their children, when no step is left; null if the record is none of these items'. */
        public var nodes:Vector.<HierarchyNode> = null;

        /** What made them. */
        public var maker:NodeMaker;

        private var _hierarchy:Hierarchy;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _bytes:ByteArray;
        private var _maxDepth:int;
        private var _count:int;
        private var _width:int;
        private var _phase:int = ORDERING;
        private var _next:int = 0;
        private var _isListed:Vector.<Boolean>;

        // Of each node: its first item, the one behind its last, its level, the number of its right child (its left one comes
        // next; 0 for a leaf), its axis. And of each, its extents.
        private var _plan:Vector.<int> = new Vector.<int>();
        private var _extents:Vector.<Number>;

        // the nodes whose right child is to come
        private var _open:Vector.<int> = new Vector.<int>();

        /**
         * @param hierarchy has room for the order
         * @param vertices x, y, z each
         * @param triangles three vertex indices each; null if the vertices are the items
         * @param bytes the record, read from its position on
         * @param maxDepth how many levels there may be
         */
        public function TreeReader(hierarchy:Hierarchy, vertices:Vector.<Number>, triangles:Vector.<uint>, bytes:ByteArray, maxDepth:int)
        {
            _hierarchy = hierarchy;
            _vertices = vertices;
            _triangles = triangles;
            _bytes = bytes;
            _maxDepth = maxDepth;
            _count = hierarchy.order.length;
            _width = TreeWriter.widthFor(_count);
            _isListed = new Vector.<Boolean>(_count, true);
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            var isTrue:Boolean = true;
            switch (_phase)
            {
                case ORDERING:
                    isTrue = orderSome();
                    break;
                case DIVIDING:
                    isTrue = divideSome();
                    break;
                case MEASURING:
                    measureSome();
                    break;
                case MAKING:
                    makeSome();
                    break;
            }
            return isTrue && _phase != DONE;
        }

        // Whether every item comes once.
        private function orderSome():Boolean
        {
            var bytes:ByteArray = _bytes;
            var order:Vector.<int> = _hierarchy.order;
            var isListed:Vector.<Boolean> = _isListed;
            var end:int = Math.min(_next + ITEMS_A_STEP, _count);
            if (bytes.bytesAvailable < _width * (end - _next))
            {
                return false;
            }
            for (var i:int = _next; i < end; i++)
            {
                var item:int;
                if (_width == 2)
                {
                    item = bytes.readUnsignedShort();
                }
                else
                {
                    item = _width == 1 ? bytes.readUnsignedByte() : bytes.readInt();
                }
                if (item < 0 || item >= _count || isListed[item])
                {
                    return false;
                }
                isListed[item] = true;
                order[i] = item;
            }
            _next = end;
            if (end == _count)
            {
                _phase = DIVIDING;
                addPlan(0, _count, 1);
            }
            return true;
        }

        private function addPlan(first:int, end:int, level:int):void
        {
            _plan.push(first, end, level, 0, 0);
        }

        // Whether the nodes divide the items among them.
        private function divideSome():Boolean
        {
            for (var i:int = 0; i < NODES_A_STEP; i++)
            {
                var at:int = _plan.length - NUMBERS_A_NODE;
                var code:int = readNumber();
                if (code < 0)
                {
                    return false;
                }
                if (code > 0)
                {
                    var first:int = _plan[at];
                    var level:int = _plan[at + 2];
                    var middle:int = first + (code - 1) / 3;
                    if (middle <= first || middle >= _plan[at + 1] || level >= _maxDepth)
                    {
                        return false;
                    }
                    _plan[at + 4] = (code - 1) % 3;
                    _open.push(at);
                    addPlan(first, middle, level + 1);
                    continue;
                }
                if (_open.length == 0)
                {
                    _phase = MEASURING;
                    var nodeCount:int = _plan.length / NUMBERS_A_NODE;
                    _extents = new Vector.<Number>(6 * nodeCount, true);
                    _next = nodeCount;
                    return true;
                }
                var parent:int = _open.pop();
                _plan[parent + 3] = _plan.length / NUMBERS_A_NODE;
                addPlan(_plan[at + 1], _plan[parent + 1], _plan[parent + 2] + 1);
            }
            return true;
        }

        // -1 if there is none
        private function readNumber():int
        {
            var value:int = 0;
            for (var shift:int = 0; shift < 32; shift += 7)
            {
                if (_bytes.bytesAvailable == 0)
                {
                    return -1;
                }
                var byte:int = _bytes.readUnsignedByte();
                value |= (byte & 0x7F) << shift;
                if (byte < 0x80)
                {
                    return value;
                }
            }
            return -1;
        }

        // From the last node up: children come after their parents.
        private function measureSome():void
        {
            var items:int = 0;
            while (_next > 0 && items < ITEMS_A_STEP)
            {
                _next--;
                var at:int = NUMBERS_A_NODE * _next;
                var right:int = _plan[int(at + 3)];
                if (right > 0)
                {
                    unite(6 * _next, 6 * _next + 6, 6 * right);
                    items += 2;
                }
                else
                {
                    measure(6 * _next, _plan[at], _plan[int(at + 1)]);
                    items += _plan[int(at + 1)] - _plan[at];
                }
            }
            if (_next == 0)
            {
                _phase = MAKING;
                _next = _plan.length / NUMBERS_A_NODE;
                maker = new NodeMaker(_hierarchy, _extents);
                nodes = new Vector.<HierarchyNode>(_next);
            }
        }

        private function unite(at:int, left:int, right:int):void
        {
            var extents:Vector.<Number> = _extents;
            for (var i:int = 0; i < 3; i++)
            {
                var a:Number = extents[int(left + i)];
                var b:Number = extents[int(right + i)];
                extents[int(at + i)] = a < b ? a : b;
                a = extents[int(left + i + 3)];
                b = extents[int(right + i + 3)];
                extents[int(at + i + 3)] = a > b ? a : b;
            }
        }

        private function measure(at:int, first:int, end:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            var triangles:Vector.<uint> = _triangles;
            var order:Vector.<int> = _hierarchy.order;
            var corners:int = triangles == null ? 1 : 3;
            var vertex:int = corners * order[first];
            if (triangles != null)
            {
                vertex = triangles[vertex];
            }
            vertex *= 3;
            var minX:Number = vertices[vertex];
            var minY:Number = vertices[int(vertex + 1)];
            var minZ:Number = vertices[int(vertex + 2)];
            var maxX:Number = minX;
            var maxY:Number = minY;
            var maxZ:Number = minZ;
            for (var i:int = first; i < end; i++)
            {
                var corner:int = corners * order[i];
                for (var last:int = corner + corners; corner < last; corner++)
                {
                    vertex = corner;
                    if (triangles != null)
                    {
                        vertex = triangles[corner];
                    }
                    vertex *= 3;
                    var coordinate:Number = vertices[vertex];
                    if (coordinate < minX)
                    {
                        minX = coordinate;
                    }
                    else if (coordinate > maxX)
                    {
                        maxX = coordinate;
                    }
                    coordinate = vertices[int(vertex + 1)];
                    if (coordinate < minY)
                    {
                        minY = coordinate;
                    }
                    else if (coordinate > maxY)
                    {
                        maxY = coordinate;
                    }
                    coordinate = vertices[int(vertex + 2)];
                    if (coordinate < minZ)
                    {
                        minZ = coordinate;
                    }
                    else if (coordinate > maxZ)
                    {
                        maxZ = coordinate;
                    }
                }
            }
            var extents:Vector.<Number> = _extents;
            extents[at] = minX;
            extents[int(at + 1)] = minY;
            extents[int(at + 2)] = minZ;
            extents[int(at + 3)] = maxX;
            extents[int(at + 4)] = maxY;
            extents[int(at + 5)] = maxZ;
        }

        private function makeSome():void
        {
            var end:int = Math.max(0, _next - NODES_A_STEP);
            while (_next > end)
            {
                _next--;
                var at:int = NUMBERS_A_NODE * _next;
                var node:HierarchyNode = maker.make(_plan[int(at + 2)], _plan[at], _plan[int(at + 1)], _extents, 6 * _next);
                nodes[_next] = node;
                var right:int = _plan[int(at + 3)];
                if (right > 0)
                {
                    maker.divide(node, _plan[int(at + 4)], nodes[int(_next + 1)], nodes[right]);
                }
            }
            if (_next == 0)
            {
                _hierarchy.root = nodes[0];
                _phase = DONE;
            }
        }
    }
}
