package starlogo.models.collada
{
    import starlogo.models.AffineTransform;

    /** A node of a COLLADA scene as it is visited: one element may be visited often, through instance_node. */
    internal final class ColladaNode
    {
        /** The element. */
        public var element:ColladaElement;

        /** What it is in, or null. */
        public var parent:ColladaNode;

        /** Where its parent is in the scene, then where it is itself. */
        public var transform:AffineTransform;

        /** The element's id. */
        public var id:String;

        /** How many nodes it is in. */
        public var depth:int;

        /**
         * @param element the element
         * @param parent what it is in, or null
         */
        public function ColladaNode(element:ColladaElement, parent:ColladaNode)
        {
            this.element = element;
            this.parent = parent;
            id = element.id;
            transform = parent == null ? new AffineTransform() : parent.transform;
            depth = parent == null ? 0 : parent.depth + 1;
        }

        /** Whether it is, or is in, a node of an id. */
        public function isWithin(id:String):Boolean
        {
            for (var node:ColladaNode = this; node != null; node = node.parent)
            {
                if (node.id == id)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
