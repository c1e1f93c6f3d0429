package starlogo.bounding
{
    import flash.geom.Vector3D;
    import starlogo.geometry.hull.ConvexHull;
    import starlogo.geometry.hull.edgesAcross;
    import starlogo.geometry.Tolerances;

    /**
     * Which corners of a hull make its faces and edges. All copies of a hull share it, because a placement moves only the corners. A corner
     * is given as the index of its first number in the hull's points, so it is a multiple of 3.
     *
     * @private
     */
    public final class HullTopology
    {
        /** 3 for a solid hull, 2 for a flat one, 1 for a segment, 0 for a point. */
        public var dimension:int;

        /**
         * Three corners for each triangle of the surface, counter-clockwise seen from outside. The surface of a flat hull is its front and
         * its back. A segment and a point have none.
         */
        public var faces:Vector.<int>;

        /**
         * Four corners for each edge: its two ends, one more corner of the face on its left, and one of the face on its right. A
         * segment has one edge, with its start in place of the latter two. Edges inside of a flat side are left out.
         */
        public var edges:Vector.<int>;

        /**
         * @param dimension 0 to 3
         * @param faces three corners each
         * @param edges four corners each
         */
        public function HullTopology(dimension:int, faces:Vector.<int>, edges:Vector.<int>)
        {
            this.dimension = dimension;
            this.faces = faces;
            this.edges = edges;
        }

        /** The faces and edges of a complete ConvexHull. Its corners have the same order. */
        public static function of(hull:ConvexHull):HullTopology
        {
            switch (hull.dimension)
            {
                case 3:
                    return new HullTopology(3, coordinateIndices(hull.triangles), edgesOf(hull));
                case 2:
                    return ofPolygon(coordinateIndices(hull.outline));
                case 1:
                    return new HullTopology(1, new Vector.<int>(), new <int>[0, 3, 0, 0]);
                default:
                    return new HullTopology(0, new Vector.<int>(), new Vector.<int>());
            }
        }

        private static function ofPolygon(outline:Vector.<int>):HullTopology
        {
            var count:int = outline.length;
            var triangles:Vector.<int> = new Vector.<int>();
            var borders:Vector.<int> = new Vector.<int>();
            for (var i:int = 2; i < count; i++)
            {
                triangles.push(outline[0], outline[i - 1], outline[i], outline[0], outline[i], outline[i - 1]);
            }
            for (i = 0; i < count; i++)
            {
                var beyond:int = outline[(i + 2) % count];
                borders.push(outline[i], outline[(i + 1) % count], beyond, beyond);
            }
            return new HullTopology(2, triangles, borders);
        }

        // The edges between triangles that are not in one plane.
        private static function edgesOf(hull:ConvexHull):Vector.<int>
        {
            var found:Vector.<int> = new Vector.<int>();
            var corners:Vector.<int> = coordinateIndices(hull.triangles);
            var across:Vector.<int> = edgesAcross(hull.triangles, hull.indices.length);
            for (var i:int = 0; i < across.length; i++)
            {
                var first:int = i - i % 3;
                var end:int = corners[first + (i + 1) % 3];
                var left:int = corners[first + (i + 2) % 3];
                var other:int = across[i];
                var right:int = corners[other - other % 3 + (other + 2) % 3];
                if (i < other && !isInFlatSide(hull.points, corners[i], end, left, right))
                {
                    found.push(corners[i], end, left, right);
                }
            }
            return found;
        }

        // Whether the two triangles at an edge are parts of one flat side: their normals are the same, up to rounding. At a knife's edge they are opposite.
        private static function isInFlatSide(points:Vector.<Number>, start:int, end:int, left:int, right:int):Boolean
        {
            var along:Vector3D = between(points, start, end);
            var toRight:Vector3D = between(points, start, right);
            var ofLeft:Vector3D = along.crossProduct(between(points, start, left));
            var ofRight:Vector3D = toRight.crossProduct(along);
            // the sine of the angle between the normals, times their lengths
            var turn:Number = Math.abs(ofLeft.dotProduct(toRight)) * along.length;
            return ofLeft.dotProduct(ofRight) > 0 && turn <= Tolerances.UNIT_ROUNDING * ofLeft.length * ofRight.length;
        }

        private static function between(points:Vector.<Number>, from:int, to:int):Vector3D
        {
            return new Vector3D(points[to] - points[from], points[to + 1] - points[from + 1], points[to + 2] - points[from + 2]);
        }

        private static function coordinateIndices(corners:Vector.<int>):Vector.<int>
        {
            var indices:Vector.<int> = new Vector.<int>(corners.length, true);
            for (var i:int = 0; i < corners.length; i++)
            {
                indices[i] = 3 * corners[i];
            }
            return indices;
        }
    }
}
