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

        /** The latest time at the beginning of the search. The search's own may have become earlier since. Read only. */
        public var latest:Number = 0;

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
            latest = search.latest;
            corner.setTo(grid.x - search.origin.x - border, grid.y - search.origin.y - border, -search.origin.z);
            var pathX:Number = latest * Math.abs(motion.x);
            var pathY:Number = latest * Math.abs(motion.y);
            var rounding:Number = Tolerances.ROUNDING * (Math.abs(box.x) + Math.abs(corner.x) + Math.abs(box.y) + Math.abs(corner.y) + Math.abs(box.z)
                    + Math.abs(corner.z) + grid.cellWidth + pathX + pathY + latest * Math.abs(motion.z));
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
         * The first or the last column or row of a level that the box may pass over in a passage. It may be outside of the grid.
         *
         * @param isX whether these are columns, along x; otherwise they are rows
         */
        public function endOf(passage:SquarePassage, level:int, isX:Boolean, isLast:Boolean):int
        {
            var speed:Number = isX ? search.motion.x : search.motion.y;
            var at:Number = isX ? search.box.x - corner.x : search.box.y - corner.y;
            var half:Number = isX ? _half.x : _half.y;
            var around:Number = half + search.maxDistance;
            var start:Number = at + passage.from * speed;
            var end:Number = at + passage.to * speed;
            var place:Number = isLast ? Math.max(start, end) + around : Math.min(start, end) - around;
            return Math.max(-1, Math.min(int.MAX_VALUE, Math.floor(place / widthAt(level))));
        }

        /**
         * Narrows a passage to the part in which the box is over a square, and finds the heights between which the box is then.
         *
         * @param passage a part of the motion; receives the part and the heights
         */
        public function findPassage(level:int, column:int, row:int, passage:SquarePassage):void
        {
            passage.besideSquared = 0;
            narrowAlong(true, column, level, passage);
            narrowAlong(false, row, level, passage);
            var start:Number = search.box.z + passage.from * search.motion.z;
            var end:Number = search.box.z + passage.to * search.motion.z;
            // a triangle beside the box must be nearer in height to be near enough
            var up:Number = Math.sqrt(Math.max(0, search.maxDistance * search.maxDistance - passage.besideSquared));
            var bottom:Number = Math.min(start, end) - _half.z;
            passage.low = Math.max(bottom - up, bottom + search.above + 2 * _slack);
            passage.high = Math.max(start, end) + _half.z + up;
        }

        // Narrows a passage to the part in which the box is over a column or a row. If it does not move along x or y, it is
        // over the column or row all the time or never.
        private function narrowAlong(isX:Boolean, square:int, level:int, passage:SquarePassage):void
        {
            var width:Number = widthAt(level);
            var at:Number = isX ? search.box.x : search.box.y;
            var half:Number = isX ? _half.x : _half.y;
            var speed:Number = isX ? search.motion.x : search.motion.y;
            var first:Number = isX ? corner.x : corner.y;
            if (speed == 0)
            {
                var beside:Number = Math.max(0, Math.abs(at - first - (square + 0.5) * width) - width / 2 - half);
                passage.besideSquared += beside * beside;
                passage.to = beside > search.maxDistance ? -1 : passage.to;
                return;
            }
            var low:Number = (first + square * width - (at + half)) / speed;
            var high:Number = (first + (square + 1) * width - (at - half)) / speed;
            passage.from = Math.max(passage.from, Math.min(low, high));
            passage.to = Math.min(passage.to, Math.max(low, high));
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
