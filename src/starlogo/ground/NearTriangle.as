package starlogo.ground
{
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Touching;

    /** A triangle of the ground near a model, as a record, with what the tests of all pieces of the model share. */
    internal final class NearTriangle extends GroundTriangle
    {
        /** A box around it. */
        public var box:GroundBox = new GroundBox();

        /** Its plane, and how far from it other shapes still touch it, because its surface is rounded (see Touching). */
        public var plane:TrianglePlane = new TrianglePlane();
        public var margin:Number = 0;

        /** Sets all this to the corners. The box is larger by the source's slack. */
        public function update(source:GroundTriangles):void
        {
            box.setToTriangle(corners);
            box.grow(source.slack);
            plane.setTriangle(corners, 0);
            margin = Touching.marginOfSurface(radius);
        }
    }
}
