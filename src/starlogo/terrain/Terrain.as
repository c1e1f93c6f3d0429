// This room has what a game knows of its world besides agents: the ground and the edges. Terrain has the heights, TerrainSurface makes triangles
// of them for drawing, and WorldBounds has the edges; an agent stands for each (EnvironmentAgent). Read this file first; the room ground computes.
package starlogo.terrain
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.Breeds;
    import starlogo.data.requireGiven;
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.geometry.requireInWorld;
    import starlogo.ground.GroundPoint;
    import starlogo.ground.HeightGrid;
    import starlogo.search.EnvironmentAgent;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.GroundPairTests;

    use namespace engine;

    /**
     * The ground of a game: a grid of heights. Below the heights the ground is solid, however deep. Outside of the grid there is nothing.
     *
     * <p>The heights make one of two surfaces: slopes or blocks. With slopes, each cell between four heights is two triangles. The diagonal
     * between them goes from the corner with the least x and y to the corner with the greatest x and y. With <code>isBlocky</code>, each height
     * is the top of an upright square block around it, one cell wide. The surface belongs to the ground.</p>
     *
     * <p>A cell or a block may be a hole. Nothing is there, as outside of the grid, however deep. The ground beside it ends in upright walls.</p>
     *
     * <p>Heights may change at any time. Frames and questions that begin later see the change. The cost is in proportion to the heights that
     * change, but the first change that handlers make in a frame copies all heights. The memory is 9 bytes for each height, and twice as much once a
     * handler has changed the ground. A call that throws changes nothing.</p>
     */
    public final class Terrain
    {
        /** The largest number of cells. */
        public static const MOST_CELLS:int = 16000000;

        /** @private The value of <code>agent</code>. Its surface has the heights. */
        engine var environmentAgent:EnvironmentAgent = new EnvironmentAgent(Breeds.TERRAIN);

        private var _point:GroundPoint = new GroundPoint();

        /**
         * Flat ground of height 0.
         *
         * @param columns how many heights there are along x, at least 2
         * @param rows how many there are along y, at least 2
         * @param cellWidth how far neighbours are apart, in patches
         * @param x where the first height is
         * @param y where the first height is
         * @throws RangeError if there would be no cell or more than MOST_CELLS, a number is not finite, or a block would not be in the world
         */
        public function Terrain(columns:int, rows:int, cellWidth:Number = 1, x:Number = 0, y:Number = 0)
        {
            if (!(columns >= 2 && rows >= 2 && (columns - 1) * (rows - 1) <= MOST_CELLS))
            {
                throw new RangeError("a terrain has from 2 by 2 heights to " + MOST_CELLS + " cells between them, not " + columns + " by " + rows + " heights");
            }
            if (!(cellWidth >= Agent.SMALLEST_SIZE && cellWidth <= Agent.LARGEST_COORDINATE))
            {
                throw new RangeError("a terrain's cellWidth must be between " + Agent.SMALLEST_SIZE + " and " + Agent.LARGEST_COORDINATE + ", not "
                        + cellWidth);
            }
            requireInWorld("the beginning of a terrain's blocks", x - cellWidth / 2, y - cellWidth / 2, 0);
            requireInWorld("the end of a terrain's blocks", x + (columns - 0.5) * cellWidth, y + (rows - 0.5) * cellWidth, 0);
            environmentAgent.surface = ModelShape.ofEnvironment(new HeightGrid(columns, rows, cellWidth, x, y), null, GroundPairTests.addTo);
            // only the edges' agents have negative ids: see Agent.id
            environmentAgent.idNumber = Agent.takeId();
        }

        /**
         * Ground with a height for each pixel of a picture. The picture is seen from above: its top row has the greatest y.
         *
         * @param picture in Flash a BitmapData, in JavaScript an ImageData
         * @param height the height of white; black is 0, and greys are in between. A color counts as the mean of its red, green and blue
         * @throws ArgumentError if there is no picture, or it has too little data
         * @throws RangeError as the constructor does for the other numbers, and if the height is not finite or too large
         */
        public static function fromPicture(picture:Object, height:Number, cellWidth:Number = 1, x:Number = 0, y:Number = 0):Terrain
        {
            var data:Object = picture != null && "data" in picture ? picture.data : null;
            if (picture == null || !(picture.width > 0) || (data == null && !("getPixel" in picture)))
            {
                throw new ArgumentError("picture must be a BitmapData or an ImageData, not " + textOf(picture));
            }
            requireInWorld("the height of white", height, 0, 0);
            var terrain:Terrain = new Terrain(picture.width, picture.height, cellWidth, x, y);
            if (data != null && data.length < 4 * terrain.columns * terrain.rows)
            {
                throw new ArgumentError("a picture of " + terrain.columns + " by " + terrain.rows + " pixels has too little data: " + data.length);
            }
            terrain.setHeights(0, 0, terrain.columns, terrain.rows, greysOf(picture, data, height));
            return terrain;
        }

        /** Its size and place, as text. */
        public function toString():String
        {
            return "terrain of " + columns + " by " + rows + " heights, " + cellWidth + " apart, from (" + x + ", " + y + ")";
        }

        /** @private The heights as they are now. Call <code>environmentAgent.beginChange()</code> to change them. */
        engine function get grid():HeightGrid
        {
            return environmentAgent.surface.grid;
        }

        /** Whether the surface is upright blocks; otherwise it is slopes. May be changed at any time. */
        public function get isBlocky():Boolean
        {
            return grid.isBlocky;
        }

        public function set isBlocky(value:Boolean):void
        {
            if (value != grid.isBlocky)
            {
                environmentAgent.beginChange().isBlocky = value;
            }
        }

        /** How many heights there are along x. */
        public function get columns():int
        {
            return grid.columns;
        }

        /** How many heights there are along y. */
        public function get rows():int
        {
            return grid.rows;
        }

        /** How far neighbours are apart, in patches. */
        public function get cellWidth():Number
        {
            return grid.cellWidth;
        }

        /** The x of the first height, in patches. */
        public function get x():Number
        {
            return grid.x;
        }

        /** The y of the first height, in patches. */
        public function get y():Number
        {
            return grid.y;
        }

        /**
         * The agent that stands for the ground: handlers get it as the collidee, and answers to questions name it. Its breed is
         * <code>Collision.TERRAIN</code>. It must not be put into a list of agents.
         */
        public function get agent():Agent
        {
            return environmentAgent;
        }

        /**
         * One of the heights.
         *
         * @throws RangeError if there is no such height; columns and rows count from 0 on
         */
        public function getHeight(column:int, row:int):Number
        {
            requireRegion(column, row, 1, 1);
            return grid.heights[row * grid.columns + column];
        }

        /**
         * Changes one of the heights.
         *
         * @param height in patches, at most Agent.LARGEST_COORDINATE either way
         * @throws RangeError if there is no such height, or if the new height is not finite or too large
         */
        public function setHeight(column:int, row:int, height:Number):void
        {
            setHeights(column, row, 1, 1, new <Number>[height]);
        }

        /**
         * Changes the heights of a region.
         *
         * @param column the region's first column, from 0 on; row is its first row
         * @param columns how many columns the region has; rows is how many rows
         * @param heights a height for each place of the region, row by row
         * @throws ArgumentError if heights is null
         * @throws RangeError if the region is not within the terrain, there are too few or too many, or one is not finite or too large
         */
        public function setHeights(column:int, row:int, columns:int, rows:int, heights:Vector.<Number>):void
        {
            requireRegion(column, row, columns, rows);
            requireGiven("heights", heights);
            if (heights.length != columns * rows)
            {
                throw new RangeError(columns + " by " + rows + " heights are needed, not " + heights.length);
            }
            for (var i:int = 0; i < heights.length; i++)
            {
                requireInWorld("a terrain's height", heights[i], 0, 0);
            }
            environmentAgent.beginChange().setHeights(column, row, columns, rows, heights);
        }

        /**
         * Makes a part of the ground a hole, or fills it. Agents fall through holes, and rays pass. A hole keeps its heights.
         *
         * @param column which part: with blocks, the one around this height. With slopes, the cell between this height and the next ones along
         *     x and y. The last height along x or y has no such cell; then nothing is seen of the hole until the surface is blocks
         * @throws RangeError if there is no such height; columns and rows count from 0 on
         */
        public function setHole(column:int, row:int, becomesHole:Boolean):void
        {
            if (isHole(column, row) != becomesHole)
            {
                environmentAgent.beginChange().setHole(column, row, becomesHole);
            }
        }

        /**
         * Makes the part of the ground at a place a hole, or fills it: the block there, or with slopes the cell. See <code>setHole()</code>.
         *
         * @throws RangeError if the place is outside of the terrain
         */
        public function setHoleAt(x:Number, y:Number, becomesHole:Boolean):void
        {
            var cell:GroundPoint = requireCell("a hole", x, y, isBlocky);
            setHole(cell.column, cell.row, becomesHole);
        }

        /**
         * Whether a part of the ground is a hole, as <code>setHole()</code> names it.
         *
         * @throws RangeError if there is no such height
         */
        public function isHole(column:int, row:int):Boolean
        {
            requireRegion(column, row, 1, 1);
            return grid.isHole(row * grid.columns + column);
        }

        /**
         * Raises a round mound about (x, y). With a negative height it digs a hollow. The middle rises by the height, and the border does not
         * rise. At the share d of the way from the middle to the border, the ground rises by (1 - dd)(1 - dd) times the height. A mound that is so
         * narrow that no height is inside its border changes nothing.
         *
         * @param width from border to border, more than 0
         * @throws RangeError if a number is not finite, the width is not more than 0, the mound is wholly outside of the blocks that the heights
         *     have with isBlocky, or a height would be too large
         */
        public function raiseMound(x:Number, y:Number, width:Number, height:Number):void
        {
            requireInWorld("a mound's place and height", x, y, height);
            requireInWorld("a mound's width", width, 0, 0);
            if (!(width > 0))
            {
                throw new RangeError("a mound's width must be more than 0, not " + width);
            }
            var ground:HeightGrid = grid;
            // rounding must not make it 0
            var radius:Number = Math.max(Number.MIN_VALUE, width / 2 / ground.cellWidth);
            var middleColumn:Number = (x - ground.x) / ground.cellWidth;
            var middleRow:Number = (y - ground.y) / ground.cellWidth;
            // how far the middle is outside of the blocks
            var outsideX:Number = Math.max(0, Math.abs(middleColumn - (ground.columns - 1) / 2) - ground.columns / 2);
            var outsideY:Number = Math.max(0, Math.abs(middleRow - (ground.rows - 1) / 2) - ground.rows / 2);
            if (!(outsideX * outsideX + outsideY * outsideY <= radius * radius))
            {
                throw new RangeError("a mound of width " + width + " at (" + x + ", " + y + ") is not within the terrain");
            }
            var firstColumn:int = Math.max(0, Math.ceil(middleColumn - radius));
            var lastColumn:int = Math.min(ground.columns - 1, Math.floor(middleColumn + radius));
            var firstRow:int = Math.max(0, Math.ceil(middleRow - radius));
            var lastRow:int = Math.min(ground.rows - 1, Math.floor(middleRow + radius));
            var raised:Vector.<Number> = new Vector.<Number>();
            for (var row:int = firstRow; row <= lastRow; row++)
            {
                for (var column:int = firstColumn; column <= lastColumn; column++)
                {
                    var acrossX:Number = (column - middleColumn) / radius;
                    var acrossY:Number = (row - middleRow) / radius;
                    var share:Number = Math.max(0, 1 - acrossX * acrossX - acrossY * acrossY);
                    raised.push(ground.heights[int(row * ground.columns + column)] + height * share * share);
                }
            }
            if (raised.length > 0)
            {
                setHeights(firstColumn, firstRow, lastColumn - firstColumn + 1, lastRow - firstRow + 1, raised);
            }
        }

        /**
         * Raises the height that is nearest to a place: a block, or on slopes a peak whose foot is one cell around it. The place may be up to half
         * a cell beyond the outermost heights, because with isBlocky their blocks reach as far.
         *
         * @param height by how much; may be negative
         * @throws RangeError if the place is farther outside, or the height would be too large
         */
        public function raiseWall(x:Number, y:Number, height:Number):void
        {
            var block:GroundPoint = requireCell("a wall", x, y, true);
            setHeight(block.column, block.row, getHeight(block.column, block.row) + height);
        }

        /** Makes the ground flat again, of height 0, without holes. */
        public function reset():void
        {
            environmentAgent.beginChange().reset();
        }

        /**
         * How high the ground is at a place. At a border between blocks it is the height of the higher block. The border of a hole belongs to
         * the ground beside it. A place is at a border up to rounding.
         *
         * @return NaN outside of the terrain and over a hole
         * @throws RangeError if the place is not in the world
         */
        public function heightAt(x:Number, y:Number):Number
        {
            requireInWorld("a place", x, y, 0);
            return grid.heightAt(x, y);
        }

        /**
         * The direction that points out of the ground at a place, of length 1. At a border between triangles it is the direction of one of
         * them. On blocks it is straight up.
         *
         * @param out takes it; made if null
         * @return out, or the new one; null outside of the terrain and over a hole
         * @throws RangeError if the place is not in the world
         */
        public function normalAt(x:Number, y:Number, out:Vector3D = null):Vector3D
        {
            requireInWorld("a place", x, y, 0);
            _point.x = x;
            _point.y = y;
            grid.findHeight(_point);
            if (isNaN(_point.height))
            {
                return null;
            }
            out ||= new Vector3D();
            grid.findNormal(_point, out);
            return out;
        }

        /**
         * Whether an agent's place is under the ground. False outside of the terrain and over a hole.
         *
         * @throws ArgumentError if the agent is null
         */
        public function isUnder(agent:Agent):Boolean
        {
            requireGiven("agent", agent);
            return heightAt(agent.x, agent.y) > agent.z;
        }

        // The place's cell, as HeightGrid.findCell() finds it.
        private function requireCell(what:String, x:Number, y:Number, areBlocks:Boolean):GroundPoint
        {
            requireInWorld(what + "'s place", x, y, 0);
            _point.x = x;
            _point.y = y;
            if (!grid.findCell(_point, areBlocks))
            {
                throw new RangeError(what + " at (" + x + ", " + y + ") is outside of the terrain");
            }
            return _point;
        }

        private function requireRegion(column:int, row:int, columns:int, rows:int):void
        {
            if (!(column >= 0 && row >= 0 && columns >= 1 && rows >= 1 && column + columns <= grid.columns && row + rows <= grid.rows))
            {
                var what:String = columns == 1 && rows == 1 ? "there is no height" : "a region of " + columns + " by " + rows + " heights does not fit";
                throw new RangeError(what + " at column " + column + " and row " + row + " of the " + this
                        + "; columns and rows count heights, from 0 on: they are no places");
            }
        }
    }
}
