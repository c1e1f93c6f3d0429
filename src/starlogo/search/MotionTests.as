package starlogo.search
{
    import starlogo.broadphase.Extents;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.pointPointImpact;

    /** When two rows of a table touch as their agents move. */
    internal final class MotionTests
    {
        /** The motion of the first row relative to the second, once <code>impactTime()</code> was asked. */
        public var way:RelativeMotion = new RelativeMotion();

        private var _strategy:ShapeStrategy;

        // When the extents of a pair begin to overlap in those directions that were looked at, and cease to.
        private var _enters:Number;
        private var _leaves:Number;

        /**
         * @param strategy decides what is not a sphere
         */
        public function MotionTests(strategy:ShapeStrategy)
        {
            _strategy = strategy;
        }

        /**
         * When two rows of which one sweeps touch for the first time.
         *
         * @param slack by how much extents may miss each other that touch
         * @return from 0 to 1, or RelativeMotion.NEVER
         */
        public function impactTime(table:AgentTable, motions:Motions, a:int, b:int, slack:Number):Number
        {
            var x:Number = motions.x[a] - motions.x[b];
            var y:Number = motions.y[a] - motions.y[b];
            var z:Number = motions.z[a] - motions.z[b];
            way.endAfter(x, y, z);
            if (x == 0 && y == 0 && z == 0)
            {
                _strategy.counts.sweptPairs++;
                return _strategy.areTouching(table, a, b) ? 0 : RelativeMotion.NEVER;
            }
            if (table.shapes[a].isSphere && table.shapes[b].isSphere)
            {
                _strategy.counts.sweptPairs++;
                return timeOfSpheres(table, a, b);
            }
            if (passEachOther(table.extents, a, b, slack))
            {
                return RelativeMotion.NEVER;
            }
            _strategy.counts.sweptPairs++;
            return _strategy.impactTime(table, a, b, way);
        }

        private function timeOfSpheres(table:AgentTable, a:int, b:int):Number
        {
            _strategy.counts.tests[0]++;
            var extents:Extents = table.extents;
            var x:Number = extents.x[a] - extents.x[b];
            var y:Number = extents.y[a] - extents.y[b];
            var z:Number = extents.z[a] - extents.z[b];
            // the motion's own rounding too
            var reach:Number = ShapeStrategy.reachOfSpheres(table, a, b)
                + Tolerances.ROUNDING * (Math.abs(way.x) + Math.abs(way.y) + Math.abs(way.z));
            var time:Number = pointPointImpact(x + way.startX, y + way.startY, z + way.startZ, way.x, way.y, way.z, reach);
            // no rounding hides what stands there
            return time == RelativeMotion.NEVER && ShapeStrategy.areSpheresTouching(table, a, b) ? 1 : time;
        }

        // Whether the extents of two rows, which now are where they are at the end of the way, never overlap in all directions at once.
        private function passEachOther(extents:Extents, a:int, b:int, slack:Number):Boolean
        {
            _enters = 0;
            _leaves = 1;
            return isGap(extents.x[b] - extents.x[a], way.x, extents.halfX[a] + extents.halfX[b] + slack)
                || isGap(extents.y[b] - extents.y[a], way.y, extents.halfY[a] + extents.halfY[b] + slack)
                || isGap(extents.z[b] - extents.z[a], way.z, extents.halfZ[a] + extents.halfZ[b] + slack);
        }

        // One direction: where b is from a at the end, and how far it has come down.
        private function isGap(at:Number, speed:Number, reach:Number):Boolean
        {
            at += speed;
            if (speed < 0)
            {
                speed = -speed;
                at = -at;
            }
            if (at < -reach || at - reach > _leaves * speed)
            {
                return true;
            }
            if (at > reach)
            {
                var enters:Number = (at - reach) / speed;
                if (enters > _enters)
                {
                    _enters = enters;
                }
            }
            if (at + reach < _leaves * speed)
            {
                _leaves = (at + reach) / speed;
            }
            return _enters > _leaves;
        }
    }
}
