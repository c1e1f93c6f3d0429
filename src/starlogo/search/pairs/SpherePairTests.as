package starlogo.search.pairs
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Extents;
    import starlogo.broadphase.Points;
    import starlogo.convex.BallGap;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.CoreGap;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.findTimeOfImpactOfSpheres;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;
    import starlogo.search.Body;
    import starlogo.search.NarrowPhase;
    import starlogo.search.SearchCounts;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Tests two bodies that are spheres. A sphere is as wide as its extents, so whether, when and how two touch (not how far apart they are) needs no
     * structure in the world.
     *
     * @private
     */
    public final class SpherePairTests extends PairTests
    {
        // In SearchCounts.structures: the index of two spheres.
        private static const TWO_SPHERES:int = BoundingStructure.KIND_COUNT * BoundingStructure.SPHERE + BoundingStructure.SPHERE;

        private var _counts:SearchCounts;

        // The gap for touches and their times. Its touch distance has all that Touching names.
        private var _gap:BallGap = new BallGap();

        // The gap for contacts and closest points.
        private var _centers:CoreGap = new CoreGap();

        /** @param counts counts the tests */
        public function SpherePairTests(counts:SearchCounts)
        {
            _counts = counts;
        }

        /** Gives these tests to a narrow phase that does not have them. */
        public static function addTo(narrowPhase:NarrowPhase):void
        {
            narrowPhase.sphereTests ||= new SpherePairTests(narrowPhase.counts);
        }

        /**
         * Keeps those of some rows that touch a row, and moves them to the beginning of the list. All must be spheres. Returns how many they are.
         *
         * @param level says how far apart the circles of the candidates may be
         */
        public function keepTouchingSpheres(table:AgentTable, row:int, others:Vector.<int>, count:int, level:BinLevel):int
        {
            var xs:Vector.<Number> = table.extents.x;
            var ys:Vector.<Number> = table.extents.y;
            var zs:Vector.<Number> = table.extents.z;
            var radii:Vector.<Number> = table.extents.halfX;
            var atX:Number = xs[row];
            var atY:Number = ys[row];
            var atZ:Number = zs[row];
            var radius:Number = radii[row];
            var slack:Number = level.slack;
            var kept:int = 0;
            _counts.structures[TWO_SPHERES] += count;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var x:Number = xs[other] - atX;
                var y:Number = ys[other] - atY;
                var z:Number = zs[other] - atZ;
                var across:Number = radius + radii[other];
                var squared:Number = x * x + y * y + z * z;
                if (squared > across * across)
                {
                    // if the gap is not larger than rounding errors, the exact test decides
                    across += slack;
                    if (squared > across * across || !areOverlapping(table.bodyOf(row), table.bodyOf(other)))
                    {
                        continue;
                    }
                }
                others[kept] = other;
                kept++;
            }
            return kept;
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            _counts.structures[TWO_SPHERES]++;
            return areOverlapping(a, b);
        }

        /** @inheritDoc */
        override public function findFirstTouch(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            readGap(a, b, _gap);
            sweep(_gap, motion);
            findContactIfNeeded(a, b, motion, out);
        }

        /**
         * Finds the time at which two rows first touch. It reads the columns of the table, because with bodies a frame of swept spheres takes half as
         * long again.
         */
        public function findTimeOfRows(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            readGapOfRows(table, a, b, _gap);
            sweep(_gap, motion);
        }

        /**
         * It needs no structures in the world, which would take memory for each row, and are wider than the bodies.
         *
         * @inheritDoc
         */
        override public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            readCenters(a, b, motion);
            _centers.radiusA = a.halfX;
            _centers.radiusB = b.halfX;
            out.setFromGap(_centers, motion);
        }

        /** @inheritDoc */
        override protected function findClosestInOrder(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            readCenters(a, b, RelativeMotion.NONE);
            // the widened spheres: a distance leaves out all of the gap that counts as a touch; a contact's depth leaves the gap in place
            var sphereA:Sphere = a.worldStructure() as Sphere;
            var sphereB:Sphere = b.worldStructure() as Sphere;
            _centers.radiusA = sphereA.radius;
            _centers.radiusB = sphereB.radius;
            out.setFromGap(_centers);
            out.correct(areTouching);
        }

        // Sets the gap of the centres at the time of the motion. The radii stay.
        private function readCenters(a:Body, b:Body, motion:RelativeMotion):void
        {
            _centers.point.x = a.middleX;
            _centers.point.y = a.middleY;
            _centers.point.z = a.middleZ;
            _centers.x = a.middleX - b.middleX + motion.startX + motion.time * motion.x;
            _centers.y = a.middleY - b.middleY + motion.startY + motion.time * motion.y;
            _centers.z = a.middleZ - b.middleZ + motion.startZ + motion.time * motion.z;
        }

        private function areOverlapping(a:Body, b:Body):Boolean
        {
            readGap(a, b, _gap);
            return isClosed(_gap);
        }

        private static function readGap(a:Body, b:Body, out:BallGap):void
        {
            // not Body.margin, because V8 makes an object for the Number of a getter
            var marginA:Number = Touching.marginOfPlace(a.placement.x, a.placement.y, a.placement.z);
            var marginB:Number = Touching.marginOfPlace(b.placement.x, b.placement.y, b.placement.z);
            out.x = a.middleX - b.middleX;
            out.y = a.middleY - b.middleY;
            out.z = a.middleZ - b.middleZ;
            out.touchDistance = (a.halfX + b.halfX) * Tolerances.TOUCHING + (marginA + marginB);
        }

        private static function readGapOfRows(table:AgentTable, a:int, b:int, out:BallGap):void
        {
            var extents:Extents = table.extents;
            var places:Points = table.places;
            var marginA:Number = Touching.marginOfPlace(places.x[a], places.y[a], places.z[a]);
            var marginB:Number = Touching.marginOfPlace(places.x[b], places.y[b], places.z[b]);
            out.x = extents.x[a] - extents.x[b];
            out.y = extents.y[a] - extents.y[b];
            out.z = extents.z[a] - extents.z[b];
            out.touchDistance = (extents.halfX[a] + extents.halfX[b]) * Tolerances.TOUCHING + (marginA + marginB);
        }

        private static function isClosed(gap:BallGap):Boolean
        {
            return gap.x * gap.x + gap.y * gap.y + gap.z * gap.z <= gap.touchDistance * gap.touchDistance;
        }

        // Finds the time at which two spheres first touch. The gap is that at the end of the motion, and becomes that at its beginning.
        private function sweep(gap:BallGap, motion:RelativeMotion):void
        {
            var areTouchingAtEnd:Boolean = isClosed(gap);
            _counts.structures[TWO_SPHERES]++;
            gap.x += motion.startX;
            gap.y += motion.startY;
            gap.z += motion.startZ;
            // The margin of the motion. Its start is 0 or the reverse of it: see Touching.
            gap.touchDistance += Tolerances.ROUNDING * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            findTimeOfImpactOfSpheres(gap, motion);
            // rounding can miss a touch at the end of a motion that is far shorter than the two
            if (motion.time == RelativeMotion.NEVER && areTouchingAtEnd)
            {
                motion.time = 1;
            }
        }
    }
}
