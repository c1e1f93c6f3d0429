package starlogo.fitting.hull
{
    import starlogo.bounding.Hull;
    import starlogo.engine;
    import starlogo.fitting.FitSession;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * The steps that scale a hull until it encloses every vertex of a session in double precision.
     *
     * <p>A vertex may be outside of the corners' hull by 2e-7 of its size. The hull is scaled about its centre until all half-spaces hold all
     * vertices. Rounding errors count, because a vertex that is hardly above two faces is far from their edge if that is sharp. Scaling does not help
     * a flat hull against vertices beside its plane. So its margin covers these. It also covers vertices that are still outside after many
     * scalings.</p>
     *
     * @private
     */
    public final class HullEnclosure extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 1000;

        // The hull is scaled by this fraction more than it needs. Rounding may leave a vertex outside, so the fraction is doubled each time.
        private static const FIRST_EXCESS:Number = 1e-15;
        private static const MAX_SCALINGS:int = 20;

        /** The hull, when no step is left. */
        public var hull:Hull;

        private var _session:FitSession;

        /**
         * @param session the vertices, whose hull exists
         * @param corners of the hull to begin with
         */
        public function HullEnclosure(session:FitSession, corners:Vector.<Number>)
        {
            _session = session;
            hull = new Hull(corners);
            // Most hulls need to be scaled. So the first rounds measure the few vertices of the convex hull, and only the last ones measure all.
            addRound(session.hull.points, 0);
        }

        private function addRound(vertices:Vector.<Number>, scalings:int):void
        {
            var heights:Vector.<Number> = new Vector.<Number>(hull.halfSpaces.length / 4);
            slices(vertices.length / 3, VERTICES_PER_STEP, function(first:int, end:int):void
                {
                    measure(vertices, first, end, heights);
                }).call(function():void
                {
                    endRound(vertices, heights, scalings);
                });
        }

        // Raises the height of each half-space of the hull, along its normal, until the half-space contains the vertices from first to end.
        private function measure(vertices:Vector.<Number>, first:int, end:int, heights:Vector.<Number>):void
        {
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
                var highest:Number = heights[i / 4];
                for (var k:int = 3 * first; k < last; k += 3)
                {
                    var height:Number = x * (vertices[k] - centerX) + y * (vertices[int(k + 1)] - centerY) + z * (vertices[int(k + 2)] - centerZ);
                    highest = height > highest ? height : highest;
                }
                heights[i / 4] = highest;
            }
        }

        private function endRound(vertices:Vector.<Number>, heights:Vector.<Number>, scalings:int):void
        {
            var halfSpaces:Vector.<Number> = hull.halfSpaces;
            var factor:Number = 1;
            for (var i:int = 0; i < heights.length; i++)
            {
                var offset:Number = halfSpaces[4 * i + 3];
                if (offset > 0 && scalings < MAX_SCALINGS)
                {
                    factor = Math.max(factor, heights[i] / offset);
                }
                else
                {
                    hull.widen(Math.max(0, heights[i] - offset - hull.radius));
                }
            }
            if (factor > 1)
            {
                hull.scaleCorners(factor * (1 + FIRST_EXCESS * (1 << scalings)));
                addRound(vertices, scalings + 1);
            }
            else if (vertices != _session.vertices)
            {
                addRound(_session.vertices, scalings);
            }
        }
    }
}
