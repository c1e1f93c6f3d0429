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

        /** Sets all this to the corners. The box is larger by a growth on all sides. */
        public function update(growth:Number):void
        {
            box.setToTriangle(corners, growth);
            plane.setTriangle(corners, 0);
            margin = Touching.marginOfSurface(radius);
        }
    }
}
