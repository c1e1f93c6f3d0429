package starlogo.fitting.hull
{
    import starlogo.bounding.Hull;
    import starlogo.engine;
    import starlogo.fitting.FitSession;
    import starlogo.geometry.Tolerances;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * The steps that make a hull of few corners, and enlarge it until it encloses every vertex of a session in double precision.
     *
     * <p>A vertex may be outside of the corners' hull by 2e-7 of its size. Then the hull is scaled about its centre. What is left is rounding, which
     * the hull's margin covers. The margin also covers vertices beside the plane of a flat hull.</p>
     *
     * @private
     */
    public final class HullEnclosure extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 1000;
        private static const MOST_SCALINGS:int = 20;

        /** The hull, when no step is left. */
        public var hull:Hull;

        private var _session:FitSession;

        /**
         * @param session the vertices; their hull may not exist before the first step
         * @param most the largest number of corners, at least 8
         */
        public function HullEnclosure(session:FitSession, most:int)
        {
            var simplification:HullSimplification = new HullSimplification(session, most);
            _session = session;
            add(simplification).call(function():void
                {
                    hull = new Hull(simplification.listCorners());
                    addRound(0);
                });
        }

        private function addRound(scalings:int):void
        {
            var heights:Vector.<Number> = new Vector.<Number>(hull.halfSpaces.length / 4);
            slices(_session.vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    measure(first, end, heights);
                }).call(function():void
                {
                    endRound(heights, scalings);
                });
        }

        // Raises the height of each half-space of the hull, along its normal, until the half-space contains the vertices from first to end.
        private function measure(first:int, end:int, heights:Vector.<Number>):void
        {
            var vertices:Vector.<Number> = _session.vertices;
            var halfSpaces:Vector.<Number> = hull.halfSpaces;
            var centerX:Number = hull.center.x;
            var centerY:Number = hull.center.y;
            var centerZ:Number = hull.center.z;
            var last:int = 3 * end;
            for (var i:int = 0; i < halfSpaces.length; i += 4)
            {
                var x:Number = halfSpaces[i];
                var y:Number = halfSpaces[i + 1];
                var z:Number = halfSpaces[i + 2];
                var most:Number = heights[i / 4];
                for (var k:int = 3 * first; k < last; k += 3)
                {
                    var height:Number = x * (vertices[k] - centerX) + y * (vertices[int(k + 1)] - centerY) + z * (vertices[int(k + 2)] - centerZ);
                    most = height > most ? height : most;
                }
                heights[i / 4] = most;
            }
        }

        private function endRound(heights:Vector.<Number>, scalings:int):void
        {
            var halfSpaces:Vector.<Number> = hull.halfSpaces;
            var rounding:Number = Tolerances.UNIT_ROUNDING * _session.hull.extent;
            var factor:Number = 1;
            var margin:Number = 0;
            for (var i:int = 0; i < heights.length; i++)
            {
                var offset:Number = halfSpaces[4 * i + 3];
                margin = Math.max(margin, heights[i] - offset);
                if (offset > 0 && heights[i] - offset > rounding)
                {
                    factor = Math.max(factor, heights[i] / offset);
                }
            }
            if (factor > 1 && scalings < MOST_SCALINGS)
            {
                hull.scaleCorners(factor);
                addRound(scalings + 1);
            }
            else
            {
                hull.widen(margin);
            }
        }
    }
}
