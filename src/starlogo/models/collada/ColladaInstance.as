package starlogo.models.collada
{
    import starlogo.models.AffineTransform;

    /** A geometry in a COLLADA scene, and where it is. */
    internal final class ColladaInstance
    {
        /** The element "geometry". */
        public var geometry:ColladaElement;

        /** Where it is in the scene. */
        public var transform:AffineTransform;

        /** The element that placed it there. */
        public var element:ColladaElement;

        /**
         * @param geometry the element "geometry"
         * @param transform where it is in the scene
         * @param element the element that placed it there
         */
        public function ColladaInstance(geometry:ColladaElement, transform:AffineTransform, element:ColladaElement)
        {
            this.geometry = geometry;
            this.transform = transform;
            this.element = element;
        }
    }
}
