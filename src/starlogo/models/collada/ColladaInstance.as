package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;

    /** A geometry at a place in a COLLADA scene. One geometry may be placed often. */
    internal final class ColladaInstance
    {
        /** The element that places it; the geometry's own element if there is no scene. */
        public var element:ColladaElement;

        /** The geometry's vertices and triangles. All instances of a geometry share them. */
        public var mesh:ColladaMesh;

        /** Takes the geometry's points to the scene, with z up. */
        public var transform:AffineTransform;

        /**
         * @param element the element that places it
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
