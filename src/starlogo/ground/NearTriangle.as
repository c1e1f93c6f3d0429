package starlogo.ground
{
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Touching;

    /** A triangle of the ground near a model, as a record, with what the tests of all pieces of the model share. */
    internal final class NearTriangle
    {
        /** The triangle. */
        public var ground:GroundTriangle = new GroundTriangle();

        /** A box around it, once <code>setBox()</code> has been called. */
        public var box:GroundBox = new GroundBox();

        /** Its plane, and how far from it other shapes still touch it, because its surface is rounded (see Touching). Set if hasPlane. */
        public var plane:TrianglePlane = new TrianglePlane();
        public var margin:Number = 0;
        public var hasPlane:Boolean = false;

        /** Sets the box, which is larger by a slack. */
        public function setBox(slack:Number):void
        {
            box.setToTriangle(ground.corners, slack);
        }

        /** Sets the plane and the margin. Many triangles are ruled out by their boxes, and need none. */
        public function setPlane():void
        {
            plane.setTriangle(ground.corners, 0);
            margin = Touching.marginOfSurface(ground.radius);
            hasPlane = true;
        }
    }
}
