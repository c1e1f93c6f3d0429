package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Builds a hierarchy from the root down (thesis §4.4).
     *
     * <p>What is divided are items: triangles, or vertices where there are none. An item goes to the side of the split
     * that the centre of its extents is on. The thesis's splitting point, halfway along the longest axis of the box or at
     * the mean, may leave all triangles on one side; then it is halfway along the axis on which their centres spread
     * most. A node whose items all have the same centre is a leaf.</p>
     *
     * <p>The work is done in steps, a millisecond or two each for thousands of items. For the engine; a client has the
     * HierarchiesLibrary.</p>
     */
    public final class HierarchyBuilder implements Steps
    {
        // About how much a step does, and how many items making a node takes as long as.
        private static const ITEMS_A_STEP:int = 1000;
        private static const ITEMS_A_NODE:int = 10;

        private static const MEASURING:int = 0;
        private static const ROOTING:int = 1;
        private static const DIVIDING:int = 2;
        private static const BOUNDING:int = 3;
        private static const DONE:int = 4;

        private var _minVerticesToSplit:int;
        private var _maxDepth:int;
        private var _splitByMean:Boolean;
        private var _boundsKind:int;

        // The build under way. An item's least coordinates are at item * _stride in _extents, the largest _high further on.
        private var _hierarchy:Hierarchy;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _extents:Vector.<Number>;
        private var _stride:int;
        private var _high:int;
        private var _order:Vector.<int>;
        private var _nodes:Vector.<HierarchyNode>;
        private var _margin:Number;
        private var _phase:int;
        private var _next:int;

        /**
         * @param minVerticesToSplit a node of no more vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         * @param boundsKind which structures the nodes have
         */
        public function HierarchyBuilder(minVerticesToSplit:int, maxDepth:int, splitByMean:Boolean, boundsKind:int)
        {
            _minVerticesToSplit = minVerticesToSplit;
            _maxDepth = maxDepth;
            _splitByMean = splitByMean;
            _boundsKind = boundsKind;
        }

        /** Begins a hierarchy of triangles, or of vertices where triangles is null. It keeps both lists. */
        public function begin(vertices:Vector.<Number>, triangles:Vector.<uint>):void
        {
            _hierarchy = new Hierarchy(vertices, triangles);
            _vertices = vertices;
            _triangles = triangles;
            _phase = MEASURING;
            _next = 0;
            _order = new Vector.<int>((triangles == null ? vertices.length : triangles.length) / 3, true);
            _hierarchy.order = _order;
            _hierarchy.boundsKind = _boundsKind;
            _stride = triangles == null ? 3 : 6;
            _high = triangles == null ? 0 : 3;
            _extents = triangles == null ? vertices : new Vector.<Number>(6 * _order.length, true);
        }

        /**
         * @inheritDoc
         *
         * @throws ArgumentError if the model's extent is not finite
         */
        public function step():Boolean
        {
            switch (_phase)
            {
                case MEASURING:
                    measureSome();
                    break;
                case ROOTING:
                    _hierarchy.root = makeRoot(_order.length);
                    _nodes = new <HierarchyNode>[_hierarchy.root];
                    _phase = DIVIDING;
                    break;
                case DIVIDING:
                    divideSome();
                    break;
                case BOUNDING:
                    boundSome();
                    break;
            }
            return _phase != DONE;
        }

        /** The hierarchy, when no step is left. */
        public function get hierarchy():Hierarchy
        {
            return _hierarchy;
        }

        private function measureSome():void
        {
            var count:int = _order.length;
            var end:int = Math.min(_next + ITEMS_A_STEP, count);
            for (var i:int = _next; i < end; i++)
            {
                _order[i] = i;
                if (_triangles != null)
                {
                    writeExtents(3 * i, 6 * i);
                }
            }
            _next = end;
            if (end == count)
            {
                _phase = ROOTING;
                _next = 0;
            }
        }

        private function divideSome():void
        {
            var items:int = 0;
            // children are appended while their parents are divided
            while (_next < _nodes.length)
            {
                var node:HierarchyNode = _nodes[_next++];
                if (node.level < _maxDepth && hasEnough(node))
                {
                    divide(node);
                }
                items += node.end - node.first + ITEMS_A_NODE;
                if (items >= ITEMS_A_STEP)
                {
                    return;
                }
            }
            _phase = _boundsKind == BoundingStructure.BOX ? DONE : BOUNDING;
            _next = 0;
        }

        // Spheres or capsules instead of boxes.
        private function boundSome():void
        {
            var items:int = 0;
            while (_next < _nodes.length)
            {
                var node:HierarchyNode = _nodes[_next++];
                var points:Vector.<Number> = pointsOf(node);
                node.structure = _boundsKind == BoundingStructure.SPHERE ? sphereAround(node, points) : capsuleAround(node, points);
                items += node.end - node.first + ITEMS_A_NODE;
                if (items >= ITEMS_A_STEP)
                {
                    return;
                }
            }
            _phase = DONE;
        }

        private function writeExtents(corner:int, at:int):void
        {
            var a:int = 3 * _triangles[corner];
            var b:int = 3 * _triangles[int(corner + 1)];
            var c:int = 3 * _triangles[int(corner + 2)];
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:Number = _vertices[int(a + axis)];
                var high:Number = low;
                var coordinate:Number = _vertices[int(b + axis)];
                if (coordinate < low)
                {
                    low = coordinate;
                }
                else
                {
                    high = coordinate;
                }
                coordinate = _vertices[int(c + axis)];
                if (coordinate < low)
                {
                    low = coordinate;
                }
                else if (coordinate > high)
                {
                    high = coordinate;
                }
                _extents[int(at + axis)] = low;
                _extents[int(at + axis + 3)] = high;
            }
        }

        private function makeRoot(count:int):HierarchyNode
        {
            var low:Vector.<Number> = new <Number>[Infinity, Infinity, Infinity];
            var high:Vector.<Number> = new <Number>[-Infinity, -Infinity, -Infinity];
            var length:int = count * _stride;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var least:Number = Infinity;
                var largest:Number = -Infinity;
                for (var i:int = axis; i < length; i += _stride)
                {
                    var coordinate:Number = _extents[i];
                    if (coordinate < least)
                    {
                        least = coordinate;
                    }
                    coordinate = _extents[int(i + _high)];
                    if (coordinate > largest)
                    {
                        largest = coordinate;
                    }
                }
                low[axis] = least;
                high[axis] = largest;
            }
            _margin = Tolerances.ROUNDING * Math.max(-low[0], -low[1], -low[2], high[0], high[1], high[2]);
            var root:HierarchyNode = makeNode(1, 0, count, low[0], low[1], low[2], high[0], high[1], high[2]);
            if (root.radius - root.radius != 0)
            {
                throw new ArgumentError("the coordinates are too large: the model's extent is not a finite number");
            }
            return root;
        }

        private function makeNode(level:int, first:int, end:int, minX:Number, minY:Number, minZ:Number,
                maxX:Number, maxY:Number, maxZ:Number):HierarchyNode
        {
            var node:HierarchyNode = new HierarchyNode();
            node.hierarchy = _hierarchy;
            node.level = level;
            node.first = first;
            node.end = end;
            var halfX:Number = 0.5 * (maxX - minX);
            var halfY:Number = 0.5 * (maxY - minY);
            var halfZ:Number = 0.5 * (maxZ - minZ);
            node.x = minX + halfX;
            node.y = minY + halfY;
            node.z = minZ + halfZ;
            node.halfX = halfX += _margin;
            node.halfY = halfY += _margin;
            node.halfZ = halfZ += _margin;
            node.radius = Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
            node.innerRadius = halfX < halfY ? halfX : halfY;
            if (halfZ < node.innerRadius)
            {
                node.innerRadius = halfZ;
            }
            return node;
        }

        private function hasEnough(node:HierarchyNode):Boolean
        {
            var count:int = node.end - node.first;
            if (_triangles == null || count == 1)
            {
                return _triangles == null && count > _minVerticesToSplit;
            }
            // so many different triangles have more vertices in any case
            var few:int = _minVerticesToSplit;
            return count > few * (few - 1) * (few - 2) / 6 || node.vertexCount > few;
        }

        private function divide(node:HierarchyNode):void
        {
            var axis:int = 2;
            var middle:Number = node.z;
            if (node.halfX >= node.halfY && node.halfX >= node.halfZ)
            {
                axis = 0;
                middle = node.x;
            }
            else if (node.halfY >= node.halfZ)
            {
                axis = 1;
                middle = node.y;
            }
            if (!partition(node, axis, _splitByMean ? meanOf(node, axis) : 2 * middle))
            {
                divideWhereCentresSpread(node);
            }
        }

        /** The mean of the items' least and largest coordinates, added. */
        private function meanOf(node:HierarchyNode, axis:int):Number
        {
            var sum:Number = 0;
            var end:int = node.end;
            var high:int = axis + _high;
            for (var i:int = node.first; i < end; i++)
            {
                var at:int = _order[i] * _stride;
                sum += _extents[int(at + axis)] + _extents[int(at + high)];
            }
            return sum / (end - node.first);
        }

        private function divideWhereCentresSpread(node:HierarchyNode):void
        {
            var widest:int = 0;
            var width:Number = 0;
            var split:Number = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var least:Number = Infinity;
                var largest:Number = -Infinity;
                for (var i:int = node.first; i < node.end; i++)
                {
                    var at:int = _order[i] * _stride + axis;
                    var sum:Number = _extents[at] + _extents[int(at + _high)];
                    least = sum < least ? sum : least;
                    largest = sum > largest ? sum : largest;
                }
                if (largest - least > width)
                {
                    widest = axis;
                    width = largest - least;
                    split = least + 0.5 * width;
                }
            }
            if (width > 0)
            {
                partition(node, widest, split);
            }
        }

        /**
         * Puts the items whose centre is below the splitting point first, and makes the children. The extents of both are
         * found on the way, so that an item is looked at once a level.
         *
         * @param split twice the coordinate of the splitting point
         * @return whether there are items on either side; if not, the node has no children
         */
        private function partition(node:HierarchyNode, axis:int, split:Number):Boolean
        {
            var order:Vector.<int> = _order;
            var extents:Vector.<Number> = _extents;
            var stride:int = _stride;
            var high:int = _high;
            var leftMinX:Number = Infinity;
            var leftMinY:Number = Infinity;
            var leftMinZ:Number = Infinity;
            var leftMaxX:Number = -Infinity;
            var leftMaxY:Number = -Infinity;
            var leftMaxZ:Number = -Infinity;
            var rightMinX:Number = Infinity;
            var rightMinY:Number = Infinity;
            var rightMinZ:Number = Infinity;
            var rightMaxX:Number = -Infinity;
            var rightMaxY:Number = -Infinity;
            var rightMaxZ:Number = -Infinity;
            var i:int = node.first;
            var last:int = node.end - 1;
            while (i <= last)
            {
                var item:int = order[i];
                var at:int = item * stride;
                var minX:Number = extents[at];
                var minY:Number = extents[int(at + 1)];
                var minZ:Number = extents[int(at + 2)];
                at += high;
                var maxX:Number = extents[at];
                var maxY:Number = extents[int(at + 1)];
                var maxZ:Number = extents[int(at + 2)];
                var sum:Number = axis == 0 ? minX + maxX : (axis == 1 ? minY + maxY : minZ + maxZ);
                if (sum < split)
                {
                    i++;
                    if (minX < leftMinX)
                    {
                        leftMinX = minX;
                    }
                    if (maxX > leftMaxX)
                    {
                        leftMaxX = maxX;
                    }
                    if (minY < leftMinY)
                    {
                        leftMinY = minY;
                    }
                    if (maxY > leftMaxY)
                    {
                        leftMaxY = maxY;
                    }
                    if (minZ < leftMinZ)
                    {
                        leftMinZ = minZ;
                    }
                    if (maxZ > leftMaxZ)
                    {
                        leftMaxZ = maxZ;
                    }
                }
                else
                {
                    order[i] = order[last];
                    order[last] = item;
                    last--;
                    if (minX < rightMinX)
                    {
                        rightMinX = minX;
                    }
                    if (maxX > rightMaxX)
                    {
                        rightMaxX = maxX;
                    }
                    if (minY < rightMinY)
                    {
                        rightMinY = minY;
                    }
                    if (maxY > rightMaxY)
                    {
                        rightMaxY = maxY;
                    }
                    if (minZ < rightMinZ)
                    {
                        rightMinZ = minZ;
                    }
                    if (maxZ > rightMaxZ)
                    {
                        rightMaxZ = maxZ;
                    }
                }
            }
            if (i == node.first || i == node.end)
            {
                return false;
            }
            node.isLeaf = false;
            node.endLevel = node.level;
            node.splitAxis = axis;
            node.left = makeNode(node.level + 1, node.first, i,
                    leftMinX, leftMinY, leftMinZ, leftMaxX, leftMaxY, leftMaxZ);
            node.right = makeNode(node.level + 1, i, node.end,
                    rightMinX, rightMinY, rightMinZ, rightMaxX, rightMaxY, rightMaxZ);
            _nodes.push(node.left, node.right);
            return true;
        }

        private function pointsOf(node:HierarchyNode):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for (var i:int = node.first; i < node.end; i++)
            {
                var item:int = _order[i];
                if (_triangles == null)
                {
                    addPoint(points, item);
                    continue;
                }
                addPoint(points, _triangles[3 * item]);
                addPoint(points, _triangles[3 * item + 1]);
                addPoint(points, _triangles[3 * item + 2]);
            }
            return points;
        }

        private function addPoint(points:Vector.<Number>, vertex:int):void
        {
            points.push(_vertices[3 * vertex], _vertices[3 * vertex + 1], _vertices[3 * vertex + 2]);
        }

        private function sphereAround(node:HierarchyNode, points:Vector.<Number>):Sphere
        {
            var largest:Number = 0;
            for (var i:int = 0; i < points.length; i += 3)
            {
                var x:Number = points[i] - node.x;
                var y:Number = points[i + 1] - node.y;
                var z:Number = points[i + 2] - node.z;
                var squared:Number = x * x + y * y + z * z;
                largest = squared > largest ? squared : largest;
            }
            return new Sphere(new Vector3D(node.x, node.y, node.z), Math.sqrt(largest) + 2 * _margin);
        }

        // Along the box's longest axis: as thick as the vertex farthest from that axis, and as long as the others need.
        private function capsuleAround(node:HierarchyNode, points:Vector.<Number>):Capsule
        {
            var axis:int = node.halfX >= node.halfY && node.halfX >= node.halfZ ? 0 : (node.halfY >= node.halfZ ? 1 : 2);
            var centre:Vector.<Number> = new <Number>[node.x, node.y, node.z];
            var u:int = (axis + 1) % 3;
            var v:int = (axis + 2) % 3;
            var distances:Vector.<Number> = new Vector.<Number>(points.length / 3, true);
            var largest:Number = 0;
            for (var i:int = 0; i < distances.length; i++)
            {
                var du:Number = points[3 * i + u] - centre[u];
                var dv:Number = points[3 * i + v] - centre[v];
                distances[i] = du * du + dv * dv;
                largest = Math.max(largest, distances[i]);
            }
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for (i = 0; i < distances.length; i++)
            {
                // how far along the axis the vertex may be from the segment's end
                var slack:Number = Math.sqrt(largest - distances[i]);
                low = Math.min(low, points[3 * i + axis] + slack);
                high = Math.max(high, points[3 * i + axis] - slack);
            }
            if (low > high)
            {
                low = high = (low + high) / 2;
            }
            var start:Vector3D = pointOnAxis(centre, axis, low);
            var end:Vector3D = pointOnAxis(centre, axis, high);
            return new Capsule(start, end, Math.sqrt(largest) + 2 * _margin);
        }

        private static function pointOnAxis(centre:Vector.<Number>, axis:int, coordinate:Number):Vector3D
        {
            return new Vector3D(axis == 0 ? coordinate : centre[0], axis == 1 ? coordinate : centre[1],
                    axis == 2 ? coordinate : centre[2]);
        }
    }
}
