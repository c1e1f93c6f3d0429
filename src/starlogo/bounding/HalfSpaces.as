package starlogo.bounding
{
    /**
     * Finds the half-spaces whose intersection is the hull of some corners. A half-space has four numbers: an outward unit normal, and how
     * far its plane is from the hull's centre along the normal.
     *
     * @private
     */
    public final class HalfSpaces
    {
        /**
         * Writes all half-spaces. Those whose planes go through the centre come first: none for a solid hull, two for a flat one, four for a
         * segment, six for a point.
         *
         * @param points the corners relative to the centre, x, y, z of each
         * @param topology their faces and edges
         * @param out empty; receives four numbers for each half-space
         */
        public static function find(points:Vector.<Number>, topology:HullTopology, out:Vector.<Number>):void
        {
            switch (topology.dimension)
            {
                case 3:
                    addFaces(points, topology.faces, out);
                    break;
                case 2:
                    addPolygon(points, topology, out);
                    break;
                case 1:
                    addSegment(points, out);
            }
            if (out.length == 0)
            {
                // a point, or rounding has left no area
                out.push(1, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 0);
            }
        }

        private static function addFaces(points:Vector.<Number>, faces:Vector.<int>, out:Vector.<Number>):void
        {
            for (var i:int = 0; i < faces.length; i += 3)
            {
                var a:int = faces[i];
                var b:int = faces[i + 1];
                var c:int = faces[i + 2];
                var abX:Number = points[b] - points[a];
                var abY:Number = points[b + 1] - points[a + 1];
                var abZ:Number = points[b + 2] - points[a + 2];
                var acX:Number = points[c] - points[a];
                var acY:Number = points[c + 1] - points[a + 1];
                var acZ:Number = points[c + 2] - points[a + 2];
                add(abY * acZ - abZ * acY, abZ * acX - abX * acZ, abX * acY - abY * acX, points, out);
            }
        }

        // The front and the back, then one half-space across each edge.
        private static function addPolygon(points:Vector.<Number>, topology:HullTopology, out:Vector.<Number>):void
        {
            // twice the polygon's area along its normal (Newell)
            var x:Number = 0;
            var y:Number = 0;
            var z:Number = 0;
            var edges:Vector.<int> = topology.edges;
            for (var i:int = 0; i < edges.length; i += 4)
            {
                var a:int = edges[i];
                var b:int = edges[i + 1];
                x += points[a + 1] * points[b + 2] - points[a + 2] * points[b + 1];
                y += points[a + 2] * points[b] - points[a] * points[b + 2];
                z += points[a] * points[b + 1] - points[a + 1] * points[b];
            }
            addThroughCentre(x, y, z, out);
            if (out.length == 0)
            {
                return;
            }
            // the unit normal, because products of three lengths have squares that are infinite or 0
            x = out[0];
            y = out[1];
            z = out[2];
            for (i = 0; i < edges.length; i += 4)
            {
                a = edges[i];
                b = edges[i + 1];
                var alongX:Number = points[b] - points[a];
                var alongY:Number = points[b + 1] - points[a + 1];
                var alongZ:Number = points[b + 2] - points[a + 2];
                add(alongY * z - alongZ * y, alongZ * x - alongX * z, alongX * y - alongY * x, points, out);
            }
        }

        private static function addSegment(points:Vector.<Number>, out:Vector.<Number>):void
        {
            var x:Number = points[3] - points[0];
            var y:Number = points[4] - points[1];
            var z:Number = points[5] - points[2];
            // a direction across the segment, from the coordinate axis that is farthest from the segment
            var isX:Boolean = Math.abs(x) <= Math.abs(y) && Math.abs(x) <= Math.abs(z);
            var isY:Boolean = !isX && Math.abs(y) <= Math.abs(z);
            var acrossX:Number = isX ? 0 : isY ? -z : y;
            var acrossY:Number = isX ? z : isY ? 0 : -x;
            var acrossZ:Number = isX ? -y : isY ? x : 0;
            addThroughCentre(acrossX, acrossY, acrossZ, out);
            addThroughCentre(y * acrossZ - z * acrossY, z * acrossX - x * acrossZ, x * acrossY - y * acrossX, out);
            add(-x, -y, -z, points, out);
            add(x, y, z, points, out);
        }

        // Adds the half-space of a direction that just contains all corners. The normal of a needle is a rounding error, so its plane may be
        // below other corners.
        private static function add(x:Number, y:Number, z:Number, points:Vector.<Number>, out:Vector.<Number>):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length == 0)
            {
                return;
            }
            x /= length;
            y /= length;
            z /= length;
            var most:Number = 0;
            for (var i:int = 0; i < points.length; i += 3)
            {
                var along:Number = x * points[i] + y * points[i + 1] + z * points[i + 2];
                most = along > most ? along : most;
            }
            out.push(x, y, z, most);
        }

        // Adds the half-spaces on both sides of the plane through the centre with a normal of any length; none if rounding has left no length.
        private static function addThroughCentre(x:Number, y:Number, z:Number, out:Vector.<Number>):void
        {
            var length:Number = Math.sqrt(x * x + y * y + z * z);
            if (length > 0)
            {
                out.push(x / length, y / length, z / length, 0, -x / length, -y / length, -z / length, 0);
            }
        }
    }
}
