package starlogo.debug
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Trigonometry;

    /** Appends lines to a list. */
    internal final class LinePen
    {
        private static const SEGMENTS:int = 32;

        /** Six numbers for each line. */
        public var lines:Vector.<Number>;

        /** @param lines takes the lines; created if null */
        public function LinePen(lines:Vector.<Number>)
        {
            this.lines = lines == null ? new Vector.<Number>() : lines;
        }

        /** A point moved by atA along a, and by atB along b. */
        public static function along(from:Vector3D, a:Vector3D, atA:Number, b:Vector3D, atB:Number):Vector3D
        {
            return new Vector3D(from.x + a.x * atA + b.x * atB, from.y + a.y * atA + b.y * atB, from.z + a.z * atA + b.z * atB);
        }

        /** Appends a line, if it has a length. */
        public function drawLine(from:Vector3D, to:Vector3D):void
        {
            if (!from.equals(to))
            {
                lines.push(from.x, from.y, from.z, to.x, to.y, to.z);
            }
        }

        /** Appends a part of a circle as lines, from direction a towards b. Both are unit vectors at right angles. */
        public function drawArc(center:Vector3D, a:Vector3D, b:Vector3D, radius:Number, degrees:int = 360):void
        {
            var from:Vector3D = along(center, a, radius, b, 0);
            for (var i:int = 1; 360 * i <= degrees * SEGMENTS; i++)
            {
                var angle:Number = 360 * i / SEGMENTS;
                var to:Vector3D = along(center, a, radius * Trigonometry.cosine(angle), b, radius * Trigonometry.sine(angle));
                drawLine(from, to);
                from = to;
            }
        }
    }
}
