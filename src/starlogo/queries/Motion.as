package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How a motion of a body has ended. Mover writes it.
     *
     * @private
     */
    public final class Motion
    {
        /** The place of the body at the end. */
        public var place:Vector3D = new Vector3D();

        /** The part of the motion that the body has gone, from 0 to 1. */
        public var fraction:Number = 1;

        /** The row that stopped it; -1 for none, and after a slide. */
        public var row:int = -1;

        /** The contact with that row. */
        public var contact:ContactPoint = new ContactPoint();

        /** Whether it began deep in another row. */
        public var isDeep:Boolean = false;

        /** Whether it began with a lift out of a row. */
        public var isLifted:Boolean = false;

        /** Whether a slide met a wall: a surface that was too steep for it. */
        public var metWall:Boolean = false;

        /** The most level contact that a slide has met: the one with the greatest z of its normal. If there is none, its normalZ is -2. */
        public var floor:ContactPoint = new ContactPoint();

        /** The other row of that contact. */
        public var floorRow:int = -1;

        /** A row that the body is known not to touch at the end; -1 if none is. */
        public var clearRow:int = -1;

        /** Becomes a motion that has not begun. */
        public function beginAt(from:Vector3D):void
        {
            place.copyFrom(from);
            fraction = 1;
            row = clearRow = -1;
            contact.setNormal(0, 0, 0);
            floor.setNormal(0, 0, -2);
            isDeep = isLifted = metWall = false;
        }
    }
}
