package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Says over which squares of the ground the box of a GroundSearch passes in its motion: when, and between which heights. A square has a level, a
     * column and a row. The squares of level 0 are the cells. A box also passes over a square if it comes as near as the search's
     * <code>maxDistance</code>.
     */
    internal final class BoxPath
    {
        // How much farther than rounding errors a structure is from squares that are left out.
        private static const FARTHER:Number = 4;

        /** Where the first cell begins, and the height 0, relative to the search's origin. Read only. */
        public var corner:Vector3D = new Vector3D();

        /** How long the box passes along x or along y, with its own length. Read only. */
        public var length:Number = 0;

        /** The search, and its ground. Read only. */
        public var search:GroundSearch;
        public var grid:HeightGrid;

        // The latest time at the beginning of the search. The search's own may have become earlier since.
        private var _latest:Number = 0;

        // Half the box's lengths, with a margin for rounding; and the distance that rounding errors may hide.
        private var _half:Vector3D = new Vector3D();
        private var _slack:Number = 0;

        private var _separation:SquareSeparation = new SquareSeparation();
        private var _least:Vector3D = new Vector3D();
        private var _greatest:Vector3D = new Vector3D();

        /** Begins with a search, which is kept. */
        public function begin(search:GroundSearch):void
        {
            this.search = search;
            grid = search.grid;
            var box:GroundBox = search.box;
            var motion:RelativeMotion = search.motion;
            var border:Number = grid.isBlocky ? grid.cellWidth / 2 : 0;
            _latest = search.latest;
            corner.setTo(grid.x - search.origin.x - border, grid.y - search.origin.y - border, -search.origin.z);
            var pathX:Number = _latest * Math.abs(motion.x);
            var pathY:Number = _latest * Math.abs(motion.y);
            var rounding:Number = Tolerances.ROUNDING * (Math.abs(box.x) + Math.abs(corner.x) + Math.abs(box.y) + Math.abs(corner.y) + Math.abs(box.z)
                    + Math.abs(corner.z) + grid.cellWidth + pathX + pathY + _latest * Math.abs(motion.z));
            _slack = FARTHER * rounding;
            _half.setTo(box.halfX + rounding, box.halfY + rounding, box.halfZ + rounding);
            length = Math.max(2 * _half.x + pathX, 2 * _half.y + pathY) + 2 * search.maxDistance;
        }

        /** How wide the squares of a level are. */
        public function widthAt(level:int):Number
        {
            return grid.cellWidth * (1 << level * HeightPyramid.SHIFT);
        }

        /**
         * The first of some columns or rows of a level that the box may pass over in a passage, or the number after the last one if it passes over
         * none.
         *
         * @param isX whether these are columns, along x; otherwise they are rows
         */
        public function firstPassed(passage:SquarePassage, level:int, isX:Boolean, first:int, last:int):int
        {
            var speed:Number = isX ? search.motion.x : search.motion.y;
            var at:Number = isX ? search.box.x - corner.x : search.box.y - corner.y;
            var half:Number = isX ? _half.x : _half.y;
            var least:Number = Math.min(at + passage.from * speed, at + passage.to * speed) - (half + search.maxDistance);
            return Math.max(first, Math.min(last + 1, Math.floor(least / widthAt(level))));
        }

        /** The last one, or the number before the first one. See <code>firstPassed()</code>. */
        public function lastPassed(passage:SquarePassage, level:int, isX:Boolean, first:int, last:int):int
        {
            var speed:Number = isX ? search.motion.x : search.motion.y;
            var at:Number = isX ? search.box.x - corner.x : search.box.y - corner.y;
            var half:Number = isX ? _half.x : _half.y;
            var greatest:Number = Math.max(at + passage.from * speed, at + passage.to * speed) + (half + search.maxDistance);
            return Math.max(first - 1, Math.min(last, Math.floor(greatest / widthAt(level))));
        }

        /**
         * Finds the part of the motion in which the box is over a square, and the heights between which it is then.
         *
         * @param isNarrowed whether the part ends with the search's latest time as it is now; otherwise, as it was at the beginning
         * @param out receives the part and the heights
         */
        public function findPassage(level:int, column:int, row:int, isNarrowed:Boolean, out:SquarePassage):void
        {
            var box:GroundBox = search.box;
            var width:Number = widthAt(level);
            var motion:RelativeMotion = search.motion;
            var from:Number = 0;
            var to:Number = isNarrowed ? search.latest : _latest;
            // the square of how far above or below the box something is near enough
            var squared:Number = search.maxDistance * search.maxDistance;
            for (var axis:int = 0; axis < 2; axis++)
            {
                var isX:Boolean = axis == 0;
                var square:int = isX ? column : row;
                var at:Number = isX ? box.x : box.y;
                var half:Number = isX ? _half.x : _half.y;
                var speed:Number = isX ? motion.x : motion.y;
                var begin:Number = isX ? corner.x : corner.y;
                if (speed == 0)
                {
                    var off:Number = Math.max(0, Math.abs(at - begin - (square + 0.5) * width) - width / 2 - half);
                    squared -= off * off;
                    to = off > search.maxDistance ? -1 : to;
                }
                else
                {
                    var low:Number = (begin + square * width - (at + half)) / speed;
                    var high:Number = (begin + (square + 1) * width - (at - half)) / speed;
                    from = Math.max(from, Math.min(low, high));
                    to = Math.min(to, Math.max(low, high));
                }
            }
            out.from = from;
            out.to = to;
            var start:Number = box.z + from * motion.z;
            var end:Number = box.z + to * motion.z;
            // a triangle beside the box must be nearer in height to be near enough
            var up:Number = Math.sqrt(Math.max(0, squared));
            var bottom:Number = Math.min(start, end) - _half.z;
            out.low = Math.max(bottom - up, bottom + search.above + 2 * _slack);
            out.high = Math.max(start, end) + _half.z + up;
        }

        /** Narrows a passage over a square to the part in which the box is between the heights of the square. */
        public function narrowPassage(heights:HeightRange, passage:SquarePassage):void
        {
            var box:GroundBox = search.box;
            var speed:Number = search.motion.z;
            if (speed != 0)
            {
                var low:Number = (heights.least - (box.z + _half.z)) / speed;
                var high:Number = (heights.greatest - (box.z - _half.z)) / speed;
                passage.from = Math.max(passage.from, Math.min(low, high));
                passage.to = Math.min(passage.to, Math.max(low, high));
            }
        }

        /** Whether the shape in the box stays farther away from a square than a triangle may be. The square is between two heights. */
        public function stayApart(level:int, column:int, row:int, heights:HeightRange):Boolean
        {
            if (search.shape == null)
            {
                return false;
            }
            var width:Number = widthAt(level);
            var x:Number = corner.x + column * width;
            var y:Number = corner.y + row * width;
            _least.setTo(x - _slack, y - _slack, heights.least - _slack);
            _greatest.setTo(x + width + _slack, y + width + _slack, heights.greatest + _slack);
            return _separation.stayApart(search, _least, _greatest);
        }
    }
}
