package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.geometry.HalfSpaceSolver;
    import starlogo.geometry.Tolerances;

    /**
     * Pushes the first of two bodies out of the second. It tries the shortest push out of a contact. A contact requires a push of at least its
     * depth along its normal. If the two still touch after the push, their contact there is added to those that decide about the push. So a
     * box in a corner of floor and wall goes out of both at once.
     */
    internal final class PushOut
    {
        // The most contacts that a push leads out of. Three are the sides of a corner; others were met before them.
        private static const MAX_CONTACTS:int = 6;

        // How much farther than its depth a push leads out of each contact, as a fraction of SEPARATION. This is more than the gap across which
        // surfaces touch.
        private static const OVERSHOOT:Number = 0.001;

        // The most searches between two calls of begin().
        private static const MAX_SEARCHES:int = 2;

        /** Where the pushes end that do not free the body, in all searches since <code>begin()</code>: x and y of each. Read only. */
        public var blockedPlaces:Vector.<Number> = new Vector.<Number>(2 * MAX_CONTACTS * MAX_SEARCHES, true);

        /** How many numbers of <code>blockedPlaces</code> are set. Read only. */
        public var blockedEnd:int = 0;

        /**
         * The contact at which the last of these pushes ended whose deepest point is known to be of the body, but with its place where the body was at
         * the beginning. If there is none, no deepest point is known. Read only.
         */
        public var lastBlocked:ContactPoint = new ContactPoint();

        // The push: the shortest out of the contacts that decide about it, whose depths are from where the body was at the beginning.
        private var _push:HalfSpaceSolver = new HalfSpaceSolver();

        // The contact after a push.
        private var _next:ContactPoint = new ContactPoint();

        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;

        // The push that is tried: about as long as the shortest one.
        private var _tried:ContactPoint = new ContactPoint();

        /**
         * @param pair has the two bodies. Call its <code>setTo()</code> before any method here
         * @param directions shortens pushes that are longer than needed
         */
        public function PushOut(pair:DisplacedPair, directions:DirectionSearch)
        {
            _pair = pair;
            _directions = directions;
        }

        /** Begins with two bodies: forgets the pushes of those before. */
        public function begin():void
        {
            blockedEnd = 0;
            lastBlocked.forgetDeepest();
        }

        /**
         * Looks for the shortest push that leads out of all contacts.
         *
         * @param contact the contact of the two at the touch
         * @param maxLength the length of the longest push that counts
         * @param out receives the normal and the depth if there is such a push
         * @return whether there is one
         */
        public function findPush(contact:ContactPoint, maxLength:Number, out:ContactPoint):Boolean
        {
            var count:int = 1;
            _push.clear();
            _pair.putBack();
            addContact(contact);
            while (_push.distance <= maxLength && _push.distance < Infinity && count <= MAX_CONTACTS)
            {
                if (tryPushAndBeyond())
                {
                    writePush(out);
                    return true;
                }
                addBlockedPush();
                count++;
            }
            return false;
        }

        // Adds a contact: the next push leads out of it too. The more planes the last push ended on, the farther the next one leads out of the new contact.
        private function addContact(contact:ContactPoint):void
        {
            var overshoot:Number = (OVERSHOOT * Tolerances.SEPARATION * _pair.largestExtent + _pair.margin) * (1 << _push.planeCount);
            _push.keepDeciding();
            _push.add(contact.normalX, contact.normalY, contact.normalZ, contact.depth + overshoot + contact.along(_push.displacement));
            _push.solve();
        }

        // Adds the contact where a push is blocked: tryPushAndBeyond() has left the first body there.
        private function addBlockedPush():void
        {
            blockedPlaces[blockedEnd++] = _push.displacement.x;
            blockedPlaces[blockedEnd++] = _push.displacement.y;
            _pair.findContactOfParts(_next);
            if (_next.isDeepestOfA)
            {
                lastBlocked.copyFrom(_next);
                // its exits are known where the push ended, not where the body was
                lastBlocked.exitBound = 0;
                lastBlocked.x -= _tried.depth * _tried.normalX;
                lastBlocked.y -= _tried.depth * _tried.normalY;
                lastBlocked.z -= _tried.depth * _tried.normalZ;
            }
            // the body is a little farther than the push
            _next.depth += (_tried.depth - _push.distance)
                * (_next.normalX * _tried.normalX + _next.normalY * _tried.normalY + _next.normalZ * _tried.normalZ);
            addContact(_next);
        }

        // Tries the push at its end and a little farther, until the two touch. Leaves the body where it was tried last. Returns whether it is free.
        private function tryPushAndBeyond():Boolean
        {
            // beyond its end, a push out of several contacts may lead into one of them again
            var isOfSeveral:Boolean = _push.planeCount > 1;
            _tried.setNormal(_push.displacement.x / _push.distance, _push.displacement.y / _push.distance, _push.displacement.z / _push.distance);
            _tried.depth = _push.distance;
            if (isOfSeveral && !_pair.tryPush(_tried))
            {
                return false;
            }
            _tried.depth = _push.distance + _pair.probeDistance;
            if (!_pair.tryPush(_tried))
            {
                return false;
            }
            _tried.depth = _push.distance + _pair.minOpening;
            return !isOfSeveral || _pair.tryPush(_tried);
        }

        // Takes the push, whose direction is free. If the two are free before its end, the depth is refined.
        private function writePush(out:ContactPoint):void
        {
            out.setNormal(_tried.normalX, _tried.normalY, _tried.normalZ);
            out.depth = _push.distance;
            _tried.depth = _push.distance - _pair.probeDistance;
            if (_tried.depth > 0 && _pair.tryPush(_tried))
            {
                _directions.shorten(_tried, out);
            }
        }
    }
}
