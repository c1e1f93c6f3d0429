package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.contactOfSpheres;
    import starlogo.intersection.sweep.PointSweep;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * When two rows touch for the first time as one of them moves, and how: spheres by their extents, all others by the strategy.
     *
     * @private
     */
    public final class RowSweep
    {
        private var _strategy:ShapeStrategy;
        private var _sphereA:Sphere = new Sphere(new Vector3D(), 0);
        private var _sphereB:Sphere = new Sphere(new Vector3D(), 0);
        private var _points:PointSweep = new PointSweep();
        private var _displacement:RelativeMotion = new RelativeMotion();

        /**
         * @param strategy decides what is not a sphere
         */
        public function RowSweep(strategy:ShapeStrategy)
        {
            _strategy = strategy;
        }

        /**
         * Finds when two rows touch for the first time.
         *
         * @param motion of the first, which ends where it is in the table, relative to the second; takes the time, from 0 to 1, or
         *     RelativeMotion.NEVER
         */
        public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                sweepSpheres(table, a, b, motion);
                return;
            }
            _strategy.findTime(table, a, b, motion);
        }

        /**
         * When and how two rows touch for the first time that do not touch at the beginning; as ShapeStrategy.findImpact.
         */
        public function findImpact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                sweepSpheres(table, a, b, motion);
                if (motion.time != RelativeMotion.NEVER)
                {
                    findContact(table, a, b, motion, out);
                }
                return;
            }
            _strategy.findImpact(table, a, b, motion, out);
        }

        /**
         * How two rows touch.
         *
         * @param motion as in findTime, with the time when they do first
         * @param out takes it, the normal pointing from b to a
         */
        public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                readSphere(table.extents, a, _sphereA);
                readSphere(table.extents, b, _sphereB);
                _displacement.stopAt(motion);
                contactOfSpheres(_sphereA, _sphereB, _displacement, out);
                return;
            }
            _strategy.findContact(table, a, b, motion, out);
        }

        private function sweepSpheres(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            _strategy.counts.tests[0]++;
            var standing:Extents = table.extents;
            _points.x = standing.x[a] - standing.x[b] + motion.startX;
            _points.y = standing.y[a] - standing.y[b] + motion.startY;
            _points.z = standing.z[a] - standing.z[b] + motion.startZ;
            // the motion's own rounding too
            _points.reach = (standing.halfX[a] + standing.halfX[b]) * Tolerances.TOUCHING
                + Tolerances.PLACES * (Math.abs(table.x[a]) + Math.abs(table.y[a]) + Math.abs(table.z[a])
                    + (Math.abs(table.x[b]) + Math.abs(table.y[b]) + Math.abs(table.z[b])))
                + Tolerances.ROUNDING * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _points.findTime(motion);
            // no rounding hides what stands there
            if (motion.time == RelativeMotion.NEVER && ShapeStrategy.areSpheresTouching(table, a, b))
            {
                motion.time = 1;
            }
        }

        private static function readSphere(standing:Extents, row:int, sphere:Sphere):void
        {
            var center:Vector3D = sphere.center;
            center.x = standing.x[row];
            center.y = standing.y[row];
            center.z = standing.z[row];
            sphere.radius = standing.halfX[row];
        }
    }
}
