package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;
    import starlogo.search.pairs.GroundPairTests;

    /**
     * Finds a short way out of the ground. An agent in the ground may have many. Its contact may have a lower bound of their lengths
     * (DepthProof). If the first push is hardly longer, it is taken.
     *
     * <p>Otherwise each side of the ground that the deepest touched part is behind begins a push of its own
     * (<code>GroundPairTests.findExits()</code>). The shortest push that frees the agent is taken. Contacts may contradict each other, as opposite
     * walls do, and the ground ends at edges, where a push out of the whole plane is longer than needed. So a push that does not free the agent is
     * changed: it goes as far along the ground, and from there as high as the agent has to be lifted. The shortest of these ways is taken if no push
     * is shorter. One sweep down finds each lift, because all places above a free one are free.</p>
     *
     * <p>The way is about the shortest, not always the shortest: which sides begin pushes depends on the deepest part, and parts may be equally deep
     * up to rounding.</p>
     *
     * @private
     */
    public final class GroundExitSearch
    {
        // The most pushes that are tried. With 20, 18 % of the contacts of random agents in jagged ground are longer. With 250, 1 % are shorter.
        private static const MOST_PUSHES:int = 80;

        // No other way is tried if the least length of a way out is at least this fraction of the push. From 0.7 to 0.97 hardly a contact differs.
        private static const LEAST_SHARE_TAKEN:Number = 0.85;

        // The factor by which the search distance for other ways grows. With 1.5 a search takes a sixth longer. With 10, 3 % of the contacts are longer,
        // up to 1.3 times as long.
        private static const FARTHER:Number = 3;

        private var _tests:GroundPairTests;
        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;
        private var _pushOut:PushOut;

        // The contact of the two, the contacts with which other ways begin, and the displacement that is tried.
        private var _first:ContactPoint = new ContactPoint();
        private var _exits:Vector.<ContactPoint> = new Vector.<ContactPoint>();
        private var _tried:Displacement = new Displacement();

        // The shortest way out that ends with a lift; and for a lift, the sweep down.
        private var _lift:ContactPoint = new ContactPoint();
        private var _down:RelativeMotion = new RelativeMotion();

        /** @param tests the tests of a body and the ground */
        public function GroundExitSearch(tests:GroundPairTests)
        {
            _tests = tests;
            _pair = new DisplacedPair(tests);
            _directions = new DirectionSearch(_pair);
            _pushOut = new PushOut(_pair, _directions);
        }

        /**
         * Changes a contact's normal and depth so that they separate a body and the ground. See TreeExitSearch.find.
         *
         * @param motion the motion of the body, with the time at which they touch. It ends where the body is
         * @param out the contact of two parts that touch at that time
         */
        public function find(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _pair.begin(a, b, motion);
            if (!_pair.findGrazing(motion, out))
            {
                findExit(out);
            }
            _pair.finish(out);
        }

        // Finds a way out for a body that touches the ground. The push out of one contact after the other is taken if no way is clearly shorter.
        // Otherwise it looks farther and farther for other ways, and for ways that end with a lift. The first of these goes straight up, above all
        // ground around.
        private function findExit(out:ContactPoint):void
        {
            var first:ContactPoint = _first;
            first.copyFrom(out);
            out.depth = Infinity;
            var maxDistance:Number = Math.max(DirectionSearch.IMPROVED_DEPTH * _pair.extent, Math.min(first.depth, _pair.extent));
            if (_pushOut.find(first, Math.max(first.proof.provenDepth / LEAST_SHARE_TAKEN, PushOut.ROOM * _pair.extent), out))
            {
                return;
            }
            _pair.putBack();
            _tests.findLift(_pair.first, _pair.second, _lift);
            _lift.depth += _pair.tolerance;
            while (!findPushOrLift(maxDistance, out) && maxDistance / LEAST_SHARE_TAKEN <= _lift.depth)
            {
                maxDistance *= FARTHER;
            }
            if (_lift.depth < out.depth - _pair.tolerance)
            {
                _directions.findAlong(_lift, out);
            }
        }

        // Looks for the shortest push, also out of sides of the ground that are at most a distance away. Tries a lift after each other push. Takes
        // a push that frees the body if it is neither much longer than the distance nor longer than the shortest lift. Returns whether it has
        // taken one.
        private function findPushOrLift(maxDistance:Number, out:ContactPoint):Boolean
        {
            _pushOut.begin(_first);
            for (var tries:int = MOST_PUSHES; tries > 0; tries--)
            {
                addExits(maxDistance);
                tryLift();
                var result:int = _pushOut.tryNext(Math.min(maxDistance / LEAST_SHARE_TAKEN, _lift.depth), out);
                if (result == PushOut.TOO_LONG)
                {
                    tryLift();
                }
                if (result != PushOut.BLOCKED)
                {
                    return result == PushOut.FREE;
                }
            }
            return false;
        }

        private function addExits(maxDistance:Number):void
        {
            var count:int = _tests.findExits(_pair.first, _pair.second, _pushOut.contact, maxDistance, _exits);
            for (var i:int = 0; i < count; i++)
            {
                _pushOut.add(_exits[i]);
            }
        }

        // Finds how high the first body has to be lifted after it has gone along the ground as far as the push. Keeps this way out if it is the
        // shortest one so far. The lift is that of a place PushOut.ROOM farther, so that the body is free a little farther along the way too,
        // even between walls that are as far apart as it is wide. A push that is too long leads past an edge of the ground on the way: it goes
        // half as far as the shortest way.
        private function tryLift():void
        {
            var alongX:Number = _pushOut.push.x;
            var alongY:Number = _pushOut.push.y;
            var along:Number = Math.sqrt(alongX * alongX + alongY * alongY);
            var fartherFactor:Number = along > 0 ? 1 + PushOut.ROOM * _pair.extent / along : 1;
            if (along >= _lift.depth)
            {
                fartherFactor = 1;
                alongX *= _lift.depth / (2 * along);
                alongY *= _lift.depth / (2 * along);
            }
            var fartherX:Number = alongX * fartherFactor;
            var fartherY:Number = alongY * fartherFactor;
            var highSquared:Number = _lift.depth * _lift.depth - (fartherX * fartherX + fartherY * fartherY);
            if (!(highSquared > 0))
            {
                return;
            }
            var high:Number = Math.sqrt(highSquared);
            if (!sweepDown(fartherX, fartherY, high, _down))
            {
                // there is something higher
                return;
            }
            // halfway between the place of the push and the one farther
            var share:Number = (1 + fartherFactor) / (2 * fartherFactor);
            keepLift(fartherX * share, fartherY * share, high * (1 - Math.min(_down.time, 1)));
        }

        // Keeps a way out that ends with a lift, if the first body is free a little beyond its end.
        private function keepLift(x:Number, y:Number, z:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length == 0)
            {
                return;
            }
            _tried.setDirection(x / length, y / length, z / length);
            _tried.distance = length + _pair.tolerance;
            if (!_pair.testAt(_tried))
            {
                _lift.setNormal(_tried.x, _tried.y, _tried.z);
                _lift.depth = length;
            }
        }

        // Sweeps the first body down from a height, at a place moved by x and y from its own. Returns whether it is free at that height. If it is,
        // the last argument receives the time at which it meets the ground.
        private function sweepDown(x:Number, y:Number, high:Number, out:RelativeMotion):Boolean
        {
            _tried.setDirection(x, y, high);
            _tried.distance = 1;
            if (_pair.testAt(_tried))
            {
                return false;
            }
            _tried.z = 0;
            _pair.displace(_tried);
            out.endAfter(0, 0, -high);
            _pair.findImpact(out, null);
            return true;
        }
    }
}
