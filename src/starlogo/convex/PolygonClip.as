package starlogo.convex
{
    import starlogo.geometry.Tolerances;

    /** Clips a segment or a convex polygon to another convex polygon (Sutherland and Hodgman, "Reentrant polygon clipping", 1974). */
    internal final class PolygonClip
    {
        /** The corners that are left, in order: x, y, z of each. <code>end</code> is the count of these numbers: 0 if nothing is left. Read only. */
        public var points:Vector.<Number> = new Vector.<Number>();
        public var end:int = 0;

        // The corners before a cut.
        private var _before:Vector.<Number> = new Vector.<Number>();

        // How far outside of the other polygon a corner still counts as inside.
        private var _slack:Number = 0;

        /**
         * Clips a feature.
         *
         * @param inner a segment or a polygon, in the plane of the other or in a parallel one
         * @param outer a polygon, in order around the normal
         * @param contact has the normal of the planes
         */
        public function clip(inner:ContactFeature, outer:ContactFeature, contact:ContactPoint):void
        {
            var p:Vector.<Number> = outer.points;
            _slack = Tolerances.DIRECTION * (Math.abs(p[3] - p[0]) + Math.abs(p[4] - p[1]) + Math.abs(p[5] - p[2])
                    + Math.abs(p[6] - p[3]) + Math.abs(p[7] - p[4]) + Math.abs(p[8] - p[5]));
            for (end = 0; end < inner.end; end++)
            {
                points[end] = inner.points[end];
            }
            var last:int = outer.end - 3;
            for (var at:int = 0; at < outer.end && end > 0; at += 3)
            {
                cut(p, last, at, contact);
                last = at;
            }
        }

        // Keeps the part on the inner side of an edge of the other polygon.
        private function cut(edges:Vector.<Number>, edgeFrom:int, edgeTo:int, contact:ContactPoint):void
        {
            var edgeX:Number = edges[edgeTo] - edges[edgeFrom];
            var edgeY:Number = edges[int(edgeTo + 1)] - edges[int(edgeFrom + 1)];
            var edgeZ:Number = edges[int(edgeTo + 2)] - edges[int(edgeFrom + 2)];
            // to the left of the edge, which is inwards
            var inX:Number = contact.normalY * edgeZ - contact.normalZ * edgeY;
            var inY:Number = contact.normalZ * edgeX - contact.normalX * edgeZ;
            var inZ:Number = contact.normalX * edgeY - contact.normalY * edgeX;
            var from:Number = inX * edges[edgeTo] + inY * edges[int(edgeTo + 1)] + inZ * edges[int(edgeTo + 2)];
            from -= _slack * Math.sqrt(inX * inX + inY * inY + inZ * inZ);
            var kept:Vector.<Number> = _before;
            var before:Vector.<Number> = points;
            var count:int = 0;
            var last:int = end - 3;
            var lastInwards:Number = inX * before[last] + inY * before[int(last + 1)] + inZ * before[int(last + 2)] - from;
            // A segment is not a closed outline.
            var isSegment:Boolean = end == ContactFeature.EDGE;
            for (var at:int = 0; at < end; at += 3)
            {
                var inwards:Number = inX * before[at] + inY * before[int(at + 1)] + inZ * before[int(at + 2)] - from;
                if (inwards > 0 != lastInwards > 0 && !(isSegment && at == 0))
                {
                    var share:Number = lastInwards / (lastInwards - inwards);
                    kept[count] = before[last] + share * (before[at] - before[last]);
                    kept[int(count + 1)] = before[int(last + 1)] + share * (before[int(at + 1)] - before[int(last + 1)]);
                    kept[int(count + 2)] = before[int(last + 2)] + share * (before[int(at + 2)] - before[int(last + 2)]);
                    count += 3;
                }
                if (inwards > 0)
                {
                    kept[count] = before[at];
                    kept[int(count + 1)] = before[int(at + 1)];
                    kept[int(count + 2)] = before[int(at + 2)];
                    count += 3;
                }
                last = at;
                lastInwards = inwards;
            }
            points = kept;
            _before = before;
            end = count;
        }
    }
}
