package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.PointPoint;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    use namespace engine;

    /**
     * Tests two rows that are spheres. A sphere has the same width as its extents, so it needs no structure in the world.
     *
     * @private
     */
    public final class SpherePairs extends PairTests
    {
        /** The number of tests. */
        public var tests:int = 0;

        private var _sphereA:Sphere = new Sphere(new Vector3D(), 0);
        private var _sphereB:Sphere = new Sphere(new Vector3D(), 0);
        private var _points:PointPoint = new PointPoint();
        private var _displacement:RelativeMotion = new RelativeMotion();

        /** Begins with a count of 0. */
        public function SpherePairs()
        {
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            var extents:Extents = table.extents;
            var x:Number = extents.x[a] - extents.x[b];
            var y:Number = extents.y[a] - extents.y[b];
            var z:Number = extents.z[a] - extents.z[b];
            findReach(table, a, b);
            return x * x + y * y + z * z <= _points.reach * _points.reach;
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            tests++;
            var extents:Extents = table.extents;
            _points.x = extents.x[a] - extents.x[b] + motion.startX;
            _points.y = extents.y[a] - extents.y[b] + motion.startY;
            _points.z = extents.z[a] - extents.z[b] + motion.startZ;
            findReach(table, a, b);
            // the motion's own rounding errors are added too
            _points.reach += Tolerances.ROUNDING * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _points.findEntry(motion);
            // rounding can miss a touch at the end of the motion
            if (motion.time == RelativeMotion.NEVER && areTouching(table, a, b))
            {
                motion.time = 1;
            }
        }

        /** @inheritDoc */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            readSphere(table.extents, a, _sphereA);
            readSphere(table.extents, b, _sphereB);
            _displacement.stopAt(motion);
            _points.findContact(_sphereA, _sphereB, _displacement, out);
        }

        /** @inheritDoc */
        override public function hasExactContact(table:AgentTable, a:int, b:int):Boolean
        {
            return true;
        }

        // Finds the largest distance of the middles at which two rows touch.
        private function findReach(table:AgentTable, a:int, b:int):void
        {
            var halfX:Vector.<Number> = table.extents.halfX;
            _points.reach = (halfX[a] + halfX[b]) * Tolerances.TOUCHING + (table.marginOf(a) + table.marginOf(b));
        }

        private static function readSphere(extents:Extents, row:int, sphere:Sphere):void
        {
            var center:Vector3D = sphere.center;
            center.x = extents.x[row];
            center.y = extents.y[row];
            center.z = extents.z[row];
            sphere.radius = extents.halfX[row];
        }
    }
}
