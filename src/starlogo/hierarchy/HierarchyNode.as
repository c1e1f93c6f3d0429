package starlogo.hierarchy
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.data.IntSet;
    import starlogo.engine;

    use namespace engine;

    /**
     * A node of a model's hierarchy: a box around a part of the model, and two child nodes that divide this part between them (thesis §4.3).
     *
     * <p>A part consists of whole triangles, or of vertices if the model has no triangles. A node's box encloses its children's boxes. All
     * coordinates are in the model's space.</p>
     *
     * <p>A node is a view of a place in the tree that the engine keeps. It is made when a client first asks for it.</p>
     */
    public final class HierarchyNode
    {
        private var _tree:BoxTree;
        private var _node:int;

        // Null until they are read.
        private var _left:HierarchyNode = null;
        private var _right:HierarchyNode = null;

        /** Not for clients: the HierarchiesLibrary makes the nodes. */
        public function HierarchyNode()
        {
        }

        /** @private A view of a node. */
        engine static function of(tree:BoxTree, node:int):HierarchyNode
        {
            var view:HierarchyNode = new HierarchyNode();
            view._tree = tree;
            view._node = node;
            return view;
        }

        /** The child on the low side of the split, or null. */
        public function get left():HierarchyNode
        {
            return _left ||= childAt(0);
        }

        /** The child on the high side of the split, or null. */
        public function get right():HierarchyNode
        {
            return _right ||= childAt(1);
        }

        private function childAt(side:int):HierarchyNode
        {
            return isLeaf ? null : of(_tree, _tree.left[_node] + side);
        }

        /** Whether the node has no children that clients see. */
        public function get isLeaf():Boolean
        {
            return _tree.isLeafOrBelow(_node);
        }

        /**
         * The number of vertices under the node. If the model has triangles, these are the vertices of the node's triangles, each counted
         * once. Then the counts of two children add up to more than their parent's if they share vertices. They are counted at each call.
         */
        public function get vertexCount():int
        {
            return _tree.countVertices(_node, new IntSet());
        }

        /**
         * A new axis-aligned box around the node's part as it is now: <code>Model.pose()</code> changes it. The box is slightly larger than the
         * part (Tolerances.SURFACES and NESTING).
         */
        public function get bounds():BoundingStructure
        {
            return _tree.boxOf(_node).clone();
        }

        /** The number of triangles under the node; 0 if only vertices are known. */
        public function get triangleCount():int
        {
            return _tree.hasTriangles ? _tree.endPrimitive[_node] - _tree.firstPrimitive[_node] : 0;
        }

        /**
         * The indices of the triangles under the node, in ascending order. The model's first triangle is 0.
         *
         * @param out overwritten; created if null
         * @return out
         */
        public function triangleIndices(out:Vector.<int> = null):Vector.<int>
        {
            return writePrimitives(_tree.hasTriangles, out);
        }

        /**
         * The indices of the vertices under the node, in ascending order, if only vertices are known. The model's first vertex is 0. Empty
         * if the model has triangles, because these name their vertices.
         *
         * @param out overwritten; created if null
         * @return out
         */
        public function vertexIndices(out:Vector.<int> = null):Vector.<int>
        {
            return writePrimitives(!_tree.hasTriangles, out);
        }

        private function writePrimitives(areAsked:Boolean, out:Vector.<int>):Vector.<int>
        {
            var end:int = areAsked ? _tree.endPrimitive[_node] : 0;
            out ||= new Vector.<int>();
            out.length = 0;
            for (var i:int = _tree.firstPrimitive[_node]; i < end; i++)
            {
                out.push(_tree.primitives[i]);
            }
            out.sort(Array.NUMERIC);
            return out;
        }
    }
}
