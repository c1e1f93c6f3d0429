// This folder tests two bodies, by a class for each kind of pairs, all with the same methods: SpherePairTests, StructurePairTests and TreePairTests
// for agents, GroundPairTests and EdgePairTests for an agent and the ground or the edges of the world.
// Read this file first, then StructurePairTests, the shortest one. Three of the methods are sweeps: they find the first touch on a motion. They differ
// if the two touch where the motion begins. Only findFirstTouch finds a touch that rounding hides at the end of a motion far shorter than the two are.
// The methods, in the order of this file:
// - areTouching: the verdict.
// - findFirstTouch: a sweep. If the two touch where the motion begins, it finds the time 0, and the contact there.
// - findImpactOfSurfaces: a sweep. In that case it finds the time 0, or when their surfaces first touch, also if one is inside of the other.
// - findImpactOfSolids: a sweep. It finds the same, but the time 0 if one is inside of the other.
// - findContact: the contact of the two where they are. It begins with findContactOfParts, and ends with separate if they touch.
// - findContactOfParts: the contact of two parts of theirs, which need not separate the two.
// - findContactOfCovers: the contact of larger shapes, with which the search for a push begins.
// - separate: makes the contact of parts one that separates the two.
// - findClosest: the distance of the two, and their closest points.
// - marginOf and all after it: the tolerances.
package starlogo.search.pairs
{
    import flash.errors.IllegalOperationError;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Tests two bodies: whether they touch, when they touch, and how. NarrowPhase has an object of a subclass for each kind of pairs.
     *
     * <p>The order of a pair: the ground or the edges of the world are the second body in all these methods except <code>findClosest()</code>. Other
     * bodies may come in either order. Where rounding could depend on it, the two are put into the order of <code>Body.comesAfter()</code>.</p>
     *
     * @private
     */
    public class PairTests
    {
        // A tolerance in patches is at least this many times the gap across which two touch because places are rounded.
        private static const MIN_MARGINS:Number = 4;

        // Rounding hides the direction between two points that are nearer than this fraction of the extent. Smaller than 1e-14: normals are rounding
        // errors. Larger: a small body beside the edge of a large one gets the normal of a side of the large one.
        private static const HIDDEN_DIRECTION:Number = 10 * Tolerances.ROUNDING;

        // The closest points of two bodies whose contact is asked for although they do not touch.
        private var _closest:ClosestPoints = new ClosestPoints();

        /** Whether two bodies touch. The answer must be the same in either order, to the last bit. */
        public function areTouching(a:Body, b:Body):Boolean
        {
            throw new IllegalOperationError(this + " does not implement areTouching");
        }

        /**
         * Finds the time at which two bodies first touch, while the first one moves, and their contact then. It is the first moment at which
         * <code>areTouching()</code> would be true.
         *
         * @param motion the motion of the first body relative to the second. It ends where the first body is now, and all of it is asked about. It
         *     receives the time
         * @param out receives the contact if they touch, as in findContactOfParts; null if only the time is needed
         */
        public function findFirstTouch(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findFirstTouch");
        }

        /**
         * Finds the time and the contact of the first touch of two bodies that do not touch at the beginning of the motion. If they do, it is either
         * the beginning, or the first moment at which their surfaces touch.
         *
         * @param motion as in findFirstTouch. But a touch that rounding errors hide at its end may be missing
         * @param out receives the contact, as in findContactOfParts; null if only the time is needed
         */
        public function findImpactOfSurfaces(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            findFirstTouch(a, b, motion, out);
        }

        /**
         * Does what findImpactOfSurfaces() does, but if one body is inside of the other where the motion begins, the time is 0, and the contact's normal 0.
         *
         * @param out must not be null
         */
        public function findImpactOfSolids(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            findImpactOfSurfaces(a, b, motion, out);
        }

        /** Finds the contact for <code>findFirstTouch()</code>, if the two touch and it is needed. The motion has the time. */
        protected function findContactIfNeeded(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                findContactOfParts(a, b, motion, out);
            }
        }

        /**
         * Finds the contact of two bodies where they are, which separates them. If the two do not touch, its point is half way between the points where
         * they are nearest, its normal points from one of these points to the other, and its depth is 0.
         *
         * @param motion becomes none, at the time 1
         * @param out receives the contact. Its normal points from the second body to the first
         */
        public function findContact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            motion.endAfter(0, 0, 0);
            motion.time = 1;
            findContactOfParts(a, b, motion, out);
            if (showsTouch(a, b, out) || areTouching(a, b))
            {
                separate(a, b, motion, out);
                return;
            }
            findContactApart(a, b, out);
        }

        /**
         * Whether a contact of parts of two bodies shows that they touch. If not, only areTouching() decides. Structures that are deep in each other
         * touch, but the contact of trees may be deep without a touch.
         */
        protected function showsTouch(a:Body, b:Body, contact:ContactPoint):Boolean
        {
            return areStructures(a, b) && contact.depth > 2 * depthToleranceOf(a, b);
        }

        // Changes the contact of parts of two bodies to that of two that do not touch. If rounding hides the direction between the points where they are
        // nearest, the point and the normal stay as they are.
        private function findContactApart(a:Body, b:Body, out:ContactPoint):void
        {
            findClosest(a, b, false, _closest);
            if (areStructures(a, b) && _closest.distance <= toleranceOf(a, b, HIDDEN_DIRECTION))
            {
                out.depth = 0;
                return;
            }
            _closest.writeContact(out);
        }

        private static function areStructures(a:Body, b:Body):Boolean
        {
            return a.kind < ModelShape.TREE && b.kind < ModelShape.TREE;
        }

        /**
         * Finds the contact of two parts of two bodies, such as two triangles. The two bodies may still touch after the first one moves along the
         * normal by the depth.
         *
         * @param motion as in findFirstTouch, with the time of the first touch
         * @param out receives the contact. Its normal points from b to a, and b is where it is now
         */
        public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            throw new IllegalOperationError(this + " does not implement findContactOfParts");
        }

        /**
         * Finds the contact of convex covers of two bodies, where they are. A push out of the covers leads out of the bodies too. Convex bodies are
         * their own covers.
         */
        public function findContactOfCovers(a:Body, b:Body, out:ContactPoint):void
        {
            findContactOfParts(a, b, RelativeMotion.NONE, out);
        }

        /**
         * Changes a contact of parts so that it separates two bodies: if the first one moves along the normal by the depth, the two just
         * touch. Most contacts of parts do this already, and only the point moves, to the middle of the overlap.
         *
         * @param motion as in findFirstTouch, with the time at which the two touch
         * @param out the contact of two parts that touch at that time
         */
        public function separate(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            OverlapMiddle.moveToMiddle(a, b, out);
        }

        /**
         * Finds the distance between two bodies, and their closest points. The ground or the edges of the world may come first.
         *
         * @param areTouching what <code>areTouching()</code> says of the two. If it is true the distance is 0, and otherwise greater
         * @param out receives the distance and the closest points, in the world
         */
        public function findClosest(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            if (a.comesAfter(b))
            {
                findClosestInOrder(b, a, areTouching, out);
                out.swap();
                return;
            }
            findClosestInOrder(a, b, areTouching, out);
        }

        /** Does what findClosest() does. Body.comesAfter is false for the two. */
        protected function findClosestInOrder(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            throw new IllegalOperationError(this + " does not implement findClosestInOrder");
        }

        /** The gap across which two bodies touch because their places are rounded. */
        public function marginOf(a:Body, b:Body):Number
        {
            return a.margin + b.margin;
        }

        /** The largest extent of the two, which tolerances of a push are fractions of. It is 0 for two points. */
        public function largestExtentOf(a:Body, b:Body):Number
        {
            return 2 * Math.max(a.maxHalf, b.maxHalf);
        }

        /** How far a depth may be off, in patches: Tolerances.SEPARATION of the largest extent. Far from the origin, rounding decides instead. */
        public function depthToleranceOf(a:Body, b:Body):Number
        {
            return toleranceOf(a, b, Tolerances.SEPARATION);
        }

        // A fraction of the largest extent in patches, but not less than the rounding of places.
        private function toleranceOf(a:Body, b:Body, fraction:Number):Number
        {
            return Math.max(fraction * largestExtentOf(a, b), MIN_MARGINS * marginOf(a, b));
        }
    }
}
