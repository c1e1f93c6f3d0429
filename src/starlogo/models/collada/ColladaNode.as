package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;

    /** A node of a COLLADA scene during the visit. One element may be visited often, through instance_node. */
    internal final class ColladaNode
    {
        /** The node's element. */
        public var element:ColladaElement;

        /** The node around this one, or null. */
        public var parent:ColladaNode;

        /** The parent's transform in the scene, combined with the node's own transform elements that are visited so far. */
        public var transform:AffineTransform;

        /** The number of nodes around it. */
        public var depth:int;

        /**
         * @param element the node's element
         * @param parent the node around it, or null
         * @param transform the parent's transform in the scene
         */
        public function ColladaNode(element:ColladaElement, parent:ColladaNode, transform:AffineTransform)
        {
            this.element = element;
            this.parent = parent;
            this.transform = transform;
            depth = parent == null ? 0 : parent.depth + 1;
        }

        /** Adds the transform of an element of the node, which applies before those so far. */
        public function addTransform(local:AffineTransform):void
        {
            transform = transform.after(local);
        }

        /** Whether this node, or one around it, has the given element. */
        public function isWithin(element:ColladaElement):Boolean
        {
            for (var node:ColladaNode = this; node != null; node = node.parent)
            {
                if (node.element == element)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
