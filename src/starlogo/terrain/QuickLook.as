package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.engine;

    use namespace engine;

    /**
     * Answers for most agents in a tenth of the time whether they touch the ground. It decides about agents whose inner ball reaches down to
     * the ground, and about agents that are higher above the ground than the steepest slope near them allows.
     *
     * @private
     */
    public final class QuickLook
    {
        // The cells within the agent's reach.
        private var _first:int = 0;
        private var _last:int = 0;
        private var _firstRow:int = 0;
        private var _lastRow:int = 0;

        /** The middle of the agent; fields, because V8 makes an object of each Number that it passes. */
        public var x:Number = 0;

        /** @copy #x */
        public var y:Number = 0;

        /** @copy #x */
        public var z:Number = 0;

        /** Whether the agent contains its middle, and the radius of a ball about the middle that the agent contains. */
        public var isSolid:Boolean = false;

        /** @copy #isSolid */
        public var inner:Number = 0;

        /** The radius of a ball around the agent, enlarged by the gap across which the agent and the ground still touch. */
        public var outer:Number = 0;

        /** Whether the agent is known to touch the ground. */
        public var isTouching:Boolean = false;

        /** Creates a test without an agent. */
        public function QuickLook()
        {
        }

        /** Whether the answer is known. At the borders of a terrain it is mostly not known. */
        public function decide(grid:HeightGrid):Boolean
        {
            grid.placeX = x;
            grid.placeY = y;
            grid.findHeight();
            var above:Number = z - grid.height;
            isTouching = isSolid && above <= inner;
            if (isTouching || !(above > outer))
            {
                return isTouching;
            }
            var width:Number = grid.cellWidth;
            _first = Math.floor((x - outer - grid.x) / width);
            _last = Math.floor((x + outer - grid.x) / width);
            _firstRow = Math.floor((y - outer - grid.y) / width);
            _lastRow = Math.floor((y + outer - grid.y) / width);
            if (_first < 0 || _firstRow < 0 || _last > grid.columns - 2 || _lastRow > grid.rows - 2)
            {
                return false;
            }
            return isAbove(grid, above);
        }

        // Whether the agent is higher than all of the ground within its reach, or too high for the slopes there. The distance from a sloped
        // plane is the height above the plane times the cosine of its angle.
        private function isAbove(grid:HeightGrid, above:Number):Boolean
        {
            var greatest:Number = -Agent.LARGEST_COORDINATE;
            var steepest:Number = 0;
            // A column extends half a cell beyond the place of its height.
            for (var row:int = _firstRow >> HeightGrid.BLOCK; row <= (_lastRow + 1) >> HeightGrid.BLOCK; row++)
            {
                for (var column:int = _first >> HeightGrid.BLOCK; column <= (_last + 1) >> HeightGrid.BLOCK; column++)
                {
                    var block:int = row * grid.blockColumns + column;
                    greatest = grid.greatests[block] > greatest ? grid.greatests[block] : greatest;
                    steepest = grid.steepests[block] > steepest ? grid.steepests[block] : steepest;
                }
            }
            return z - outer > greatest || !grid.isBlocky && above * above > (1 + steepest) * outer * outer;
        }
    }
}
