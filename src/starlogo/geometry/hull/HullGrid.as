package starlogo.geometry.hull
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.VertexBounds;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Rounds vertices to QuickHull's grid of whole numbers along three axes. Vertices in a plane are put on the grid's floor. One more
     * point, the last one, is then above them, so that all points span a volume.
     *
     * @private
     */
    public final class HullGrid
    {
        private static const VERTICES_PER_STEP:int = 2000;

        /**
         * The steps that round them.
         *
         * @param vertices x, y, z of each; they must differ along each of the axes
         * @param axes perpendicular unit vectors, three numbers each; null for the coordinate axes
         * @param bounds around the vertices
         * @param isPlane whether the vertices are in the plane of the first two axes
         * @param points takes the vertices on the grid, three whole numbers each, from 0 to QuickHull.GRID; as long as the vertices
         */
        public static function rounding(vertices:Vector.<Number>, axes:Vector.<Number>, bounds:VertexBounds, isPlane:Boolean,
                points:Vector.<Number>):StepSequence
        {
            if (isPlane)
            {
                points.push(QuickHull.GRID / 2, QuickHull.GRID / 2, QuickHull.GRID);
            }
            var work:StepSequence = new StepSequence();
            var count:int = vertices.length / 3;
            var from:Vector.<Number> = vertices;
            if (axes != null)
            {
                var turning:Placement = new Placement();
                turning.readRotation(axes, 0);
                bounds = new VertexBounds();
                from = points;
                work.slices(count, VERTICES_PER_STEP, function(first:int, end:int):void
                    {
                        turning.placePoints(vertices, 3 * first, 3 * end, points, 3 * first);
                        bounds.add(points, first, end);
                    });
            }
            return work.slices(count, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    snap(from, 3 * first, 3 * end, bounds.minX, bounds.maxX, false, points);
                    snap(from, 3 * first + 1, 3 * end, bounds.minY, bounds.maxY, false, points);
                    snap(from, 3 * first + 2, 3 * end, bounds.minZ, bounds.maxZ, isPlane, points);
                });
        }

        // Rounds every third of the numbers from one index up to another, which are between two limits.
        private static function snap(from:Vector.<Number>, first:int, last:int, low:Number, high:Number, isFlat:Boolean, points:Vector.<Number>):void
        {
            var scale:Number = isFlat ? 0 : QuickHull.GRID / (high - low);
            for (var i:int = first; i < last; i += 3)
            {
                points[i] = int((from[i] - low) * scale + 0.5);
            }
        }
    }
}
