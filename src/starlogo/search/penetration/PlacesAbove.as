package starlogo.search.penetration
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.HalfSpaceSolver;

    /**
     * Shortens a push out of the ground. All places above a free one are free. So if a push is shorter than another one, the body is also free
     * somewhere on the upper half of the sphere around it whose radius is the longer push. The search tries places that are spread over this half. From a
     * free one, a sweep down finds how high the body has to be there, and from there it slides back towards its own place, as long as this shortens the
     * push, which becomes the radius. Pits hardly wider than the body may have no such place, so places above blocked pushes are tried too.
     *
     * @private
     */
    public final class PlacesAbove
    {
        // How many places are tried.
        private static const PLACE_COUNT:int = 120;

        // The cosine and the sine of the golden angle, the angle between two places after each other.
        private static const TURN_X:Number = -0.7373688780783197;
        private static const TURN_Y:Number = 0.6754902942615238;

        // The most planes that the body slides along before it forgets them. Three meet in one place.
        private static const MAX_PLANES:int = 3;

        private var _pair:DisplacedPair;

        // The planes that the body slides along. The displacement out of them is the place where it slides to.
        private var _planes:HalfSpaceSolver = new HalfSpaceSolver();

        // The length of the shortest push so far; a place beside the body's own; a place above that one; and a push that is tried.
        private var _shortest:Number = 0;
        private var _place:Vector3D = new Vector3D();
        private var _above:Vector3D = new Vector3D();
        private var _tried:ContactPoint = new ContactPoint();

        // The shortest push, a little longer: the body was found free there.
        private var _free:ContactPoint = new ContactPoint();

        // A sweep, and the contact at its end.
        private var _sweep:RelativeMotion = new RelativeMotion();
        private var _met:ContactPoint = new ContactPoint();

        /** @param pair has a body and the ground. Call its <code>setTo()</code> before any method here */
        public function PlacesAbove(pair:DisplacedPair)
        {
            _pair = pair;
        }

        /**
         * Shortens a push.
         *
         * @param pushOut has tried pushes of the two
         * @param directions finds the end of the shortest push
         * @param out the normal and the depth lead the first body out; receives those of a shorter push if one is found
         */
        internal function shorten(pushOut:PushOut, directions:DirectionSearch, out:ContactPoint):void
        {
            var x:Number = 1;
            var y:Number = 0;
            _shortest = out.depth;
            for (var push:int = 0; push < pushOut.blockedEnd; push += 2)
            {
                _place.setTo(pushOut.blockedPlaces[push], pushOut.blockedPlaces[int(push + 1)], 0);
                tryAbove(_place);
            }
            for (var i:int = 0; i < PLACE_COUNT; i++)
            {
                var along:Number = _shortest * Math.sqrt((i + 0.5) / PLACE_COUNT);
                _place.setTo(along * x, along * y, 0);
                tryAbove(_place);
                var before:Number = x;
                x = TURN_X * x - TURN_Y * y;
                y = TURN_Y * before + TURN_X * y;
            }
            if (_shortest < out.depth)
            {
                // the body may touch between the push's end and the place where it is free
                directions.shorten(_free, out);
            }
        }

        // Tries to put the body above a place beside its own, as far from its own as the shortest push is long. If it is free there, finds a shorter
        // push. It is tried minOpening farther to the side, and the push ends before that. So the body is free a little farther along the push too,
        // even between walls that are as far apart as it is wide.
        private function tryAbove(place:Vector3D):void
        {
            var along:Number = Math.sqrt(place.x * place.x + place.y * place.y);
            var fartherFactor:Number = along > 0 ? 1 + _pair.minOpening / along : 1;
            var fartherX:Number = place.x * fartherFactor;
            var fartherY:Number = place.y * fartherFactor;
            var heightSquared:Number = _shortest * _shortest - (fartherX * fartherX + fartherY * fartherY);
            if (!(heightSquared > 0))
            {
                return;
            }
            var height:Number = Math.sqrt(heightSquared);
            _above.setTo(fartherX, fartherY, height);
            _pair.displaceBy(_above);
            if (!_pair.areTouching())
            {
                var freePart:Number = sweepDown(_above);
                // halfway between the place and the one farther; and a little higher, because the ground may rise on the way back to there
                var fraction:Number = (1 + fartherFactor) / (2 * fartherFactor);
                var lowest:Number = height * (1 - freePart) + _pair.minOpening;
                if (takeIfFree(fartherX * fraction, fartherY * fraction, lowest, _pair.tolerance))
                {
                    slideBackRepeatedly();
                }
            }
        }

        // Takes the push to a place if it is shorter than the others and the first body is free a distance beyond it. Returns whether it is taken.
        private function takeIfFree(x:Number, y:Number, z:Number, beyond:Number):Boolean
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (!(length > 0 && length < _shortest))
            {
                return false;
            }
            _tried.setNormal(x / length, y / length, z / length);
            _tried.depth = length + beyond;
            if (!_pair.tryPush(_tried))
            {
                return false;
            }
            _shortest = length;
            _free.copyFrom(_tried);
            return true;
        }

        // Slides the first body back from the end of the shortest push, until a slide hardly shortens the push. What a body slides along may be round,
        // so at the end of a slide it may have left the planes that it met first, and is free to go on.
        private function slideBackRepeatedly():void
        {
            var before:Number;
            do
            {
                before = _shortest;
                slideBack();
            }
            while (_shortest < DirectionSearch.MAX_BETTER_RATIO * before);
        }

        // Slides the first body back towards its own place, from the end of the shortest push. What it meets are planes that it slides along. Takes the
        // push to where the slide ends, if the body is free minOpening beyond, because it may have slid into a gap.
        private function slideBack():void
        {
            var x:Number = _shortest * _free.normalX;
            var y:Number = _shortest * _free.normalY;
            var z:Number = _shortest * _free.normalZ;
            _planes.clear();
            for (var i:int = 0; i < MAX_PLANES && _planes.distance < _shortest; i++)
            {
                var target:Vector3D = _planes.displacement;
                _pair.displaceBy(target);
                _sweep.endAfter(target.x - x, target.y - y, target.z - z);
                _pair.findImpactOfSurfaces(_sweep, _met);
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
                _planes.solve();
            }
            takeIfFree(x, y, z, _pair.minOpening);
        }

        // Sweeps the first body down from a place to the height of its own place. The place goes down too. Returns which part of this way is free.
        private function sweepDown(place:Vector3D):Number
        {
            _sweep.endAfter(0, 0, -place.z);
            place.z = 0;
            _pair.displaceBy(place);
            _pair.findImpactOfSurfaces(_sweep, _met);
            return Math.min(_sweep.time, 1);
        }
    }
}
