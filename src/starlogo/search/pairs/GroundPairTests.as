package starlogo.search.pairs
{
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.ground.GroundBox;
    import starlogo.ground.GroundEarlyOut;
    import starlogo.ground.GroundExits;
    import starlogo.ground.GroundModelQuery;
    import starlogo.ground.GroundRayQuery;
    import starlogo.ground.HeightGrid;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.NarrowPhase;
    import starlogo.search.penetration.DisplacedPair;
    import starlogo.search.penetration.PenetrationSearch;
    import starlogo.search.penetration.PlacesAbove;
    import starlogo.search.TreeLimits;

    use namespace engine;

    /**
     * Tests a body and the ground, which is the second body of each pair: whether they touch, when they touch, and how.
     *
     * @private
     */
    public final class GroundPairTests extends PairTests
    {
        // How much of a cell of the ground counts as its extent. It is small because agents may be small, and not 0 because they may be points.
        private static const CELL_SHARE:Number = 1e-4;

        private var _limits:TreeLimits;
        private var _penetrationSearch:PenetrationSearch;

        // Decides quickly about bodies that are clearly above or in the ground, by their extents; and about the others.
        private var _box:GroundBox = new GroundBox();
        private var _earlyOut:GroundEarlyOut = new GroundEarlyOut();
        private var _query:GroundModelQuery = new GroundModelQuery();
        private var _rays:GroundRayQuery = new GroundRayQuery();

        /** @param limits how far trees are tested */
        public function GroundPairTests(limits:TreeLimits)
        {
            _limits = limits;
            var pair:DisplacedPair = new DisplacedPair(this);
            _penetrationSearch = new PenetrationSearch(pair, new GroundExits(), new PlacesAbove(pair));
        }

        /** Gives these tests to a narrow phase that does not have them. */
        public static function addTo(narrowPhase:NarrowPhase):void
        {
            narrowPhase.groundTests ||= new GroundPairTests(narrowPhase.treeLimits);
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            return touchesAtBeginning(a, b, RelativeMotion.NONE);
        }

        /** Finds where a ray first meets the ground. Returns whether it does. */
        public function findRayEntry(b:Body, ray:Ray, out:RayCrossing):Boolean
        {
            return _rays.find(gridOf(b), ray, out);
        }

        /** Adds all crossings of a ray with the ground's surface. */
        public function findCrossings(b:Body, ray:Ray, out:RayCrossings):void
        {
            _rays.findAll(gridOf(b), ray, out);
        }

        /** Whether a piece of a body is deeper in the ground than this, in patches. */
        public function isDeeper(a:Body, b:Body, depth:Number):Boolean
        {
            return queryOf(a, b).penetration.isDeeper(depth);
        }

        /** @inheritDoc */
        override public function findFirstTouch(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            queryOf(a, b).findFirstTouch(motion, out);
        }

        /** @inheritDoc */
        override public function findImpactOfSurfaces(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            queryOf(a, b).findImpactOfSurfaces(motion, out);
        }

        /** A model may be wholly under the surface. @inheritDoc */
        override public function findImpactOfSolids(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            findImpactOfSurfaces(a, b, motion, out);
            if (motion.time > 0 && touchesAtBeginning(a, b, motion))
            {
                motion.time = 0;
                out.setNormal(0, 0, 0);
            }
        }

        /** A point of the body that is under the ground shows a touch. @inheritDoc */
        override protected function showsTouch(a:Body, b:Body, contact:ContactPoint):Boolean
        {
            return contact.exitBound > depthToleranceOf(a, b);
        }

        /** For most bodies, planes alone show the push. @inheritDoc */
        override public function findContact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            if (queryOf(a, b).findPush(DisplacedPair.PROBE_SHARE * depthToleranceOf(a, b), out))
            {
                motion.endAfter(0, 0, 0);
                motion.time = 1;
                OverlapMiddle.moveToMiddle(a, b, out);
                OverlapMiddle.keepWithin(a, out);
                return;
            }
            super.findContact(a, b, motion, out);
        }

        /** @inheritDoc */
        override public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            queryOf(a, b).findContact(motion, out);
        }

        /**
         * The cover of the ground is all below its greatest height under the body, so the push leads straight up.
         *
         * @inheritDoc
         */
        override public function findContactOfCovers(a:Body, b:Body, out:ContactPoint):void
        {
            queryOf(a, b).penetration.findLift(out);
        }

        /** @inheritDoc */
        override public function separate(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            _penetrationSearch.separate(a, b, motion, out);
        }

        /** @inheritDoc */
        override protected function findClosestInOrder(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            queryOf(a, b).findClosest(areTouching, out);
        }

        /** @inheritDoc */
        override public function marginOf(a:Body, b:Body):Number
        {
            // the margin of the body counts twice, as if another agent stood at its place
            return 2 * a.margin;
        }

        /** @inheritDoc */
        override public function largestExtentOf(a:Body, b:Body):Number
        {
            return Math.max(CELL_SHARE * gridOf(b).cellWidth, 2 * a.maxHalf);
        }

        private static function gridOf(ground:Body):HeightGrid
        {
            return ground.shape.grid;
        }

        // Whether a body touches the ground where a motion begins that ends where it stands.
        private function touchesAtBeginning(a:Body, b:Body, motion:RelativeMotion):Boolean
        {
            setBox(a, motion);
            var found:int = _earlyOut.decide(gridOf(b), _box, a.kind);
            return found == GroundEarlyOut.UNKNOWN ? queryOf(a, b).areTouchingAt(motion, 0) : found == GroundEarlyOut.TOUCHING;
        }

        // Sets the box to a body's extents where a motion begins.
        private function setBox(a:Body, motion:RelativeMotion):void
        {
            _box.x = a.middleX + motion.startX;
            _box.y = a.middleY + motion.startY;
            _box.z = a.middleZ + motion.startZ;
            _box.halfX = a.halfX;
            _box.halfY = a.halfY;
            _box.halfZ = a.halfZ;
        }

        // The query of the ground, set to a body.
        private function queryOf(a:Body, b:Body):GroundModelQuery
        {
            var shape:ModelShape = a.shape;
            var depth:int = shape.tree == null ? 1 : _limits.depthOf(a);
            _query.setTo(gridOf(b), shape.tree, shape.structure, a.placement, depth);
            return _query;
        }
    }
}
