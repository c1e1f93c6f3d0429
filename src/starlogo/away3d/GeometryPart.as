package starlogo.away3d
{
    import away3d.core.base.ISubGeometry;

    /** A sub-geometry and where it is in the tree that it was found in. */
    internal final class GeometryPart
    {
        /** Its vertices and triangles. */
        public var geometry:ISubGeometry;

        /** Takes its vertices to the tree's own space. */
        public var place:NodeTransform;

        /**
         * @param geometry its vertices and triangles
         * @param place takes its vertices to the tree's own space
         */
        public function GeometryPart(geometry:ISubGeometry, place:NodeTransform)
        {
            this.geometry = geometry;
            this.place = place;
        }
    }
}
