package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How the beginning of a motion lifts a body out of what it overlaps a little, as a record: the displacement, and the contacts that it leads out of.
     *
     * @private
     */
    public final class StartLift
    {
        /** The displacement. */
        public var displacement:Vector3D = new Vector3D();

        /** Where the lifted body is. OverlapRecovery.leaveOverlaps() sets it. */
        public var place:Vector3D = new Vector3D();

        /** If a motion leads this much deeper into what the body was lifted out of, in patches, the body has left the surface. */
        public var mostDepth:Number = 0;

        /** The contacts, and their number. */
        public var contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();
        public var count:int = 0;

        /** Whether the body is displaced. */
        public function get isLifted():Boolean
        {
            return displacement.x != 0 || displacement.y != 0 || displacement.z != 0;
        }

        /** Begins without displacement and contacts. */
        public function clear():void
        {
            displacement.setTo(0, 0, 0);
            count = 0;
        }

        /** Adds a contact. The displacement does not change. */
        public function add(contact:ContactPoint):void
        {
            if (count == contacts.length)
            {
                contacts[count] = new ContactPoint();
            }
            contacts[count].copyFrom(contact);
            count++;
        }

        /** Takes the displacement and the contacts of another lift. */
        public function copyFrom(other:StartLift):void
        {
            clear();
            displacement.copyFrom(other.displacement);
            mostDepth = other.mostDepth;
            for (var i:int = 0; i < other.count; i++)
            {
                add(other.contacts[i]);
            }
        }
    }
}
