package starlogo.debug
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Trigonometry;

    /** Draws lines into a list: about a centre, along axes u, v and w at right angles to each other. */
    internal final class LinePen
    {
        private static const SEGMENTS:int = 32;

        /** Six numbers a line. */
        public var lines:Vector.<Number>;

        private var _center:Vector3D = new Vector3D();
        private var _u:Vector3D = new Vector3D();
        private var _v:Vector3D = new Vector3D();
        private var _w:Vector3D = new Vector3D();

        /**
         * @param lines added to; made if null
         */
        public function LinePen(lines:Vector.<Number>)
        {
            this.lines = lines == null ? new Vector.<Number>() : lines;
        }

        /** Sets the centre; it is not copied. */
        public function moveTo(center:Vector3D):void
        {
            _center = center;
        }

        /** Sets u and v, unit vectors at right angles. */
        public function setAxes(ux:Number, uy:Number, uz:Number, vx:Number, vy:Number, vz:Number):void
        {
            _u.setTo(ux, uy, uz);
            _v.setTo(vx, vy, vz);
            _w = _u.crossProduct(_v);
        }

        /** Sets w from one point to another, u and v across it; if the points are the same, sets the world's axes and returns false. */
        public function setAxesAcross(start:Vector3D, end:Vector3D):Boolean
        {
            var x:Number = end.x - start.x;
            var y:Number = end.y - start.y;
            var z:Number = end.z - start.z;
            // the largest first: squares neither vanish nor overflow
            var largest:Number = Math.max(Math.abs(x), Math.abs(y), Math.abs(z));
            if (!(largest > 0))
            {
                setAxes(1, 0, 0, 0, 1, 0);
                return false;
            }
            _w = new Vector3D(x / largest, y / largest, z / largest);
            _w.normalize();
            _u = (Math.abs(_w.z) < 0.7 ? Vector3D.Z_AXIS : Vector3D.X_AXIS).crossProduct(_w);
            _u.normalize();
            _v = _w.crossProduct(_u);
            return true;
        }

        /** A circle about the centre, along u and v. */
        public function drawCircle(radius:Number):void
        {
            drawArc(_u, _v, radius, SEGMENTS);
        }

        /** Two half-circles about the centre from u and v over w, or over -w if the radius is negative. */
        public function drawDome(radius:Number):void
        {
            drawArc(_u, _w, radius, SEGMENTS / 2);
            drawArc(_v, _w, radius, SEGMENTS / 2);
        }

        /** Four lines from around one point to around another, at this distance along u and v, either way. */
        public function drawSides(start:Vector3D, end:Vector3D, radius:Number):void
        {
            drawSide(start, end, _u, radius);
            if (radius > 0)
            {
                drawSide(start, end, _u, -radius);
                drawSide(start, end, _v, radius);
                drawSide(start, end, _v, -radius);
            }
        }

        /** An edge of a box about the centre: along a, at a distance from the centre along b and c. */
        public function drawEdge(a:Vector3D, half:Number, b:Vector3D, atB:Number, c:Vector3D, atC:Number):void
        {
            var x:Number = _center.x + b.x * atB + c.x * atC;
            var y:Number = _center.y + b.y * atB + c.y * atC;
            var z:Number = _center.z + b.z * atB + c.z * atC;
            drawLine(x - a.x * half, y - a.y * half, z - a.z * half, x + a.x * half, y + a.y * half, z + a.z * half);
        }

        /** A line, if it has a length. */
        public function drawLine(fromX:Number, fromY:Number, fromZ:Number, x:Number, y:Number, z:Number):void
        {
            if (fromX != x || fromY != y || fromZ != z)
            {
                lines.push(fromX, fromY, fromZ, x, y, z);
            }
        }

        private function drawSide(start:Vector3D, end:Vector3D, across:Vector3D, distance:Number):void
        {
            var x:Number = across.x * distance;
            var y:Number = across.y * distance;
            var z:Number = across.z * distance;
            drawLine(start.x + x, start.y + y, start.z + z, end.x + x, end.y + y, end.z + z);
        }

        // From a towards b, by so many segments of a circle.
        private function drawArc(a:Vector3D, b:Vector3D, radius:Number, count:int):void
        {
            var fromX:Number = _center.x + a.x * radius;
            var fromY:Number = _center.y + a.y * radius;
            var fromZ:Number = _center.z + a.z * radius;
            for (var i:int = 1; i <= count; i++)
            {
                var angle:Number = 360 * i / SEGMENTS;
                var alongA:Number = radius * Trigonometry.cosine(angle);
                var alongB:Number = radius * Trigonometry.sine(angle);
                var x:Number = _center.x + a.x * alongA + b.x * alongB;
                var y:Number = _center.y + a.y * alongA + b.y * alongB;
                var z:Number = _center.z + a.z * alongA + b.z * alongB;
                drawLine(fromX, fromY, fromZ, x, y, z);
                fromX = x;
                fromY = y;
                fromZ = z;
            }
        }
    }
}
