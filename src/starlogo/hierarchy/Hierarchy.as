package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.VertexBounds;

    use namespace engine;

    /**
     * A model's hierarchy as the engine uses it: the root, and the data that all nodes share. Clients see the root only.
     *
     * @private
     */
    public class Hierarchy
    {
        /** @private The node around the whole model; null until it is built or read. */
        engine var root:HierarchyNode = null;

        /** @private Whether the items are triangles; otherwise they are vertices. */
        engine var hasTriangles:Boolean;

        /** @private The indices of the triangles or vertices. The indices of a leaf stand side by side. Null until the order is known. */
        engine var order:Vector.<int> = null;

        /** @private The model's vertices: x, y, z of each. */
        engine var vertices:Vector.<Number>;

        /** @private The model's triangles, three vertex indices each; null if only vertices are known. */
        engine var triangles:Vector.<uint>;

        /** @private The measured triangles, until they are divided for exact tests; null if they are not measured. */
        engine var items:TreeItems = null;

        /** @private The boxes down to a few triangles each, or null if they are not prepared. */
        engine var tree:PackedTree = null;

        /** @private A node with at most this many vertices is a leaf. */
        engine var minVerticesToSplit:int;

        /** @private A node on this level is a leaf. */
        engine var maxDepth:int;

        /** @private Whether nodes are split at the mean. */
        engine var splitByMean:Boolean;

        // How far the model extends from its origin. The rounding error is relative to it.
        private var _reach:Number = 0;

        /**
         * Creates a hierarchy without nodes. A HierarchyBuilder makes them.
         *
         * @param vertices x, y, z of each
         * @param triangles three vertex indices each, or null if the vertices are the items
         * @param minVerticesToSplit a node with at most this many vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean
         */
        public function Hierarchy(vertices:Vector.<Number>, triangles:Vector.<uint>, minVerticesToSplit:int, maxDepth:int, splitByMean:Boolean)
        {
            this.vertices = vertices;
            this.triangles = triangles;
            this.minVerticesToSplit = minVerticesToSplit;
            this.maxDepth = maxDepth;
            this.splitByMean = splitByMean;
            hasTriangles = triangles != null;
        }

        /** @private The number of items. */
        engine function get itemCount():int
        {
            return hasTriangles ? triangles.length / 3 : vertices.length / 3;
        }

        /** @private The number of vertices of some items. Each vertex is counted once. */
        engine function countVertices(first:int, end:int):int
        {
            return countUpTo(first, end, int.MAX_VALUE);
        }

        /** @private Whether some items have more vertices than a number. It looks only at as many items as that takes. */
        engine function hasMoreVertices(first:int, end:int, number:int):Boolean
        {
            return countUpTo(first, end, number) > number;
        }

        // Counts the vertices of items, until there are more than a number.
        private function countUpTo(first:int, end:int, most:int):int
        {
            var isCounted:Object = {};
            var count:int = hasTriangles ? 0 : end - first;
            for (var i:int = first; hasTriangles && i < end && count <= most; i++)
            {
                var corner:int = 3 * order[i];
                for (var last:int = corner + 3; corner < last; corner++)
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
         * @private Sets the extents of the whole model. Must be called before nodes are made.
         *
         * @param extents minX, minY, minZ, maxX, maxY, maxZ
         * @throws ArgumentError if a coordinate is larger than 1e60
         */
        engine function setExtents(extents:Vector.<Number>):void
        {
            for (var i:int = 0; i < 6; i++)
            {
                _reach = Math.max(_reach, Math.abs(extents[i]));
            }
            VertexBounds.requireWithin(_reach);
            _reach *= Math.sqrt(3);
        }

        /**
         * @private Makes a node without children. Its box is larger than its part by a margin. So everything that touches the surface touches
         * the boxes, and boxes are inside of their parents' boxes in spite of rounding.
         *
         * @param level the root's level is 1
         * @param first index of its first item in the order
         * @param end index after its last item
         * @param extents contains the extents of its part: minX, minY, minZ, maxX, maxY, maxZ
         * @param at index at which they begin
         */
        engine function makeNode(level:int, first:int, end:int, extents:Vector.<Number>, at:int = 0):HierarchyNode
        {
            var margin:Number = _reach * (Tolerances.SURFACES + Tolerances.NESTING * Math.max(1, Tolerances.NESTED_LEVELS - level));
            var node:HierarchyNode = new HierarchyNode();
            node.hierarchy = this;
            node.level = level;
            node.first = first;
            node.end = end;
            var minX:Number = extents[at];
            var minY:Number = extents[int(at + 1)];
            var minZ:Number = extents[int(at + 2)];
            var halfX:Number = 0.5 * (extents[int(at + 3)] - minX);
            var halfY:Number = 0.5 * (extents[int(at + 4)] - minY);
            var halfZ:Number = 0.5 * (extents[int(at + 5)] - minZ);
            node.x = minX + halfX;
            node.y = minY + halfY;
            node.z = minZ + halfZ;
            node.setHalfExtents(halfX + margin, halfY + margin, halfZ + margin);
            return node;
        }
    }
}
