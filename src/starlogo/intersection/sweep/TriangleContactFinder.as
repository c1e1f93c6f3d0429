package starlogo.intersection.sweep
{
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactFeature;
    import starlogo.intersection.contact.ContactPoint;

    /**
     * Finds the contact of two triangles. The normal is perpendicular to a triangle or to an edge of each, and is the direction along which
     * they overlap least. Allocates nothing.
     *
     * @private
     */
    public final class TriangleContactFinder extends TriangleAxes
    {
        private var _featureA:ContactFeature = new ContactFeature();
        private var _featureB:ContactFeature = new ContactFeature();

        // The first triangle's corners, relative to its first corner.
        private var _cornersA:Vector.<Number> = new Vector.<Number>(9, true);

        // Its depth and normal are the shortest separating displacement so far.
        private var _contact:ContactPoint;

        /**
         * Finds the contact of the two triangles that were set by <code>relate()</code>.
         *
         * @param motion displaces the second triangle to where it is at the motion's time
         * @param out receives the contact; the normal points from the second triangle to the first
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            this.motion = motion;
            _contact = out;
            out.depth = Infinity;
            out.setNormal(0, 0, 1);
            for (var i:int = 0; i < 9; i += 3)
            {
                cornersB[i] += motion.time * motion.x;
                cornersB[int(i + 1)] += motion.time * motion.y;
                cornersB[int(i + 2)] += motion.time * motion.z;
            }
            areSeparatedByNormal();
            areSeparatedAcrossEdges();
            measure(edgesA);
            var heightA:Number = height;
            measure(edgesB);
            areSeparatedInPlane(heightA < height ? edgesB : edgesA);
            for (i = 3; i < 9; i++)
            {
                _cornersA[i] = edgesA[int(i - 3)];
            }
            _featureA.setFarthest(_cornersA, 0, out, -1);
            _featureB.setFarthest(cornersB, 0, out, 1);
            _featureA.findCommonPoint(_featureB, out);
            var depth:Number = out.depth;
            out.depth = depth > 0 && depth < Infinity ? depth : 0;
            out.x = _featureA.x + origin.x;
            out.y = _featureA.y + origin.y;
            out.z = _featureA.z + origin.z;
        }

        /** Keeps the displacement if it is the shortest so far. Always returns false, so that all axes are tried. */
        override protected function isSeparating():Boolean
        {
            var length:Number = Math.sqrt(axisX * axisX + axisY * axisY + axisZ * axisZ);
            var depth:Number = (reach - Math.abs(at)) / length;
            // The comparison is false for NaN too.
            if (depth < _contact.depth - Tolerances.ROUNDING * reach / length)
            {
                var side:Number = at > 0 ? -1 : 1;
                var speed:Number = axisX * motion.x + axisY * motion.y + axisZ * motion.z;
                if (speed != 0 && motion.time > 0 && Math.abs(at) < tolerance * length)
                {
                    // For a triangle in the other's plane, rounding decides the side. So the side that it comes from is taken.
                    side = speed > 0 ? 1 : -1;
                }
                _contact.depth = depth;
                _contact.setNormal(side * axisX / length, side * axisY / length, side * axisZ / length);
            }
            return false;
        }
    }
}
