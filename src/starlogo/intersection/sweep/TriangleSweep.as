package starlogo.intersection.sweep
{
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.TriangleAxes;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.Polygon;

    /**
     * When triangles that pass each other touch, and where: separating axes over time (see BoxSweep). Allocates nothing.
     *
     * @private
     */
    public final class TriangleSweep extends TriangleAxes
    {
        private var _polygonA:Polygon = new Polygon();
        private var _polygonB:Polygon = new Polygon();

        // The shortest separating displacement so far.
        private var _depth:Number = Infinity;
        private var _x:Number = 0;
        private var _y:Number = 0;
        private var _z:Number = 1;

        // How close they touch.
        private var _near:Number = 0;

        /** No triangles yet. */
        public function TriangleSweep()
        {
            isStanding = false;
            times = new TouchingTimes();
        }

        /**
         * Finds when the two triangles that were related touch for the first time.
         *
         * @param motion of the second, which is where it is at time 0; its time is the latest that is of interest, and becomes the time, from 0 on, or
         *     RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            this.motion = motion;
            comparesSegments = true;
            times.last = motion.time;
            times.reset();
            if (areSeparated())
            {
                motion.time = RelativeMotion.NEVER;
                return;
            }
            motion.time = times.touch < times.last ? times.touch : times.last;
        }

        /**
         * Where the two triangles that were related touch: the direction, at right angles to one or to an edge of each, along which they overlap least.
         *
         * @param motion displaces the second to where it is at the motion's time
         * @param out takes it, the normal pointing from b to a, in the space of the triangles
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            comparesSegments = false;
            _depth = Infinity;
            _x = _y = 0;
            _z = 1;
            _near = tolerance;
            tolerance = 0;
            this.motion = motion;
            var x:Number = motion.time * motion.x;
            var y:Number = motion.time * motion.y;
            var z:Number = motion.time * motion.z;
            px += x;
            py += y;
            pz += z;
            qx += x;
            qy += y;
            qz += z;
            rx += x;
            ry += y;
            rz += z;
            areSeparated();
            out.setNormal(_x, _y, _z);
            supportFirst();
            supportSecond();
            _polygonA.findCommonPoint(_polygonB, out);
            out.depth = _depth > 0 && _depth < Infinity ? _depth : 0;
            out.x = _polygonA.x;
            out.y = _polygonA.y;
            out.z = _polygonA.z;
        }

        // Keeps the shortest separating displacement.
        override protected function tryDepth():void
        {
            var x:Number = axisX;
            var y:Number = axisY;
            var z:Number = axisZ;
            var at:Number = times.at;
            var reach:Number = times.reach;
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            var depth:Number = (reach - Math.abs(at)) / length;
            // false for NaN
            if (depth < _depth - Tolerances.ROUNDING * reach / length)
            {
                var speed:Number = motion.x * x + motion.y * y + motion.z * z;
                if (speed != 0 && motion.time > 0 && Math.abs(at) < _near * length)
                {
                    // rounding decides on which side a triangle in the other's plane is; but it touches from the side that it comes from
                    at = -speed;
                }
                var side:Number = at > 0 ? -1 : 1;
                _depth = depth;
                _x = side * x / length;
                _y = side * y / length;
                _z = side * z / length;
            }
        }

        override protected function areSegmentsSeparated():Boolean
        {
            findTimeOfImpact(segmentB, segmentA, motion);
            times.touch = motion.time;
            return !(times.touch <= times.last);
        }

        // The corners of the first triangle that are farthest out against the direction; they are from its first corner.
        private function supportFirst():void
        {
            var points:Polygon = _polygonA;
            var q:Number = -(ux * _x + uy * _y + uz * _z);
            var r:Number = -(vx * _x + vy * _y + vz * _z);
            var far:Number = q > 0 ? q : 0;
            far = r > far ? r : far;
            far -= Tolerances.DIRECTION * (Math.abs(ux) + Math.abs(uy) + Math.abs(uz) + Math.abs(vx) + Math.abs(vy) + Math.abs(vz));
            points.clear();
            if (far <= 0)
            {
                points.setStep(0, 0, 0);
                points.add();
            }
            if (q >= far)
            {
                points.setStep(ux, uy, uz);
                points.add();
            }
            if (r >= far)
            {
                points.setStep(vx, vy, vz);
                points.add();
            }
        }

        // Those of the second that are farthest out along it.
        private function supportSecond():void
        {
            var points:Polygon = _polygonB;
            var p:Number = px * _x + py * _y + pz * _z;
            var q:Number = qx * _x + qy * _y + qz * _z;
            var r:Number = rx * _x + ry * _y + rz * _z;
            var far:Number = p > q ? p : q;
            far = r > far ? r : far;
            far -= Tolerances.DIRECTION * (Math.abs(px - qx) + Math.abs(py - qy) + Math.abs(pz - qz) + Math.abs(px - rx)
                    + Math.abs(py - ry) + Math.abs(pz - rz));
            points.clear();
            if (p >= far)
            {
                points.setStep(px, py, pz);
                points.add();
            }
            if (q >= far)
            {
                points.setStep(qx, qy, qz);
                points.add();
            }
            if (r >= far)
            {
                points.setStep(rx, ry, rz);
                points.add();
            }
        }
    }
}
