package starlogo.convex
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;

    /**
     * The feature of a core that touches another core: a point, a segment or a convex polygon. Finds a point that two touching features
     * have in common.
     */
    internal final class ContactFeature
    {
        // The corners in order, and how many numbers they are; and the polygon that a clip makes.
        private var _points:Vector.<Number> = new Vector.<Number>();
        private var _end:int = 0;
        private var _clipped:Vector.<Number> = new Vector.<Number>();

        private var _middle:Vector3D = new Vector3D();

        /** Removes all points. */
        public function clear():void
        {
            _end = 0;
        }

        /** Adds a corner after the others. */
        public function add(corner:Vector3D):void
        {
            _points[_end] = corner.x;
            _points[int(_end + 1)] = corner.y;
            _points[int(_end + 2)] = corner.z;
            _end += 3;
        }

        /** Moves all points by a vector. */
        public function move(by:Vector3D):void
        {
            for (var at:int = 0; at < _end; at += 3)
            {
                _points[at] += by.x;
                _points[int(at + 1)] += by.y;
                _points[int(at + 2)] += by.z;
            }
        }

        /**
         * Finds the middle of the area that two features share when seen along a normal.
         *
         * @param other in the same plane, or in a parallel one
         * @param out has the normal; receives the point, in the plane of either
         */
        public function findCommonPoint(other:ContactFeature, out:ContactPoint):void
        {
            if (_end == 3)
            {
                writeMiddle(out);
            }
            else if (other._end == 3)
            {
                other.writeMiddle(out);
            }
            else if (other._end > 6)
            {
                writeMiddleWithin(other, out);
            }
            else if (_end > 6)
            {
                other.writeMiddleWithin(this, out);
            }
            else
            {
                writeCrossing(_points, other._points, out);
            }
        }

        // Writes the middle of the corners.
        private function writeMiddle(out:ContactPoint):void
        {
            setMiddle();
            out.x = _middle.x;
            out.y = _middle.y;
            out.z = _middle.z;
        }

        private function setMiddle():void
        {
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            for (var at:int = 0; at < _end; at += 3)
            {
                x += _points[at];
                y += _points[int(at + 1)];
                z += _points[int(at + 2)];
            }
            _middle.x = x * (3 / _end);
            _middle.y = y * (3 / _end);
            _middle.z = z * (3 / _end);
        }

        // Writes the middle of this segment or polygon after clipping it to another polygon (Sutherland and Hodgman, "Reentrant polygon
        // clipping", 1974). If the two do not overlap, it is the other's middle.
        private function writeMiddleWithin(outer:ContactFeature, out:ContactPoint):void
        {
            outer.writeMiddle(out);
            var last:int = outer._end - 3;
            for (var at:int = 0; at < outer._end && _end > 0; at += 3)
            {
                cut(outer, last, at, out);
                last = at;
            }
            if (_end > 0)
            {
                writeMiddle(out);
            }
        }

        // Keeps the part on the inner side of an edge of the outer polygon, whose middle has been set.
        private function cut(outer:ContactFeature, edgeFrom:int, edgeTo:int, contact:ContactPoint):void
        {
            var points:Vector.<Number> = _points;
            var kept:Vector.<Number> = _clipped;
            var edges:Vector.<Number> = outer._points;
            var slack:Number = Tolerances.DIRECTION * (Math.abs(edges[0] - outer._middle.x) + Math.abs(edges[1] - outer._middle.y)
                    + Math.abs(edges[2] - outer._middle.z) + Math.abs(edges[3] - outer._middle.x) + Math.abs(edges[4] - outer._middle.y)
                    + Math.abs(edges[5] - outer._middle.z));
            var edgeX:Number = edges[edgeTo] - edges[edgeFrom];
            var edgeY:Number = edges[int(edgeTo + 1)] - edges[int(edgeFrom + 1)];
            var edgeZ:Number = edges[int(edgeTo + 2)] - edges[int(edgeFrom + 2)];
            // The vector points inwards, in the plane.
            var inX:Number = edgeY * contact.normalZ - edgeZ * contact.normalY;
            var inY:Number = edgeZ * contact.normalX - edgeX * contact.normalZ;
            var inZ:Number = edgeX * contact.normalY - edgeY * contact.normalX;
            var from:Number = inX * edges[edgeTo] + inY * edges[int(edgeTo + 1)] + inZ * edges[int(edgeTo + 2)];
            if (inX * outer._middle.x + inY * outer._middle.y + inZ * outer._middle.z < from)
            {
                inX = -inX;
                inY = -inY;
                inZ = -inZ;
                from = -from;
            }
            from -= slack * Math.sqrt(inX * inX + inY * inY + inZ * inZ);
            var count:int = 0;
            var last:int = _end - 3;
            var lastBeyond:Number = inX * points[last] + inY * points[int(last + 1)] + inZ * points[int(last + 2)] - from;
            // A segment is not a closed outline.
            var isSegment:Boolean = _end == 6;
            for (var at:int = 0; at < _end; at += 3)
            {
                var beyond:Number = inX * points[at] + inY * points[int(at + 1)] + inZ * points[int(at + 2)] - from;
                if (beyond > 0 != lastBeyond > 0 && !(isSegment && at == 0))
                {
                    var share:Number = lastBeyond / (lastBeyond - beyond);
                    kept[count] = points[last] + share * (points[at] - points[last]);
                    kept[int(count + 1)] = points[int(last + 1)] + share * (points[int(at + 1)] - points[int(last + 1)]);
                    kept[int(count + 2)] = points[int(last + 2)] + share * (points[int(at + 2)] - points[int(last + 2)]);
                    count += 3;
                }
                if (beyond > 0)
                {
                    kept[count] = points[at];
                    kept[int(count + 1)] = points[int(at + 1)];
                    kept[int(count + 2)] = points[int(at + 2)];
                    count += 3;
                }
                last = at;
                lastBeyond = beyond;
            }
            _points = kept;
            _clipped = points;
            _end = count;
        }

        // Writes where two segments cross, seen along the normal, or the point of the first one that is nearest to the other's end. If they are
        // parallel, writes the middle of the part that they share.
        private static function writeCrossing(a:Vector.<Number>, b:Vector.<Number>, out:ContactPoint):void
        {
            var ux:Number = a[3] - a[0];
            var uy:Number = a[4] - a[1];
            var uz:Number = a[5] - a[2];
            var vx:Number = b[3] - b[0];
            var vy:Number = b[4] - b[1];
            var vz:Number = b[5] - b[2];
            var gapX:Number = b[0] - a[0];
            var gapY:Number = b[1] - a[1];
            var gapZ:Number = b[2] - a[2];
            var uu:Number = ux * ux + uy * uy + uz * uz;
            var vv:Number = vx * vx + vy * vy + vz * vz;
            var crossX:Number = uy * vz - uz * vy;
            var crossY:Number = uz * vx - ux * vz;
            var crossZ:Number = ux * vy - uy * vx;
            var squared:Number = crossX * crossX + crossY * crossY + crossZ * crossZ;
            var one:Number;
            var other:Number;
            if (squared > Tolerances.DIRECTION * Tolerances.DIRECTION * uu * vv)
            {
                var onB:Number = ((gapY * uz - gapZ * uy) * crossX + (gapZ * ux - gapX * uz) * crossY + (gapX * uy - gapY * ux) * crossZ) / squared;
                onB = onB > 0 ? (onB < 1 ? onB : 1) : 0;
                one = ((gapX + onB * vx) * ux + (gapY + onB * vy) * uy + (gapZ + onB * vz) * uz) / uu;
                other = one;
            }
            else
            {
                one = (gapX * ux + gapY * uy + gapZ * uz) / uu;
                other = one + (vx * ux + vy * uy + vz * uz) / uu;
            }
            one = one > 0 ? (one < 1 ? one : 1) : 0;
            other = other > 0 ? (other < 1 ? other : 1) : 0;
            var share:Number = (one + other) / 2;
            out.x = a[0] + share * ux;
            out.y = a[1] + share * uy;
            out.z = a[2] + share * uz;
        }
    }
}
