package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.ground.GroundExits;
    import starlogo.search.Body;

    use namespace engine;

    /**
     * Finds a short push out of an overlap: nearly the minimum translation that separates two bodies. It pushes the first body out along the normals
     * that it meets (PushOut). If an exit may be much shorter than this push, it also tries the direction that leads out of convex covers of the two
     * (DirectionSearch). If the second body is the ground, it tries many places above the ground after that (PlacesAbove).
     *
     * @private
     */
    public final class PenetrationSearch
    {
        // No other push is tried if each exit is at least this fraction of the push. Smaller: contacts are longer. Larger: most searches in smooth
        // ground try all places.
        private static const MIN_EXIT_RATIO:Number = 0.68;

        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;
        private var _pushOut:PushOut;

        // What is known about the exits from the ground, and places above it. Null if the second body is not the ground.
        private var _groundExits:GroundExits;
        private var _placesAbove:PlacesAbove;

        // The contact of the two at the touch, and another push to try.
        private var _contact:ContactPoint = new ContactPoint();
        private var _guess:ContactPoint = new ContactPoint();

        /**
         * @param pair takes the two bodies of each search
         * @param groundExits what is known about the exits from the ground; null if the second body is not the ground. Then the deepest point of no
         *     contact is known
         * @param placesAbove of the pair; null if the second body is not the ground
         */
        public function PenetrationSearch(pair:DisplacedPair, groundExits:GroundExits = null, placesAbove:PlacesAbove = null)
        {
            _pair = pair;
            _groundExits = groundExits;
            _directions = new DirectionSearch(pair);
            _pushOut = new PushOut(pair, _directions);
            _placesAbove = placesAbove;
        }

        /**
         * Changes a contact's normal and depth so that they separate two bodies: if the first one moves along the normal by the depth, the two just
         * touch, and a little farther they do not.
         *
         * @param motion the motion of the first body relative to the second, with the time at which they touch. It ends where the first body is
         * @param out the contact of two parts that touch at that time
         */
        public function separate(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.setTo(a, b, motion);
            if (!_pair.findGrazing(motion, out))
            {
                findPush(motion, out);
            }
            _pair.finish(out);
        }

        // Finds a push for two bodies that touch.
        private function findPush(motion:RelativeMotion, out:ContactPoint):void
        {
            _contact.copyFrom(out);
            out.depth = Infinity;
            _pushOut.begin();
            var isPushed:Boolean = _pushOut.findPush(_contact, Infinity, out);
            if (DisplacedPair.touchesOnTheWay(motion) && out.depth > DirectionSearch.MIN_DEPTH_TO_IMPROVE * _pair.largestExtent)
            {
                _guess.copyFrom(_contact);
                _guess.setNormalAgainst(motion);
                _guess.depth = 0;
                // its point need not be the deepest
                _guess.forgetDeepest();
                isPushed = _pushOut.findPush(_guess, DirectionSearch.MAX_BETTER_RATIO * out.depth, out) || isPushed;
            }
            if (!isShortEnough(out.depth))
            {
                tryOutOfCovers(isPushed, out);
                if (_placesAbove != null)
                {
                    _placesAbove.shorten(_pushOut, _directions, out);
                }
            }
        }

        // Whether no other push is tried, because a depth is short, or because no exit is much shorter.
        private function isShortEnough(depth:Number):Boolean
        {
            // a point of the body that is deep where a push ended also has to get out from where the push began
            return depth <= _pair.minOpening || areExitsLong(_contact, depth) || areExitsLong(_pushOut.lastBlocked, depth);
        }

        // Whether a contact whose deepest point is of the first body shows that each exit is at least a share of a depth.
        private function areExitsLong(contact:ContactPoint, depth:Number):Boolean
        {
            var least:Number = MIN_EXIT_RATIO * depth;
            return contact.exitBound >= least || contact.isDeepestOfA && _groundExits.boundOf(_pair.second.shape.grid, contact, depth) >= least;
        }

        // Tries the shortest push out of covers of the two. If PushOut has found none, it is taken, however long it is.
        private function tryOutOfCovers(isPushed:Boolean, out:ContactPoint):void
        {
            _pair.putBack();
            _pair.findContactOfCovers(_guess);
            if (!isPushed)
            {
                _directions.findAlong(_guess, out);
                return;
            }
            _guess.depth = out.depth - _pair.tolerance;
            if (_guess.depth > 0 && _pair.tryPush(_guess))
            {
                _directions.shorten(_guess, out);
            }
        }
    }
}
