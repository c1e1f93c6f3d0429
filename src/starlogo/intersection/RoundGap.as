package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.convex.CoreGap;

    /**
     * The gap between the cores of two structures of a RoundKernel, as a record. The first core is a sphere's centre or a capsule's axis. The second is
     * one too, or a box.
     */
    internal final class RoundGap
    {
        /** The gap that the tests write whose structures stand: <code>capsuleCapsule()</code> and <code>capsuleBox()</code>. */
        public static const SCRATCH:RoundGap = new RoundGap();

        /** If the first core is an axis, where on it the closest point is: from 0 at its start to 1 at its end. */
        public var fraction:Number = 0;

        /** The vector, both radii and the closest point, in the structures' space. */
        public var cores:CoreGap = new CoreGap();

        /** If the second core is a box, the closest point of the first core in the box's axes, as seen from its middle. */
        public var place:Vector3D = new Vector3D();

        /** The squared length of the vector. At a box it is more precise than the vector in the structures' space. */
        public var squaredLength:Number = 0;

        /** How fast the motion closes the gap, times the gap's length. Unknown for two centres. */
        public var closingSpeedTimesLength:Number = 0;

        /** The size of both structures together, which rounding errors are relative to. */
        public var size:Number = 0;
    }
}
