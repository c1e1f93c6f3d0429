package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How a straight motion of a body ends, as a record. ShrunkSweep.findStop() writes it, except for the place, which depends on the question. It
     * writes the contact only if something stops the body, and the shrunk body's place only if the shrunk body meets a row. TouchSweep takes pushes
     * out of it.
     *
     * @private
     */
    public final class MotionResult
    {
        /** The place of the body at the end. */
        public var place:Vector3D = new Vector3D();

        /** The place of the body where the shrunk body touches what stops it. */
        public var shrunkPlace:Vector3D = new Vector3D();

        /** When it ends: in the touch, from 0 to 1; 1 without one. */
        public var time:Number = 1;

        /** The row that stops it; -1 for none. */
        public var row:int = -1;

        /** The contact with that row. */
        public var contact:ContactPoint = new ContactPoint();

        /** Whether planes stand for what the body overlaps at the start, deeply or without a way out. */
        public var hasPlanes:Boolean = false;

        /** Whether a row stops it. */
        public function get isStopped():Boolean
        {
            return row >= 0;
        }

        /** Becomes a copy of another result. */
        public function copyFrom(other:MotionResult):void
        {
            place.copyFrom(other.place);
            shrunkPlace.copyFrom(other.shrunkPlace);
            time = other.time;
            row = other.row;
            contact.copyFrom(other.contact);
            hasPlanes = other.hasPlanes;
        }
    }
}
