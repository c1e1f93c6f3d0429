package starlogo.models.collada
{
    import starlogo.models.AffineTransform;

    /** A node of a COLLADA scene as it is visited, or a geometry that it places. One element may be visited often, through instance_node. */
    internal final class ColladaNode
    {
        /** The element. */
        public var element:ColladaElement;

        /** What it is in, or null. */
        public var parent:ColladaNode;

        /** Where its parent is in the scene, then where it is itself. */
        public var transform:AffineTransform;

        /** The geometry that it places; null for a node. */
        public var geometry:ColladaElement;

        /** How many nodes it is in. */
        public var depth:int;

        /**
         * @param element the element
         * @param parent what it is in, or null
         * @param transform where that is in the scene
         * @param geometry the geometry that it places; null for a node
         */
        public function ColladaNode(element:ColladaElement, parent:ColladaNode, transform:AffineTransform, geometry:ColladaElement = null)
        {
            this.geometry = geometry;
            this.element = element;
            this.parent = parent;
            this.transform = transform;
            depth = parent == null ? 0 : parent.depth + 1;
        }

        /** Whether it is, or is in, a node of an element. */
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
