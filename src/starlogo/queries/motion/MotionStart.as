package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.data.IntList;

    /**
     * How a motion starts, as a record. CoreSweep.findStart() writes it. A slide goes on with it: it adds planes, and removes what it passes from the
     * obstacles.
     *
     * @private
     */
    public final class MotionStart
    {
        /** The core of the body on this motion, and the motion's tolerances. */
        public var core:BodyCore = new BodyCore();

        /** The place of the body. It differs from where the motion should start if the body was lifted out of something. */
        public var place:Vector3D = new Vector3D();

        /** The contacts of shallow overlaps, which the body was lifted out of. */
        public var lifted:ContactList = new ContactList();

        /** The contacts of deep overlaps. The motion must not cross their planes. */
        public var planes:ContactList = new ContactList();

        /** The rows that can stop the motion: not those that have a plane, and no one-way rows that the body passes. */
        public var obstacles:IntList = new IntList();

        /** Whether the body overlapped nothing. Then the first impact is known. */
        public var isFree:Boolean = false;

        /** What the core meets first. */
        public var impact:Impact = new Impact();
    }
}
