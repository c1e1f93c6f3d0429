package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * How the beginning of a motion lifts a body out of what it overlaps a little: the displacement, and the contacts that it leads out of.
     *
     * @private
     */
    public final class StartLift
    {
        /** The displacement. */
        public var displacement:Vector3D = new Vector3D();

        /** If a motion leads this much deeper into what the body was lifted out of, in patches, the body has left the surface. */
        public var mostDepth:Number = 0;

        // The contacts, and their number.
        private var _contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();
        private var _count:int = 0;

        /** Whether the body is displaced. */
        public function get isLifted():Boolean
        {
            return displacement.x != 0 || displacement.y != 0 || displacement.z != 0;
        }

        /** Begins without displacement and contacts. */
        public function clear():void
        {
            displacement.setTo(0, 0, 0);
            _count = 0;
        }

        /** Adds a contact. The displacement does not change. */
        public function add(contact:ContactPoint):void
        {
            if (_count == _contacts.length)
            {
                _contacts[_count] = new ContactPoint();
            }
            _contacts[_count].copyFrom(contact);
            _count++;
        }

        /** Takes the displacement and the contacts of another lift. */
        public function copyFrom(other:StartLift):void
        {
            clear();
            displacement.copyFrom(other.displacement);
            mostDepth = other.mostDepth;
            for (var i:int = 0; i < other._count; i++)
            {
                add(other._contacts[i]);
            }
        }

        /**
         * Moves a place back to where the body is no deeper in what it was lifted out of than at the beginning. Without this, motions that are
         * shorter than the lift's clearance would lead deeper each time.
         *
         * @param at the place at the end of the motion, which changes
         * @param from the place at its beginning
         */
        public function keepDepth(at:Vector3D, from:Vector3D):void
        {
            for (var i:int = 0; i < _count; i++)
            {
                var contact:ContactPoint = _contacts[i];
                var deeper:Number = contact.normalX * (from.x - at.x) + contact.normalY * (from.y - at.y) + contact.normalZ * (from.z - at.z);
                if (deeper > 0 && deeper < mostDepth)
                {
                    contact.push(at, deeper);
                }
            }
        }
    }
}
