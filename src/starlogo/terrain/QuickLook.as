package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Answers for most agents in a tenth of the time whether they touch the ground. It decides about agents whose inner ball reaches down to
     * the ground, and about agents that are higher above the ground than the steepest slope near them allows.
     *
     * @private
     */
    public final class QuickLook
    {
        /** The largest gap across which the agent and the ground still touch; a field, because V8 makes an object of each Number that it passes. */
        public var gap:Number = 0;

        /** Whether the agent is known to touch the ground. */
        public var isTouching:Boolean = false;

        // The greatest height near the agent, and the greatest difference of two neighbouring heights.
        private var _greatest:Number = 0;
        private var _difference:Number = 0;

        /** Creates a test without an agent. */
        public function QuickLook()
        {
        }

        /**
         * Whether the answer is known. It is not known for agents whose middle is outside of the terrain.
         *
         * @param extents of the agent, by row
         * @param isSphere whether the agent is the sphere in its extents
         * @param isSolid whether the agent contains its middle
         */
        public function decide(grid:HeightGrid, extents:Extents, row:int, isSphere:Boolean, isSolid:Boolean):Boolean
        {
            var x:Number = extents.x[row];
            var y:Number = extents.y[row];
            var z:Number = extents.z[row];
            var halfX:Number = extents.halfX[row];
            var halfY:Number = extents.halfY[row];
            var halfZ:Number = extents.halfZ[row];
            var inner:Number = isSphere ? halfX : 0;
            var outer:Number = isSphere ? halfX : Math.sqrt(halfX * halfX + halfY * halfY + halfZ * halfZ);
            outer = outer * Tolerances.OUTER + gap;
            grid.placeX = x;
            grid.placeY = y;
            grid.findHeight();
            var above:Number = z - grid.height;
            isTouching = isSolid && above <= inner;
            if (isTouching || !(above > outer))
            {
                return isTouching;
            }
            // A column extends half a cell beyond the place of its height.
            var width:Number = grid.cellWidth;
            x -= grid.x;
            y -= grid.y;
            findBounds(grid, Math.max(0, (x - outer) / width), Math.max(0, (y - outer) / width), Math.min(grid.columns - 1, (x + outer) / width + 1),
                    Math.min(grid.rows - 1, (y + outer) / width + 1));
            // The distance from a sloped plane is the height above the plane times the cosine of its angle.
            return z - outer > _greatest || !grid.isBlocky && above * above * width * width > (width * width + 2 * _difference * _difference) * outer * outer;
        }

        // Finds the bounds of some cells, by the smallest squares of which at most two are in a row.
        private function findBounds(grid:HeightGrid, first:int, firstRow:int, last:int, lastRow:int):void
        {
            var level:int = 1;
            var shift:int = HeightGrid.SHIFT;
            while ((last >> shift) - (first >> shift) > 1 || (lastRow >> shift) - (firstRow >> shift) > 1)
            {
                shift += HeightGrid.SHIFT;
                level++;
            }
            _greatest = -Agent.LARGEST_COORDINATE;
            _difference = 0;
            for (var row:int = firstRow >> shift; row <= lastRow >> shift; row++)
            {
                for (var column:int = first >> shift; column <= last >> shift; column++)
                {
                    var at:int = grid.begins[level] + 3 * (row * grid.across[level] + column);
                    _greatest = Math.max(_greatest, grid.bounds[int(at + 1)]);
                    _difference = Math.max(_difference, grid.bounds[int(at + 2)]);
                }
            }
        }
    }
}
