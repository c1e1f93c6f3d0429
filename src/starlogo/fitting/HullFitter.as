package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.hull.HullEnclosure;
    import starlogo.fitting.hull.HullSimplification;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.vertices.VertexBounds;
    import starlogo.steps.Steps;
    import starlogo.steps.StepSequence;

    /**
     * Finds a convex hull of few corners around all vertices. It is beyond the thesis. No other convex shape around a model is smaller than
     * its convex hull, but that may have hundreds of corners, and each makes a test slower. This hull is a few percent larger as a mean
     * of many models. If rounding stops the search, it is a box. Its volume is never larger than that of the axis-aligned box.
     *
     * <p>It begins with the convex hull of the vertices, and collapses edges until few corners are left. A corner outside of all faces
     * at both ends takes the place of an edge, where the hull grows least (progressive hulls: Sander and others, "Silhouette Clipping",
     * SIGGRAPH 2000). The next edge is always the one that makes the hull grow least.</p>
     *
     * <p>Vertices in a plane get a polygon. Vertices on a line get a segment, and vertices in one place get a point. All vertices are
     * inside, up to rounding: Tolerances.ROUNDING times the sum of its coordinates. The cost is n log n for n vertices.</p>
     */
    public final class HullFitter extends Fitter
    {
        /** The smallest number of corners that may be asked for. A box has 8 corners. */
        public static const LEAST_CORNERS:int = 8;

        private var _maxCorners:int;

        /**
         * Creates a fitter.
         *
         * @param maxCorners the most corners that a hull may have, at least 8. 16 corners give hulls that are 7 percent larger than the
         *     full hull, and 32 corners 2 percent, as the mean of many models. Twice the corners make a test half as slow again
         * @throws RangeError if there are fewer than 8
         */
        public function HullFitter(maxCorners:int = 16)
        {
            if (maxCorners < LEAST_CORNERS)
            {
                throw new RangeError("a hull needs to have " + LEAST_CORNERS + " corners or more: " + maxCorners);
            }
            _maxCorners = maxCorners;
        }

        /** The most corners that a hull may have. */
        public function get maxCorners():int
        {
            return _maxCorners;
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return "hull " + _maxCorners;
        }

        /** @inheritDoc */
        override public function fitting(session:FitSession):Fit
        {
            var simplification:HullSimplification = new HullSimplification(session, _maxCorners);
            var enclosure:HullEnclosure;
            var work:StepSequence = new StepSequence().add(simplification).begin(function():Steps
                {
                    enclosure = new HullEnclosure(session, simplification.listCorners());
                    return enclosure;
                }).begin(function():Steps
                {
                    var box:VertexBounds = VertexBounds.of(session.hull.points);
                    var isLarger:Boolean = box.extentX * box.extentY * box.extentZ < (1 - Tolerances.FIT_TIE) * enclosure.hull.volume;
                    enclosure = isLarger ? new HullEnclosure(session, cornersOf(box)) : enclosure;
                    return enclosure;
                });
            return new Fit(session, function(session:FitSession):BoundingStructure
                {
                    return enclosure.hull;
                }, work);
        }

        private static function cornersOf(box:VertexBounds):Vector.<Number>
        {
            var corners:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 8; i++)
            {
                corners.push((i & 1) == 0 ? box.minX : box.maxX, (i & 2) == 0 ? box.minY : box.maxY, (i & 4) == 0 ? box.minZ : box.maxZ);
            }
            return corners;
        }
    }
}
