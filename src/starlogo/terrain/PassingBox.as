package starlogo.terrain
{
    import flash.geom.Vector3D;
    import starlogo.intersection.sweep.RelativeMotion;

    /**
     * A box along the world's axes that stands, or moves along a straight line. It has plain fields, because V8 allocates an object for each
     * Number that is passed.
     */
    internal final class PassingBox
    {
        /** Its middle, where the way begins. */
        public var middle:Vector3D = new Vector3D();

        /** Half its lengths. */
        public var half:Vector3D = new Vector3D();

        /** The way; RelativeMotion.NONE if it stands. Only x, y and z count. */
        public var way:RelativeMotion = RelativeMotion.NONE;

        /** How far from the standing box something still counts. It may be reduced during a walk, as the limit may. */
        public var reach:Number = 0;

        /** How much of the way counts, as a multiple of the way. It may be reduced during a walk. */
        public var limit:Number = 0;

        /** The part of the way that <code>cut()</code> narrows. */
        public var from:Number = 0;

        /** @copy #from */
        public var to:Number = 0;

        /** Creates a box at the origin. */
        public function PassingBox()
        {
        }

        /** Narrows the part of the way to the part on which the box overlaps an interval along one axis. */
        public function cut(at:Number, half:Number, way:Number, low:Number, high:Number):void
        {
            low -= at + half;
            high -= at - half;
            if (way == 0)
            {
                to = low > 0 || high < 0 ? -1 : to;
                return;
            }
            from = Math.max(from, Math.min(low / way, high / way));
            to = Math.min(to, Math.max(low / way, high / way));
        }
    }
}
