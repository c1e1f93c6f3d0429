package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;

    /**
     * A node of the scene graph: an element of a COLLADA document where a scene has it. An element that other nodes instantiate is several
     * nodes.
     */
    internal final class ColladaNode
    {
        /** The node around this one; null for the root, which is the scene. Read only. */
        public var parent:ColladaNode;

        /** How many nodes are around this one. Read only. */
        public var depth:int;

        /** What takes points of the node to the scene, by the transforms that are visited so far. Read only. */
        public var transform:AffineTransform;

        private var _element:ColladaElement;

        // The index of the child element that is visited next.
        private var _nextChild:int = 0;

        // Nodes are numbered in the order of the visit. This one has the number _preorder, and its descendants the next ones, up to _subtreeEnd.
        private var _preorder:int;
        private var _subtreeEnd:int;

        /**
         * @param element the node's element
         * @param parent the node around it; null for the scene
         * @param first how many nodes were visited before this one
         */
        public function ColladaNode(element:ColladaElement, parent:ColladaNode, first:int)
        {
            _element = element;
            this.parent = parent;
            _preorder = first;
            depth = parent == null ? 0 : parent.depth + 1;
            transform = parent == null ? new AffineTransform() : parent.transform;
        }

        /** Adds the node's next transform, which acts on points before those so far. */
        public function addTransform(local:AffineTransform):void
        {
            transform = transform.after(local);
        }

        /** The next child element. Null if all were visited. */
        public function nextElement():ColladaElement
        {
            return _nextChild < _element.children.length ? _element.children[_nextChild++] : null;
        }

        /** Ends the visit of the node. @param nodeCount how many nodes have been visited */
        public function exit(nodeCount:int):void
        {
            _subtreeEnd = nodeCount;
        }

        /**
         * Of the nodes of an element, the one that has the lowest ancestor in common with this node; the first of several. So each of several
         * figures has joints of its own.
         *
         * @param nodes in the order of the visit, at least one
         */
        public function withLowestCommonAncestor(nodes:Array):ColladaNode
        {
            for (var ancestor:ColladaNode = this; nodes.length > 1 && ancestor != null; ancestor = ancestor.parent)
            {
                var next:int = indexFrom(nodes, ancestor._preorder);
                if (next < nodes.length && nodes[next]._preorder < ancestor._subtreeEnd)
                {
                    return nodes[next];
                }
            }
            return nodes[0];
        }

        /** Whether this node, or one around it, is of an element. */
        public function isWithin(element:ColladaElement):Boolean
        {
            for (var node:ColladaNode = this; node != null; node = node.parent)
            {
                if (node._element == element)
                {
                    return true;
                }
            }
            return false;
        }

        // The index of the first node with at least this number.
        private static function indexFrom(nodes:Array, first:int):int
        {
            var low:int = 0;
            var high:int = nodes.length;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (nodes[middle]._preorder < first)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle;
                }
            }
            return low;
        }
    }
}
