package starlogo.search.penetration
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.geometry.Tolerances;

    /**
     * Pushes the first of two bodies out of the second. It tries the shortest push out of all contacts so far (PushQueue). If the two still touch
     * after it, their contact there is added. So a box in a corner of floor and wall goes out of both at once.
     *
     * <p><code>find()</code> is a whole search. Another search takes its steps itself: <code>begin()</code>, and then in each round <code>add()</code>
     * for contacts of its own, and <code>tryNext()</code>.</p>
     */
    internal final class PushOut
    {
        /**
         * A push out of several contacts counts only if the body is free this much farther along it too, as a fraction of the larger extent.
         * Otherwise it ends in a gap between parts of the second body.
         */
        public static const ROOM:Number = 100 * Tolerances.SEPARATION;

        /** A result of <code>tryNext()</code>: the push frees the body. */
        public static const FREE:int = 0;

        /** A result of <code>tryNext()</code>: the push does not free the body. Pushes that also lead out of the contact there are added. */
        public static const BLOCKED:int = 1;

        /** A result of <code>tryNext()</code>: the push is too long, and was not tried. */
        public static const TOO_LONG:int = 2;

        /** A result of <code>tryNext()</code>: no push is left that can free the body. */
        public static const NONE_LEFT:int = 3;

        // The most contacts that a push of find() leads out of: the three sides of a corner, and one that was met before them. With one, an eighth of the
        // contacts of random trees are longer, up to 11 times as long. With six, 2 % are shorter.
        private static const MOST_CONTACTS:int = 4;

        // How much farther than its depth a push leads out of each contact, as a fraction of SEPARATION. This is more than the gap across which
        // surfaces touch.
        private static const SLACK:Number = 0.001;

        /** The contact that was found last: the first one, or the one after a push. Read only. */
        public var contact:ContactPoint = new ContactPoint();

        // The pushes. The current one is tried.
        private var _pushes:PushQueue = new PushQueue();

        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;

        // The displacement that is tried.
        private var _tried:Displacement = new Displacement();

        /**
         * @param pair has begun when a method is called
         * @param directions shortens pushes that are longer than needed
         */
        public function PushOut(pair:DisplacedPair, directions:DirectionSearch)
        {
            _pair = pair;
            _directions = directions;
        }

        /** Begins where the first body touches the second, with the push out of their contact there. */
        public function begin(first:ContactPoint):void
        {
            _pushes.begin();
            contact.copyFrom(first);
            _pair.putBack();
            add(contact);
        }

        /**
         * Looks for the shortest push that leads out of all contacts.
         *
         * @param first the contact of the two
         * @param most the length of the longest push that counts
         * @param out receives the normal and the depth if there is such a push
         * @return whether there is one
         */
        public function find(first:ContactPoint, most:Number, out:ContactPoint):Boolean
        {
            begin(first);
            for (var tries:int = MOST_CONTACTS; tries > 0; tries--)
            {
                var result:int = tryNext(most, out);
                if (result != BLOCKED)
                {
                    return result == FREE;
                }
            }
            return false;
        }

        /** Adds the push that also leads out of a contact, which was found after the current push. */
        public function add(found:ContactPoint):void
        {
            _pushes.add(found, SLACK * Tolerances.SEPARATION * _pair.extent + _pair.roundingGap);
        }

        /** The push that was tried last; 0 at the beginning. Do not change it. */
        public function get push():Vector3D
        {
            return _pushes.current.displacement;
        }

        /**
         * Goes on to the shortest push that is left, and tries it.
         *
         * @param most the length of the longest push that counts
         * @param out receives its normal and its depth if the first body is free after it
         * @return FREE, BLOCKED, TOO_LONG or NONE_LEFT
         */
        public function tryNext(most:Number, out:ContactPoint):int
        {
            if (!_pushes.next())
            {
                return NONE_LEFT;
            }
            if (_pushes.length > most)
            {
                return TOO_LONG;
            }
            if (!goToBlocked())
            {
                takePush(out);
                return FREE;
            }
            addBlock();
            return BLOCKED;
        }

        // Adds the contact of the first body, which is blocked on its way along the current push.
        private function addBlock():void
        {
            _pair.findContactOfParts(contact);
            // the body is a little farther than the push
            contact.depth += (_tried.distance - _pushes.length) * (contact.normalX * _tried.x + contact.normalY * _tried.y + contact.normalZ * _tried.z);
            add(contact);
        }

        // Tries the current push: at its end, and a little farther. If the two touch at one of these places, it leaves the body there, and _tried
        // has the distance. Returns whether they touch.
        private function goToBlocked():Boolean
        {
            // beyond its end, a push out of several contacts may lead into one of them again
            var isOfSeveral:Boolean = _pushes.current.planeCount > 1;
            _tried.setDirection(push.x / _pushes.length, push.y / _pushes.length, push.z / _pushes.length);
            _tried.distance = _pushes.length;
            if (isOfSeveral && _pair.testAt(_tried))
            {
                return true;
            }
            _tried.distance = _pushes.length + _pair.probeDistance;
            if (_pair.testAt(_tried))
            {
                return true;
            }
            _tried.distance = _pushes.length + ROOM * _pair.extent;
            return isOfSeveral && _pair.testAt(_tried);
        }

        // Takes the push. If the two are free before its end, the depth is refined.
        private function takePush(out:ContactPoint):void
        {
            out.setNormal(_tried.x, _tried.y, _tried.z);
            out.depth = _pushes.length;
            _tried.distance = _pushes.length - _pair.probeDistance;
            if (_tried.distance > 0 && !_pair.testAt(_tried))
            {
                _directions.shorten(_tried, out);
            }
        }
    }
}
