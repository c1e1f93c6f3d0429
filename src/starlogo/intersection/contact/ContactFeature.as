package starlogo.intersection.contact
{
    import starlogo.convex.ContactPoint;
    import starlogo.geometry.Tolerances;

    /**
     * The feature of a shape that touches another shape: a point, a segment or a convex polygon. Finds a point that two touching features
     * have in common.
     *
     * @private
     */
    public final class ContactFeature
    {
        // Room for four corners, one more corner for each of four clips, and a spare one.
        private static const MOST_NUMBERS:int = 3 * 9;

        /** The common point. */
        public var x:Number;
        public var y:Number;
        public var z:Number;

        // Arguments of the next call. Fields, because V8 would allocate objects for Numbers that are passed.
        private var _stepX:Number = 0;
        private var _stepY:Number = 0;
        private var _stepZ:Number = 0;

        private var _points:Vector.<Number> = new Vector.<Number>(MOST_NUMBERS, true);
        private var _end:int = 0;
        private var _clipped:Vector.<Number> = new Vector.<Number>(MOST_NUMBERS, true);

        /** Removes all points. */
        public function clear():void
        {
            _end = 0;
        }

        /** Sets the vector that the next calls use. */
        public function setVector(x:Number, y:Number, z:Number):void
        {
            _stepX = x;
            _stepY = y;
            _stepZ = z;
        }

        /** Adds the vector's end as a corner after the others. */
        public function add():void
        {
            _points[_end] = _stepX;
            _points[int(_end + 1)] = _stepY;
            _points[int(_end + 2)] = _stepZ;
            _end += 3;
        }

        /** Moves all points by the vector. */
        public function move():void
        {
            for (var at:int = 0; at < _end; at += 3)
            {
                _points[at] += _stepX;
                _points[int(at + 1)] += _stepY;
                _points[int(at + 2)] += _stepZ;
            }
        }

        /** Extends the polygon by the vector to both sides: a point becomes a segment, and a segment becomes a parallelogram. */
        public function widen():void
        {
            var points:Vector.<Number> = _points;
            for (var at:int = _end - 3; at >= 0; at -= 3)
            {
                points[at] -= _stepX;
                points[int(at + 1)] -= _stepY;
                points[int(at + 2)] -= _stepZ;
                points[_end] = points[at] + 2 * _stepX;
                points[int(_end + 1)] = points[int(at + 1)] + 2 * _stepY;
                points[int(_end + 2)] = points[int(at + 2)] + 2 * _stepZ;
                _end += 3;
            }
        }

        /**
         * Finds the middle of the area that two polygons share when seen along a normal. The point is halfway between the two polygons.
         *
         * @param other in the same plane, or in a parallel one
         * @param contact has the normal
         */
        public function findCommonPoint(other:ContactFeature, contact:ContactPoint):void
        {
            var normalX:Number = contact.normalX;
            var normalY:Number = contact.normalY;
            var normalZ:Number = contact.normalZ;
            var a:Vector.<Number> = _points;
            var b:Vector.<Number> = other._points;
            var heights:Number = a[0] * normalX + a[1] * normalY + a[2] * normalZ + (b[0] * normalX + b[1] * normalY + b[2] * normalZ);
            var found:ContactFeature = this;
            if (_end == 3)
            {
                setMiddle();
            }
            else if (other._end == 3)
            {
                found = other;
                other.setMiddle();
            }
            else if (other._end > 6)
            {
                setMiddleWithin(other, contact);
            }
            else if (_end > 6)
            {
                found = other;
                other.setMiddleWithin(this, contact);
            }
            else
            {
                setCrossing(a, b);
            }
            var height:Number = heights / 2 - (normalX * found.x + normalY * found.y + normalZ * found.z);
            x = found.x + height * normalX;
            y = found.y + height * normalY;
            z = found.z + height * normalZ;
        }

        private function setMiddle():void
        {
            x = y = z = 0;
            for (var at:int = 0; at < _end; at += 3)
            {
                x += _points[at];
                y += _points[int(at + 1)];
                z += _points[int(at + 2)];
            }
            x *= 3 / _end;
            y *= 3 / _end;
            z *= 3 / _end;
        }

        // Sets the point to the middle of this segment or polygon after clipping it to another polygon (Sutherland and Hodgman, "Reentrant
        // polygon clipping", 1974).
        private function setMiddleWithin(outer:ContactFeature, contact:ContactPoint):void
        {
            outer.setMiddle();
            var last:int = outer._end - 3;
            for (var at:int = 0; at < outer._end && _end > 0; at += 3)
            {
                cut(outer, last, at, contact);
                last = at;
            }
            if (_end > 0)
            {
                setMiddle();
                return;
            }
            // The polygons do not overlap.
            x = outer.x;
            y = outer.y;
            z = outer.z;
        }

        // Keeps the part on the inner side of an edge of the outer polygon, whose middle has been set.
        private function cut(outer:ContactFeature, edgeFrom:int, edgeTo:int, contact:ContactPoint):void
        {
            var points:Vector.<Number> = _points;
            var kept:Vector.<Number> = _clipped;
            var edges:Vector.<Number> = outer._points;
            var slack:Number = Tolerances.DIRECTION * (Math.abs(edges[0] - outer.x) + Math.abs(edges[1] - outer.y)
                    + Math.abs(edges[2] - outer.z) + Math.abs(edges[3] - outer.x) + Math.abs(edges[4] - outer.y)
                    + Math.abs(edges[5] - outer.z));
            var edgeX:Number = edges[edgeTo] - edges[edgeFrom];
            var edgeY:Number = edges[int(edgeTo + 1)] - edges[int(edgeFrom + 1)];
            var edgeZ:Number = edges[int(edgeTo + 2)] - edges[int(edgeFrom + 2)];
            // The vector points inwards, in the plane.
            var inX:Number = edgeY * contact.normalZ - edgeZ * contact.normalY;
            var inY:Number = edgeZ * contact.normalX - edgeX * contact.normalZ;
            var inZ:Number = edgeX * contact.normalY - edgeY * contact.normalX;
            var from:Number = inX * edges[edgeTo] + inY * edges[int(edgeTo + 1)] + inZ * edges[int(edgeTo + 2)];
            if (inX * outer.x + inY * outer.y + inZ * outer.z < from)
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

        // Sets the point to where two segments cross. If they are parallel, sets it to the middle of the part that they share.
        private function setCrossing(a:Vector.<Number>, b:Vector.<Number>):void
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
            var share:Number;
            if (squared > Tolerances.DIRECTION * Tolerances.DIRECTION * uu * vv)
            {
                share = (gapY * vz - gapZ * vy) * crossX + (gapZ * vx - gapX * vz) * crossY + (gapX * vy - gapY * vx) * crossZ;
                share /= squared;
                share = share > 0 ? (share < 1 ? share : 1) : 0;
            }
            else
            {
                var one:Number = (gapX * ux + gapY * uy + gapZ * uz) / uu;
                var other:Number = one + (vx * ux + vy * uy + vz * uz) / uu;
                one = one > 0 ? (one < 1 ? one : 1) : 0;
                other = other > 0 ? (other < 1 ? other : 1) : 0;
                share = (one + other) / 2;
            }
            x = a[0] + share * ux;
            y = a[1] + share * uy;
            z = a[2] + share * uz;
        }
    }
}
