package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.data.IntList;

    /**
     * What a motion has met and what can still stop it, as a record. ShrunkSweep.startMotion() begins it. A slide goes on with it: it adds planes,
     * finds the next impact, and removes what it passes from the obstacles.
     *
     * @private
     */
    public final class MotionState
    {
        /** The shrunk body on this motion, and the motion's tolerances. */
        public var shrunk:ShrunkBody = new ShrunkBody();

        /** Where the body starts. It differs from where the motion should start if the body was pushed out of something. */
        public var start:Vector3D = new Vector3D();

        /** The pushes out of shallow overlaps: each along the normal of a contact, by its depth. */
        public var pushes:ContactList = new ContactList();

        /** The contacts of overlaps that stay (deep, or without a way out), and those that a slide has met. The motion must not cross their planes. */
        public var planes:ContactList = new ContactList();

        /** The rows that can stop the motion: not those that a plane stands for, and no one-way rows that the body passes. */
        public var obstacles:IntList = new IntList();

        /**
         * Whether the impact is known already: the motion has no length, or the sweep has shown that the shrunk body overlaps nothing. Otherwise the
         * body may overlap something, or it is flat, or a one-way row comes first. Then overlaps have been left, and the obstacles must be swept from
         * the start.
         */
        public var isImpactKnown:Boolean = false;

        /** What the shrunk body meets next, once it is known. */
        public var impact:Impact = new Impact();
    }
}
