package starlogo.ground
{
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;

    /**
     * Says over which squares of the ground the box of a GroundSearch passes in its motion: when, and between which heights. A square has a level, a
     * column and a row. The squares of level 0 are the cells. A standing box also passes over a square if it is as near as the
     * search's <code>maxDistance</code>, which is 0 for a moving one.
     */
    internal final class BoxPath
    {
        // The search begins with squares of which the box is at most this many long. Most boxes are small, and then these are the cells. Smaller: more
        // boxes begin with squares that are larger than needed. Larger: long boxes begin with many squares.
        private static const MAX_FIRST_SQUARES:int = 3;

        // How many rounded terms a place of the box and a limit are: of each axis the box's middle, half its length, and how far it has moved; and a limit.
        // Each may be off by Tolerances.ROUNDING of the lengths.
        private static const TERMS_OF_PLACE:Number = 10;

        /** The search. Read only. */
        public var search:GroundSearch;

        /**
         * How much nearer to the box a triangle may be than its numbers say: no rounding error of the search's coordinates is larger, and no margin of a
         * triangle (see Touching). Read only.
         */
        public var slack:Number = 0;

        /** How the box moves along x and along y. Read only. */
        public var alongX:AxisPath = new AxisPath();
        public var alongY:AxisPath = new AxisPath();

        /** The latest time of the motion when the search began. It may have become earlier since. Read only. */
        public var latestAtBegin:Number = 0;

        // How far the box reaches above and below its middle, and the slack.
        private var _reachZ:Number = 0;

        private var _separation:SquareSeparation = new SquareSeparation();
        private var _square:GroundBox = new GroundBox();

        /** Begins with a search, which is kept. */
        public function begin(search:GroundSearch):void
        {
            this.search = search;
            var grid:HeightGrid = search.grid;
            var box:GroundBox = search.box;
            var motion:RelativeMotion = search.motion;
            latestAtBegin = motion.latestTime;
            alongX.cellsBegin = grid.x - search.origin.x - grid.border;
            alongY.cellsBegin = grid.y - search.origin.y - grid.border;
            alongX.lastCell = grid.lastCellColumn;
            alongY.lastCell = grid.lastCellRow;
            // the margins are fractions of the triangles' sizes, and so of the cell's width and the heights
            var whole:HeightBounds = grid.pyramid.whole;
            slack = TERMS_OF_PLACE * Tolerances.ROUNDING * (Math.abs(box.x) + Math.abs(box.y) + Math.abs(box.z) + box.halfX + box.halfY + box.halfZ
                    + Math.abs(alongX.cellsBegin) + Math.abs(alongY.cellsBegin) + Math.abs(search.origin.z) + grid.cellWidth + whole.max - whole.min
                    + latestAtBegin * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z)));
            alongX.middle = box.x;
            alongX.reach = box.halfX * Tolerances.OUTER + slack;
            alongX.speed = motion.x;
            alongY.middle = box.y;
            alongY.reach = box.halfY * Tolerances.OUTER + slack;
            alongY.speed = motion.y;
            _reachZ = box.halfZ * Tolerances.OUTER + slack;
        }

        /** The column or row of a level that has the box's middle. It may be outside of the grid. */
        public function middleAlong(axis:AxisPath, level:int):int
        {
            return squareAt(axis.middle - axis.cellsBegin, level);
        }

        /** The level with whose squares the search begins. */
        public function firstLevel():int
        {
            // the longer side of the rectangle over which the box passes
            var length:Number = Math.max(2 * alongX.reach + latestAtBegin * Math.abs(alongX.speed),
                    2 * alongY.reach + latestAtBegin * Math.abs(alongY.speed)) + 2 * search.maxDistance;
            var level:int = 0;
            while (level < search.grid.pyramid.lastLevel && length > MAX_FIRST_SQUARES * widthAt(level))
            {
                level++;
            }
            return level;
        }

        /** How wide the squares of a level are. */
        public function widthAt(level:int):Number
        {
            return search.grid.cellWidth * (1 << level * HeightPyramid.SHIFT);
        }

        /** The first column or row of a level that the box may pass over in a passage. It may be outside of the grid. */
        public function firstSquareAlong(axis:AxisPath, passage:SquarePassage, level:int):int
        {
            var least:Number = axis.middle - axis.cellsBegin + Math.min(passage.earliest * axis.speed, passage.latest * axis.speed);
            return squareAt(least - (axis.reach + search.maxDistance), level);
        }

        /** The last column or row of a level that the box may pass over in a passage. It may be outside of the grid. */
        public function lastSquareAlong(axis:AxisPath, passage:SquarePassage, level:int):int
        {
            var greatest:Number = axis.middle - axis.cellsBegin + Math.max(passage.earliest * axis.speed, passage.latest * axis.speed);
            return squareAt(greatest + (axis.reach + search.maxDistance), level);
        }

        // The column or row of a level that is so far from the first one; -1 for all before that one.
        private function squareAt(distance:Number, level:int):int
        {
            return Math.max(-1, Math.min(int.MAX_VALUE, Math.floor(distance / widthAt(level))));
        }

        /** Whether a square is at a border of the ground. */
        public function isAtBorder(level:int, column:int, row:int):Boolean
        {
            return column == 0 || row == 0 || column == HeightPyramid.squareOf(alongX.lastCell, level)
                || row == HeightPyramid.squareOf(alongY.lastCell, level);
        }

        /**
         * Clips a passage to the part of the motion in which the box is over a square.
         *
         * @param passage from the motion's start to its own latest time; receives the part
         * @return whether there is such a part
         */
        public function clipToSquare(level:int, column:int, row:int, passage:SquarePassage):Boolean
        {
            passage.earliest = 0;
            passage.squaredDistanceBeside = 0;
            if (!clipAlong(alongX, column, level, passage) || !clipAlong(alongY, row, level, passage))
            {
                return false;
            }
            var start:Number = search.box.z + passage.earliest * search.motion.z;
            var end:Number = search.box.z + passage.latest * search.motion.z;
            var maxDistance:Number = search.maxDistance;
            // a triangle beside the box must be nearer in height to be near enough
            var up:Number = maxDistance > 0 ? Math.sqrt(Math.max(0, maxDistance * maxDistance - passage.squaredDistanceBeside)) : 0;
            passage.minHeight = Math.min(start, end) - _reachZ - up;
            passage.maxHeight = Math.max(start, end) + _reachZ + up;
            return true;
        }

        // Clips a passage to the part in which the box is over a column or a row. If the box does not move along this axis, it is near enough to the
        // column or row all the time or never. Returns whether there is such a part.
        private function clipAlong(axis:AxisPath, square:int, level:int, passage:SquarePassage):Boolean
        {
            var speed:Number = axis.speed;
            var width:Number = widthAt(level);
            if (speed == 0)
            {
                var beside:Number = Math.max(0, Math.abs(axis.middle - axis.cellsBegin - (square + 0.5) * width) - width / 2 - axis.reach);
                passage.squaredDistanceBeside += beside * beside;
                return beside <= search.maxDistance;
            }
            var low:Number = (axis.cellsBegin + square * width - (axis.middle + axis.reach)) / speed;
            var high:Number = (axis.cellsBegin + (square + 1) * width - (axis.middle - axis.reach)) / speed;
            passage.earliest = Math.max(passage.earliest, Math.min(low, high));
            passage.latest = Math.min(passage.latest, Math.max(low, high));
            return passage.earliest <= passage.latest;
        }

        /** Whether the shape in the box stays farther away from a square than a triangle may be. The square is between two heights. */
        public function isBeyondMaxDistance(level:int, column:int, row:int, heights:HeightBounds):Boolean
        {
            if (search.shape == null)
            {
                return false;
            }
            var half:Number = widthAt(level) / 2;
            _square.x = alongX.cellsBegin + (2 * column + 1) * half;
            _square.y = alongY.cellsBegin + (2 * row + 1) * half;
            _square.z = (heights.min + heights.max) / 2;
            _square.halfX = _square.halfY = half + slack;
            _square.halfZ = (heights.max - heights.min) / 2 + slack;
            return _separation.isBeyondMaxDistance(search, _square);
        }
    }
}
