package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;

    /**
     * An element at a place in a COLLADA scene: a node during the visit, or an instance of a geometry. One element may be at many places, through
     * instance_node.
     */
    internal final class ColladaPlace
    {
        /** The node's element, or the element that places the geometry. If there is no scene, the geometry's own element. */
        public var element:ColladaElement;

        /** The node around this one; null for the scene and for an instance. */
        public var parent:ColladaPlace;

        /** Takes points to the scene, with z up. For a node, it grows with each of its transform elements that is visited. */
        public var transform:AffineTransform;

        /** The geometry's vertices and triangles; null for a node. All instances of a geometry share them. */
        public var mesh:ColladaMesh;

        /** The number of nodes around this one. */
        public var depth:int;

        /**
         * @param element the element
         * @param parent the node around this one; null for the scene and for an instance
         * @param transform takes its points to the scene
         * @param mesh the geometry's vertices and triangles; null for a node
         */
        public function ColladaPlace(element:ColladaElement, parent:ColladaPlace, transform:AffineTransform, mesh:ColladaMesh = null)
        {
            this.element = element;
            this.parent = parent;
            this.transform = transform;
            this.mesh = mesh;
            depth = parent == null ? 0 : parent.depth + 1;
        }

        /** Whether this node, or one around it, has the given element. */
        public function isWithin(element:ColladaElement):Boolean
        {
            for (var node:ColladaPlace = this; node != null; node = node.parent)
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
