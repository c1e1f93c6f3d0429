package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Sphere;
    import starlogo.broadphase.Extents;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;

    /** How two rows of a table touch, standing or as their agents moved. */
    internal final class RowContacts
    {
        private var _strategy:ShapeStrategy;
        private var _motions:Motions;
        private var _motionTests:MotionTests;
        private var _finder:ContactFinder = new ContactFinder();
        private var _sphereA:Sphere = new Sphere(new Vector3D(), 0);
        private var _sphereB:Sphere = new Sphere(new Vector3D(), 0);

        /**
         * @param strategy decides what is not a sphere
         * @param motions those of the last search
         * @param motionTests tell when rows touch
         */
        public function RowContacts(strategy:ShapeStrategy, motions:Motions, motionTests:MotionTests)
        {
            _strategy = strategy;
            _motions = motions;
            _motionTests = motionTests;
        }

        /**
         * Finds how two rows touch.
         *
         * @param isSwept whether the motions are those of the table
         * @param out takes it, the normal pointing from b to a
         * @return when, on the ways of their motions; 1 where neither sweeps
         */
        public function find(table:AgentTable, a:int, b:int, isSwept:Boolean, out:ContactPoint):Number
        {
            var way:RelativeMotion = _motionTests.way;
            var isPassing:Boolean = isSwept && (_motions.isSweeping[a] || _motions.isSweeping[b]);
            var time:Number = isPassing ? _motionTests.impactTime(table, _motions, a, b, Infinity) : 1;
            if (time == RelativeMotion.NEVER)
            {
                isPassing = false;
                time = 1;
            }
            if (!isPassing)
            {
                way.endAfter(0, 0, 0);
            }
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                readSphere(table.extents, a, _sphereA);
                readSphere(table.extents, b, _sphereB);
                _finder.find(_sphereA, _sphereB, way.startX + time * way.x, way.startY + time * way.y, way.startZ + time * way.z, out);
            }
            else
            {
                _strategy.findContact(table, a, b, way, time, out);
            }
            if (isPassing)
            {
                // from where b is now to where it was
                out.x -= (1 - time) * _motions.x[b];
                out.y -= (1 - time) * _motions.y[b];
                out.z -= (1 - time) * _motions.z[b];
            }
            return time;
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
