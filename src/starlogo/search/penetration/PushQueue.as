package starlogo.search.penetration
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;

    /**
     * Finds the shortest push that leads out of several contacts. A contact requires a push of at least its depth along its normal.
     *
     * <p>PushOut takes the shortest push of the list and tries it. If the body still touches something there, pushes are added that also lead
     * out of this contact. When a push frees the body, no push in the list is shorter (branch and bound).</p>
     */
    internal final class PushQueue
    {
        // The most pushes that are kept.
        private static const MOST:int = 256;

        // Before the first push.
        private static const AT_START:ShortestExit = new ShortestExit();

        /** The current push; one of length 0 at first. Read only. */
        public var current:ShortestExit = AT_START;

        /** Its length. A push in the list that was taken has the length Infinity. Read only. */
        public var length:Number = 0;

        // The pushes; by push, the contact that it was added for, whose depth is counted from the start; and the number of both. A push's planes are
        // indices of these contacts.
        private var _pushes:Vector.<ShortestExit> = new Vector.<ShortestExit>();
        private var _contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();
        private var _count:int = 0;

        // The new contact and those that decide about the current push.
        private var _halfSpaces:HalfSpaceSolver = new HalfSpaceSolver();

        /** Begins again, with a push of length 0. */
        public function begin():void
        {
            _count = 0;
            length = 0;
            current = AT_START;
        }

        /** Goes on to the shortest push that is left. Returns false if there is none. */
        public function next():Boolean
        {
            length = Infinity;
            for (var i:int = 0; i < _count; i++)
            {
                if (_pushes[i].length < length)
                {
                    current = _pushes[i];
                    length = current.length;
                }
            }
            if (length == Infinity)
            {
                return false;
            }
            current.length = Infinity;
            return true;
        }

        /**
         * Adds the push that also leads out of a contact, which was found after the current push.
         *
         * @param slack is added to the contact's depth; twice as much for each contact that decides about the current push
         */
        public function add(contact:ContactPoint, slack:Number):void
        {
            _halfSpaces.begin();
            for (var i:int = 0; i < current.planeCount; i++)
            {
                addHalfSpace(_contacts[current.planes[i]]);
                slack *= 2;
            }
            if (_count == _pushes.length)
            {
                _pushes.push(new ShortestExit());
                _contacts.push(new ContactPoint());
            }
            var found:ShortestExit = _pushes[_count];
            var added:ContactPoint = _contacts[_count];
            added.copyFrom(contact);
            added.depth = contact.depth + slack + contact.along(current.displacement);
            addHalfSpace(added);
            // if the new contact does not decide, the current push is out of it, and leads nowhere
            if (_count < MOST && _halfSpaces.solve(3, 0, found) && found.planes[0] == current.planeCount && isNew(found.displacement, slack))
            {
                // its planes are those of _halfSpaces: the contacts of the current push, and then the new one
                found.planes[0] = _count;
                found.planes[1] = current.planes[found.planes[1]];
                found.planes[2] = current.planes[found.planes[2]];
                _count++;
            }
        }

        private function addHalfSpace(contact:ContactPoint):void
        {
            _halfSpaces.add(contact.normalX, contact.normalY, contact.normalZ, contact.depth);
        }

        // Whether a displacement differs from all pushes, except the current one, by more than the slack.
        private function isNew(displacement:Vector3D, slack:Number):Boolean
        {
            for (var i:int = 0; i < _count; i++)
            {
                var other:Vector3D = _pushes[i].displacement;
                var off:Number = Math.abs(other.x - displacement.x) + Math.abs(other.y - displacement.y) + Math.abs(other.z - displacement.z);
                if (off <= slack && _pushes[i] !== current)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
