package starlogo.bounding
{
    import flash.geom.Vector3D;

    /**
     * A convex structure as the package convex takes it, as a record: the convex hull of points, with a radius around it.
     *
     * @private
     */
    public final class RoundedHull
    {
        /** A point inside of the structure. */
        public var center:Vector3D = null;

        /** The points relative to the centre, x, y, z of each. */
        public var points:Vector.<Number> = null;

        /** Three points of each face, counter-clockwise seen from outside, as indices of their first numbers. */
        public var faces:Vector.<int> = null;

        /** Both ends of each edge, and one more point of each of its two faces, as such indices. */
        public var edges:Vector.<int> = null;

        /** The radius around the points' hull. */
        public var radius:Number = 0;
    }
}
