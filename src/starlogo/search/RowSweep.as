package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.contactOfSpheres;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.pointPointImpact;

    use namespace engine;

    /**
     * When two rows touch for the first time as one of them moves, and how: spheres by their extents, all others by the strategy.
     *
     * @private
     */
    public final class RowSweep
    {
        /** When the rows touch that findImpact was asked about last. */
        public var time:Number = 0;

        private var _strategy:ShapeStrategy;
        private var _sphereA:Sphere = new Sphere(new Vector3D(), 0);
        private var _sphereB:Sphere = new Sphere(new Vector3D(), 0);

        /**
         * @param strategy decides what is not a sphere
         */
        public function RowSweep(strategy:ShapeStrategy)
        {
            _strategy = strategy;
        }

        /**
         * When two rows touch for the first time.
         *
         * @param motion of the first, which ends where it is in the table, relative to the second
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function impactTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):Number
        {
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                sweepSpheres(table, a, b, motion);
                return time;
            }
            return _strategy.impactTime(table, a, b, motion);
        }

        /**
         * When and how two rows touch for the first time that do not touch at the beginning; as ShapeStrategy.findImpact, but for the result, which is
         * in <code>time</code>.
         */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                sweepSpheres(table, a, b, motion);
                if (time != RelativeMotion.NEVER)
                {
                    findContact(table, a, b, motion, time, out);
                }
                return;
            }
            time = _strategy.findImpact(table, a, b, motion, out);
        }

        /**
         * How two rows touch.
         *
         * @param motion as in impactTime
         * @param time when they do first
         * @param out takes it, the normal pointing from b to a
         */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, time:Number, out:ContactPoint):void
        {
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                readSphere(table.extents, a, _sphereA);
                readSphere(table.extents, b, _sphereB);
                contactOfSpheres(_sphereA, _sphereB, motion.startX + time * motion.x, motion.startY + time * motion.y,
                        motion.startZ + time * motion.z, out);
                return;
            }
            _strategy.findContact(table, a, b, motion, time, out);
        }

        private function sweepSpheres(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            _strategy.counts.tests[0]++;
            var standing:Extents = table.extents;
            var fromX:Number = standing.x[a] - standing.x[b] + motion.startX;
            var fromY:Number = standing.y[a] - standing.y[b] + motion.startY;
            var fromZ:Number = standing.z[a] - standing.z[b] + motion.startZ;
            // the motion's own rounding too
            var reach:Number = ShapeStrategy.reachOfSpheres(table, a, b)
                + Tolerances.ROUNDING * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            time = pointPointImpact(fromX, fromY, fromZ, motion.x, motion.y, motion.z, reach);
            // no rounding hides what stands there
            if (time == RelativeMotion.NEVER && ShapeStrategy.areSpheresTouching(table, a, b))
            {
                time = 1;
            }
        }

        private static function readSphere(standing:Extents, row:int, sphere:Sphere):void
        {
            sphere.center.setTo(standing.x[row], standing.y[row], standing.z[row]);
            sphere.radius = standing.halfX[row];
        }
    }
}
