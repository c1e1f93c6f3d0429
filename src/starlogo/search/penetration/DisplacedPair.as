// This folder finds short pushes out of overlaps, for contacts that separate two bodies. A push is the normal and the depth of a ContactPoint: it moves
// the first body along the normal by the depth. A DisplacedPair puts that body to places that are tried.
// A PenetrationSearch tries pushes out of all contacts so far (PushOut, with HalfSpaceSolver), looks for the end of a push along one direction
// (DirectionSearch), and tries places above the ground (PlacesAbove). An exit leads one point out, a push the whole body.
// Read this file first, then PenetrationSearch, then PushOut.
package starlogo.search.penetration
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.pairs.OverlapMiddle;
    import starlogo.search.pairs.PairTests;

    use namespace engine;

    /**
     * Two bodies that touch, the first one at places that are tried, and the tests that say whether, when and how they touch there. Other classes
     * only read the fields.
     *
     * <p>It has five lengths. Rounding makes <code>margin</code>. The bodies make <code>largestExtent</code>, and <code>minOpening</code> is a fraction of it.
     * Both together make <code>tolerance</code>, and <code>probeDistance</code> is a fraction of that.</p>
     *
     * @private
     */
    public final class DisplacedPair
    {
        /** How far before and behind a depth the first body is tried, as a share of the tolerance. The rest of the tolerance is for rounding. */
        public static const PROBE_SHARE:Number = 1 / 4;

        // The least opening, as a fraction of the largest extent.
        private static const MIN_OPENING:Number = 100 * Tolerances.SEPARATION;

        // The extent of two points at the origin. It is not 0, so all steps are longer than 0.
        private static const MIN_EXTENT:Number = 1e-100;

        /** The first body, at the place that is tried. */
        public var first:Body = new Body();

        /** The second body. */
        public var second:Body = null;

        /**
         * The largest extent of the two, which tolerances are fractions of. If both are points, it is the gap across which they still touch.
         */
        public var largestExtent:Number = 0;

        /**
         * How far a depth may be off, in patches: see PairTests.depthToleranceOf. It is more than the gap of rounding, because two bodies touch across
         * that gap: no push would ever seem free to a search that goes less far.
         */
        public var tolerance:Number = 0;

        /** The gap across which the two touch because places are rounded. */
        public var margin:Number = 0;

        private var _tests:PairTests;

        // The first body's place at the touch, and the place that is tried.
        private var _from:Vector3D = new Vector3D();
        private var _place:Vector3D = new Vector3D();

        /** @param tests of such pairs */
        public function DisplacedPair(tests:PairTests)
        {
            _tests = tests;
        }

        /** Begins where the motion of the first body relative to the second is at its time. The motion ends where the first body is. */
        public function setTo(a:Body, b:Body, motion:RelativeMotion):void
        {
            var time:Number = motion.time;
            second = b;
            _from.x = a.placement.x + (motion.startX + time * motion.x);
            _from.y = a.placement.y + (motion.startY + time * motion.y);
            _from.z = a.placement.z + (motion.startZ + time * motion.z);
            first.copyFrom(a);
            first.moveTo(_from);
            margin = _tests.marginOf(a, b);
            largestExtent = Math.max(_tests.largestExtentOf(a, b), Math.max(margin, MIN_EXTENT));
            tolerance = Math.max(_tests.depthToleranceOf(a, b), Tolerances.SEPARATION * MIN_EXTENT);
        }

        /**
         * How far before and behind a depth the first body is tried: a share of the tolerance, and at least the gap of rounding.
         */
        public function get probeDistance():Number
        {
            return PROBE_SHARE * tolerance;
        }

        /**
         * A push past several sides counts only if the first body is free this much farther along it too. Otherwise it ends in a gap between parts
         * of the second body. A push that is not longer is short enough.
         */
        public function get minOpening():Number
        {
            return MIN_OPENING * largestExtent;
        }

        /**
         * Finds the contact of two bodies that do not touch at the time of the motion in <code>setTo()</code>. Because of rounding, a first body that moves
         * may have been stopped just before the touch.
         *
         * @param motion as in setTo
         * @param out a contact near here; receives the depth 0 if they do not touch. Then its normal points against the motion, unless the two touch
         *     if the first one moves a little against the given normal
         * @return whether there is such a contact: they do not touch
         */
        public function findGrazing(motion:RelativeMotion, out:ContactPoint):Boolean
        {
            if (!touchesOnTheWay(motion) || areTouching())
            {
                return false;
            }
            out.depth = 0;
            _place.setTo(_from.x - probeDistance * out.normalX, _from.y - probeDistance * out.normalY, _from.z - probeDistance * out.normalZ);
            first.moveTo(_place);
            if (!areTouching())
            {
                out.setNormalAgainst(motion);
            }
            return true;
        }

        /** Whether the first body moves, and touches the second only after the motion's beginning. */
        internal static function touchesOnTheWay(motion:RelativeMotion):Boolean
        {
            return motion.time > 0 && !motion.isStill;
        }

        /** Ends at the touch. The point of the contact that was found goes to the middle of the overlap, in both bodies. */
        public function finish(out:ContactPoint):void
        {
            putBack();
            OverlapMiddle.moveToMiddle(first, second, out);
            OverlapMiddle.keepWithin(first, out);
            OverlapMiddle.keepWithin(second, out);
        }

        /** Puts the first body where it was at the touch. */
        public function putBack():void
        {
            first.moveTo(_from);
        }

        /** Displaces the first body, from where it was at the touch, by a vector. */
        public function displaceBy(by:Vector3D):void
        {
            _place.setTo(_from.x + by.x, _from.y + by.y, _from.z + by.z);
            first.moveTo(_place);
        }

        /** Displaces the first body by a push. */
        public function displace(push:ContactPoint):void
        {
            _place.setTo(_from.x + push.depth * push.normalX, _from.y + push.depth * push.normalY, _from.z + push.depth * push.normalZ);
            first.moveTo(_place);
        }

        /** Displaces the first body by a push. Returns whether it is free of the second one there. */
        public function tryPush(push:ContactPoint):Boolean
        {
            displace(push);
            return !areTouching();
        }

        /** Whether the two touch where the first one is. */
        public function areTouching():Boolean
        {
            return _tests.areTouching(first, second);
        }

        /** Finds the first touch on a motion that ends where the first body is. See PairTests.findImpactOfSurfaces. */
        public function findImpactOfSurfaces(motion:RelativeMotion, out:ContactPoint):void
        {
            _tests.findImpactOfSurfaces(first, second, motion, out);
        }

        /** Finds the contact of convex covers of the two where the first body is. See PairTests.findContactOfCovers. */
        public function findContactOfCovers(out:ContactPoint):void
        {
            _tests.findContactOfCovers(first, second, out);
        }

        /** Finds the contact of two parts where the first body is. See PairTests.findContactOfParts. */
        public function findContactOfParts(out:ContactPoint):void
        {
            _tests.findContactOfParts(first, second, RelativeMotion.NONE, out);
        }
    }
}
