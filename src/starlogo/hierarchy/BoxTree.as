// The package hierarchy keeps, builds and searches trees of boxes. A BoxTreeBuilder makes the nodes, and a BoxRefit moves them. A BoxSearch finds
// the leaves of one tree near a box or a ray. The package solid asks trees, and visits pairs of nodes of two. Read BoxTree first, then BoxSearch.

package starlogo.hierarchy
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Box;
    import starlogo.data.zeroedInts;
    import starlogo.geometry.Tolerances;

    /**
     * A model's tree of boxes (thesis §4.3). Its primitives are the model's triangles, or its vertices if it has no triangles.
     *
     * <p>A node is an index into the columns. The root is 0. The two children of a node stand side by side, after their parent. Once the
     * nodes are made, only a BoxRefit changes them: it gives all of them new boxes. Clients see a node as a HierarchyNode.</p>
     *
     * <p>A tree of triangles goes on below the leaves of the thesis's tree, down to nodes with a few triangles, for exact tests. A search goes down to a
     * depth. The nodes at which it ends are its leaves (<code>leafUpToDepth</code>). It tests them by their boxes, or in exact tests by their triangles.</p>
     *
     * @private
     */
    public final class BoxTree
    {
        /** The depth of exact tests: a search goes on below the leaves of the thesis, to nodes without children. */
        public static const EXACT:int = int.MAX_VALUE;

        /** The largest other depth: a search ends at the leaves of the thesis. */
        public static const LEAVES:int = int.MAX_VALUE - 1;

        // The boxes' margins are at least as large as if this were the model's largest coordinate. So no box is smaller than a structure may be.
        private static const MIN_COORDINATE:Number = 1e-50;

        /** The model's vertices: x, y, z of each. */
        public var vertices:Vector.<Number>;

        /** The model's triangles, three vertex indices each; null if the vertices are the primitives. */
        public var triangles:Vector.<uint>;

        /**
         * The primitives in the order of the tree, so that those of a node stand side by side: the number of each triangle or vertex in the model. A
         * primitive index is an index into this list. Set before the nodes are made.
         */
        public var primitives:Vector.<int> = null;

        /**
         * The triangles' corners by primitive index, three each: where the coordinates of the vertex begin in the list of vertices. Null until
         * <code>listCorners()</code>.
         */
        public var cornerOffsets:Vector.<int> = null;

        /** Six numbers for each node: the middle of its box (x, y, z), and half of the box's extents. */
        public var boxes:Vector.<Number> = new Vector.<Number>();

        /** For each node, its left child, which is on the low side of the split. The right child is the next node. 0 if the node has no children. */
        public var left:Vector.<int> = new Vector.<int>();

        /** For each node, the index of its first primitive. */
        public var firstPrimitive:Vector.<int> = new Vector.<int>();

        /** For each node, the index after that of its last one. */
        public var endPrimitive:Vector.<int> = new Vector.<int>();

        /**
         * For each node, the largest depth of the searches whose leaf it is: EXACT for a node without children, LEAVES for any other leaf of the thesis or
         * node below one, its level for a node above these.
         */
        public var leafUpToDepth:Vector.<int> = new Vector.<int>();

        /** For each node, four times its level plus the axis along which it is split: see <code>levelOf()</code> and <code>axisOf()</code>. */
        internal var levelAndAxis:Vector.<int> = new Vector.<int>();

        /** The radius of the sphere around the root's box. Set with that box. */
        public var boundingRadius:Number = 0;

        /** The radius of a sphere around the origin that contains the model. Rounding errors are relative to it. Complete with the root's box. */
        public var radiusAboutOrigin:Number = 0;

        // The number of nodes while they are made; 0 before and after.
        private var _count:int = 0;

        // The result of boxOf().
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 0, 0, 0);

        /**
         * Creates a tree without nodes. A BoxTreeBuilder makes them, or a CookedTree.
         *
         * @param vertices x, y, z of each, at most 1e60
         * @param triangles three vertex indices each, or null if the vertices are the primitives
         */
        public function BoxTree(vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            this.vertices = vertices;
            this.triangles = triangles;
        }

        /** Whether there are nodes, all of them. */
        public function get isMade():Boolean
        {
            return _count == 0 && left.length > 0;
        }

        /** Whether the primitives are triangles; otherwise they are vertices. */
        public function get hasTriangles():Boolean
        {
            return triangles != null;
        }

        /** The number of primitives. */
        public function get primitiveCount():int
        {
            return hasTriangles ? triangles.length / 3 : vertices.length / 3;
        }

        /** Lists the triangles' corners, for exact tests, unless they are listed. The nodes are made. */
        public function listCorners():void
        {
            if (cornerOffsets != null)
            {
                return;
            }
            cornerOffsets = zeroedInts(3 * primitives.length);
            for (var index:int = 0; index < primitives.length; index++)
            {
                for (var corner:int = 0; corner < 3; corner++)
                {
                    cornerOffsets[int(3 * index + corner)] = 3 * triangles[int(3 * primitives[index] + corner)];
                }
            }
        }

        /**
         * Reads the corners' coordinates of a triangle. The corners are listed.
         *
         * @param index the primitive index
         * @param out receives nine numbers
         * @param at index at which they begin
         */
        public function readTriangle(index:int, out:Vector.<Number>, at:int = 0):void
        {
            var points:Vector.<Number> = vertices;
            var a:int = cornerOffsets[int(3 * index)];
            var b:int = cornerOffsets[int(3 * index + 1)];
            var c:int = cornerOffsets[int(3 * index + 2)];
            out[at] = points[a];
            out[int(at + 1)] = points[int(a + 1)];
            out[int(at + 2)] = points[int(a + 2)];
            out[int(at + 3)] = points[b];
            out[int(at + 4)] = points[int(b + 1)];
            out[int(at + 5)] = points[int(b + 2)];
            out[int(at + 6)] = points[c];
            out[int(at + 7)] = points[int(c + 1)];
            out[int(at + 8)] = points[int(c + 2)];
        }

        /** Whether a node is a leaf of the thesis, or below one. */
        public function isLeafOrBelow(node:int):Boolean
        {
            return leafUpToDepth[node] >= LEAVES;
        }

        /** The axis along which a node is split: 0, 1 or 2. */
        public function axisOf(node:int):int
        {
            return levelAndAxis[node] & 3;
        }

        /** The level of a node. The root has 1. */
        public function levelOf(node:int):int
        {
            return levelAndAxis[node] >> 2;
        }

        /**
         * The box of a node as a structure. The next call overwrites it. Two models a and b may share one tree: place b's box before asking for a's.
         */
        public function boxOf(node:int):Box
        {
            var at:int = 6 * node;
            var box:Box = _box;
            var center:Vector3D = box.center;
            center.x = boxes[at];
            center.y = boxes[int(at + 1)];
            center.z = boxes[int(at + 2)];
            box.halfX = boxes[int(at + 3)];
            box.halfY = boxes[int(at + 4)];
            box.halfZ = boxes[int(at + 5)];
            return box;
        }

        /**
         * The number of vertices of a node's primitives. Each vertex is counted once.
         *
         * @param enough the count may end when it is more than this
         */
        public function countVertices(node:int, enough:int = int.MAX_VALUE):int
        {
            if (!hasTriangles)
            {
                return endPrimitive[node] - firstPrimitive[node];
            }
            var isCounted:Object = {};
            var count:int = 0;
            for (var i:int = firstPrimitive[node]; i < endPrimitive[node] && count <= enough; i++)
            {
                for (var corner:int = 3 * primitives[i]; corner < 3 * primitives[i] + 3; corner++)
                {
                    if (isCounted[triangles[corner]] == undefined)
                    {
                        isCounted[triangles[corner]] = true;
                        count++;
                    }
                }
            }
            return count;
        }

        /**
         * Reads the extents of some primitives together: minX, maxX, minY, maxY, minZ, maxZ.
         *
         * @param from the index of the first of them
         * @param to the index after the last of them
         * @param out receives the extents
         * @param at index at which they begin
         */
        public function readExtents(from:int, to:int, out:Vector.<Number>, at:int):void
        {
            var points:Vector.<Number> = vertices;
            var corners:Vector.<uint> = triangles;
            var numbers:Vector.<int> = primitives;
            var perPrimitive:int = corners == null ? 1 : 3;
            var minX:Number = Infinity;
            var minY:Number = Infinity;
            var minZ:Number = Infinity;
            var maxX:Number = -Infinity;
            var maxY:Number = -Infinity;
            var maxZ:Number = -Infinity;
            for (var i:int = from; i < to; i++)
            {
                var corner:int = perPrimitive * numbers[i];
                for (var last:int = corner + perPrimitive; corner < last; corner++)
                {
                    var vertex:int = corner;
                    if (perPrimitive == 3)
                    {
                        vertex = corners[corner];
                    }
                    vertex *= 3;
                    var x:Number = points[vertex];
                    var y:Number = points[int(vertex + 1)];
                    var z:Number = points[int(vertex + 2)];
                    minX = x < minX ? x : minX;
                    maxX = x > maxX ? x : maxX;
                    minY = y < minY ? y : minY;
                    maxY = y > maxY ? y : maxY;
                    minZ = z < minZ ? z : minZ;
                    maxZ = z > maxZ ? z : maxZ;
                }
            }
            out[at] = minX;
            out[int(at + 1)] = maxX;
            out[int(at + 2)] = minY;
            out[int(at + 3)] = maxY;
            out[int(at + 4)] = minZ;
            out[int(at + 5)] = maxZ;
        }

        /**
         * Measures the radius about the origin, on which the boxes' margins depend. Must be called before <code>enclose()</code>.
         *
         * @param extents the extents of the whole model; begins with minX, maxX, minY, maxY, minZ, maxZ
         */
        internal function measureRadiusAboutOrigin(extents:Vector.<Number>):void
        {
            var largest:Number = 0;
            for (var i:int = 0; i < 6; i++)
            {
                largest = Math.max(largest, Math.abs(extents[i]));
            }
            radiusAboutOrigin = largest == 0 ? 0 : Math.max(MIN_COORDINATE, largest) * Math.sqrt(3);
        }

        /**
         * Sets a node's box, and the bounding radius with that of the root. The box is larger than the node's part by a margin. So everything that touches the
         * surface touches the boxes, and boxes are inside of their parents' boxes in spite of rounding.
         *
         * @param extents contains the extents of the part: minX, maxX, minY, maxY, minZ, maxZ
         * @param at index at which they begin
         */
        internal function enclose(node:int, extents:Vector.<Number>, at:int = 0):void
        {
            var margin:Number = radiusAboutOrigin * (Tolerances.SURFACES + Tolerances.NESTING * Math.max(1, Tolerances.NESTED_LEVELS - levelOf(node)));
            var minX:Number = extents[at];
            var minY:Number = extents[int(at + 2)];
            var minZ:Number = extents[int(at + 4)];
            var halfX:Number = 0.5 * (extents[int(at + 1)] - minX);
            var halfY:Number = 0.5 * (extents[int(at + 3)] - minY);
            var halfZ:Number = 0.5 * (extents[int(at + 5)] - minZ);
            var to:int = 6 * node;
            boxes[to] = minX + halfX;
            boxes[int(to + 1)] = minY + halfY;
            boxes[int(to + 2)] = minZ + halfZ;
            boxes[int(to + 3)] = halfX + margin;
            boxes[int(to + 4)] = halfY + margin;
            boxes[int(to + 5)] = halfZ + margin;
            if (node == 0)
            {
                boundingRadius = Math.sqrt(boxes[3] * boxes[3] + boxes[4] * boxes[4] + boxes[5] * boxes[5]);
            }
        }

        /**
         * Makes the root, without children. Until <code>completeNodes()</code>, the columns are longer than the number of nodes. They begin with room for
         * the nodes of most models, because longer columns are copies.
         */
        public function beginNodes():void
        {
            var room:int = Math.min(2 * primitiveCount, 0.4 * primitiveCount + 1000);
            boxes = new Vector.<Number>(6 * room);
            left = new Vector.<int>(room);
            firstPrimitive = new Vector.<int>(room);
            endPrimitive = new Vector.<int>(room);
            leafUpToDepth = new Vector.<int>(room);
            levelAndAxis = new Vector.<int>(room);
            _count = 0;
            addNode(0, primitiveCount, 1);
        }

        /**
         * Gives a node two children. They have no boxes yet.
         *
         * @param axis the axis along which it is split
         * @param splitIndex the index of the right child's first primitive
         * @param isLeafOrBelow whether the node is a leaf of the thesis, or below one
         * @return the left child
         */
        public function addChildren(node:int, axis:int, splitIndex:int, isLeafOrBelow:Boolean):int
        {
            var level:int = levelOf(node);
            var child:int = _count;
            left[node] = child;
            leafUpToDepth[node] = isLeafOrBelow ? LEAVES : level;
            levelAndAxis[node] = level << 2 | axis;
            addNode(firstPrimitive[node], splitIndex, level + 1);
            addNode(splitIndex, endPrimitive[node], level + 1);
            return child;
        }

        /** Ends the making of nodes. */
        public function completeNodes():void
        {
            // V8 keeps all of a list that is shortened by less than half, and copying takes time
            if (4 * _count < 3 * left.length)
            {
                boxes = boxes.slice(0, 6 * _count);
                left = left.slice(0, _count);
                firstPrimitive = firstPrimitive.slice(0, _count);
                endPrimitive = endPrimitive.slice(0, _count);
                leafUpToDepth = leafUpToDepth.slice(0, _count);
                levelAndAxis = levelAndAxis.slice(0, _count);
            }
            boxes.length = 6 * _count;
            left.length = firstPrimitive.length = endPrimitive.length = leafUpToDepth.length = levelAndAxis.length = _count;
            _count = 0;
        }

        private function addNode(from:int, to:int, level:int):void
        {
            var node:int = _count;
            if (node == left.length)
            {
                boxes.length = 12 * node;
                left.length = firstPrimitive.length = endPrimitive.length = leafUpToDepth.length = levelAndAxis.length = 2 * node;
            }
            firstPrimitive[node] = from;
            endPrimitive[node] = to;
            leafUpToDepth[node] = EXACT;
            levelAndAxis[node] = level << 2;
            _count = node + 1;
        }
    }
}
