package starlogo.search.penetration
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;

    /**
     * Finds the distance at which two touching bodies are free of each other if the first one moves along a direction. It tries places farther and
     * farther away until the two do not touch. Then it sweeps back to the place where they part. The surfaces have a normal at that place.
     * Along this normal the push is usually shorter. For convex bodies it always is, because it is at most the depth times the cosine of
     * the angle between the two directions. So it tries that normal next, as Je, Tang, Lee, Lee and Kim do ("PolyDepth: Real-time penetration depth
     * computation using iterative contact-space projection", 2012). It improves a direction twice at most.
     */
    internal final class DirectionSearch
    {
        /**
         * The search improves the direction of a contact whose depth is more than this fraction of the largest extent. The search for a push
         * also begins with steps of this length. After a longer push of PushOut, PenetrationSearch tries one against the motion too.
         */
        internal static const MIN_DEPTH_TO_IMPROVE:Number = 1 / 256;

        /** Another direction counts as better if its depth is less than this times the old depth. */
        internal static const MAX_BETTER_RATIO:Number = 0.95;

        // How often a normal is improved at most. Without improvements 7 % of the contacts of random trees are longer, up to 11 times as long. With more
        // than two none is shorter.
        private static const MAX_IMPROVEMENTS:int = 2;

        // The interval is halved until it is shorter than this fraction of the largest extent. The rest is swept.
        private static const SWEPT_WIDTH:Number = 1 / 16;

        // The most halvings. After 53 a Number has no more bits to halve.
        private static const MAX_HALVINGS:int = 60;

        // No displacement is longer, in patches. Bodies in the world are free long before it.
        private static const MAX_DISTANCE:Number = 1e300;

        private var _pair:DisplacedPair;

        // The push that is tested: its direction and length; and the lengths between which the two part. They touch at the inner one, unless it
        // is 0. They are free at the outer one, once they have been tested there.
        private var _tried:ContactPoint = new ContactPoint();
        private var _inner:Number = 0;
        private var _outer:Number = 0;

        // The sweep back, and the contact at its end.
        private var _back:RelativeMotion = new RelativeMotion();
        private var _parting:ContactPoint = new ContactPoint();

        /** @param pair has the two bodies. Call its <code>setTo()</code> before any method here */
        public function DirectionSearch(pair:DisplacedPair)
        {
            _pair = pair;
        }

        /**
         * Finds a push along a direction, or a shorter one along normals that it meets.
         *
         * @param guess a contact with the direction; its depth is the first guess of the distance
         * @param out receives the normal, the depth and the point
         */
        public function findAlong(guess:ContactPoint, out:ContactPoint):void
        {
            begin(guess, guess.depth + _pair.tolerance);
            growOuter(MIN_DEPTH_TO_IMPROVE * _pair.largestExtent);
            refine(out);
        }

        /**
         * Shortens a push.
         *
         * @param free a push after which the two do not touch
         * @param out receives the normal, the depth and the point
         */
        public function shorten(free:ContactPoint, out:ContactPoint):void
        {
            begin(free, free.depth);
            refine(out);
        }

        // Begins with the normal of a contact, and the whole way up to an outer distance along it.
        private function begin(contact:ContactPoint, outer:Number):void
        {
            _tried.setNormal(contact.normalX, contact.normalY, contact.normalZ);
            _inner = 0;
            _outer = outer;
        }

        // Sweeps back from the outer distance. If the depth is more than MIN_DEPTH_TO_IMPROVE, improves the direction. Then the point becomes the
        // middle between the place where the two part and the matching place on the first body.
        private function refine(out:ContactPoint):void
        {
            sweepBack(out);
            if (out.depth > MIN_DEPTH_TO_IMPROVE * _pair.largestExtent)
            {
                for (var left:int = MAX_IMPROVEMENTS; left > 0 && startAlongNormal(out); left--)
                {
                    sweepBack(out);
                }
            }
            out.x = _parting.x - out.depth / 2 * out.normalX;
            out.y = _parting.y - out.depth / 2 * out.normalY;
            out.z = _parting.z - out.depth / 2 * out.normalZ;
            correctDepth(out);
        }

        // Starts along the normal of the surfaces where the two parted. Returns whether the push along it is shorter than a contact's depth.
        private function startAlongNormal(contact:ContactPoint):Boolean
        {
            var cosine:Number = _parting.normalX * contact.normalX + _parting.normalY * contact.normalY + _parting.normalZ * contact.normalZ;
            if (!(cosine > 0 && cosine < MAX_BETTER_RATIO))
            {
                return false;
            }
            begin(_parting, cosine * contact.depth + _pair.tolerance);
            return tryDepth(_outer);
        }

        // Increases the outer distance by a step until the two do not touch there. Each step is twice as long as the one before. Returns whether they were
        // free at the first outer distance.
        private function growOuter(step:Number):Boolean
        {
            while (!tryDepth(_outer) && _outer < MAX_DISTANCE)
            {
                _inner = _outer;
                _outer += step;
                step *= 2;
            }
            return _inner == 0;
        }

        // Finds the contact at the place where the two part (_parting). The distance of this place becomes the depth, the length of the push.
        private function sweepBack(out:ContactPoint):void
        {
            bisect(SWEPT_WIDTH * _pair.largestExtent);
            _tried.depth = _inner;
            _pair.displace(_tried);
            // the first body is at the inner distance, so its motion from the outer one is against the direction
            var back:Number = _inner - _outer;
            _back.endAfter(back * _tried.normalX, back * _tried.normalY, back * _tried.normalZ);
            _pair.findImpactOfSurfaces(_back, _parting);
            if (_back.time == RelativeMotion.NEVER)
            {
                // rounding hides the touch at the end
                _pair.findContactOfParts(_parting);
            }
            var time:Number = Math.min(_back.time, 1);
            out.setNormal(_tried.normalX, _tried.normalY, _tried.normalZ);
            out.depth = _outer + time * back;
        }

        // Halves the interval until it is no longer than a width. The width may be less than the distance between two Numbers as large as the ends.
        private function bisect(width:Number):void
        {
            for (var i:int = 0; i < MAX_HALVINGS && _outer - _inner > width; i++)
            {
                var middle:Number = (_inner + _outer) / 2;
                if (tryDepth(middle))
                {
                    _outer = middle;
                }
                else
                {
                    _inner = middle;
                }
            }
        }

        // Corrects what rounding has made of a contact's depth: the two do not touch a little beyond it, and touch a little before it.
        private function correctDepth(out:ContactPoint):void
        {
            var probe:Number = _pair.probeDistance;
            begin(out, out.depth + probe);
            if (growOuter(probe))
            {
                var shorter:Number = out.depth - probe;
                if (shorter <= 0 || !tryDepth(shorter))
                {
                    return;
                }
                _outer = shorter;
            }
            bisect(probe);
            out.depth = (_outer + _inner) / 2;
        }

        // Displaces the first body along the direction. Returns whether it is free there.
        private function tryDepth(depth:Number):Boolean
        {
            _tried.depth = depth;
            return _pair.tryPush(_tried);
        }
    }
}
