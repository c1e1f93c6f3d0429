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
            // The distance from a sloped plane is the height above the plane times the cosine of its angle. The bounds of the whole terrain
            // are looked at first, because they are in the processor's cache.
            var width:Number = grid.cellWidth;
            var lowest:Number = z - outer;
            var slope:Number = grid.isBlocky ? 0 : width * Math.sqrt((above * above / outer / outer - 1) / 2);
            var whole:int = grid.bounds.length - 3;
            if (lowest > grid.bounds[int(whole + 1)] || grid.bounds[int(whole + 2)] < slope)
            {
                return true;
            }
            // A column extends half a cell beyond the place of its height.
            x -= grid.x;
            y -= grid.y;
            findBounds(grid, Math.max(0, (x - outer) / width), Math.max(0, (y - outer) / width), Math.min(grid.columns - 1, (x + outer) / width + 1),
                    Math.min(grid.rows - 1, (y + outer) / width + 1));
            if (lowest > _greatest || _difference < slope)
            {
                return true;
            }
            // Look at the point of the inner ball that is nearest to the plane under its middle.
            var step:Number = inner / Math.sqrt(grid.fallX * grid.fallX + grid.fallY * grid.fallY + width * width);
            grid.placeX -= step * grid.fallX;
            grid.placeY -= step * grid.fallY;
            grid.findHeight();
            isTouching = isSolid && grid.height >= z - step * width;
            return isTouching;
        }

        // Finds the bounds of some cells. It takes the smallest squares that are no smaller than the range of cells. The corners of the range
        // are in all squares to which it extends.
        private function findBounds(grid:HeightGrid, first:int, firstRow:int, last:int, lastRow:int):void
        {
            var level:int = 1;
            var shift:int = HeightGrid.SHIFT;
            while (Math.max(last - first, lastRow - firstRow) >= 1 << shift)
            {
                shift += HeightGrid.SHIFT;
                level++;
            }
            _greatest = -Agent.LARGEST_COORDINATE;
            _difference = 0;
            for (var corner:int = 0; corner < 4; corner++)
            {
                var column:int = (corner & 1) == 0 ? first : last;
                var row:int = corner < 2 ? firstRow : lastRow;
                var at:int = grid.begins[level] + 3 * ((row >> shift) * grid.across[level] + (column >> shift));
                _greatest = Math.max(_greatest, grid.bounds[int(at + 1)]);
                _difference = Math.max(_difference, grid.bounds[int(at + 2)]);
            }
        }
    }
}
