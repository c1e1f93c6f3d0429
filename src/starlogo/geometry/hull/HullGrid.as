package starlogo.geometry.hull
{
    import starlogo.steps.StepSequence;

    /**
     * Rounds vertices to QuickHull's grid of whole numbers along three axes. Vertices in a plane are put on the grid's floor. One more
     * point, the last one, is then above them, so that all points span a volume.
     *
     * @private
     */
    public final class HullGrid
    {
        private static const VERTICES_PER_STEP:int = 4000;

        /**
         * The steps that round them.
         *
         * @param vertices x, y, z of each; they must differ along each of the axes
         * @param axes perpendicular unit vectors, three numbers each
         * @param isPlane whether the vertices are in the plane of the first two axes
         * @param points takes the vertices on the grid, three whole numbers each, from 0 to QuickHull.GRID; as long as the vertices
         */
        public static function rounding(vertices:Vector.<Number>, axes:Vector.<Number>, isPlane:Boolean, points:Vector.<Number>):StepSequence
        {
            if (isPlane)
            {
                points.push(QuickHull.GRID / 2, QuickHull.GRID / 2, QuickHull.GRID);
            }
            var work:StepSequence = new StepSequence();
            for (var axis:int = 0; axis < 3; axis++)
            {
                addAxis(work, vertices, axes.slice(3 * axis, 3 * axis + 3), isPlane && axis == 2, points, axis);
            }
            return work;
        }

        private static function addAxis(work:StepSequence, vertices:Vector.<Number>, axis:Vector.<Number>, isFlat:Boolean,
                points:Vector.<Number>, place:int):void
        {
            // the smallest and the largest place of the vertices on the axis
            var extent:Vector.<Number> = new <Number>[Infinity, -Infinity];
            work.slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    measure(vertices, first, end, axis, extent, points, place);
                }).slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    snap(points, 3 * first + place, 3 * end, extent[0], isFlat ? 0 : QuickHull.GRID / (extent[1] - extent[0]));
                });
        }

        // Writes the vertices' places along an axis, before rounding. Widens the extent.
        private static function measure(vertices:Vector.<Number>, first:int, end:int, axis:Vector.<Number>, extent:Vector.<Number>,
                places:Vector.<Number>, place:int):void
        {
            var axisX:Number = axis[0];
            var axisY:Number = axis[1];
            var axisZ:Number = axis[2];
            var low:Number = extent[0];
            var high:Number = extent[1];
            var to:int = 3 * first + place;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var t:Number = vertices[i] * axisX + vertices[int(i + 1)] * axisY + vertices[int(i + 2)] * axisZ;
                places[to] = t;
                to += 3;
                if (t < low)
                {
                    low = t;
                }
                if (t > high)
                {
                    high = t;
                }
            }
            extent[0] = low;
            extent[1] = high;
        }

        // Rounds every third of the numbers from one index up to another.
        private static function snap(places:Vector.<Number>, first:int, last:int, low:Number, scale:Number):void
        {
            for (var i:int = first; i < last; i += 3)
            {
                places[i] = int((places[i] - low) * scale + 0.5);
            }
        }
    }
}
