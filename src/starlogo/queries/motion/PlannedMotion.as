package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.data.NumberList;
    import starlogo.search.Body;

    /**
     * A motion that a question asks about: what moves, where to, and what may be in its way. MotionPlanner writes it.
     *
     * @private
     */
    public final class PlannedMotion
    {
        /**
         * The body that moves, where it begins: a copy, because a filter's <code>accepts</code> may move the agent. It has no shape while its model
         * is loading.
         */
        public var body:Body = new Body();

        /** Where its place is then. */
        public var from:Vector3D = new Vector3D();

        /** The whole motion, if it is known. */
        public var motion:Vector3D = new Vector3D();

        /** The rows that count and are near it, in the order of the list. */
        public var rows:NumberList = new NumberList();
    }
}
