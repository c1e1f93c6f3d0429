package starlogo.models.collada
{
    import starlogo.data.lastAtMost;
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

        // Nodes have indices in the order of the visit. The descendants of this one have those after its own, up to _subtreeEnd.
        private var _index:int;
        private var _subtreeEnd:int;

        /**
         * @param element the node's element
         * @param parent the node around it; null for the scene
         * @param index how many nodes were visited before this one
         */
        public function ColladaNode(element:ColladaElement, parent:ColladaNode, index:int)
        {
            _element = element;
            this.parent = parent;
            _index = index;
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
         * figures has joints of its own. Returns its index.
         *
         * @param indices the indices of the element's nodes, at least one, in ascending order
         */
        public function withLowestCommonAncestor(indices:Vector.<Number>):int
        {
            for (var ancestor:ColladaNode = this; indices.length > 1 && ancestor != null; ancestor = ancestor.parent)
            {
                // the first node that is not before the ancestor
                var next:int = lastAtMost(indices, ancestor._index - 1);
                next += indices[next] < ancestor._index ? 1 : 0;
                if (next < indices.length && indices[next] < ancestor._subtreeEnd)
                {
                    return indices[next];
                }
            }
            return indices[0];
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
    }
}
