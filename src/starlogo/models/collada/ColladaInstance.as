package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;

    /** A geometry at a place in a COLLADA scene. */
    internal final class ColladaInstance
    {
        /** The element that places the geometry. If there is no scene, the geometry's own element. */
        public var element:ColladaElement;

        /** The geometry's vertices and triangles. All places of a geometry share them. */
        public var mesh:ColladaMesh;

        /** Takes points to the scene. */
        public var transform:AffineTransform;

        /**
         * @param element the element that places the geometry
         * @param mesh the geometry's vertices and triangles
         * @param transform takes its points to the scene
         */
        public function ColladaInstance(element:ColladaElement, mesh:ColladaMesh, transform:AffineTransform)
        {
            this.element = element;
            this.mesh = mesh;
            this.transform = transform;
        }
    }
}
