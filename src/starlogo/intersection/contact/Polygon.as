package starlogo.intersection.contact
{
    import starlogo.geometry.Tolerances;

    /**
     * A corner, an edge or a face in a plane where something else touches it: one point, two, or a convex polygon. Of two that touch
     * it finds a point that both have.
     *
     * @private
     */
    public final class Polygon
    {
        // four corners against four planes
        private static const MOST_NUMBERS:int = 3 * 9;

        /** The common point. */
        public var x:Number;

        /** @copy #x */
        public var y:Number;

        /** @copy #x */
        public var z:Number;

        private var _points:Vector.<Number> = new Vector.<Number>(MOST_NUMBERS, true);
        private var _end:int = 0;
        private var _clipped:Vector.<Number> = new Vector.<Number>(MOST_NUMBERS, true);

        /** No points yet. */
        public function Polygon()
        {
        }

        /** Takes all points away. */
        public function clear():void
        {
            _end = 0;
        }

        /** Becomes a point. */
        public function setPoint(x:Number, y:Number, z:Number):void
        {
            _end = 0;
            add(x, y, z);
        }

        /** Adds a corner after the others. */
        public function add(x:Number, y:Number, z:Number):void
        {
            _points[_end] = x;
            _points[int(_end + 1)] = y;
            _points[int(_end + 2)] = z;
            _end += 3;
        }

        /** Moves all points. */
        public function moveBy(x:Number, y:Number, z:Number):void
        {
            for (var at:int = 0; at < _end; at += 3)
            {
                _points[at] += x;
                _points[int(at + 1)] += y;
                _points[int(at + 2)] += z;
            }
        }

        /** A point becomes a segment, a segment a parallelogram: as far to both sides. */
        public function widenBy(x:Number, y:Number, z:Number):void
        {
            var end:int = _end;
            moveBy(-x, -y, -z);
            for (var at:int = end - 3; at >= 0; at -= 3)
            {
                add(_points[at] + 2 * x, _points[int(at + 1)] + 2 * y, _points[int(at + 2)] + 2 * z);
            }
        }

        /**
         * Finds a point that this and another have in common, seen along a normal: the middle of what they have in common, and half way
         * between the two.
         *
         * @param other in the same plane, or in one parallel to it
         * @param x the normal
         * @param y likewise
         * @param z likewise
         */
        public function findCommonPoint(other:Polygon, x:Number, y:Number, z:Number):void
        {
            var heights:Number = along(_points, x, y, z) + along(other._points, x, y, z);
            if (_end == 3)
            {
                setMiddle(_points, 3);
            }
            else if (other._end == 3)
            {
                setMiddle(other._points, 3);
            }
            else if (other._end > 6)
            {
                setMiddleWithin(this, other, x, y, z);
            }
            else if (_end > 6)
            {
                setMiddleWithin(other, this, x, y, z);
            }
            else
            {
                setCrossing(_points, other._points);
            }
            var height:Number = heights / 2 - (x * this.x + y * this.y + z * this.z);
            this.x += height * x;
            this.y += height * y;
            this.z += height * z;
        }

        private static function along(points:Vector.<Number>, x:Number, y:Number, z:Number):Number
        {
            return points[0] * x + points[1] * y + points[2] * z;
        }

        private function setMiddle(points:Vector.<Number>, end:int):void
        {
            x = y = z = 0;
            for (var at:int = 0; at < end; at += 3)
            {
                x += points[at];
                y += points[int(at + 1)];
                z += points[int(at + 2)];
            }
            x *= 3 / end;
            y *= 3 / end;
            z *= 3 / end;
        }

        // Sets the point to the middle of a segment or polygon, clipped to another polygon (Sutherland and Hodgman, "Reentrant polygon
        // clipping", 1974).
        private function setMiddleWithin(inner:Polygon, outer:Polygon, x:Number, y:Number, z:Number):void
        {
            var points:Vector.<Number> = inner._points;
            var kept:Vector.<Number> = inner._clipped;
            var end:int = inner._end;
            var edges:Vector.<Number> = outer._points;
            outer.setMiddle(edges, outer._end);
            var slack:Number = Tolerances.DIRECTION * (Math.abs(edges[0] - outer.x) + Math.abs(edges[1] - outer.y)
                    + Math.abs(edges[2] - outer.z) + Math.abs(edges[3] - outer.x) + Math.abs(edges[4] - outer.y)
                    + Math.abs(edges[5] - outer.z));
            var last:int = outer._end - 3;
            for (var at:int = 0; at < outer._end && end > 0; at += 3)
            {
                var edgeX:Number = edges[at] - edges[last];
                var edgeY:Number = edges[int(at + 1)] - edges[int(last + 1)];
                var edgeZ:Number = edges[int(at + 2)] - edges[int(last + 2)];
                // inwards, in the plane
                var inX:Number = edgeY * z - edgeZ * y;
                var inY:Number = edgeZ * x - edgeX * z;
                var inZ:Number = edgeX * y - edgeY * x;
                var from:Number = inX * edges[at] + inY * edges[int(at + 1)] + inZ * edges[int(at + 2)];
                if (inX * outer.x + inY * outer.y + inZ * outer.z < from)
                {
                    inX = -inX;
                    inY = -inY;
                    inZ = -inZ;
                    from = -from;
                }
                from -= slack * Math.sqrt(inX * inX + inY * inY + inZ * inZ);
                end = cut(points, end, kept, inX, inY, inZ, from);
                var swapped:Vector.<Number> = points;
                points = kept;
                kept = swapped;
                last = at;
            }
            inner._points = points;
            inner._clipped = kept;
            if (end == 0)
            {
                // they do not touch
                setMiddle(edges, outer._end);
                return;
            }
            setMiddle(points, end);
        }

        // Keeps what lies beyond a plane; returns the end of it.
        private static function cut(points:Vector.<Number>, end:int, kept:Vector.<Number>, x:Number, y:Number, z:Number,
                from:Number):int
        {
            var count:int = 0;
            var last:int = end - 3;
            var lastBeyond:Number = x * points[last] + y * points[int(last + 1)] + z * points[int(last + 2)] - from;
            // a segment is no closed line
            var isSegment:Boolean = end == 6;
            for (var at:int = 0; at < end; at += 3)
            {
                var beyond:Number = x * points[at] + y * points[int(at + 1)] + z * points[int(at + 2)] - from;
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
            return count;
        }

        // Where two segments cross; the middle of what they have in common where they are parallel.
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
