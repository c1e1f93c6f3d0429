package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How the beginning of a motion lifts a body out of what it overlaps a little: the displacement, and the contacts that it leads out of. Slides go
     * on from the lifted place. Straight motions until a touch end where they would without the lift, but no deeper.
     *
     * @private
     */
    public final class StartLift
    {
        // If a motion leads this many slops deeper into what it was lifted out of, the body has left the surface. Otherwise its core would meet it.
        private static const SLOPS_TO_LEAVE:Number = 2;

        /** The displacement. */
        public var displacement:Vector3D = new Vector3D();

        /** Where the lifted body is. OverlapRecovery.leaveOverlaps() sets it. */
        public var place:Vector3D = new Vector3D();

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

        /**
         * Finds where a part of a motion ends that begins before the lift, but no deeper in what the body was lifted out of. Without this, motions that
         * are shorter than the lift's clearance would lead deeper each time.
         *
         * @param slop the slop of the motion with the lift
         */
        public function findEnd(from:Vector3D, motion:Vector3D, part:Number, slop:Number, out:Vector3D):void
        {
            out.setTo(from.x + part * motion.x, from.y + part * motion.y, from.z + part * motion.z);
            for (var i:int = 0; i < count; i++)
            {
                var contact:ContactPoint = contacts[i];
                var deeper:Number = contact.normalX * (from.x - out.x) + contact.normalY * (from.y - out.y) + contact.normalZ * (from.z - out.z);
                if (deeper > 0 && deeper < SLOPS_TO_LEAVE * slop)
                {
                    contact.push(out, deeper);
                }
            }
        }

        /** Takes the displacement and the contacts of another lift. */
        public function copyFrom(other:StartLift):void
        {
            clear();
            displacement.copyFrom(other.displacement);
            for (var i:int = 0; i < other.count; i++)
            {
                add(other.contacts[i]);
            }
        }
    }
}
