package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.geometry.Tolerances;

    /**
     * Finds when two moving triangles first touch, by separating axes over time (see BoxSweep). Allocates nothing.
     *
     * @private
     */
    public final class TriangleSweep extends TriangleAxes
    {
        private var _times:ContactInterval = new ContactInterval();

        // The longest edges of two triangles without area. The first has the tolerance as its radius.
        private var _edgeA:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);
        private var _edgeB:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        /**
         * Finds when the two triangles that were set by <code>relate()</code> first touch. If both triangles have no area, their longest
         * edges are compared.
         *
         * @param motion the second triangle's motion, which places it at time 0; its time is the latest one to look at, and becomes the
         *     result: 0 or later, or RelativeMotion.NEVER
         */
        public function findTime(motion:RelativeMotion):void
        {
            var times:ContactInterval = _times;
            this.motion = motion;
            times.last = motion.time;
            times.reset();
            motion.time = RelativeMotion.NEVER;
            if (areSeparatedByNormal())
            {
                return;
            }
            measure(edgesA);
            var heightA:Number = height;
            measure(edgesB);
            if (heightA <= Tolerances.FLAT_TRIANGLE && height <= Tolerances.FLAT_TRIANGLE)
            {
                findTimeOfEdges();
            }
            else if (!areSeparatedAcrossEdges() && !areSeparatedInPlane(heightA < height ? edgesB : edgesA))
            {
                motion.time = times.touch < times.last ? times.touch : times.last;
            }
        }

        /** @inheritDoc */
        override protected function isSeparating():Boolean
        {
            var x:Number = axisX;
            var y:Number = axisY;
            var z:Number = axisZ;
            var times:ContactInterval = _times;
            times.at = at;
            times.reach = reach;
            times.speed = x * motion.x + y * motion.y + z * motion.z;
            times.gap = tolerance * Math.sqrt(x * x + y * y + z * z);
            return times.areSeparated();
        }

        // Finds when the longest edges touch.
        private function findTimeOfEdges():void
        {
            setLongest(_edgeA, edgesA, 0, 0, 0);
            setLongest(_edgeB, edgesB, cornersB[0], cornersB[1], cornersB[2]);
            _edgeA.radius = tolerance;
            findTimeOfImpact(_edgeB, _edgeA, motion);
            if (!(motion.time <= _times.last))
            {
                motion.time = RelativeMotion.NEVER;
            }
        }

        // Sets a segment to the longest edge. x, y, z is the first corner. The third edge begins where the first one ends.
        private static function setLongest(segment:Capsule, edges:Vector.<Number>, x:Number, y:Number, z:Number):void
        {
            var longest:Number = -1;
            for (var i:int = 0; i < 9; i += 3)
            {
                var dx:Number = edges[i];
                var dy:Number = edges[int(i + 1)];
                var dz:Number = edges[int(i + 2)];
                var squared:Number = dx * dx + dy * dy + dz * dz;
                if (squared > longest)
                {
                    longest = squared;
                    var isThird:Boolean = i == 6;
                    segment.start.setTo(isThird ? x + edges[0] : x, isThird ? y + edges[1] : y, isThird ? z + edges[2] : z);
                    segment.end.setTo(segment.start.x + dx, segment.start.y + dy, segment.start.z + dz);
                }
            }
        }
    }
}
