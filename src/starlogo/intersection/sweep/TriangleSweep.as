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
        private var _depth:Number;
        private var _x:Number;
        private var _y:Number;
        private var _z:Number;

        /** No triangles yet. */
        public function TriangleSweep()
        {
            isStanding = false;
            times = new TouchingTimes();
            motion = new RelativeMotion();
        }

        /**
         * When two triangles touch for the first time.
         *
         * @param a has nine numbers of the one: x, y, z of each corner
         * @param atA where in a they begin
         * @param b has nine numbers of the other, where it is at time 0, in the same space
         * @param atB where in b they begin
         * @param motionX how b moves between times 0 and 1
         * @param motionY likewise
         * @param motionZ likewise
         * @param gap what still counts as touching, a distance
         * @param latest the latest time that is of interest
         * @return from 0 to the latest time, or RelativeMotion.NEVER
         */
        public function touch(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, motionX:Number, motionY:Number, motionZ:Number,
                gap:Number, latest:Number):Number
        {
            comparesSegments = true;
            times.reset(latest);
            motion.x = motionX;
            motion.y = motionY;
            motion.z = motionZ;
            relate(a, atA, b, atB, gap);
            return areSeparated() ? RelativeMotion.NEVER : times.first;
        }

        /**
         * Where two triangles touch: the direction, at right angles to one or to an edge of each, along which they overlap least.
         *
         * @param a as in touch
         * @param atA as in touch
         * @param b as in touch
         * @param atB as in touch
         * @param motionX how far b is displaced
         * @param motionY likewise
         * @param motionZ likewise
         * @param out takes it, the normal pointing from b to a
         */
        public function findContact(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, motionX:Number, motionY:Number, motionZ:Number,
                out:ContactPoint):void
        {
            comparesSegments = false;
            _depth = Infinity;
            _x = _y = 0;
            _z = 1;
            relate(a, atA, b, atB, 0);
            px += motionX;
            py += motionY;
            pz += motionZ;
            qx += motionX;
            qy += motionY;
            qz += motionZ;
            rx += motionX;
            ry += motionY;
            rz += motionZ;
            areSeparated();
            out.normalX = _x;
            out.normalY = _y;
            out.normalZ = _z;
            setSupport(_polygonA, 0, 0, 0, ux, uy, uz, vx, vy, vz, -_x, -_y, -_z);
            setSupport(_polygonB, px, py, pz, qx, qy, qz, rx, ry, rz, _x, _y, _z);
            _polygonA.findCommonPoint(_polygonB, _x, _y, _z);
            out.depth = _depth > 0 && _depth < Infinity ? _depth : 0;
            out.x = a[atA] + _polygonA.x;
            out.y = a[int(atA + 1)] + _polygonA.y;
            out.z = a[int(atA + 2)] + _polygonA.z;
        }

        // Keeps the shortest separating displacement.
        override protected function tryDepth(x:Number, y:Number, z:Number, at:Number, reach:Number):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            var depth:Number = (reach - Math.abs(at)) / length;
            // false for NaN
            if (depth < _depth - Tolerances.ROUNDING * reach / length)
            {
                var side:Number = at > 0 ? -1 : 1;
                _depth = depth;
                _x = side * x / length;
                _y = side * y / length;
                _z = side * z / length;
            }
        }

        override protected function areSegmentsSeparated():Boolean
        {
            return !times.limitTo(timeOfImpact(segmentB, segmentA, motion));
        }

        // The corners of a triangle that are farthest out in a direction.
        private static function setSupport(polygon:Polygon, px:Number, py:Number, pz:Number, qx:Number, qy:Number, qz:Number,
                rx:Number, ry:Number, rz:Number, x:Number, y:Number, z:Number):void
        {
            var p:Number = px * x + py * y + pz * z;
            var q:Number = qx * x + qy * y + qz * z;
            var r:Number = rx * x + ry * y + rz * z;
            var far:Number = p > q ? p : q;
            far = r > far ? r : far;
            far -= Tolerances.DIRECTION * (Math.abs(px - qx) + Math.abs(py - qy) + Math.abs(pz - qz) + Math.abs(px - rx)
                    + Math.abs(py - ry) + Math.abs(pz - rz));
            polygon.clear();
            if (p >= far)
            {
                polygon.add(px, py, pz);
            }
            if (q >= far)
            {
                polygon.add(qx, qy, qz);
            }
            if (r >= far)
            {
                polygon.add(rx, ry, rz);
            }
        }
    }
}
