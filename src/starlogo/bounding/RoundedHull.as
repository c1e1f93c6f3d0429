package starlogo.bounding
{
    import flash.geom.Vector3D;

    /**
     * A convex structure as the package convex takes it, as a record: the convex hull of points, with a radius around it.
     *
     * @private
     */
    public final class RoundedHull
    {
        /** A point inside of the structure. */
        public var center:Vector3D = null;

        /** The points relative to the centre, x, y, z of each. */
        public var points:Vector.<Number> = null;

        /** Three points of each face, counter-clockwise seen from outside, as indices of their first numbers. */
        public var faces:Vector.<int> = null;

        /** Both ends of each edge, and one more point of each of its two faces, as such indices. */
        public var edges:Vector.<int> = null;

        /** The radius around the points' hull. */
        public var radius:Number = 0;

        // A box around the points that count as the farthest.
        private static var sLow:Vector3D = new Vector3D();
        private static var sHigh:Vector3D = new Vector3D();

        /** As BoundingStructure.supportAlong. */
        public function supportAlong(direction:Vector3D):Number
        {
            var best:int = 0;
            var most:Number = -Infinity;
            for (var i:int = 0; i < points.length; i += 3)
            {
                var place:Number = points[i] * direction.x + points[int(i + 1)] * direction.y + points[int(i + 2)] * direction.z;
                if (place > most)
                {
                    most = place;
                    best = i;
                }
            }
            return (center.x + points[best]) * direction.x + (center.y + points[int(best + 1)]) * direction.y
                + (center.z + points[int(best + 2)]) * direction.z + radius;
        }

        /** As BoundingStructure.farthestPoint. */
        public function farthestPoint(direction:Vector3D, least:Number, out:Vector3D):void
        {
            sLow.setTo(Infinity, Infinity, Infinity);
            sHigh.setTo(-Infinity, -Infinity, -Infinity);
            for (var i:int = 0; i < points.length; i += 3)
            {
                var x:Number = center.x + points[i];
                var y:Number = center.y + points[int(i + 1)];
                var z:Number = center.z + points[int(i + 2)];
                if (x * direction.x + y * direction.y + z * direction.z + radius >= least)
                {
                    sLow.setTo(Math.min(sLow.x, x), Math.min(sLow.y, y), Math.min(sLow.z, z));
                    sHigh.setTo(Math.max(sHigh.x, x), Math.max(sHigh.y, y), Math.max(sHigh.z, z));
                }
            }
            out.setTo((sLow.x + sHigh.x) / 2, (sLow.y + sHigh.y) / 2, (sLow.z + sHigh.z) / 2);
        }
    }
}
