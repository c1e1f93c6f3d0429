package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.search.Body;
    import starlogo.search.pairs.GroundPairTests;

    /**
     * Finds a short way out of the ground. An agent in the ground may have many. Its contact may have a lower bound of their lengths. If a push out of
     * one contact after the other (PushOut) is hardly longer, it is taken.
     *
     * <p>Otherwise the shortest of many ways counts. All places above a free one are free. So if a way out is shorter than another one, the
     * body is also free somewhere on the upper half of the sphere around it whose radius is the longer way. The search tries places that are spread
     * over this half, and more of them around the end of the shortest way. From a free one, a sweep down finds how high the body has to be there, and
     * from there it slides back towards its own place. Then the radius is that of the shorter way. Pits that are hardly wider than the
     * body may have no such place, so places above pushes are tried too.</p>
     *
     * <p>The way is about the shortest, not always the shortest.</p>
     *
     * @private
     */
    public final class GroundExitSearch
    {
        // How many places around the body are tried, and how many around the end of the shortest way.
        private static const PLACES:int = 128;
        private static const PLACES_NEARBY:int = 24;

        // How far around the end of the shortest way, as a fraction of it: first farther, then nearer.
        private static const NEARBY:Number = 1 / 4;
        private static const NEARER:Number = 1 / 16;

        // The cosine and the sine of the golden angle, the angle between two places after each other.
        private static const TURN_X:Number = -0.7373688780783197;
        private static const TURN_Y:Number = 0.6754902942615238;

        // The most planes that the body slides along.
        private static const MOST_PLANES:int = 6;

        // No other way is tried if the least length of a way out is at least this fraction of the push. From 0.7 to 0.97 hardly a contact differs.
        private static const LEAST_SHARE_TAKEN:Number = 0.85;

        private var _tests:GroundPairTests;
        private var _pair:DisplacedPair;
        private var _directions:DirectionSearch;

        private var _pushOut:PushOut;

        // The planes that the body slides along, and the place where it slides to.
        private var _planes:HalfSpaceSolver = new HalfSpaceSolver();
        private var _target:ShortestExit = new ShortestExit();

        // The contact of the two, the shortest way out so far, and the displacement that is tried.
        private var _first:ContactPoint = new ContactPoint();
        private var _shortest:ContactPoint = new ContactPoint();
        private var _tried:Displacement = new Displacement();

        // A sweep, and the contact at its end.
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _met:ContactPoint = new ContactPoint();

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

        // Finds a way out for a body that touches the ground. The first one goes straight up, above all ground around.
        private function findExit(out:ContactPoint):void
        {
            _first.copyFrom(out);
            if (_pushOut.find(_first, Math.max(_first.provenDepth / LEAST_SHARE_TAKEN, PushOut.ROOM * _pair.extent), out))
            {
                return;
            }
            _pair.putBack();
            _tests.findLift(_pair.first, _pair.second, _shortest);
            _shortest.depth += _pair.tolerance;
            slideBack(0, 0, _shortest.depth);
            tryAbove(0, 0);
            followPushes();
            tryAround(0, 0, 1, PLACES);
            tryNearby(NEARBY);
            tryNearby(NEARER);
            _directions.findAlong(_shortest, out);
        }

        // Tries the places above pushes, and pushes out of one contact after the other.
        private function followPushes():void
        {
            _pushOut.begin(_first);
            do
            {
                tryAbove(_pushOut.push.x, _pushOut.push.y);
            }
            while (_pushOut.tryNext(_shortest.depth, _shortest) == PushOut.BLOCKED);
        }

        // Tries places around the end of the shortest way.
        private function tryNearby(share:Number):void
        {
            tryAround(_shortest.depth * _shortest.normalX, _shortest.depth * _shortest.normalY, share, PLACES_NEARBY);
        }

        // Tries places that are spread over a circle, from its middle to its border. Its radius is a share of the shortest way so far, which becomes shorter
        // meanwhile.
        private function tryAround(middleX:Number, middleY:Number, share:Number, count:int):void
        {
            var x:Number = 1;
            var y:Number = 0;
            for (var i:int = 0; i < count; i++)
            {
                var along:Number = share * _shortest.depth * Math.sqrt((i + 0.5) / count);
                tryAbove(middleX + along * x, middleY + along * y);
                var before:Number = x;
                x = TURN_X * x - TURN_Y * y;
                y = TURN_Y * before + TURN_X * y;
            }
        }

        // Tries a place that is so high above another one that it is as far as the shortest way. If the body is free there, finds a shorter way. The
        // place is PushOut.ROOM farther, and the way ends before it. So the body is free a little farther along the way too, even between walls that
        // are as far apart as it is wide.
        private function tryAbove(x:Number, y:Number):void
        {
            var along:Number = Math.sqrt(x * x + y * y);
            var fartherFactor:Number = along > 0 ? 1 + PushOut.ROOM * _pair.extent / along : 1;
            var fartherX:Number = x * fartherFactor;
            var fartherY:Number = y * fartherFactor;
            var highSquared:Number = _shortest.depth * _shortest.depth - (fartherX * fartherX + fartherY * fartherY);
            if (!(highSquared > 0))
            {
                return;
            }
            var high:Number = Math.sqrt(highSquared);
            if (sweepDown(fartherX, fartherY, high))
            {
                // halfway between the place and the one farther; and a little higher, because a way along the ground leads away from it slowly
                var share:Number = (1 + fartherFactor) / (2 * fartherFactor);
                var lowest:Number = high * (1 - Math.min(_sweep.time, 1)) + _pair.tolerance;
                if (takeIfFree(fartherX * share, fartherY * share, lowest, _pair.tolerance))
                {
                    slideBack(fartherX * share, fartherY * share, lowest);
                }
            }
        }

        // Takes the way to a place if it is shorter than the others and the first body is free a distance beyond it. Returns whether it is taken.
        private function takeIfFree(x:Number, y:Number, z:Number, beyond:Number):Boolean
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (!(length > 0 && length < _shortest.depth))
            {
                return false;
            }
            _tried.setDirection(x / length, y / length, z / length);
            _tried.distance = length + beyond;
            if (_pair.testAt(_tried))
            {
                return false;
            }
            _shortest.setNormal(_tried.x, _tried.y, _tried.z);
            _shortest.depth = length;
            return true;
        }

        // Slides the first body from a free place back towards its own. What it meets are planes that it slides along. Takes the way to where it ends, if
        // the body is free as far beyond as after a push, because it may have slid into a gap.
        private function slideBack(x:Number, y:Number, z:Number):void
        {
            _planes.begin();
            _planes.solve(1, 0, _target);
            for (var i:int = 0; i < MOST_PLANES && _target.length < _shortest.depth; i++)
            {
                _tried.setDirection(_target.displacement.x, _target.displacement.y, _target.displacement.z);
                _tried.distance = 1;
                _pair.displace(_tried);
                _sweep.endAfter(_target.displacement.x - x, _target.displacement.y - y, _target.displacement.z - z);
                _pair.findImpact(_sweep, _met);
                var time:Number = Math.min(_sweep.time, 1);
                x += time * _sweep.x;
                y += time * _sweep.y;
                z += time * _sweep.z;
                if (_sweep.time > 1)
                {
                    break;
                }
                // a little off the plane, so that the slide along it does not meet it
                x += 2 * _pair.tolerance * _met.normalX;
                y += 2 * _pair.tolerance * _met.normalY;
                z += 2 * _pair.tolerance * _met.normalZ;
                _planes.add(_met.normalX, _met.normalY, _met.normalZ, x * _met.normalX + y * _met.normalY + z * _met.normalZ - _pair.tolerance);
                _planes.solve(3, 0, _target);
            }
            takeIfFree(x, y, z, PushOut.ROOM * _pair.extent);
        }

        // Sweeps the first body down from a height, at a place moved by x and y from its own. Returns whether it is free at that height. If it is,
        // finds when it meets the ground.
        private function sweepDown(x:Number, y:Number, high:Number):Boolean
        {
            _tried.setDirection(x, y, high);
            _tried.distance = 1;
            if (_pair.testAt(_tried))
            {
                return false;
            }
            _tried.z = 0;
            _pair.displace(_tried);
            _sweep.endAfter(0, 0, -high);
            _pair.findImpact(_sweep, _met);
            return true;
        }
    }
}
