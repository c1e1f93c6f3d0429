package starlogo.ground
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.geometry.Tolerances;

    /**
     * Decides about most agents, in a tenth of the time of a full test, whether they touch the ground. It knows the answer for
     *
     * <ul>
     * <li>agents whose middle is in the ground, if it is in the agent too</li>
     * <li>agents that are higher above the ground than the steepest slope near them allows</li>
     * </ul>
     *
     * @private
     */
    public final class GroundEarlyOut
    {
        /** An answer: the agent is apart from the ground. */
        public static const APART:int = 0;

        /** An answer: the agent touches the ground. */
        public static const TOUCHING:int = 1;

        /** No answer. Only a test of the agent's shape decides. */
        public static const UNKNOWN:int = 2;

        // The place under the agent's middle, and bounds of the heights around.
        private var _under:GroundPoint = new GroundPoint();
        private var _heightsAround:HeightBounds = new HeightBounds();

        /**
         * Decides about an agent. Nothing is known about trees, about hulls whose extents have their middle in the ground, and about agents whose middle
         * is outside of the terrain or over a hole.
         *
         * @param grid the ground
         * @param extents of the agent, in the world
         * @param kind of the agent
         * @return one of the three answers
         */
        public function decide(grid:HeightGrid, extents:GroundBox, kind:int):int
        {
            // Kinds above HULL are ModelShape's: trees, whose nodes may extend beyond their extents, and structures of other kinds.
            if (kind > BoundingStructure.HULL)
            {
                return UNKNOWN;
            }
            var isSphere:Boolean = kind == BoundingStructure.SPHERE;
            // a ball with this radius around the middle is in the agent
            var inner:Number = isSphere ? extents.halfX : 0;
            _under.x = extents.x;
            _under.y = extents.y;
            grid.findHeight(_under);
            var above:Number = extents.z - _under.height;
            if (above <= inner)
            {
                // the middle of a hull's extents may be outside of the hull
                return kind == BoundingStructure.HULL ? UNKNOWN : TOUCHING;
            }
            if (isNaN(above))
            {
                // no ground is below
                return UNKNOWN;
            }
            var whole:HeightBounds = grid.pyramid.whole;
            // agents that are this close may touch, because of rounding
            var touchMargin:Number = Tolerances.ROUNDING * (Math.abs(grid.x) + Math.abs(grid.y) + (grid.columns + grid.rows) * grid.cellWidth
                    + Math.abs(whole.min) + Math.abs(whole.max));
            var slope:Number = grid.isBlocky ? Infinity : Math.max(whole.maxStepX, whole.maxStepY) / grid.cellWidth;
            // The height that the steepest slope of all reaches. For a sphere it is its radius times the root of 1 + 2 s², at most 1 + s².
            var height:Number = isSphere ? inner + inner * slope * slope : extents.halfZ + slope * (extents.halfX + extents.halfY);
            // an agent whose lowest height is in the ground under its middle is not far
            var isApart:Boolean = above > height * Tolerances.OUTER + touchMargin || above > extents.halfZ && isFar(grid, extents, isSphere, above, touchMargin);
            return isApart ? APART : UNKNOWN;
        }

        // Whether the agent is above all heights near it, or higher above its place than the slopes between them reach.
        private function isFar(grid:HeightGrid, extents:GroundBox, isSphere:Boolean, above:Number, touchMargin:Number):Boolean
        {
            var halfX:Number = extents.halfX * Tolerances.OUTER + touchMargin;
            var halfY:Number = extents.halfY * Tolerances.OUTER + touchMargin;
            var halfZ:Number = extents.halfZ * Tolerances.OUTER + touchMargin;
            grid.pyramid.findAround(extents.x, extents.y, halfX, halfY, _heightsAround);
            if (extents.z - halfZ > _heightsAround.max)
            {
                return true;
            }
            var riseX:Number = _heightsAround.maxStepX * halfX / grid.cellWidth;
            var riseY:Number = _heightsAround.maxStepY * halfY / grid.cellWidth;
            var height:Number = isSphere ? Math.sqrt(halfZ * halfZ + riseX * riseX + riseY * riseY) : halfZ + riseX + riseY;
            return !grid.isBlocky && above > height;
        }
    }
}
